// The narrow column on the left: tools, brush shapes, gizmos, what the views show.
#include <algorithm>
#include <cmath>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets.h"

namespace voxprite::editor {
namespace {

// Buttons shrink before anything is cut off in a low window.
constexpr float kButton = 36.0f, kLeastButton = 24.0f;
constexpr float kButtons = 15.0f, kBesides = 112.0f;

float buttonSize(const Ui& ui) {
    const float room = ImGui::GetWindowHeight() - ui.theme.px(kBesides);
    return std::floor(std::clamp(room / kButtons, ui.theme.px(kLeastButton), ui.theme.px(kButton)));
}

void group(Ui& ui, Lit litWhenOn, std::initializer_list<CommandId> ids) {
    const float size = buttonSize(ui);
    ImFont* font = size < ui.theme.px(30) ? ui.theme.fonts.text : ui.theme.fonts.icons;
    for (const CommandId id : ids) {
        ImGui::SetCursorPosX(std::round((ImGui::GetWindowWidth() - size) * 0.5f));
        commandButton(ui, id, isOn(id, ui.settings) ? litWhenOn : Lit::off, size, font);
    }
}

void divider(Ui& ui) {
    const Theme& theme = ui.theme;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + theme.px(4);
    ImGui::GetWindowDrawList()->AddLine({at.x + theme.px(6), y}, {at.x + theme.px(30), y},
                                        theme.line, theme.px(1));
    ImGui::Dummy({theme.px(36), theme.px(9)});
}

}  // namespace

void drawToolColumn(Ui& ui) {
    using enum CommandId;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.theme.px(0, 2));
    group(ui, Lit::filled, {attach, erase, paint, pickColour, pickAnchor});
    divider(ui);
    group(ui, Lit::filled, {shapeVoxel, shapeBox});
    divider(ui);
    group(ui, Lit::filled, {gizmoMove, gizmoRotate, gizmoScale});
    divider(ui);
    group(ui, Lit::icon, {toggleProxyBox, toggleAnchorMarker, toggleLockCameras, frameModel});

    // The colour in hand, always in sight.
    const Theme& theme = ui.theme;
    const Rgba8 colour = ui.session.document().palette.colours[ui.settings.tool.colour];
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 corner(min.x + theme.px(5), min.y + theme.px(10));
    ImGui::GetWindowDrawList()->AddRectFilled(
        corner, {corner.x + theme.px(26), corner.y + theme.px(26)},
        IM_COL32(colour.x, colour.y, colour.z, 255), theme.px(6));
    ImGui::GetWindowDrawList()->AddRect(corner, {corner.x + theme.px(26), corner.y + theme.px(26)},
                                        theme.fieldActive, theme.px(6));
    ImGui::PopStyleVar();
}

}  // namespace voxprite::editor
