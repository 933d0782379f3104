// What the artist chose in this program (and not in the document): tools, what the views show, the
// window. Plain values; panels edit them, and they are kept between runs.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/editor/commands/keymap.h"
#include "app/editor/settings/scene_settings.h"
#include "app/editor/settings/sheet_settings.h"
#include "app/editor/settings/trade_settings.h"
#include "app/editor/tools/tool_options.h"
#include "app/editor/views/navigation.h"
#include "app/editor/window/theme.h"
#include "app/editor/window/window_place.h"
#include "core/base/result.h"
#include "core/edit/patches.h"
#include "render/voxel_occlusion.h"

namespace voxprite::editor {

enum class ToolKind : std::uint8_t {
    brush,
    face,
    laser,
    fill,
    planeFill,
    stamp,
    box,
    line,
    sphere,
    ellipse,
    cylinder,
    selectBox,
    selectRectangle,
    wand,
    pickColour,
    anchor,
    socket,
    move  // what is selected, or the whole object
};
enum class GizmoKind : std::uint8_t { none, move, rotate, scale };
enum class DockTab : std::uint8_t { palette, objects, history, scene, trade };

struct ToolSettings {
    EditMode mode = EditMode::attach;  // what the drawing tools do to voxels
    ToolKind tool = ToolKind::brush;
    ToolKind before = ToolKind::brush;  // where tools good for one click return to
    std::uint8_t colour = 1;
    ToolOptions options;
    GizmoKind gizmo = GizmoKind::move;
    bool socketsInThisFrame = false;  // moving a socket does so in the frame shown alone

    void choose(ToolKind chosen);
    // Leaves a tool that is good for one click, as it would do itself.
    void chooseMode(EditMode chosen);
    // A tool that selects, or does something with what is selected.
    [[nodiscard]] static bool isForSelection(ToolKind tool) {
        return tool == ToolKind::selectBox || tool == ToolKind::selectRectangle ||
               tool == ToolKind::wand || tool == ToolKind::move;
    }
    [[nodiscard]] bool isForOneClick() const {
        return tool == ToolKind::pickColour || tool == ToolKind::anchor;
    }
    bool operator==(const ToolSettings&) const = default;
};

// What is behind the voxels in the edit view.
enum class Backdrop : std::uint8_t { theme, black, grey, white, sky };

// How the edit view draws the voxels: a ray for each pixel, or a mesh; they look the same.
enum class DrawBy : std::uint8_t { automatic, rays, clusters };

struct ViewSettings {
    bool voxelEdges = true;
    bool editGround = true;
    bool boundsBox = false;
    VoxelOcclusion occlusion = VoxelOcclusion::corners;
    bool sunShadow = false;  // in the edit view
    Backdrop backdrop = Backdrop::theme;
    DrawBy drawBy = DrawBy::automatic;
    double clusterBudgetPx = 1.0;  // screen pixels that the mesh may be off, 0 ... 16
    bool tintClusters = false;     // the mesh tells its levels of detail by colours
    bool proxyBox = true;
    bool anchorMarker = true;
    bool groundGrid = false;
    bool shadow = true;
    bool lockCameras = false;
    bool onionSkin = false;  // the frames before and after, in the edit view
    bool socketMarkers = true;
    double framesPerSecond = 8.0;  // of an animation without clips, 0.1 ... 120
    bool playing = false;
    bool operator==(const ViewSettings&) const = default;
};

// A view that is kept under a name. It is told in the model's own measure, so that it shows every
// model the same way.
struct SavedCamera {
    std::string name{};
    double yawDegrees = 0.0;
    double pitchDegrees = 0.0;
    // From the middle of the model, in radii of the sphere around it.
    glm::dvec3 targetRadii{0.0};
    double distanceRadii = 3.0;
    bool orthographic = false;
    bool operator==(const SavedCamera&) const = default;
};

struct InputSettings {
    NavigationPreset navigation = NavigationPreset::magicaVoxel;
    bool invertWheel = false;
    Keymap keys;  // what differs from the defaults
    bool operator==(const InputSettings&) const = default;
};

// The panels' measures are those at content scale 1.
inline constexpr float kLeastScale = 0.75f, kMostScale = 1.75f;
inline constexpr float kLeastSide = 280.0f, kMostSide = 520.0f;
inline constexpr float kLeastDock = 0.2f, kMostDock = 0.75f;

struct WindowSettings {
    WindowPlace place;
    ThemeKind theme = ThemeKind::dark;
    float scale = 1.0f;  // of text and all else, on top of the display's own
    float split = 0.5f;  // share of the edit view, 0.15 ... 0.85
    float sideWidth = 320.0f;
    float dockShare = 0.4f;  // of the height of the side panels
    bool showsTools = true;
    bool showsSide = true;
    bool showsDock = true;
    bool showsTimeline = true;                // where there is an animation
    std::vector<std::string> turnedSections;  // folded, or unfolded, against their default
    bool tourSeen = false;
    int historyMegabytes = 2048;  // most that undo holds
    DockTab dockTab = DockTab::palette;
    std::filesystem::path folder;  // where file dialogs start
    std::vector<std::filesystem::path> recent;

    // The list comes into sight, whatever is folded.
    void show(DockTab list);
    bool operator==(const WindowSettings&) const = default;
};

struct EditorSettings {
    ToolSettings tool;
    ViewSettings view;
    SceneSettings scene;
    TradeSettings trade;
    InputSettings input;
    WindowSettings window;
    std::vector<SavedCamera> cameras;
    SheetSettings sheet;
    bool operator==(const EditorSettings&) const = default;

    // To the top of the recent files, each of which stands there once.
    void remember(const std::filesystem::path& file);
};

// $XDG_CONFIG_HOME/voxprite/editor.json, or under ~/.config.
[[nodiscard]] std::filesystem::path settingsPath();
// Defaults for whatever the file lacks or says wrongly: settings never keep the editor from
// starting.
[[nodiscard]] EditorSettings loadSettings(const std::filesystem::path& path);
// Into the file as it is now, which another editor may have written since these were `before`: of
// its parts ("keys", "window", ...) those that differ, and what it lacks.
[[nodiscard]] Status saveSettings(const std::filesystem::path& path, const EditorSettings& settings,
                                  const EditorSettings& before);

}  // namespace voxprite::editor
