#include "app/editor/views/sprite_toolbar.h"

#include <cstdio>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/views/scene_representations.h"

namespace voxprite::editor {
namespace {

constexpr float kButton = 24.0f;

// How large saved and copied sprites are.
void drawPictureScale(Ui& ui, float size) {
    const Theme& theme = ui.theme;
    int& scale = ui.settings.scene.pictureScale;
    const std::string text = std::to_string(scale) + "×";
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 area(size + theme.px(4), size);
    if (ImGui::InvisibleButton("scale", area)) ImGui::OpenPopup("scales");
    ui.probe.markItem("sprite.scale");
    tooltip(ui, "Picture pixels a virtual pixel, of saved and copied sprites");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered()) {
        draw.AddRectFilled(corner, {corner.x + area.x, corner.y + area.y}, theme.fieldHovered,
                           theme.px(6));
    }
    const ImVec2 wide = ImGui::CalcTextSize(text.c_str());
    draw.AddText({corner.x + std::round((area.x - wide.x) * 0.5f),
                  corner.y + std::round((area.y - wide.y) * 0.5f)},
                 theme.text, text.c_str());
    if (!ImGui::BeginPopup("scales")) return;
    for (int each = 1; each <= kMostPictureScale; each *= 2) {
        const std::string label =
            std::to_string(each) + "×  " + (each == 1 ? "one pixel a virtual pixel" : "magnified");
        if (ImGui::Selectable(label.c_str(), each == scale)) scale = each;
        ui.probe.markItem("sprite.scale." + std::to_string(each));
    }
    ImGui::EndPopup();
}

constexpr std::array kCommands{CommandId::toggleHeat,  CommandId::flipSides,
                               CommandId::wipeSides,   CommandId::compareTwo,
                               CommandId::compareFour, CommandId::compareRepresentations,
                               CommandId::saveSprite,  CommandId::copySprite};
constexpr float kGap = 1.0f, kPad = 3.0f;

float widthOfButtons(const Theme& theme) {
    const float size = theme.px(kButton);
    return (size + theme.px(kGap)) * static_cast<float>(kCommands.size()) + size + theme.px(4);
}

ImVec2 cornerOfButtons(const Theme& theme, const ViewCanvas& canvas) {
    const ImVec2 corner = canvas.toWindow({canvas.sizePx().x, 0});
    return {corner.x - widthOfButtons(theme) - 2 * theme.px(kPad) - theme.px(10),
            corner.y + theme.px(8)};
}

void drawButtons(Ui& ui, const ViewCanvas& canvas) {
    const Theme& theme = ui.theme;
    const float size = theme.px(kButton), gap = theme.px(kGap), pad = theme.px(kPad);
    const float width = widthOfButtons(theme);
    ImGui::SetCursorScreenPos(cornerOfButtons(theme, canvas));
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, withAlpha(theme.panel, 0.9f));
    ImGui::BeginChild("sprite.toolbar", {width + 2 * pad, size + 2 * pad}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    for (const CommandId id : kCommands) {
        commandButton(ui, id, isOn(id, ui.context) ? Lit::filled : Lit::off, size);
        ImGui::SameLine(0.0f, gap);
    }
    drawPictureScale(ui, size);
    ImGui::EndChild();
}

void drawFigures(Ui& ui, const ViewCanvas& canvas) {
    const SceneFigures& figures = ui.figures.scene;
    if (figures.entities < 2 || ui.settings.scene.comparison.on()) return;
    if (ui.settings.trade.showsB()) return;  // A and B have theirs
    const SceneStats& stats = figures.stats;
    std::array<char, 32> ms{};
    std::snprintf(ms.data(), ms.size(), "%.1f ms", figures.cpuMs);
    const std::string text = grouped(static_cast<std::uint64_t>(stats.drawn)) + " sprites    " +
                             grouped(static_cast<std::uint64_t>(stats.drawCalls)) +
                             (stats.drawCalls == 1 ? " draw call    " : " draw calls    ") +
                             grouped(stats.rays) + " rays    " + grouped(stats.castsReused) +
                             " reused    " + ms.data();
    const Theme& theme = ui.theme;
    ImFont* small = theme.fonts.small;
    const float room = static_cast<float>(canvas.sizePx().x) - theme.px(36);
    const ImVec2 size = small->CalcTextSizeA(small->FontSize, FLT_MAX, room, text.c_str());
    const ImVec2 corner = canvas.toWindow({0, canvas.sizePx().y});
    const ImVec2 at(corner.x + theme.px(10), corner.y - size.y - theme.px(18));
    ImDrawList& draw = canvas.overlay();
    draw.AddRectFilled(at, {at.x + size.x + theme.px(16), at.y + size.y + theme.px(8)},
                       IM_COL32(16, 17, 19, 205), theme.px(6));
    draw.AddText(small, small->FontSize, {at.x + theme.px(8), at.y + theme.px(4)},
                 IM_COL32(225, 227, 231, 255), text.c_str(), nullptr, room);
}

// What the colours of tinted entities mean, and how many of each are in view.
void drawLegend(Ui& ui, const ViewCanvas& canvas) {
    if (!ui.settings.scene.representations.tint || ui.settings.scene.comparison.on()) return;
    const Theme& theme = ui.theme;
    const ImFont& small = *theme.fonts.small;
    const RepresentationShares& shares = ui.figures.scene.shares;
    const float line = theme.px(20), pad = theme.px(8), dot = theme.px(4);
    const ImVec2 size(theme.px(132), line * static_cast<float>(shares.size()) + pad);
    const ImVec2 corner = canvas.toWindow({0, 0});
    const ImVec2 at(corner.x + theme.px(10), corner.y + theme.px(46));
    const ImVec2 end(at.x + size.x, at.y + size.y);
    ImDrawList& draw = canvas.overlay();
    draw.AddRectFilled(at, end, IM_COL32(16, 17, 19, 205), theme.px(6));
    ui.probe.mark("sprite.legend", at, end);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const auto kind = static_cast<Representation>(k);
        const Rgba8 tint = tintOf(kind);
        const float y = at.y + pad * 0.5f + line * static_cast<float>(k);
        const float textY = y + std::round((line - small.FontSize) * 0.5f);
        const std::string count = grouped(static_cast<std::uint64_t>(shares[k].entities));
        const float width = small.CalcTextSizeA(small.FontSize, FLT_MAX, 0.0f, count.c_str()).x;
        const ImU32 text =
            shares[k].entities > 0 ? IM_COL32(235, 237, 241, 255) : IM_COL32(140, 143, 149, 255);
        draw.AddCircleFilled({at.x + pad + dot, y + line * 0.5f}, dot,
                             IM_COL32(tint.x, tint.y, tint.z, 255));
        draw.AddText(&small, small.FontSize, {at.x + pad + 3 * dot, textY}, text, nameOf(kind));
        draw.AddText(&small, small.FontSize, {at.x + size.x - pad - width, textY}, text,
                     count.c_str());
    }
}

}  // namespace

float leftOfSpriteToolbar(const Theme& theme, const ViewCanvas& canvas) {
    return cornerOfButtons(theme, canvas).x - theme.px(8);
}

void drawSpriteToolbar(Ui& ui, const ViewCanvas& canvas) {
    drawFigures(ui, canvas);
    drawLegend(ui, canvas);
    drawButtons(ui, canvas);
}

}  // namespace voxprite::editor
