#include "app/editor/panels/toasts.h"

#include <algorithm>
#include <cmath>

#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr double kSeconds = 4.0;
constexpr double kErrorSeconds = 9.0;
constexpr double kFadeSeconds = 0.25;
constexpr std::size_t kMost = 4;

}  // namespace

void Toasts::add(std::string text, bool isError) {
    // The same again only stays longer.
    std::erase_if(toasts_, [&](const Toast& toast) { return toast.text == text; });
    const double until = ImGui::GetTime() + (isError ? kErrorSeconds : kSeconds);
    toasts_.push_back({std::move(text), isError, until});
    if (toasts_.size() > kMost) toasts_.erase(toasts_.begin());
}

void Toasts::draw(const Theme& theme, ImVec2 bottomCentre, float maxWidth) {
    const double now = ImGui::GetTime();
    std::erase_if(toasts_, [&](const Toast& toast) { return toast.untilSeconds < now; });
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    ImFont* font = theme.fonts.text;
    const float pad = theme.px(12), iconWidth = theme.px(24);
    float bottom = bottomCentre.y - theme.px(16);
    for (auto toast = toasts_.rbegin(); toast != toasts_.rend(); ++toast) {
        const auto alpha =
            static_cast<float>(std::clamp((toast->untilSeconds - now) / kFadeSeconds, 0.0, 1.0));
        const float wrap = maxWidth - 2 * pad - iconWidth;
        const char* begin = toast->text.c_str();
        const ImVec2 text = font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap, begin);
        const ImVec2 size(text.x + 2 * pad + iconWidth, text.y + 2 * theme.px(9));
        const ImVec2 min(std::round(bottomCentre.x - size.x * 0.5f), bottom - size.y);
        const ImVec2 max(min.x + size.x, bottom);
        draw.AddRectFilled({min.x, min.y + theme.px(2)}, {max.x, max.y + theme.px(3)},
                           IM_COL32(0, 0, 0, static_cast<int>(70 * alpha)), theme.px(8));
        draw.AddRectFilled(min, max, withAlpha(theme.raised, alpha), theme.px(8));
        draw.AddRect(min, max, withAlpha(theme.line, alpha), theme.px(8));
        const float textY = min.y + theme.px(9);
        draw.AddText(font, font->FontSize, {min.x + pad, textY},
                     withAlpha(toast->isError ? theme.danger : theme.accent, alpha),
                     toast->isError ? icon::kWarning : icon::kInfo);
        draw.AddText(font, font->FontSize, {min.x + pad + iconWidth, textY},
                     withAlpha(theme.text, alpha), begin, nullptr, wrap);
        bottom = min.y - theme.px(8);
    }
}

}  // namespace voxprite::editor
