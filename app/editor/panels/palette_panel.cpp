#include "app/editor/panels/palette_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"
#include "core/base/oklab.h"

namespace voxprite::editor {
namespace {

constexpr const char* kPicker = "palette.picker";
constexpr const char* kSortMenu = "palette.sort.menu";

std::array<float, 3> floatsOf(Rgba8 colour) {
    return {static_cast<float>(colour.x) / 255.0f, static_cast<float>(colour.y) / 255.0f,
            static_cast<float>(colour.z) / 255.0f};
}

Rgba8 colourOf(const std::array<float, 3>& rgb) {
    const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(c * 255.0f)); };
    return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2]), 255};
}

}  // namespace

void PalettePanel::draw(Ui& ui) {
    const Theme& theme = ui.theme;
    pictures_.update(ui.session);
    drawColour(ui);
    drawToolbar(ui);
    drawRamp(ui);
    const bool variants = !editor_.palette().variants.empty();
    const float strip = theme.px(variants ? VariantPictures::kEdgePx + 34 : 30);
    drawSwatches(ui, std::max(theme.px(64), ImGui::GetContentRegionAvail().y - strip));
    drawVariants(ui);
}

// The colour in hand: its swatch (a click opens the picker), its number, its name.
void PalettePanel::drawColour(Ui& ui) {
    const Theme& theme = ui.theme;
    const std::uint8_t index = editor_.inHand();
    const Rgba8 shown = ui.session.shownPalette().colours[index];
    const float height = theme.px(26), gap = theme.px(6);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("in hand", {theme.px(40), height})) ImGui::OpenPopup(kPicker);
    ui.probe.markItem("palette.edit");
    tooltip(ui, "Edit the colour in hand");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 max = ImGui::GetItemRectMax();
    draw.AddRectFilled(corner, max, IM_COL32(shown.x, shown.y, shown.z, 255), theme.px(5));
    draw.AddRect(corner, max, ImGui::IsItemHovered() ? theme.accent : theme.line, theme.px(5), 0,
                 std::max(1.0f, theme.px(1)));
    drawPicker(ui);

    ImGui::SameLine(0.0f, gap);
    std::array<float, 3> rgb = floatsOf(shown);
    ImGui::SetNextItemWidth(theme.px(84));
    if (ImGui::ColorEdit3("##hex", rgb.data(),
                          ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoSmallPreview |
                              ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoPicker)) {
        ui.edits.push(editor_.setColour(colourOf(rgb), ui.edits.key()));
    }
    ui.edits.watchItem(ui.session);
    ui.probe.markItem("palette.hex");

    ImGui::SameLine(0.0f, gap);
    std::string name = editor_.palette().names[index];
    const std::string hint = "Colour " + std::to_string(index);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::InputTextWithHint("##name", hint.c_str(), &name)) {
        ui.edits.push("Name colour",
                      PaletteEdit{editor_.palette(), withName(editor_.palette(), index, name)});
    }
    ui.edits.watchItem(ui.session);
    ui.probe.markItem("palette.name");
}

// Degrees and per cent; true when it changed the colour.
bool PalettePanel::drawHueRow(Ui& ui, Rgba8 shown, std::array<float, 3>& rgb) {
    struct Part {
        const char* name;
        const char* format;
        double most;
    };
    constexpr std::array kHueParts{Part{"H", "H %.0f°", 360.0}, Part{"S", "S %.0f %%", 100.0},
                                   Part{"V", "V %.0f %%", 100.0}};
    if (shown != hsvOf_) {
        ImGui::ColorConvertRGBtoHSV(rgb[0], rgb[1], rgb[2], hsv_[0], hsv_[1], hsv_[2]);
        hsvOf_ = shown;
    }
    const float gap = ui.theme.px(4);
    const float width = std::floor((ui.theme.px(216) - 2 * gap) / 3.0f);
    bool changed = false;
    for (std::size_t i = 0; i < kHueParts.size(); ++i) {
        const Part& part = kHueParts[i];
        if (i > 0) ImGui::SameLine(0.0f, gap);
        ImGui::PushID(part.name);
        double value = static_cast<double>(hsv_[i]) * part.most;
        const double least = 0.0;
        ImGui::SetNextItemWidth(width);
        if (ImGui::DragScalar("##part", ImGuiDataType_Double, &value, 0.5f, &least, &part.most,
                              part.format, ImGuiSliderFlags_AlwaysClamp)) {
            hsv_[i] = static_cast<float>(value / part.most);
            changed = true;
        }
        ui.edits.watchItem(ui.session);
        ui.probe.markItem(std::string("palette.picker.") + part.name);
        ImGui::PopID();
    }
    if (!changed) return false;
    ImGui::ColorConvertHSVtoRGB(hsv_[0], hsv_[1], hsv_[2], rgb[0], rgb[1], rgb[2]);
    hsvOf_ = colourOf(rgb);
    return true;
}

void PalettePanel::drawPicker(Ui& ui) {
    const Theme& theme = ui.theme;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(12, 12));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
    // Beside the panel, so that the swatches stay in sight.
    ImGui::SetNextWindowPos(
        {ImGui::GetWindowPos().x - theme.px(8), ImGui::GetIO().DisplaySize.y - theme.px(34)},
        ImGuiCond_Always, {1.0f, 1.0f});
    if (ImGui::BeginPopup(kPicker)) {
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
            ImGui::CloseCurrentPopup();
        }
        const Rgba8 shown = ui.session.shownPalette().colours[editor_.inHand()];
        std::array<float, 3> rgb = floatsOf(shown);
        ImGui::SetNextItemWidth(theme.px(216));
        bool changed = ImGui::ColorPicker3(
            "##picker", rgb.data(),
            ImGuiColorEditFlags_PickerHueBar | ImGuiColorEditFlags_NoSidePreview |
                ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_NoLabel |
                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex);
        ui.edits.watchItem(ui.session);
        ui.probe.markItem("palette.picker");
        changed = drawHueRow(ui, shown, rgb) || changed;
        if (changed && colourOf(rgb) != shown) {
            ui.edits.push(editor_.setColour(colourOf(rgb), ui.edits.key()));
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

void PalettePanel::drawToolbar(Ui& ui) {
    using enum CommandId;
    const Theme& theme = ui.theme;
    constexpr std::array kButtons{
        toolPickColour, selectByColour, duplicateColour,     swapColours,   gradientColours,
        makeRamp,       suggestRamps,   removeUnusedColours, importPalette, exportPalette};
    const float size = theme.px(24);
    const auto gaps = static_cast<float>(kButtons.size());  // the menu for sorting comes last
    const float spare = ImGui::GetContentRegionAvail().x - (gaps + 1.0f) * size;
    const float gap = std::clamp(std::floor(spare / gaps), 0.0f, theme.px(6));
    for (const CommandId id : kButtons) {
        const bool enabled = isEnabled(id, ui.context);
        if (!enabled) ImGui::BeginDisabled();
        const bool on = isOn(id, ui.context);
        commandButton(ui, id, on ? Lit::filled : Lit::off, size);
        if (!enabled) ImGui::EndDisabled();
        ImGui::SameLine(0.0f, gap);
    }
    if (iconButton(ui, "palette.sort", icon::kSort, Lit::off, size, "Sort the display")) {
        ImGui::OpenPopup(kSortMenu);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(8, 8));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, theme.px(10, 7));
    if (ImGui::BeginPopup(kSortMenu)) {
        for (const CommandId id : {sortByHue, sortByLightness, sortByUse, sortByIndex}) {
            if (ImGui::MenuItem(commandOf(id).name)) ui.commands.ask(id);
            ui.probe.markItem(std::string("palette.") + commandOf(id).tag);
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

// The ramp of the colour in hand, dark to light. A step is dragged along it to another place.
void PalettePanel::drawRamp(Ui& ui) {
    const Palette& palette = ui.session.shownPalette();
    const auto ramp = palette.rampOf(editor_.inHand());
    if (!ramp) return;
    const Theme& theme = ui.theme;
    const std::vector<std::uint8_t>& indices = palette.ramps[*ramp].indices;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = theme.px(18);
    const float width =
        std::min(theme.px(32), std::floor((ImGui::GetContentRegionAvail().x - theme.px(26)) /
                                          static_cast<float>(indices.size())));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto last = static_cast<float>(indices.size() - 1);
    const auto under = static_cast<std::size_t>(
        std::clamp(std::floor((ImGui::GetMousePos().x - corner.x) / width), 0.0f, last));
    std::optional<std::size_t> dragged;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const Rgba8 colour = palette.colours[indices[i]];
        const ImVec2 min(corner.x + width * static_cast<float>(i), corner.y);
        const ImVec2 max(min.x + width, min.y + height);
        const ImDrawFlags round = i == 0                    ? ImDrawFlags_RoundCornersLeft
                                  : i + 1 == indices.size() ? ImDrawFlags_RoundCornersRight
                                                            : ImDrawFlags_RoundCornersNone;
        draw.AddRectFilled(min, max, IM_COL32(colour.x, colour.y, colour.z, 255), theme.px(4),
                           round);
        ImGui::SetCursorScreenPos(min);
        ImGui::PushID(indices[i]);  // it stays in the hand wherever it goes
        if (ImGui::InvisibleButton("step", {width, height})) editor_.choose(indices[i]);
        ui.edits.watchItem(ui.session);
        if (ImGui::IsItemActive() && under != i) dragged = i;
        ImGui::PopID();
        ui.probe.markItem("palette.ramp." + std::to_string(i));
        tooltip(ui,
                "The ramp of this colour: with shading in the palette, light picks for a step from "
                "those before it. Drag a step to another place.");
        if (indices[i] != editor_.inHand()) continue;
        // A dark mark on light, a light one on dark.
        const bool light = okLabFrom(colour).lightness > 0.6;
        draw.AddCircleFilled(
            {std::round((min.x + max.x) * 0.5f), std::round((min.y + max.y) * 0.5f)}, theme.px(3),
            light ? IM_COL32(0, 0, 0, 200) : IM_COL32_WHITE);
    }
    if (dragged) ui.edits.push(editor_.moveRampStep(*ramp, *dragged, under, ui.edits.key()));
    ImGui::SetCursorScreenPos({corner.x + width * static_cast<float>(indices.size()) + theme.px(4),
                               corner.y - theme.px(1)});
    if (iconButton(ui, "palette.ramp.remove", icon::kClose, Lit::off, theme.px(20),
                   "Remove this ramp")) {
        ui.commands.ask(CommandId::removeRamp);
    }
}

}  // namespace voxprite::editor
