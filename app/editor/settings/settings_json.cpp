// Each struct is described once, field by field; a reader and a writer follow the description.
#include "app/editor/settings/settings_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace voxprite::editor {
namespace {

using Json = nlohmann::json;

class Writer {
  public:
    explicit Writer(Json& json) : json_(json) {}
    template <class Value>
    void field(const char* name, Value& value) {
        json_[name] = value;
    }
    template <class Value>
    void number(const char* name, Value& value, Value, Value) {
        json_[name] = value;
    }
    template <class Enum>
    void choice(const char* name, Enum& value, Enum) {
        json_[name] = static_cast<int>(value);
    }

  private:
    Json& json_;
};

template <class Value>
Value valueOr(const Json& json, const char* name, Value usual) {
    try {
        return json.value(name, usual);
    } catch (const Json::exception&) {
        return usual;
    }
}

class Reader {
  public:
    explicit Reader(const Json& json) : json_(json) {}
    template <class Value>
    void field(const char* name, Value& value) {
        value = valueOr(json_, name, value);
    }
    template <class Value>
    void number(const char* name, Value& value, Value least, Value most) {
        value = std::clamp(valueOr(json_, name, value), least, most);
    }
    // Kept as whole numbers 0..last.
    template <class Enum>
    void choice(const char* name, Enum& value, Enum last) {
        const int number = valueOr(json_, name, static_cast<int>(value));
        if (number >= 0 && number <= static_cast<int>(last)) value = static_cast<Enum>(number);
    }

  private:
    const Json& json_;
};

template <class Archive>
void describe(Archive archive, ToolSettings& tool) {
    archive.choice("mode", tool.mode, EditMode::paint);
    archive.choice("tool", tool.tool, ToolKind::move);
    archive.choice("gizmo", tool.gizmo, GizmoKind::scale);
    ToolOptions& options = tool.options;
    archive.choice("tip", options.tip, TipShape::disc);
    archive.number("tip_edge", options.tipEdge, 1, kMaxTipEdge);
    archive.field("hollow", options.hollow);
    archive.choice("neighbours", options.neighbours, Neighbours::twentySix);
    archive.field("same_colour", options.sameColour);
    archive.field("inside_selection", options.insideSelection);
    archive.field("in_sight", options.inSight);
}

template <class Archive>
void describe(Archive archive, ViewSettings& view) {
    archive.field("voxel_edges", view.voxelEdges);
    archive.field("edit_ground", view.editGround);
    archive.field("bounds_box", view.boundsBox);
    archive.choice("occlusion", view.occlusion, VoxelOcclusion::rays);
    archive.field("sun_shadow", view.sunShadow);
    archive.choice("backdrop", view.backdrop, Backdrop::sky);
    archive.choice("draw_by", view.drawBy, DrawBy::clusters);
    archive.number("cluster_budget", view.clusterBudgetPx, 0.0, 16.0);
    archive.field("tint_clusters", view.tintClusters);
    archive.field("proxy_box", view.proxyBox);
    archive.field("anchor_marker", view.anchorMarker);
    archive.field("ground_grid", view.groundGrid);
    archive.field("shadow", view.shadow);
    archive.field("lock_cameras", view.lockCameras);
    archive.field("onion_skin", view.onionSkin);
    archive.field("socket_markers", view.socketMarkers);
    archive.number("frames_per_second", view.framesPerSecond, 0.1, 120.0);
}

template <class Archive>
void describe(Archive archive, WindowPlace& place) {
    constexpr int kFar = 1 << 20;
    archive.number("x", place.x, -kFar, kFar);
    archive.number("y", place.y, -kFar, kFar);
    archive.number("width", place.width, 1, kFar);
    archive.number("height", place.height, 1, kFar);
    archive.field("maximized", place.maximized);
    archive.field("known", place.known);
}

template <class Archive>
void describe(Archive archive, WindowSettings& window) {
    archive.choice("theme", window.theme, ThemeKind::light);
    archive.number("scale", window.scale, kLeastScale, kMostScale);
    archive.number("split", window.split, 0.15f, 0.85f);
    archive.number("side_width", window.sideWidth, kLeastSide, kMostSide);
    archive.number("dock_share", window.dockShare, kLeastDock, kMostDock);
    archive.field("shows_tools", window.showsTools);
    archive.field("shows_side", window.showsSide);
    archive.field("shows_dock", window.showsDock);
    archive.field("shows_timeline", window.showsTimeline);
    archive.field("turned_sections", window.turnedSections);
    archive.field("tour_seen", window.tourSeen);
    archive.number("history_megabytes", window.historyMegabytes, 16, 65'536);
    archive.choice("dock_tab", window.dockTab, DockTab::trade);
}

template <class Archive>
void describe(Archive archive, InputSettings& input) {
    archive.choice("navigation", input.navigation, NavigationPreset::trackpad);
    archive.field("invert_wheel", input.invertWheel);
}

template <class Archive>
void describe(Archive archive, SheetSettings& sheet) {
    archive.number("directions", sheet.directions, 1, 360);
    archive.number("first_yaw", sheet.firstYawDegrees, -360.0, 360.0);
    archive.field("pitches", sheet.pitches);
    archive.field("frames", sheet.frames);
    archive.number("sigma", sheet.sigma, 0.0, 64.0);
    archive.choice("outline", sheet.outline, SheetOutline::off);
    archive.field("variants", sheet.variants);
    archive.field("trim", sheet.trim);
    archive.number("padding", sheet.paddingPx, 0, 64);
    archive.number("largest_edge", sheet.largestEdgePx, 16, 16384);
    archive.field("normals", sheet.normals);
    archive.field("depths", sheet.depths);
    archive.field("indices", sheet.indices);
    archive.field("turntable", sheet.turntable);
    archive.choice("turntable_kind", sheet.turntableKind, TurntableKind::gif);
    archive.number("turntable_ms", sheet.turntableMilliseconds, 1, 65535);
    archive.number("magnify", sheet.magnify, 1, 32);
}

template <class Archive>
void describe(Archive archive, SavedCamera& camera) {
    archive.field("name", camera.name);
    archive.number("yaw", camera.yawDegrees, -360.0, 360.0);
    archive.number("pitch", camera.pitchDegrees, -90.0, 90.0);
    archive.number("target_x", camera.targetRadii.x, -1e6, 1e6);
    archive.number("target_y", camera.targetRadii.y, -1e6, 1e6);
    archive.number("target_z", camera.targetRadii.z, -1e6, 1e6);
    archive.number("distance", camera.distanceRadii, 1e-6, 1e6);
    archive.field("orthographic", camera.orthographic);
}

template <class Part>
Json written(const Part& part) {
    Json json = Json::object();
    Part copy = part;
    describe(Writer(json), copy);
    return json;
}

template <class Part>
void read(const Json& json, const char* name, Part& part) {
    const Json object = json.value(name, Json::object());
    describe(Reader(object), part);
}

template <class Part>
void readWhole(const Json& json, const char* name, Part& part, Part (*from)(const Json&)) {
    try {
        part = from(json.value(name, Json::object()));
    } catch (const Json::exception&) {
        part = {};
    }
}

// ["Ctrl+Z", ""]; nothing for what names no keys.
std::optional<std::array<Chord, 2>> chordsFrom(const Json& texts) {
    if (!texts.is_array()) return std::nullopt;
    std::array<Chord, 2> chords{};
    for (std::size_t i = 0; i < std::min(chords.size(), texts.size()); ++i) {
        const auto chord =
            texts[i].is_string() ? chordNamed(texts[i].get<std::string>()) : std::nullopt;
        if (!chord) return std::nullopt;
        chords[i] = *chord;
    }
    return chords;
}

// {"undo": ["Ctrl+Z", ""], ...}: what names no keys keeps its default.
Keymap keymapFrom(const Json& json) {
    Keymap keys;
    for (const auto& [tag, texts] : json.items()) {
        if (const auto chords = chordsFrom(texts)) keys[tag] = *chords;
    }
    return keys;
}

}  // namespace

nlohmann::json jsonOf(const EditorSettings& settings) {
    Json json;
    json["tool"] = written(settings.tool);
    json["view"] = written(settings.view);
    json["window"] = written(settings.window);
    json["place"] = written(settings.window.place);
    json["input"] = written(settings.input);
    json["sheet"] = written(settings.sheet);
    json["scene"] = toJson(settings.scene);
    json["trade"] = toJson(settings.trade);
    json["keys"] = Json::object();
    for (const auto& [tag, chords] : settings.input.keys) {
        json["keys"][tag] = {chordText(chords[0]), chordText(chords[1])};
    }
    json["cameras"] = Json::array();
    for (const SavedCamera& camera : settings.cameras) json["cameras"].push_back(written(camera));
    json["folder"] = settings.window.folder.string();
    json["recent"] = Json::array();
    for (const auto& file : settings.window.recent) json["recent"].push_back(file.string());
    return json;
}

EditorSettings settingsFrom(const nlohmann::json& json) {
    EditorSettings settings;
    read(json, "tool", settings.tool);
    read(json, "view", settings.view);
    read(json, "window", settings.window);
    read(json, "place", settings.window.place);
    read(json, "input", settings.input);
    read(json, "sheet", settings.sheet);
    readWhole(json, "scene", settings.scene, sceneSettingsFrom);
    readWhole(json, "trade", settings.trade, tradeSettingsFrom);
    settings.input.keys = keymapFrom(json.value("keys", Json::object()));
    for (const Json& camera : valueOr(json, "cameras", std::vector<Json>{})) {
        if (camera.is_object()) describe(Reader(camera), settings.cameras.emplace_back());
    }
    settings.window.folder = valueOr(json, "folder", std::string());
    for (const std::string& file : valueOr(json, "recent", std::vector<std::string>{})) {
        settings.window.recent.emplace_back(file);
    }
    return settings;
}

}  // namespace voxprite::editor
