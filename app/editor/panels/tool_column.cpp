// The column on the left: modes, tools, handles, what the views show, and the colour in hand. Two
// abreast, so that all of them are in sight.
#include <algorithm>
#include <cmath>

#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

// Buttons shrink before anything is cut off in a low window.
constexpr float kToolButton = 34.0f, kLeastButton = 22.0f, kGap = 2.0f;
constexpr float kToolRows = 15.0f, kBesides = 112.0f;  // rows of buttons; all that is no button

float buttonSize(const Ui& ui) {
    const float room = ImGui::GetWindowHeight() - ui.theme.px(kBesides);
    const float each = room / kToolRows - ui.theme.px(kGap);
    return std::floor(std::clamp(each, ui.theme.px(kLeastButton), ui.theme.px(kToolButton)));
}

void group(Ui& ui, Lit litWhenOn, std::initializer_list<CommandId> ids) {
    const float size = buttonSize(ui), gap = ui.theme.px(kGap);
    const float left = std::round((ImGui::GetWindowWidth() - 2 * size - gap) * 0.5f);
    ImFont* font = size < ui.theme.px(30) ? ui.theme.fonts.text : ui.theme.fonts.icons;
    bool atLeft = true;
    for (const CommandId id : ids) {
        if (atLeft) ImGui::SetCursorPosX(left);
        if (!atLeft) ImGui::SameLine(0.0f, gap);
        commandButton(ui, id, isOn(id, ui.context) ? litWhenOn : Lit::off, size, font);
        atLeft = !atLeft;
    }
}

void divider(Ui& ui) {
    const Theme& theme = ui.theme;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + theme.px(4), width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine({at.x + theme.px(8), y}, {at.x + width - theme.px(8), y},
                                        theme.line, theme.px(1));
    ImGui::Dummy({width, theme.px(9)});
}

void colourInHand(Ui& ui) {
    const Theme& theme = ui.theme;
    const Rgba8 colour = ui.session.shownPalette().colours[ui.settings.tool.colour];
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 corner(min.x + theme.px(6), min.y + theme.px(8));
    const ImVec2 opposite(min.x + ImGui::GetContentRegionAvail().x - theme.px(6),
                          corner.y + theme.px(24));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, opposite, IM_COL32(colour.x, colour.y, colour.z, 255), theme.px(6));
    draw.AddRect(corner, opposite, theme.fieldActive, theme.px(6));
}

}  // namespace

void drawToolColumn(Ui& ui) {
    using enum CommandId;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.theme.px(0, kGap));
    group(ui, Lit::filled, {modeAttach, modeErase, modePaint, toolPickColour});
    divider(ui);
    group(ui, Lit::filled, {toolBrush, toolFace, toolFill, toolPlaneFill, toolLaser, toolStamp});
    divider(ui);
    group(ui, Lit::filled, {toolBox, toolLine, toolSphere, toolEllipse, toolCylinder});
    divider(ui);
    group(ui, Lit::filled, {toolSelectBox, toolSelectRectangle, toolWand, toolMove});
    divider(ui);
    group(ui, Lit::filled, {toolAnchor, toolSocket});
    divider(ui);
    group(ui, Lit::filled, {gizmoMove, gizmoRotate, gizmoScale});
    divider(ui);
    group(ui, Lit::icon, {toggleProxyBox, toggleAnchorMarker, toggleLockCameras, frameModel});
    colourInHand(ui);
    ImGui::PopStyleVar();
}

}  // namespace voxprite::editor
