// What the artist chose in this program (and not in the document): tools, what the views show, the
// window. Plain values; panels edit them, and they are kept between runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/stroke.h"
#include "app/editor/theme.h"
#include "core/base/result.h"

namespace voxprite::editor {

enum class Tool : std::uint8_t { attach, erase, paint, pickColour, pickAnchor };
enum class GizmoKind : std::uint8_t { none, move, rotate, scale };
enum class DockTab : std::uint8_t { palette, objects, history };

struct ToolSettings {
    Tool tool = Tool::attach;
    Tool before = Tool::attach;  // where the picking tools, good for one click, return to
    BrushShape shape = BrushShape::voxel;
    std::uint8_t colour = 1;
    GizmoKind gizmo = GizmoKind::move;
    bool operator==(const ToolSettings&) const = default;
};

struct ViewSettings {
    bool voxelEdges = true;
    bool editGround = true;
    bool proxyBox = true;
    bool anchorMarker = true;
    bool groundGrid = false;
    bool shadow = true;
    bool lockCameras = false;
    bool playing = false;
    bool operator==(const ViewSettings&) const = default;
};

struct WindowSettings {
    ThemeKind theme = ThemeKind::dark;
    float split = 0.5f;  // share of the edit view, 0.15 ... 0.85
    DockTab dockTab = DockTab::palette;
    std::filesystem::path folder;  // where file dialogs start
    std::vector<std::filesystem::path> recent;
    bool operator==(const WindowSettings&) const = default;
};

struct EditorSettings {
    ToolSettings tool;
    ViewSettings view;
    WindowSettings window;
    bool operator==(const EditorSettings&) const = default;

    // To the top of the recent files, each of which stands there once.
    void remember(const std::filesystem::path& file);
};

// $XDG_CONFIG_HOME/voxprite/editor.json, or under ~/.config.
[[nodiscard]] std::filesystem::path settingsPath();
// Defaults for whatever the file lacks or says wrongly: settings never keep the editor from
// starting.
[[nodiscard]] EditorSettings loadSettings(const std::filesystem::path& path);
[[nodiscard]] Status saveSettings(const std::filesystem::path& path,
                                  const EditorSettings& settings);

}  // namespace voxprite::editor
