// Everything that a picture of `voxprite render` depends on, resolved from the options; and the two
// ways to draw it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/render_options.h"
#include "core/base/result.h"
#include "core/sprite/composite.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/octree.h"

namespace voxprite::cli {

// Milliseconds by what they were spent on, in the order of doing.
using Times = std::vector<std::pair<std::string, double>>;

// A socket in the frame that is drawn.
struct ShotSocket {
    std::string name;
    glm::dvec3 position{0.0};  // voxels from the octree's minimum corner
};

struct Shot {
    Octree octree;  // of the frame, in the entity's bounds
    Palette palette;
    Json warnings = Json::array();  // of the reader
    std::vector<ShotSocket> sockets;
    PlacedEntity placed;
    GameProfile profile;
    RenderMode mode = RenderMode::sprite;
    Camera camera;
    std::optional<Ground> ground;
    Rgba8 background{0, 0, 0, 0};

    // Mode `clusters`.
    double clusterBudgetPx = 1.0;
    bool tintLevels = false;

    int octreeDepth = kMaxOctreeDepth;  // mode `voxels`

    SnapshotRequest snapshots;  // mode `billboard`

    // The sprite; the modes in perspective have none.
    std::optional<SpriteView> view;  // not set with a given lattice, or unseen
    std::optional<Unseen> unseen;
    LatticeView lattice;  // size (0, 0) when unseen
    FaceLights lights;    // what `lit` was made with
    LitPalette lit;
    double sigmaInForce = 4.0;
    bool latticeGiven = false;  // then the picture is the buffer itself: a lattice has no camera
};

// Reads the files. Options out of range are wrong usage (CLI::ValidationError).
[[nodiscard]] Result<Shot> makeShot(const RenderOptions& options, Times& times);

// What mode `clusters` chose for the picture, finest level first; all of the model, seen or not.
struct ChosenClusters {
    struct Level {
        int level = 0;
        std::uint64_t clusters = 0;
        std::uint64_t triangles = 0;
    };
    std::vector<Level> levels;  // those that were chosen from
    std::uint64_t allClusters = 0;
    std::uint64_t bytes = 0;  // of the mesh on the GPU
};

// What mode `billboard` showed.
struct ChosenSnapshots {
    std::vector<ViewSet::Weighted> views;  // nearest first; empty when unseen
    std::optional<Unseen> unseen;
    double degreesOff = 0.0;  // of the nearest
    std::uint64_t bytes = 0;  // of the snapshots that were made
};

struct Drawn {
    std::optional<SpriteBuffer> buffer;  // none in perspective
    std::optional<Image> image;          // when asked for
    std::string driver;                  // of GL
    std::optional<ChosenClusters> clusters;
    std::optional<ChosenSnapshots> snapshots;
};
[[nodiscard]] Result<Drawn> drawOnCpu(const Shot& shot, RenderMode mode, bool wantImage,
                                      Times& times);
[[nodiscard]] Result<Drawn> drawOnGl(const Shot& shot, RenderMode mode, bool wantImage,
                                     Times& times);
// Mode `billboard` with snapshots of kind seed.
[[nodiscard]] Result<Drawn> drawSnapshots(const Shot& shot, Backend backend, bool wantImage,
                                          Times& times);
// Those of kind sprite are sprites: what was shown.
[[nodiscard]] ChosenSnapshots chosenSprite(const Shot& shot, const SpriteBuffer& buffer);
// Mode `clusters`, in the context that is current.
[[nodiscard]] Result<Drawn> drawClusters(const Shot& shot, Times& times);

}  // namespace voxprite::cli
