// The strip of variants: the model in each variant's colours, side by side.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/editor/panels/palette_panel.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

constexpr const char* kAddHint =
    "Add a variant: the same model in other colours, such as a team's or a season's";

// Cut to `width`, with dots where something is missing.
std::string fitted(const std::string& text, const ImFont& font, float width) {
    const auto widthOf = [&](const std::string& part) {
        return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, part.c_str()).x;
    };
    if (widthOf(text) <= width) return text;
    std::string cut = text;
    while (!cut.empty() && widthOf(cut + "…") > width) {
        // Whole characters: UTF-8 goes on with bytes of 10xxxxxx.
        while (cut.size() > 1 && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) {
            cut.pop_back();
        }
        cut.pop_back();
    }
    return cut + "…";
}

}  // namespace

void PalettePanel::drawVariants(Ui& ui) {
    const Theme& theme = ui.theme;
    const ImVec2 cell(theme.px(VariantPictures::kEdgePx + 8),
                      theme.px(VariantPictures::kEdgePx + 24));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + theme.px(4));
    if (editor_.palette().variants.empty()) {
        const std::string label = std::string(icon::kPlus) + "  Palette variant";
        if (ImGui::Button(label.c_str(), {0.0f, theme.px(22)})) {
            ui.commands.ask(CommandId::addVariant);
        }
        ui.probe.markItem("palette.variant.add");
        tooltip(ui, kAddHint);
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, theme.px(6));
    ImGui::BeginChild("variants", {0.0f, 0.0f}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoBackground);
    for (std::size_t k = 0; k < pictures_.count(); ++k) {
        drawVariant(ui, k, cell);
        ImGui::SameLine(0.0f, theme.px(4));
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("add", {cell.y * 0.5f, theme.px(VariantPictures::kEdgePx + 6)})) {
        ui.commands.ask(CommandId::addVariant);
    }
    ui.probe.markItem("palette.variant.add");
    tooltip(ui, kAddHint);
    const ImVec2 max = ImGui::GetItemRectMax();
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRect(corner, max, hovered ? theme.accent : theme.line, theme.px(6), 0, theme.px(1));
    const ImVec2 size = ImGui::CalcTextSize(icon::kPlus);
    draw.AddText({std::round((corner.x + max.x - size.x) * 0.5f),
                  std::round((corner.y + max.y - size.y) * 0.5f)},
                 hovered ? theme.accent : theme.textDim, icon::kPlus);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

// Cell 0 is the palette itself, cell k variant k - 1.
void PalettePanel::drawVariant(Ui& ui, std::size_t cell, ImVec2 size) {
    const Theme& theme = ui.theme;
    const Palette& palette = editor_.palette();
    const VariantIndex variant = cell == 0 ? VariantIndex() : VariantIndex(cell - 1);
    const std::string& name = variant ? palette.variants[*variant].name : "Original";
    const bool shown = ui.session.variant() == variant;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(cell));
    if (ImGui::InvisibleButton("cell", size)) ui.session.showVariant(variant);
    ui.probe.markItem("palette.variant." + std::to_string(cell));
    tooltip(ui, variant
                    ? (name + "\n" + std::to_string(palette.variants[*variant].overrides.size()) +
                       " colours of its own")
                          .c_str()
                    : "The palette's own colours");
    const bool hovered = ImGui::IsItemHovered();
    if (variant) drawVariantMenu(ui, *variant);
    ImGui::PopID();

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float edge = theme.px(VariantPictures::kEdgePx + 6);
    const ImVec2 max(corner.x + size.x, corner.y + edge);
    draw.AddRectFilled(corner, max, shown ? theme.accentSoft : theme.field, theme.px(6));
    if (shown || hovered) {
        draw.AddRect(corner, max, shown ? theme.accent : theme.fieldHovered, theme.px(6), 0,
                     theme.px(shown ? 2.0f : 1.0f));
    }
    const PictureTexture& picture = pictures_.picture(cell);
    if (picture.id() != 0) {
        // Whole screen pixels a pixel.
        const float room = edge - theme.px(4);
        const auto largest = static_cast<float>(std::max(picture.width(), picture.height()));
        const float scale = std::max(1.0f, std::floor(room / largest));
        const ImVec2 shownSize(static_cast<float>(picture.width()) * scale,
                               static_cast<float>(picture.height()) * scale);
        const ImVec2 at(std::round((corner.x + max.x - shownSize.x) * 0.5f),
                        std::round((corner.y + max.y - shownSize.y) * 0.5f));
        draw.AddImage(imguiTexture(picture.id()), at, {at.x + shownSize.x, at.y + shownSize.y});
    }
    const ImFont& font = *theme.fonts.small;
    const std::string label = fitted(name, font, size.x);
    const float width = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, label.c_str()).x;
    draw.AddText(&font, font.FontSize,
                 {std::round(corner.x + (size.x - width) * 0.5f), max.y + theme.px(1)},
                 shown ? theme.text : theme.textDim, label.c_str());
}

void PalettePanel::drawVariantMenu(Ui& ui, std::size_t variant) {
    const Theme& theme = ui.theme;
    const Palette& palette = editor_.palette();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(10, 10));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, theme.px(10, 7));
    if (ImGui::BeginPopupContextItem("menu")) {
        if (ImGui::IsWindowAppearing()) name_ = palette.variants[variant].name;
        ImGui::SetNextItemWidth(theme.px(180));
        const bool entered =
            ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
        const bool left = ImGui::IsItemDeactivatedAfterEdit();
        ui.probe.markItem("palette.variant.name");
        const bool free = !name_.empty() && !palette.variantNamed(name_);
        if ((entered || left) && free) {
            Palette after = palette;
            after.variants[variant].name = name_;
            ui.edits.push(editor_.change("Rename palette variant", std::move(after)));
        }
        if (entered) ImGui::CloseCurrentPopup();
        if (ImGui::MenuItem("Duplicate", nullptr, false, editor_.canAddVariant())) {
            ui.edits.push(editor_.duplicateVariant(variant));
        }
        if (ImGui::MenuItem("Delete")) {
            ui.edits.push(
                editor_.change("Delete palette variant", withVariantRemoved(palette, variant)));
            ui.session.showVariant(std::nullopt);
        }
        ui.probe.markItem("palette.variant.delete");
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace voxprite::editor
