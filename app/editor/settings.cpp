#include "app/editor/settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/file.h"

namespace voxprite::editor {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxRecent = 12;

std::filesystem::path fromEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? std::filesystem::path(value) : std::filesystem::path();
}

// Enumerations are kept as whole numbers 0..last.
template <class Enum>
void readEnum(const Json& json, const char* name, Enum last, Enum& value) {
    const int number = json.value(name, static_cast<int>(value));
    if (number >= 0 && number <= static_cast<int>(last)) value = static_cast<Enum>(number);
}

// {"undo": ["Ctrl+Z", ""], ...}: what is said wrongly keeps its default.
void readKeys(const Json& json, Keymap& keys) {
    const Json bound = json.value("keys", Json::object());
    for (const auto& [tag, texts] : bound.items()) {
        std::array<Chord, 2> chords{};
        bool good = true;
        for (std::size_t i = 0; i < std::min(chords.size(), texts.size()); ++i) {
            const auto chord = chordNamed(texts.at(i).get<std::string>());
            good = good && chord;
            if (chord) chords[i] = *chord;
        }
        if (good) keys[tag] = chords;
    }
}

void read(const Json& json, EditorSettings& settings) {
    ToolSettings& tool = settings.tool;
    readEnum(json, "mode", EditMode::paint, tool.mode);
    readEnum(json, "tool", ToolKind::socket, tool.tool);
    readEnum(json, "gizmo", GizmoKind::scale, tool.gizmo);
    ToolOptions& options = tool.options;
    readEnum(json, "tip", TipShape::disc, options.tip);
    options.tipEdge = std::clamp(json.value("tip_edge", options.tipEdge), 1, kMaxTipEdge);
    options.hollow = json.value("hollow", options.hollow);
    readEnum(json, "neighbours", Neighbours::twentySix, options.neighbours);
    options.sameColour = json.value("same_colour", options.sameColour);
    ViewSettings& view = settings.view;
    view.voxelEdges = json.value("voxel_edges", view.voxelEdges);
    view.editGround = json.value("edit_ground", view.editGround);
    view.proxyBox = json.value("proxy_box", view.proxyBox);
    view.anchorMarker = json.value("anchor_marker", view.anchorMarker);
    view.groundGrid = json.value("ground_grid", view.groundGrid);
    view.shadow = json.value("shadow", view.shadow);
    view.lockCameras = json.value("lock_cameras", view.lockCameras);
    settings.scene = sceneSettingsFrom(json.value("scene", Json::object()));
    WindowSettings& window = settings.window;
    readEnum(json, "theme", ThemeKind::light, window.theme);
    readEnum(json, "dock_tab", DockTab::scene, window.dockTab);
    window.split = std::clamp(json.value("split", window.split), 0.15f, 0.85f);
    window.folder = json.value("folder", std::string());
    for (const Json& file : json.value("recent", Json::array())) {
        window.recent.emplace_back(file.get<std::string>());
    }
    readKeys(json, settings.keys);
}

}  // namespace

void ToolSettings::choose(ToolKind chosen) {
    if (!isForOneClick()) before = tool;
    tool = chosen;
}

void ToolSettings::chooseMode(EditMode chosen) {
    mode = chosen;
    if (isForOneClick()) tool = before;
}

void EditorSettings::remember(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::path full = std::filesystem::absolute(file, ignored).lexically_normal();
    std::erase(window.recent, full);
    window.recent.insert(window.recent.begin(), full);
    if (window.recent.size() > kMaxRecent) window.recent.resize(kMaxRecent);
    window.folder = full.parent_path();
}

std::filesystem::path settingsPath() {
    std::filesystem::path base = fromEnvironment("XDG_CONFIG_HOME");
    if (base.empty()) base = fromEnvironment("HOME") / ".config";
    return base / "voxprite" / "editor.json";
}

EditorSettings loadSettings(const std::filesystem::path& path) {
    const Result<std::string> text = readTextFile(path);
    if (!text) return {};
    try {
        EditorSettings settings;
        read(Json::parse(*text), settings);
        return settings;
    } catch (const Json::exception&) {
        return {};
    }
}

Status saveSettings(const std::filesystem::path& path, const EditorSettings& settings) {
    Json json;
    json["mode"] = static_cast<int>(settings.tool.mode);
    json["tool"] = static_cast<int>(settings.tool.tool);
    json["gizmo"] = static_cast<int>(settings.tool.gizmo);
    const ToolOptions& options = settings.tool.options;
    json["tip"] = static_cast<int>(options.tip);
    json["tip_edge"] = options.tipEdge;
    json["hollow"] = options.hollow;
    json["neighbours"] = static_cast<int>(options.neighbours);
    json["same_colour"] = options.sameColour;
    json["voxel_edges"] = settings.view.voxelEdges;
    json["edit_ground"] = settings.view.editGround;
    json["proxy_box"] = settings.view.proxyBox;
    json["anchor_marker"] = settings.view.anchorMarker;
    json["ground_grid"] = settings.view.groundGrid;
    json["shadow"] = settings.view.shadow;
    json["lock_cameras"] = settings.view.lockCameras;
    json["scene"] = toJson(settings.scene);
    json["theme"] = static_cast<int>(settings.window.theme);
    json["dock_tab"] = static_cast<int>(settings.window.dockTab);
    json["split"] = settings.window.split;
    json["folder"] = settings.window.folder.string();
    json["recent"] = Json::array();
    for (const auto& file : settings.window.recent) json["recent"].push_back(file.string());
    json["keys"] = Json::object();
    for (const auto& [tag, chords] : settings.keys) {
        json["keys"][tag] = {chordText(chords[0]), chordText(chords[1])};
    }

    std::error_code failed;
    std::filesystem::create_directories(path.parent_path(), failed);
    if (failed) return failInFile(path.string(), failed.message());
    // Paths need not be UTF-8.
    return writeFileAtomically(path,
                               json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace voxprite::editor
