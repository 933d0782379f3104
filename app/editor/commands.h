// Everything that a menu, a button or a key can ask for, in one table.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace voxprite::editor {

enum class CommandId : std::uint8_t {
    newFile,
    open,
    save,
    saveAs,
    exportOctree,
    openProfile,
    saveProfile,
    saveProfileAs,
    quit,
    undo,
    redo,
    addObject,
    duplicateObject,
    deleteObject,
    attach,
    erase,
    paint,
    pickColour,
    pickAnchor,
    shapeVoxel,
    shapeBox,
    gizmoMove,
    gizmoRotate,
    gizmoScale,
    frameModel,
    viewFront,
    viewRight,
    viewTop,
    toggleEdges,
    toggleEditGround,
    toggleProxyBox,
    toggleAnchorMarker,
    toggleGroundGrid,
    toggleShadow,
    toggleLockCameras,
    themeDark,
    themeLight,
    about
};

enum class MenuId : std::uint8_t { none, file, edit, tool, view };

struct Chord {
    int key = 0;  // GLFW's number; 0 is none
    bool control = false;
    bool shift = false;
};

struct Command {
    CommandId id;
    MenuId menu;
    const char* name;
    const char* icon;  // may be empty
    Chord chord;
    Chord otherChord;  // does the same
    bool separator;    // above it in its menu
};

[[nodiscard]] std::span<const Command> commands();
[[nodiscard]] const Command& commandOf(CommandId id);
// "Ctrl+Shift+Z", or nothing.
[[nodiscard]] std::string chordText(const Chord& chord);

// What the user asked for this frame, run once the user interface has been built.
class CommandQueue {
  public:
    void ask(CommandId id) { asked_.push_back(id); }
    // Asks for whatever the keys pressed this frame mean; none while text is being typed.
    void askByKeys();
    [[nodiscard]] std::vector<CommandId> take() { return std::exchange(asked_, {}); }

  private:
    std::vector<CommandId> asked_;
};

}  // namespace voxprite::editor
