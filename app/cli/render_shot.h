// Everything that a picture of `voxprite render` depends on, resolved from the options; and the two
// ways to draw it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

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
    std::vector<ShotSocket> sockets;
    PlacedEntity placed;
    GameProfile profile;
    RenderMode mode = RenderMode::sprite;
    Camera camera;
    std::optional<Ground> ground;
    Rgba8 background{0, 0, 0, 0};

    // The sprite; in mode `voxels` there is none.
    std::optional<SpriteView> view;  // not set with a given lattice, or unseen
    std::optional<Unseen> unseen;
    LatticeView lattice;  // size (0, 0) when unseen
    LitPalette lit;
    double sigmaInForce = 4.0;
    bool latticeGiven = false;  // then the picture is the buffer itself: a lattice has no camera
};

// Reads the files. Options out of range are wrong usage (CLI::ValidationError).
[[nodiscard]] Result<Shot> makeShot(const RenderOptions& options, Times& times);

struct Drawn {
    std::optional<SpriteBuffer> buffer;  // none in mode `voxels`
    std::optional<Image> image;          // when asked for
    std::string driver;                  // of GL
};
[[nodiscard]] Result<Drawn> drawOnCpu(const Shot& shot, RenderMode mode, bool wantImage,
                                      Times& times);
[[nodiscard]] Result<Drawn> drawOnGl(const Shot& shot, RenderMode mode, bool wantImage,
                                     Times& times);

}  // namespace voxprite::cli
