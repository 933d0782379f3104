// The scene graph as a list: what is shown, what is locked, what the tools edit; and the frame.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/editor/icons.h"
#include "app/editor/panels/panels.h"
#include "app/editor/widgets.h"
#include "core/edit/scene_edits.h"

namespace voxprite::editor {
namespace {

struct Row {
    int node;
    int depth;
};

// The tree from top to bottom, without the root.
std::vector<Row> rowsOf(const Document& document) {
    std::vector<Row> rows;
    std::vector<Row> open{{0, -1}};
    while (!open.empty()) {
        const Row next = open.back();
        open.pop_back();
        if (next.node != 0) rows.push_back(next);
        const auto& children = document.nodes[static_cast<std::size_t>(next.node)].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            open.push_back({*child, next.depth + 1});
        }
    }
    return rows;
}

std::string displayName(const SceneNode& node, int index) {
    if (!node.name.empty()) return node.name;
    return (node.isGroup() ? "Group " : "Object ") + std::to_string(index);
}

void drawRow(Ui& ui, const Row& row) {
    const Theme& theme = ui.theme;
    const Document& document = ui.session.document();
    const SceneNode& node = document.nodes[static_cast<std::size_t>(row.node)];
    const bool active = row.node == ui.session.activeNode();
    const float height = theme.px(24);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;

    ImGui::PushID(row.node);
    if (ImGui::InvisibleButton("row", {width, height}) && !node.isGroup()) {
        ui.session.setActiveNode(row.node);
    }
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ui.probe.markItem("object." + std::to_string(row.node));
    ImGui::SetItemAllowOverlap();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (active || hovered) {
        draw.AddRectFilled(corner, {corner.x + width, corner.y + height},
                           active ? theme.accentSoft : theme.fieldHovered, theme.px(4));
    }
    const float textY = corner.y + std::floor((height - ImGui::GetFontSize()) * 0.5f);
    const float indent = theme.px(8) + theme.px(12) * static_cast<float>(row.depth);
    const ImU32 colour = node.hidden ? theme.textFaint : active ? theme.accent : theme.text;
    const ImVec4 clip(corner.x, corner.y, corner.x + width - theme.px(56), corner.y + height);
    draw.AddText(node.isGroup() ? theme.fonts.bold : theme.fonts.text, theme.fonts.text->FontSize,
                 {corner.x + indent, textY}, colour, displayName(node, row.node).c_str(), nullptr,
                 0.0f, &clip);
    ImGui::SetCursorScreenPos({corner.x + width - 2 * height, corner.y});
    ImGui::PushStyleColor(ImGuiCol_Text, node.locked ? theme.accent : theme.textFaint);
    if (iconButton(ui, "lock", node.locked ? icon::kLocked : icon::kUnlocked, Lit::off, height,
                   node.locked ? "Unlock" : "Lock: tools leave it alone")) {
        ui.edits.push(setLocked(document, row.node, !node.locked));
    }
    ImGui::PopStyleColor();
    ImGui::SetCursorScreenPos({corner.x + width - height, corner.y});
    ImGui::PushStyleColor(ImGuiCol_Text, node.hidden ? theme.textFaint : theme.textDim);
    if (iconButton(ui, "eye", node.hidden ? icon::kHidden : icon::kVisible, Lit::off, height,
                   node.hidden ? "Show" : "Hide")) {
        ui.edits.push(setHidden(document, row.node, !node.hidden));
    }
    ImGui::PopStyleColor();
    ImGui::PopID();
    ImGui::SetCursorScreenPos({corner.x, corner.y + height});
}

void drawActiveObject(Ui& ui) {
    const int active = ui.session.activeNode();
    if (active < 0) return;
    const Document& document = ui.session.document();
    const SceneNode& node = document.nodes[static_cast<std::size_t>(active)];
    rowLabel(ui, "Name");
    std::string name = node.name;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::InputTextWithHint("##name", displayName(node, active).c_str(), &name,
                             ImGuiInputTextFlags_AutoSelectAll);
    ui.edits.watchItem(ui.session);
    if (name != node.name) {
        Action action = rename(document, active, name);
        action.mergeKey = ui.edits.key();
        ui.edits.push(std::move(action));
    }
    const glm::ivec3 before = node.placements.front().placement.translation;
    glm::dvec3 place(before);
    if (vectorRow(ui, "object.position", "Position", place, {-32768, 32767, 0.1, "%.0f"},
                  "In voxels, in the space of its group")) {
        const glm::ivec3 after(static_cast<int>(std::round(place.x)),
                               static_cast<int>(std::round(place.y)),
                               static_cast<int>(std::round(place.z)));
        if (after != before) {
            ui.edits.push(moveObject(document, active, after, ui.edits.key()));
        }
    }
}

void drawFrames(Ui& ui) {
    if (ui.session.frames() < 2) return;
    const Theme& theme = ui.theme;
    bool& playing = ui.settings.view.playing;
    rowLabel(ui, "Frame");
    const float square = theme.px(24);
    if (iconButton(ui, "frame.play", playing ? icon::kPause : icon::kPlay,
                   playing ? Lit::icon : Lit::off, square, playing ? "Pause" : "Play")) {
        playing = !playing;
    }
    ImGui::SameLine(0.0f, theme.px(4));
    int frame = ui.session.frame() + 1;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const std::string format = "%d of " + std::to_string(ui.session.frames());
    if (ImGui::SliderInt("##frame", &frame, 1, ui.session.frames(), format.c_str(),
                         ImGuiSliderFlags_AlwaysClamp)) {
        playing = false;
        // Every frame of an open document fits: they were baked with the same bounds.
        static_cast<void>(ui.session.setFrame(frame - 1));
    }
    ui.probe.markItem("frame.slider");
}

}  // namespace

void drawObjects(Ui& ui) {
    const Theme& theme = ui.theme;
    const float square = theme.px(24);
    for (const CommandId id :
         {CommandId::addObject, CommandId::duplicateObject, CommandId::deleteObject}) {
        ImGui::BeginDisabled(!isEnabled(id, ui.context));
        commandButton(ui, id, Lit::off, square);
        ImGui::EndDisabled();
        ImGui::SameLine(0.0f, theme.px(4));
    }
    ImGui::NewLine();
    drawFrames(ui);
    drawActiveObject(ui);

    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("list");
    const std::vector<Row> rows = rowsOf(ui.session.document());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), theme.px(24));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(ui, rows[static_cast<std::size_t>(i)]);
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace voxprite::editor
