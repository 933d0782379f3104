// The options of `voxprite render`, as the user gave them.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/base/image.h"
#include "core/billboard/snapshot_blit.h"
#include "core/io/formats.h"
#include "core/model/game_profile.h"
#include "core/svo/octree.h"

namespace voxprite::cli {

enum class RenderMode : std::uint8_t { sprite, singlePass, voxels, clusters, billboard };
enum class Backend : std::uint8_t { cpu, gl };
[[nodiscard]] const char* nameOf(RenderMode mode);
// Else it shows the model in perspective, and has no sprite buffer.
[[nodiscard]] inline bool showsSprite(RenderMode mode) {
    return mode != RenderMode::voxels && mode != RenderMode::clusters;
}
[[nodiscard]] const char* nameOf(Backend backend);
[[nodiscard]] const char* nameOf(SnapshotKind kind);
[[nodiscard]] const char* nameOf(SnapshotDepth depth);
[[nodiscard]] const char* nameOf(SnapshotRoll roll);

// Mode `billboard`: which snapshots, and how they are drawn.
struct SnapshotRequest {
    SnapshotKind kind = SnapshotKind::seed;
    ViewSet views;
    int sizePx = kUsualSnapshotPx;       // kind seed
    std::optional<SnapshotDepth> depth;  // else the centre's, and of kind sprite the profile's
    bool blend = false;                  // kind seed
};

struct RenderOptions {
    std::string input;
    std::optional<std::string> output;  // the picture
    std::optional<std::string> buffer;  // the bare sprite buffer
    std::optional<RenderMode> mode;     // else the profile's
    double clusterBudgetPx = 1.0;       // mode clusters: screen pixels a surface may be off
    bool tintLevels = false;            // mode clusters: colours tell the level of detail
    int levels = 0;                     // the octree is made coarser by
    int octreeDepth = kMaxOctreeDepth;  // mode voxels: levels below the root that are seen
    SnapshotRequest snapshots;
    Backend backend = Backend::cpu;
    std::optional<int> model;
    ReadOptions reading;
    int frame = 0;
    std::optional<std::string> lattice;  // a file with the lattice view to cast
    std::optional<std::string> profile;

    // The camera.
    glm::ivec2 sizePx{512, 512};
    double yawDegrees = 0.0;
    double pitchDegrees = 0.0;
    double rollDegrees = 0.0;
    double fovDegrees = 45.0;
    std::optional<double> distanceMetres;  // else the model fits
    bool orthographic = false;
    std::optional<double> orthographicHeightMetres;  // else the model fits

    // The entity.
    std::optional<glm::dvec3> anchorVoxels;   // from the minimum corner of its bounds
    std::optional<glm::dvec3> rotateDegrees;  // yaw, pitch, roll
    std::optional<double> scale;
    std::optional<std::string> variant;        // of the palette
    std::optional<glm::dvec3> positionMetres;  // of the anchor; else the centre is at the origin

    // The profile, where it is not as its file or the built-in one has it.
    std::optional<double> voxelSizeMetres, sigma, clearancePx, viewStepDegrees;
    std::optional<double> occlusion, shadow;
    std::optional<ViewRule> view;
    std::optional<Registration> registration;
    std::optional<ProxyShape> proxy;
    std::optional<DepthRule> depth;
    std::optional<Shading> shading;
    std::optional<bool> minification;

    // The scene.
    bool ground = false;
    std::optional<double> groundHeightMetres;  // else where the entity stands
    Rgba8 background{0, 0, 0, 0};
};

void addRenderOptions(CLI::App& app, RenderOptions& options);

}  // namespace voxprite::cli
