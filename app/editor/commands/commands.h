// Everything that a menu, a button, a key or the command palette can ask for. Each area of the
// program keeps its own table (commands/tables.h); all of them are read as one here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/editor/commands/keymap.h"

namespace voxprite::editor {

struct CommandContext;

enum class CommandId : std::uint8_t {
    // File
    newFile,
    open,
    save,
    saveAs,
    exportOctree,
    exportSheet,
    openProfile,
    saveProfile,
    saveProfileAs,
    quit,
    // Edit
    undo,
    redo,
    cutVoxels,
    copyVoxels,
    pasteVoxels,
    duplicateVoxels,
    deleteVoxels,
    // Selection
    selectAllVoxels,
    selectNone,
    invertSelected,
    selectByColour,
    editInsideSelection,
    toolMove,
    nudgeRight,
    nudgeLeft,
    nudgeBack,
    nudgeFront,
    nudgeRaise,
    nudgeLower,
    turnVoxelsX,
    turnVoxelsY,
    turnVoxelsZ,
    turnVoxelsBackZ,
    flipVoxelsX,
    flipVoxelsY,
    flipVoxelsZ,
    scaleVoxels,
    recolourVoxels,
    cropVoxels,
    voxelsToObject,
    hollowOut,
    dilateVoxels,
    erodeVoxels,
    smoothVoxels,
    centreVoxels,
    dropToGround,
    trimToLimits,
    // Objects
    addObject,
    duplicateObject,
    duplicateLinked,
    makeSingleUser,
    renameObject,
    groupObjects,
    ungroupObjects,
    mergeObjects,
    deleteObject,
    hideObject,
    lockObject,
    turnObjectX,
    turnObjectY,
    turnObjectZ,
    mirrorObjectX,
    mirrorObjectY,
    mirrorObjectZ,
    // Animation
    togglePlaying,
    previousFrame,
    nextFrame,
    addFrame,
    addHeldFrame,
    addEmptyFrame,
    deleteFrame,
    addClip,
    toggleOnionSkin,
    toggleTimeline,
    // Tools
    modeAttach,
    modeErase,
    modePaint,
    toolBrush,
    toolFace,
    toolLaser,
    toolFill,
    toolPlaneFill,
    toolStamp,
    toolBox,
    toolLine,
    toolSphere,
    toolEllipse,
    toolCylinder,
    toolSelectBox,
    toolSelectRectangle,
    toolWand,
    toolPickColour,
    toolAnchor,
    toolSocket,
    keepMade,
    dropMade,
    tipSmaller,
    tipLarger,
    mirrorX,
    mirrorY,
    mirrorZ,
    centreMirrors,
    toggleHollow,
    toggleLimits,
    gizmoMove,
    gizmoRotate,
    gizmoScale,
    // View
    frameModel,
    frameSelection,
    viewFront,
    viewBack,
    viewRight,
    viewLeft,
    viewTop,
    viewBottom,
    viewIsometric,
    toggleOrthographic,
    toggleEdges,
    toggleEditGround,
    toggleBounds,
    occlusionOff,
    occlusionCorners,
    occlusionRays,
    drawByAutomatic,
    drawByRays,
    drawByClusters,
    toggleClusterTint,
    toggleSunShadow,
    toggleProxyBox,
    toggleAnchorMarker,
    toggleGroundGrid,
    toggleShadow,
    toggleLockCameras,
    themeDark,
    themeLight,
    // Scene of the sprite view
    compareTwo,
    compareFour,
    gameDistance4,
    gameDistance2,
    gameDistance1,
    frameScene,
    addSceneModel,
    toggleSinglePass,
    drawExact,
    drawAutomatic,
    drawSnapshots,
    drawClusters,
    drawCoarse,
    halveErrorBudget,
    doubleErrorBudget,
    tintByChoice,
    compareRepresentations,
    flyRepresentations,
    representationsNearer,
    representationsFarther,
    saveSprite,
    copySprite,
    // Speed against accuracy
    showTrade,
    toggleHeat,
    nextHeatYardstick,
    flipSides,
    wipeSides,
    swapSides,
    applyB,
    keepAsB,
    saveSettingA,
    cheapestWithin,
    pinReference,
    measureAgain,
    cancelMeasuring,
    // Palette
    lastColour,
    nextColour,
    duplicateColour,
    swapColours,
    gradientColours,
    removeUnusedColours,
    sortByHue,
    sortByLightness,
    sortByUse,
    sortByIndex,
    makeRamp,
    suggestRamps,
    removeRamp,
    addVariant,
    showNextVariant,
    importPalette,
    exportPalette,
    savedCameras,
    toggleTools,
    toggleSide,
    toggleDock,
    togglePanels,
    // Help
    commandPalette,
    keyList,
    tour,
    preferences,
    about
};

enum class MenuId : std::uint8_t {
    none,
    file,
    edit,
    select,
    object,
    animation,
    tool,
    palette,
    view,
    help
};

struct Command {
    CommandId id = CommandId::newFile;
    // Its name in the settings; once released it stays: "undo".
    const char* tag = "";
    MenuId menu = MenuId::none;
    const char* group = "";  // the menu within the menu; commands of one group stand together
    const char* name = "";
    const char* icon = "";
    std::array<Chord, 2> chords{};  // unless the settings say otherwise; {} is none
    bool separator = false;         // above it in its menu
    bool repeats = false;           // while its key is held
    bool settles = false;           // what is in the air, or being made, is put down first
    void (*run)(CommandContext& context) = nullptr;
    // Can it be used now? Always, when there is none.
    bool (*enabled)(const CommandContext& context) = nullptr;
    // Is the state that it stands for on? Without: it has no state.
    bool (*on)(const CommandContext& context) = nullptr;
};

// All areas' commands in the order of their menus.
[[nodiscard]] std::span<const Command> commands();
[[nodiscard]] const Command& commandOf(CommandId id);
[[nodiscard]] const char* titleOf(MenuId menu);  // "File"
[[nodiscard]] bool isEnabled(CommandId id, const CommandContext& context);
[[nodiscard]] bool isOn(CommandId id, const CommandContext& context);

// What the keys mean: the defaults of the tables but for what the artist bound otherwise.
[[nodiscard]] const std::array<Chord, 2>& chordsOf(const Command& command, const Keymap& keymap);
// What differs from the defaults is kept, nothing else.
void bindKeys(Keymap& keymap, const Command& command, const std::array<Chord, 2>& chords);
// Other commands that the same keys mean; none for no key.
[[nodiscard]] std::vector<const Command*> conflictsOf(const Command& command, const Chord& chord,
                                                      const Keymap& keymap);
// "Also means: Redo, Quit", or nothing.
[[nodiscard]] std::string conflictText(const Command& command, const Keymap& keymap);
// Whose name, menu or keys contain the words of the query; in the order of the menus.
[[nodiscard]] std::vector<const Command*> commandsWithKey(std::string_view query,
                                                          const Keymap& keymap);
// "Undo  (Ctrl+Z)"
[[nodiscard]] std::string nameWithKey(CommandId id, const Keymap& keymap);

// What the user asked for this frame, run once the user interface has been built.
class CommandQueue {
  public:
    void ask(CommandId id) { asked_.push_back(id); }
    // Asks for whatever the keys pressed this frame mean; none while text is being typed or a
    // dialog is in front.
    void askByKeys(const Keymap& keymap);
    // Those that still wait are no longer wanted.
    void forget(CommandId id) { std::erase(asked_, id); }
    [[nodiscard]] std::vector<CommandId> take() { return std::exchange(asked_, {}); }
    [[nodiscard]] bool any() const { return !asked_.empty(); }

  private:
    std::vector<CommandId> asked_;
};

}  // namespace voxprite::editor
