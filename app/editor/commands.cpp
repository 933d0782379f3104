#include "app/editor/commands.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "app/editor/icons.h"
#include "app/editor/input.h"

namespace voxprite::editor {
namespace {

constexpr Chord key(int code) {
    return {code, false, false};
}
constexpr Chord control(int code) {
    return {code, true, false};
}
constexpr Chord controlShift(int code) {
    return {code, true, true};
}

using enum CommandId;
constexpr Chord kNone{};

constexpr std::array kCommands{
    Command{newFile, MenuId::file, "New", icon::kFile, control(GLFW_KEY_N), kNone, false},
    Command{open, MenuId::file, "Open…", icon::kOpen, control(GLFW_KEY_O), kNone, false},
    Command{save, MenuId::file, "Save", icon::kSave, control(GLFW_KEY_S), kNone, true},
    Command{saveAs, MenuId::file, "Save as…", "", controlShift(GLFW_KEY_S), kNone, false},
    Command{exportOctree, MenuId::file, "Export octree…", icon::kExport, control(GLFW_KEY_E), kNone,
            false},
    Command{openProfile, MenuId::file, "Open game profile…", "", kNone, kNone, true},
    Command{saveProfile, MenuId::file, "Save game profile", "", kNone, kNone, false},
    Command{saveProfileAs, MenuId::file, "Save game profile as…", "", kNone, kNone, false},
    Command{quit, MenuId::file, "Quit", "", control(GLFW_KEY_Q), kNone, true},

    Command{undo, MenuId::edit, "Undo", icon::kUndo, control(GLFW_KEY_Z), kNone, false},
    Command{redo, MenuId::edit, "Redo", icon::kRedo, control(GLFW_KEY_Y), controlShift(GLFW_KEY_Z),
            false},
    Command{addObject, MenuId::edit, "Add object", icon::kPlus, kNone, kNone, true},
    Command{duplicateObject, MenuId::edit, "Duplicate object", icon::kCopy, control(GLFW_KEY_D),
            kNone, false},
    Command{deleteObject, MenuId::edit, "Delete object", icon::kDelete, kNone, kNone, false},

    Command{attach, MenuId::tool, "Attach", icon::kAttach, key(GLFW_KEY_T), kNone, false},
    Command{erase, MenuId::tool, "Erase", icon::kErase, key(GLFW_KEY_R), kNone, false},
    Command{paint, MenuId::tool, "Paint", icon::kPaint, key(GLFW_KEY_G), kNone, false},
    Command{pickColour, MenuId::tool, "Pick colour", icon::kPickColour, key(GLFW_KEY_I), kNone,
            false},
    Command{pickAnchor, MenuId::tool, "Set anchor", icon::kPickAnchor, key(GLFW_KEY_A), kNone,
            false},
    Command{shapeVoxel, MenuId::tool, "Single voxels", icon::kVoxel, key(GLFW_KEY_V), kNone, true},
    Command{shapeBox, MenuId::tool, "Boxes", icon::kBox, key(GLFW_KEY_B), kNone, false},
    Command{gizmoMove, MenuId::tool, "Move proxy box", icon::kMove, key(GLFW_KEY_W), kNone, true},
    Command{gizmoRotate, MenuId::tool, "Rotate proxy box", icon::kRotate, key(GLFW_KEY_E), kNone,
            false},
    Command{gizmoScale, MenuId::tool, "Scale proxy box", icon::kScale, key(GLFW_KEY_S), kNone,
            false},

    Command{frameModel, MenuId::view, "Frame the model", icon::kFit, key(GLFW_KEY_F),
            key(GLFW_KEY_HOME), false},
    Command{viewFront, MenuId::view, "From the front", "", key(GLFW_KEY_1), kNone, false},
    Command{viewRight, MenuId::view, "From the right", "", key(GLFW_KEY_3), kNone, false},
    Command{viewTop, MenuId::view, "From above", "", key(GLFW_KEY_7), kNone, false},
    Command{toggleLockCameras, MenuId::view, "Lock the cameras together", icon::kLink,
            key(GLFW_KEY_L), kNone, true},
    Command{toggleEdges, MenuId::view, "Voxel edges", "", kNone, kNone, true},
    Command{toggleEditGround, MenuId::view, "Grid under the model", "", kNone, kNone, false},
    Command{toggleProxyBox, MenuId::view, "Proxy box", icon::kWireframe, key(GLFW_KEY_P), kNone,
            true},
    Command{toggleAnchorMarker, MenuId::view, "Anchor marker", icon::kAnchor, key(GLFW_KEY_O),
            kNone, false},
    Command{toggleGroundGrid, MenuId::view, "Ground lines, one a metre", "", kNone, kNone, false},
    Command{toggleShadow, MenuId::view, "Shadow", "", kNone, kNone, false},
    Command{themeDark, MenuId::view, "Dark theme", icon::kDark, kNone, kNone, true},
    Command{themeLight, MenuId::view, "Light theme", icon::kLight, kNone, kNone, false},
    Command{about, MenuId::view, "About voxprite", icon::kInfo, kNone, kNone, true},
};

bool isPressed(const Chord& chord, const ImGuiIO& io) {
    return chord.key != 0 && io.KeyCtrl == chord.control && io.KeyShift == chord.shift &&
           !io.KeyAlt && ImGui::IsKeyPressed(chord.key, false);
}

}  // namespace

std::span<const Command> commands() {
    return kCommands;
}

const Command& commandOf(CommandId id) {
    return *std::ranges::find(kCommands, id, &Command::id);
}

std::string chordText(const Chord& chord) {
    if (chord.key == 0) return {};
    std::string text;
    if (chord.control) text += "Ctrl+";
    if (chord.shift) text += "Shift+";
    std::string name(keyName(chord.key).value_or(""));
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(name[0]));
    return text + name;
}

void CommandQueue::askByKeys() {
    const ImGuiIO& io = ImGui::GetIO();
    // A dialog in front takes all keys.
    const bool dialog = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    if (io.WantTextInput || dialog) return;
    for (const Command& command : kCommands) {
        if (isPressed(command.chord, io) || isPressed(command.otherChord, io)) ask(command.id);
    }
}

}  // namespace voxprite::editor
