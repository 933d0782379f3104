#include "app/editor/panels/option_bar.h"

#include <algorithm>
#include <numeric>

#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr float kMoreGap = 4.0f;

// Those at the right stand side by side here, too.
void drawRest(Ui& ui, std::span<const OptionPart> parts, const std::vector<bool>& shown) {
    // Below the button that opens it, which was drawn last.
    const ImVec2 button = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({button.x, button.y + ui.theme.px(kMoreGap)}, ImGuiCond_Always, {1, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(14, 12));
    if (ImGui::BeginPopup("rest")) {
        const OptionPart* before = nullptr;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            if (shown[k]) continue;
            const OptionPart& part = parts[k];
            if (before != nullptr && before->atRight) ImGui::SameLine(0.0f, before->behind);
            part.draw();
            before = &part;
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

}  // namespace

float widthOf(std::span<const OptionPart> parts) {
    return std::accumulate(parts.begin(), parts.end(), 0.0f, [](float sum, const OptionPart& part) {
        return sum + part.width + part.behind;
    });
}

std::vector<bool> partsThatFit(std::span<const OptionPart> parts, float room) {
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](std::size_t k) { return parts[k].worth; });
    std::vector<bool> fits(parts.size(), false);
    for (const std::size_t k : order) {
        const float width = parts[k].width + parts[k].behind;
        fits[k] = width <= room;
        if (fits[k]) room -= width;
    }
    return fits;
}

void drawOptionBar(Ui& ui, std::span<const OptionPart> parts) {
    const float square = ui.theme.px(kOptionHeight), room = ImGui::GetContentRegionAvail().x;
    const bool all = widthOf(parts) <= room;
    const float more = all ? 0.0f : square + ui.theme.px(kMoreGap);
    std::vector<bool> shown(parts.size(), true);
    if (!all) shown = partsThatFit(parts, room - more);

    const ImVec2 start = ImGui::GetCursorPos();
    float right = start.x + room - more;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (shown[k] && parts[k].atRight) right -= parts[k].width + parts[k].behind;
    }
    float left = start.x;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (!shown[k]) continue;
        float& x = parts[k].atRight ? right : left;
        ImGui::SetCursorPos({x, start.y});
        parts[k].draw();
        x += parts[k].width + parts[k].behind;
    }
    if (all) return;
    bool on = false;
    for (std::size_t k = 0; k < parts.size(); ++k) on = on || (!shown[k] && parts[k].on);
    ImGui::SetCursorPos({start.x + room - square, start.y});
    if (iconButton(ui, "options.more", icon::kMore, on ? Lit::icon : Lit::off, square,
                   "The other options")) {
        ImGui::OpenPopup("rest");
    }
    drawRest(ui, parts, shown);
}

void optionLabel(Ui& ui, const char* text, const char* hint) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    tooltip(ui, hint);
    ImGui::SameLine(0.0f, ui.theme.px(8));
}

float optionLabelWidth(const Ui& ui, const char* text) {
    return ImGui::CalcTextSize(text).x + ui.theme.px(8);
}

}  // namespace voxprite::editor
