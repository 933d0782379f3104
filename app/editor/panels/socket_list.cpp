// The sockets, below the objects.
#include <imgui.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/objects.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/window/icons.h"
#include "core/edit/socket_edits.h"

namespace voxprite::editor {
namespace {

void drawHeading(Ui& ui) {
    const Theme& theme = ui.theme;
    ImGui::Dummy({0, theme.px(8)});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = theme.px(24);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(theme.fonts.bold, theme.fonts.bold->FontSize,
                 {corner.x + theme.px(4), corner.y + theme.px(4)}, theme.text, "Sockets");
    ImGui::SetCursorScreenPos({corner.x + width - 2 * height, corner.y});
    commandButton(ui, CommandId::toolSocket,
                  isOn(CommandId::toolSocket, ui.context) ? Lit::filled : Lit::off, height);
    ImGui::SetCursorScreenPos({corner.x + width - height, corner.y});
    bool& shown = ui.settings.view.socketMarkers;
    ImGui::PushStyleColor(ImGuiCol_Text, shown ? theme.textDim : theme.textFaint);
    if (iconButton(ui, "sockets.eye", shown ? icon::kVisible : icon::kHidden, Lit::off, height,
                   shown ? "Hide the marks in both views" : "Show the marks in both views")) {
        shown = !shown;
    }
    ImGui::PopStyleColor();
    ImGui::SetCursorScreenPos({corner.x, corner.y + height});
}

void drawRow(Ui& ui, int index) {
    const Theme& theme = ui.theme;
    const Document& document = ui.session.document();
    const Socket& socket = document.sockets[static_cast<std::size_t>(index)];
    ObjectSelection& objects = ui.context.objects;
    ImGui::PushID(index);
    const bool chosen = objects.socket() == index;
    const ListRow row = beginRow(ui, "socket." + std::to_string(index), chosen);
    if (row.clicked) objects.chooseSocket(index);
    if (row.doubleClicked) objects.renameSocket(index);
    const float y = row.middle(theme.fonts.text->FontSize);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText({row.corner.x + theme.px(20), y}, chosen ? theme.accent : theme.textDim,
                 icon::kSocket);
    const float indent = theme.px(42), end = row.width - row.height;
    if (objects.renamingSocket() == index) {
        std::string name = socket.name;
        if (!typeName(ui, row, indent, end, name)) objects.renameSocket(std::nullopt);
        if (name != socket.name) {
            Action action = renameSocket(document, index, name);
            action.mergeKey = ui.edits.key();
            ui.edits.push(std::move(action));
        }
    } else {
        const ImVec4 clip(row.corner.x, row.corner.y, row.corner.x + end,
                          row.corner.y + row.height);
        draw.AddText(theme.fonts.text, theme.fonts.text->FontSize, {row.corner.x + indent, y},
                     chosen ? theme.accent : theme.text, socket.name.c_str(), nullptr, 0.0f, &clip);
    }
    if (row.hovered || chosen) {
        ImGui::SetCursorScreenPos({row.corner.x + row.width - row.height, row.corner.y});
        ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
        if (iconButton(ui, "socket.delete", icon::kDelete, Lit::off, row.height, "Delete socket")) {
            ui.edits.push(deleteSocket(document, index));
        }
        ImGui::PopStyleColor();
    }
    endRow(row);
    ImGui::PopID();
}

}  // namespace

void drawSocketList(Ui& ui) {
    const Theme& theme = ui.theme;
    ImGui::PushID("sockets");
    drawHeading(ui);
    const auto count = static_cast<int>(ui.session.document().sockets.size());
    // What was chosen elsewhere, by a click in the view, comes into sight.
    const int chosen = ui.context.objects.socket().value_or(-1);
    int& inSight = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen"), -1);
    for (int index = 0; index < count; ++index) {
        drawRow(ui, index);
        if (index == chosen && inSight != chosen) ImGui::SetScrollHereY(1.0f);
    }
    inSight = chosen;
    if (count == 0) {
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + theme.px(4));
        ImGui::PushStyleColor(ImGuiCol_Text, theme.textFaint);
        ImGui::PushFont(theme.fonts.small);
        ImGui::TextUnformatted("Points such as hand or muzzle, for the game");
        ImGui::PopFont();
        ImGui::PopStyleColor();
    }
    ImGui::PopID();
}

}  // namespace voxprite::editor
