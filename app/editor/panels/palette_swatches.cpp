// The grid of swatches: choosing, dragging to another place, the menu of a colour.
#include <algorithm>
#include <cmath>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/palette_panel.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr int kColumns = 16;
constexpr int kSwatchRows = 16;
constexpr float kLeastCell = 14.0f;
constexpr const char* kMenu = "palette.menu";

std::string tooltipText(const Palette& palette, std::uint8_t index, std::uint64_t count) {
    const Rgba8 colour = palette.colours[index];
    std::array<char, 16> hex{};
    std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x", colour.x, colour.y, colour.z);
    std::string text = palette.names[index].empty()
                           ? "Colour " + std::to_string(index)
                           : palette.names[index] + "  (" + std::to_string(index) + ")";
    text += palette.isVacant(index) ? "\nno colour" : std::string("\n") + hex.data();
    text += count == 0 ? "\nno voxel" : "\n" + grouped(count) + (count == 1 ? " voxel" : " voxels");
    if (palette.rampOf(index)) text += "\nin a ramp";
    return text;
}

}  // namespace

void PalettePanel::drawSwatches(Ui& ui, float height) {
    const Theme& theme = ui.theme;
    const Palette& palette = ui.session.shownPalette();
    const ColourCounts& counts = editor_.shownCounts(ImGui::GetTime());
    // Square where there is room, flatter where there is not, and then to be scrolled.
    const float full = ImGui::GetContentRegionAvail().x, bar = theme.px(6);
    const bool scrolls = height < theme.px(kLeastCell) * kSwatchRows;
    const float width = (scrolls ? full - bar - theme.px(2) : full) / kColumns;
    const float cell =
        std::clamp(std::floor(height / kSwatchRows), theme.px(kLeastCell), std::floor(width));
    const float gap = std::max(1.0f, theme.px(1));
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, bar);
    ImGui::BeginChild("swatches", {0.0f, std::min(height, cell * kSwatchRows)}, false,
                      ImGuiWindowFlags_NoBackground);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("grid", {width * kColumns, cell * kSwatchRows});
    ui.probe.markItem("palette.swatches");
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const int column = static_cast<int>(std::floor((mouse.x - corner.x) / width));
    const int row = static_cast<int>(std::floor((mouse.y - corner.y) / cell));
    const bool inside = column >= 0 && column < kColumns && row >= 0 && row < kSwatchRows;
    const std::size_t under = inside ? static_cast<std::size_t>(row * kColumns + column) : 0;

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    // Whole pixels, whatever the width is.
    const auto cornerAt = [&](std::size_t slotColumn, std::size_t slotRow) {
        return ImVec2(std::round(corner.x + width * static_cast<float>(slotColumn)),
                      corner.y + cell * static_cast<float>(slotRow));
    };
    const auto minOf = [&](std::size_t slot) { return cornerAt(slot % kColumns, slot / kColumns); };
    const auto maxOf = [&](std::size_t slot) {
        const ImVec2 next = cornerAt(slot % kColumns + 1, slot / kColumns + 1);
        return ImVec2(next.x - gap, next.y - gap);
    };
    const auto frame = [&](std::size_t slot, ImU32 colour, float thick) {
        const ImVec2 min = minOf(slot), max = maxOf(slot);
        draw.AddRect({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, theme.panel, theme.px(3), 0,
                     thick + theme.px(2));
        draw.AddRect({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, colour, theme.px(3), 0, thick);
    };
    for (std::size_t slot = 0; slot < 256; ++slot) {
        const std::uint8_t index = palette.displayOrder[slot];
        const ImVec2 min = minOf(slot), max = maxOf(slot);
        if (index == 0 || palette.isVacant(index)) {
            draw.AddRectFilled(min, max, theme.field, theme.px(2));
            if (index == 0) {  // what erasing leaves
                draw.AddLine({min.x + theme.px(3), max.y - theme.px(3)},
                             {max.x - theme.px(3), min.y + theme.px(3)}, theme.textFaint,
                             theme.px(1));
            }
            continue;
        }
        const Rgba8 c = palette.colours[index];
        draw.AddRectFilled(min, max, IM_COL32(c.x, c.y, c.z, 255), theme.px(2));
    }
    for (std::size_t slot = 1; slot < 256; ++slot) {
        const std::uint8_t index = palette.displayOrder[slot];
        if (editor_.isChosen(index) && index != editor_.inHand()) {
            frame(slot, theme.accent, theme.px(2));
        }
    }
    for (std::size_t slot = 1; slot < 256; ++slot) {
        if (palette.displayOrder[slot] == editor_.inHand()) frame(slot, theme.text, theme.px(2));
    }

    if (ImGui::IsItemActivated() && under != 0) useSwatch(ui, under);
    if (ImGui::IsItemActive() && dragged_ != 0 && ImGui::IsMouseDragging(0, theme.px(5))) {
        const Rgba8 c = palette.colours[palette.displayOrder[dragged_]];
        if (under != 0) {  // where it would go
            const ImVec2 min = minOf(under);
            const float x = under > dragged_ ? maxOf(under).x : min.x - gap;
            draw.AddRectFilled({x - theme.px(1), min.y - theme.px(1)},
                               {x + theme.px(2), min.y + cell}, theme.accent);
        }
        ImDrawList& front = *ImGui::GetForegroundDrawList();
        const ImVec2 at(mouse.x - width * 0.5f, mouse.y - width * 0.5f);
        front.AddRectFilled(at, {at.x + width, at.y + width}, IM_COL32(c.x, c.y, c.z, 255),
                            theme.px(3));
        front.AddRect(at, {at.x + width, at.y + width}, theme.text, theme.px(3), 0, theme.px(1));
    } else if (ImGui::IsItemHovered() && under != 0) {
        const std::uint8_t index = palette.displayOrder[under];
        tooltip(ui, tooltipText(palette, index, counts[index]).c_str());
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            menuFor_ = index;
            ImGui::OpenPopup(kMenu);
        }
    }
    if (ImGui::IsItemDeactivated()) {
        // Where the button went down counts: a quick drag can fall into a single frame.
        const ImVec2 from = ImGui::GetIO().MouseClickedPos[0];
        const bool moved = std::hypot(mouse.x - from.x, mouse.y - from.y) >= theme.px(5);
        if (dragged_ != 0 && under != 0 && moved) dropSwatch(ui, under);
        dragged_ = 0;
    }
    drawMenu(ui);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void PalettePanel::useSwatch(Ui& ui, std::size_t slot) {
    const std::uint8_t index = ui.session.shownPalette().displayOrder[slot];
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift) {
        editor_.chooseTo(index);
    } else if (io.KeyCtrl) {
        editor_.toggle(index);
    } else {
        editor_.choose(index);
        dragged_ = slot;
    }
    if (ImGui::IsMouseDoubleClicked(0)) dragged_ = 0;
}

void PalettePanel::dropSwatch(Ui& ui, std::size_t slot) {
    if (slot == dragged_) return;
    ui.edits.push(editor_.change("Move colour", withSlotMoved(editor_.palette(), dragged_, slot)));
}

void PalettePanel::drawMenu(Ui& ui) {
    const Theme& theme = ui.theme;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(8, 8));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, theme.px(10, 7));
    if (ImGui::BeginPopup(kMenu)) {
        const std::uint8_t hand = editor_.inHand();
        const std::uint64_t count = editor_.shownCounts(ImGui::GetTime())[menuFor_];
        const std::string voxels = grouped(count) + (count == 1 ? " voxel" : " voxels");
        if (ImGui::MenuItem("Take in hand")) editor_.choose(menuFor_);
        if (ImGui::MenuItem("Duplicate")) {
            editor_.choose(menuFor_);
            ui.commands.ask(CommandId::duplicateColour);
        }
        const std::string select = "Select its " + voxels;
        if (ImGui::MenuItem(select.c_str(), nullptr, false, count > 0)) {
            editor_.choose(menuFor_);
            ui.commands.ask(CommandId::selectByColour);
        }
        const std::string recolour = "Recolour its " + voxels + " to " + std::to_string(hand);
        if (ImGui::MenuItem(recolour.c_str(), nullptr, false, count > 0 && hand != menuFor_)) {
            // Of the voxels in the air, too, once they have come down.
            ui.edits.push(EditQueue::Edit{
                .make = [&editor = editor_, from = menuFor_,
                         hand](const Document&) { return editor.recolour(from, hand); },
                .settles = true});
        }
        ui.probe.markItem("palette.menu.recolour");
        if (ImGui::MenuItem("Swap with the one in hand", nullptr, false, hand != menuFor_)) {
            ui.edits.push(
                editor_.change("Swap colours", withSwapped(editor_.palette(), hand, menuFor_)));
        }
        ui.probe.markItem("palette.menu.swap");
        const VariantIndex variant = ui.session.variant();
        const bool varies =
            variant && editor_.palette().variants[*variant].overrides.contains(menuFor_);
        if (variant && ImGui::MenuItem("Back to the original colour", nullptr, false, varies)) {
            ui.edits.push(
                editor_.change("Palette colour", withColour(editor_.palette(), variant, menuFor_,
                                                            editor_.palette().colours[menuFor_])));
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace voxprite::editor
