// What the document is made of: the tree of objects and groups, the sockets below it, and the
// placement of what is chosen.
#include "app/editor/panels/objects.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/window/icons.h"
#include "core/edit/scene_edits.h"
#include "core/edit/socket_edits.h"

namespace voxprite::editor {
namespace {

void drawToolbar(Ui& ui) {
    constexpr std::array kFirst{CommandId::addObject, CommandId::duplicateObject,
                                CommandId::duplicateLinked, CommandId::makeSingleUser};
    constexpr std::array kSecond{CommandId::groupObjects, CommandId::ungroupObjects,
                                 CommandId::mergeObjects};
    const Theme& theme = ui.theme;
    const float square = theme.px(24), gap = theme.px(2);
    const auto button = [&](CommandId id, float after) {
        ImGui::BeginDisabled(!isEnabled(id, ui.context));
        commandButton(ui, id, Lit::off, square);
        ImGui::EndDisabled();
        ImGui::SameLine(0.0f, after);
    };
    for (const CommandId id : kFirst) button(id, id == kFirst.back() ? theme.px(10) : gap);
    for (const CommandId id : kSecond) button(id, id == kSecond.back() ? theme.px(10) : gap);
    const std::string animate = nameWithKey(CommandId::addFrame, ui.settings.input.keys);
    if (iconButton(ui, "objects.addFrame", icon::kFilm, Lit::off, square, animate.c_str())) {
        ui.commands.ask(CommandId::addFrame);
    }
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - square);
    button(CommandId::deleteObject, 0.0f);
    ImGui::NewLine();
}

// A row of small buttons, one an axis.
void axisButtons(Ui& ui, std::array<CommandId, 3> commands) {
    constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};
    const Theme& theme = ui.theme;
    const float gap = theme.px(4), height = theme.px(24);
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis > 0) ImGui::SameLine(0.0f, gap);
        const Command& command = commandOf(commands[axis]);
        ImGui::PushID(command.tag);
        const std::string label = std::string(command.icon) + " " + kAxes[axis];
        if (ImGui::Button(label.c_str(), {width, height})) ui.commands.ask(command.id);
        ui.probe.markItem(std::string("command.") + command.tag);
        tooltip(ui, nameWithKey(command.id, ui.settings.input.keys).c_str());
        ImGui::PopID();
    }
}

void drawPlacement(Ui& ui, int node) {
    const Document& document = ui.session.document();
    // What a drag has asked for may not be in force yet.
    const SceneState* dragged = ui.context.files.draggedScene();
    const auto& nodes = dragged != nullptr ? dragged->nodes : document.nodes;
    const glm::ivec3 before =
        nodes[static_cast<std::size_t>(node)].placements.front().placement.translation;
    glm::dvec3 place(before);
    if (vectorRow(ui, "object.position", "Position", place, {-32768, 32767, 0.1, "%.0f"},
                  "In voxels, in the space of its group")) {
        const glm::ivec3 after(glm::round(place));
        if (after != before) {
            const std::uint64_t key = ui.edits.key();
            ui.edits.pushScene(
                [=](const Document& now) { return moveObject(now, node, after, key); }, key);
        }
    }
    rowLabel(ui, "Turn", "By 90 degrees around its middle");
    axisButtons(ui, {CommandId::turnObjectX, CommandId::turnObjectY, CommandId::turnObjectZ});
    rowLabel(ui, "Mirror", "In place");
    axisButtons(ui, {CommandId::mirrorObjectX, CommandId::mirrorObjectY, CommandId::mirrorObjectZ});
}

void drawSocket(Ui& ui, int index) {
    const Document& document = ui.session.document();
    const int frame = ui.session.frame();
    const glm::dvec3 before = positionAt(document.sockets[static_cast<std::size_t>(index)], frame);
    glm::dvec3 place = before;
    if (vectorRow(ui, "socket.position", "Position", place, {-1e6, 1e6, 0.1, "%.1f"},
                  "In voxels, in the space of the entity") &&
        place != before) {
        const SocketReach reach =
            ui.settings.tool.socketsInThisFrame ? SocketReach::thisFrame : SocketReach::allFrames;
        ui.edits.push(moveSocket(document, index, frame, place, reach, ui.edits.key()));
    }
    if (ui.session.frames() < 2) return;
    static_cast<void>(switchRow(ui, "socket.thisFrame", "This frame",
                                ui.settings.tool.socketsInThisFrame,
                                "Moving the socket leaves the other frames as they are"));
}

}  // namespace

void drawObjects(Ui& ui) {
    const Theme& theme = ui.theme;
    drawToolbar(ui);
    const std::optional<int> socket = ui.context.objects.socket();
    const int node = ui.context.objects.node(ui.session);
    int rows = 0;
    if (socket) {
        rows = ui.session.frames() > 1 ? 2 : 1;
    } else if (node > 0) {
        rows = 3;
    }
    const float rowHeight = theme.px(24) + ImGui::GetStyle().ItemSpacing.y;
    const float list = ImGui::GetContentRegionAvail().y - rowHeight * static_cast<float>(rows) -
                       (rows > 0 ? theme.px(4) : 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("list", {0, std::max(list, theme.px(48))});
    drawObjectTree(ui);
    drawSocketList(ui);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    if (rows == 0) return;
    ImGui::Dummy({0, theme.px(4) - ImGui::GetStyle().ItemSpacing.y});
    if (socket) {
        drawSocket(ui, *socket);
    } else {
        drawPlacement(ui, node);
    }
}

}  // namespace voxprite::editor
