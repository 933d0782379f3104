#include "app/cli/render_options.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <string>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/source.h"
#include "core/io/json_value.h"
#include "core/io/profile_json.h"

namespace voxprite::cli {
namespace {

constexpr std::array kModes{
    std::pair{RenderMode::sprite, "sprite"}, std::pair{RenderMode::singlePass, "single_pass"},
    std::pair{RenderMode::voxels, "voxels"}, std::pair{RenderMode::clusters, "clusters"},
    std::pair{RenderMode::billboard, "billboard"}};
constexpr std::array kSnapshotKinds{std::pair{SnapshotKind::seed, "seed"},
                                    std::pair{SnapshotKind::sprite, "sprite"}};
constexpr std::array kSnapshotDepths{std::pair{SnapshotDepth::centre, "centre"},
                                     std::pair{SnapshotDepth::perPixel, "pixel"}};
constexpr std::array kSnapshotRolls{std::pair{SnapshotRoll::matched, "matched"},
                                    std::pair{SnapshotRoll::own, "own"}};
constexpr std::array kBackends{std::pair{Backend::cpu, "cpu"}, std::pair{Backend::gl, "gl"}};

template <class Table, class E>
const char* nameIn(const Table& table, E value) {
    for (const auto& [entry, name] : table) {
        if (entry == value) return name;
    }
    return "unknown";
}

template <class Table>
auto valueIn(const Table& table, std::string_view text) {
    std::optional<std::remove_cvref_t<decltype(table[0].first)>> value;
    for (const auto& [entry, name] : table) {
        if (text == name) value = entry;
    }
    return value;
}

std::optional<RenderMode> modeFrom(std::string_view text) {
    return valueIn(kModes, text);
}
std::optional<Backend> backendFrom(std::string_view text) {
    return valueIn(kBackends, text);
}

std::optional<SnapshotKind> snapshotKindFrom(std::string_view text) {
    return valueIn(kSnapshotKinds, text);
}
std::optional<SnapshotDepth> snapshotDepthFrom(std::string_view text) {
    return valueIn(kSnapshotDepths, text);
}
std::optional<SnapshotRoll> snapshotRollFrom(std::string_view text) {
    return valueIn(kSnapshotRolls, text);
}

template <class E>
std::optional<E> optionalOf(const Result<E>& result) {
    return result ? std::optional(*result) : std::nullopt;
}
std::optional<ViewRule> viewFrom(std::string_view t) {
    return optionalOf(viewRuleNamed(t));
}
std::optional<Registration> registrationFrom(std::string_view t) {
    return optionalOf(registrationNamed(t));
}
std::optional<ProxyShape> proxyFrom(std::string_view t) {
    return optionalOf(proxyShapeNamed(t));
}
std::optional<DepthRule> depthFrom(std::string_view t) {
    return optionalOf(depthRuleNamed(t));
}
std::optional<ViewSet> viewSetFrom(std::string_view t) {
    return optionalOf(ViewSet::named(t));
}
std::optional<Shading> shadingFrom(std::string_view t) {
    return optionalOf(shadingNamed(t));
}

// "auto" leaves the number open.
struct AutoNumber {
    std::optional<double> number;
};
std::optional<AutoNumber> autoNumberFrom(std::string_view text) {
    if (text == "auto") return AutoNumber{};
    const std::optional<double> number = numberFrom(text);
    return number ? std::optional(AutoNumber{number}) : std::nullopt;
}

// An option that is stored as it is parsed.
template <class T, class Target>
void add(CLI::App& app, const std::string& name, const std::string& form,
         const std::string& description, std::optional<T> (*parse)(std::string_view),
         Target& target) {
    addParsed(app, name, form, description, parse, [&target](const T& value) { target = value; });
}

void addCameraOptions(CLI::App& app, RenderOptions& o) {
    add(app, "--size", "WxH", "The picture's size in pixels (512x512)", sizeFrom, o.sizePx);
    add(app, "--yaw", "DEGREES", "Carries the eye toward +X; at 0 it is on the model's -Y side",
        numberFrom, o.yawDegrees);
    add(app, "--pitch", "DEGREES", "Raises the eye", numberFrom, o.pitchDegrees);
    add(app, "--roll", "DEGREES", "Turns the camera clockwise", numberFrom, o.rollDegrees);
    add(app, "--fov", "DEGREES", "Vertical field of view (45)", numberFrom, o.fovDegrees);
    add(app, "--distance", "METRES", "From the eye to the model's centre (else the model fits)",
        numberFrom, o.distanceMetres);
    addParsed(app, "--ortho", "[METRES]",
              "Orthographic; the picture's height in metres (else the model fits)", autoNumberFrom,
              [&o](const AutoNumber& height) {
                  o.orthographic = true;
                  o.orthographicHeightMetres = height.number;
              });
}

void addEntityOptions(CLI::App& app, RenderOptions& o) {
    add(app, "--model", "INDEX",
        "Only this source model, as `inspect` lists them (from 0), not the entity", indexFrom,
        o.model);
    addEntityOption(app, o.reading);
    add(app, "--frame", "INDEX", "The frame of the animation, from 0", indexFrom, o.frame);
    add(app, "--anchor", "x,y,z", "The anchor in voxels from the bounds' minimum corner",
        vectorFrom, o.anchorVoxels);
    add(app, "--rotate", "yaw,pitch,roll", "The entity's rotation in degrees", vectorFrom,
        o.rotateDegrees);
    app.add_option("--variant", o.variant, "The palette variant, by its name")->type_name("NAME");
    add(app, "--scale", "NUMBER", "The entity's scale", numberFrom, o.scale);
    add(app, "--position", "x,y,z",
        "Where the anchor stands, metres, Y up (else the model's centre is at the origin)",
        vectorFrom, o.positionMetres);
}

void addProfileOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("--profile", o.profile,
                   "The game profile (JSON); else the built-in one without minification")
        ->type_name("FILE");
    add(app, "--voxel-size", "METRES", "VoxelSize: metres a voxel", numberFrom, o.voxelSizeMetres);
    add(app, "--sigma", "NUMBER", "Virtual pixels a voxel", numberFrom, o.sigma);
    add(app, "--view", "camera_forward|toward_entity", "Which way the rays run", viewFrom, o.view);
    add(app, "--registration", "model_centre|anchor", "What the grid is registered to",
        registrationFrom, o.registration);
    add(app, "--proxy", "quad|box", "The region that is drawn", proxyFrom, o.proxy);
    add(app, "--depth", "centre|ground_safe|per_pixel", "The depth that the sprite writes",
        depthFrom, o.depth);
    add(app, "--shading", "multiply|palette",
        "Light multiplies the colours, or picks among the palette's", shadingFrom, o.shading);
    add(app, "--occlusion", "0...1", "How dark faces get that voxels stand around (0: off)",
        numberFrom, o.occlusion);
    add(app, "--shadow", "0...1", "How much light faces lose that lie in shadow (0: off)",
        numberFrom, o.shadow);
    add(app, "--minification", "[on|off]", "Halve sigma while a virtual pixel is under a pixel",
        switchFrom, o.minification);
    add(app, "--clearance", "PIXELS", "Virtual pixels between the entity and the ground",
        numberFrom, o.clearancePx);
    add(app, "--view-step", "DEGREES", "Views snap to this step (0: off)", numberFrom,
        o.viewStepDegrees);
}

void addSnapshotOptions(CLI::App& app, SnapshotRequest& o) {
    add(app, "--snapshots", "seed|sprite",
        "Mode billboard: in perspective from eight radii away, or the sprites of the views",
        snapshotKindFrom, o.kind);
    // A roll given before the set is not lost with it.
    addParsed(app, "--view-set", "canonical26|octahedral:N|hemisphere:N",
              "Mode billboard: the views that there are snapshots of (canonical26)", viewSetFrom,
              [&o](ViewSet views) {
                  views.roll = o.views.roll;
                  o.views = std::move(views);
              });
    addParsed(app, "--snapshot-size", "PIXELS", "Mode billboard, seed: a snapshot's edge (128)",
              indexFrom, [&o](int size) {
                  if (size < 1 || size > kMostSnapshotPx) {
                      throw CLI::ValidationError(
                          "--snapshot-size", "must be 1 ... " + std::to_string(kMostSnapshotPx));
                  }
                  o.sizePx = size;
              });
    add(app, "--snapshot-depth", "centre|pixel",
        "Mode billboard: one depth, or each pixel its own (centre; sprite: as --depth has it)",
        snapshotDepthFrom, o.depth);
    add(app, "--snapshot-roll", "matched|own",
        "Mode billboard: turn the picture to match the camera, or not at all", snapshotRollFrom,
        o.views.roll);
    add(app, "--snapshot-blend", "[on|off]", "Mode billboard, seed: mix the nearest views",
        switchFrom, o.blend);
}

void addSceneOptions(CLI::App& app, RenderOptions& o) {
    addParsed(app, "--ground", "[METRES]",
              "Draw a ground; its height (else the entity stands on it)", autoNumberFrom,
              [&o](const AutoNumber& height) {
                  o.ground = true;
                  o.groundHeightMetres = height.number;
              });
    add(app, "--background", "#rrggbb[aa]", "The background's colour (transparent)", colourFromText,
        o.background);
}

}  // namespace

const char* nameOf(RenderMode mode) {
    return nameIn(kModes, mode);
}
const char* nameOf(Backend backend) {
    return nameIn(kBackends, backend);
}

const char* nameOf(SnapshotKind kind) {
    return nameIn(kSnapshotKinds, kind);
}
const char* nameOf(SnapshotDepth depth) {
    return nameIn(kSnapshotDepths, depth);
}
const char* nameOf(SnapshotRoll roll) {
    return nameIn(kSnapshotRolls, roll);
}

void addRenderOptions(CLI::App& app, RenderOptions& o) {
    app.add_option("IN", o.input, "The model to draw")->required();
    app.add_option("-o,--output", o.output, "The picture")->type_name("OUT.png");
    app.add_option("--buffer", o.buffer,
                   "The bare sprite buffer: one pixel a virtual pixel, transparent outside")
        ->type_name("OUT.png");
    add(app, "--mode", "sprite|single_pass|voxels|clusters|billboard",
        "What is drawn, and how (else as the profile has it)", modeFrom, o.mode);
    add(app, "--cluster-budget", "PIXELS",
        "Mode clusters: screen pixels that a surface may be off (1; 0 is the finest)", numberFrom,
        o.clusterBudgetPx);
    app.add_flag("--tint-levels", o.tintLevels,
                 "Mode clusters: colours tell how coarse each cluster is");
    add(app, "--levels", "LEVELS",
        "Draw a coarser octree: cells of 2^LEVELS voxels an edge, as wide in the world (0)",
        indexFrom, o.levels);
    add(app, "--octree-depth", "LEVELS",
        "Mode voxels: how many levels of the octree are seen (all; 0: the root as one cube)",
        indexFrom, o.octreeDepth);
    add(app, "--backend", "cpu|gl", "Where it is drawn", backendFrom, o.backend);
    app.add_option("--lattice", o.lattice,
                   "Cast exactly this view: the `lattice` of `render --json`, or all of that JSON")
        ->type_name("FILE");
    addCameraOptions(app, o);
    addEntityOptions(app, o);
    addProfileOptions(app, o);
    addSnapshotOptions(app, o.snapshots);
    addSceneOptions(app, o);
}

}  // namespace voxprite::cli
