// A scene of sprites: the entities of a small game world, on a ground, with a depth buffer.
//
// Two ways to the same pixels (SpriteMode of core/model/game_profile.h): they agree in every pixel.
// Which one is for the caller to say; the profile's own choice is profile.mode.
//
// Either way a scene is one instanced draw, however many entities of however many models it has.
//
// With sprite buffers the finished sprites lie in a common atlas, where equal sprites (SpriteKey)
// share one place and stay until the room is needed; what a frame lacks is cast in one draw a page,
// and outlined in another. More draws are made only where a frame shows more sprites than the atlas
// holds, or one that is larger than its pages. A single pass casts from all octrees in one texture;
// an octree that does not fit there is a draw of its own.
//
// What was worked out for an entity is remembered by its place in the scene: while camera, profile,
// model, palette and entity stay the same a frame is a comparison of each and the draw.
//
// Entities may be drawn by something else than their exact sprite (render/scene_choice.h chooses):
// snapshots and coarser octrees are sprites, too, and drawn with them; clusters are meshes and come
// last, in their own draw, against the depths of the sprites.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/lod/representation.h"
#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/composite.h"
#include "core/sprite/sprite_view.h"
#include "render/frame.h"
#include "render/gpu_octree.h"

namespace voxprite {

class GpuClusters;
class ViewSet;

struct SceneEntity {
    const GpuOctree* octree = nullptr;
    const Palette* palette = nullptr;
    PlacedEntity placed;
    ViewHistory* history = nullptr;        // may be null: no hysteresis; no two entities share one
    const PlacedEntity* shadow = nullptr;  // what casts the shadow blob; null: `placed` does
    // What it is drawn by. Coarse: `octree` and `placed` are those of the coarser model.
    Representation representation = Representation::sprite;
    const ViewSet* views = nullptr;         // snapshot: what is shown is the nearest of these
    const GpuClusters* clusters = nullptr;  // clusters: the mesh
};

struct Scene {
    std::vector<SceneEntity> entities;  // equal depths: the earlier one stays in front
    Rgba8 background{0, 0, 0, 0};
    bool sky = false;  // a soft gradient instead of the background
    std::optional<Ground> ground;
    bool groundGrid = false;       // lines on the ground, one a metre
    bool shadowBlobs = false;      // a soft dark ellipse under each entity
    double clusterBudgetPx = 1.0;  // how far off on the screen the surface of clusters may be
};

struct SceneStats {
    int drawn = 0;
    int unseen = 0;
    // Cast this frame: virtual pixels (spriteBuffer), or the screen pixels of the sprites'
    // rectangles, each of which casts up to five (singlePass).
    std::uint64_t rays = 0;
    std::uint64_t casts = 0;        // sprites cast (spriteBuffer)
    std::uint64_t castsReused = 0;  // sprites taken from the frame before, or from another entity
    int drawCalls = 0;              // that put entities onto the screen
    std::array<int, kRepresentations> drawnBy{};  // by Representation; together `drawn`
    std::uint64_t atlasBytes = 0;                 // held by finished sprites
    double sigmaInForce = 0.0;                    // of the first entity drawn
    double screenPxPerPx = 0.0;                   // of the first entity drawn
};

// Where finished sprites are kept: pages of one texture array, added as they are needed. A sprite
// larger than a page has a texture of its own, which there is always room for; several of them
// share largeBytes.
struct AtlasLimits {
    int pageEdgePx = 1024;
    int pages = 32;  // at 8 bytes a pixel: 256 MiB
    std::uint64_t largeBytes = 256U << 20U;
};

class SceneRenderer {
  public:
    // Needs a current GL 4.5 context.
    [[nodiscard]] static Result<SceneRenderer> create(const AtlasLimits& limits = {});
    ~SceneRenderer();
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;

    // Clears and draws `scene` into `frame`. camera.viewportPx must be the frame's size.
    [[nodiscard]] Result<SceneStats> draw(Frame& frame, const Scene& scene, const Camera& camera,
                                          const GameProfile& profile, SpriteMode mode);

    // The bare sprite buffer, read back. singlePass runs the same fragment code over one fragment a
    // virtual pixel.
    [[nodiscard]] Result<SpriteBuffer> castBuffer(const GpuOctree& octree,
                                                  const LatticeView& lattice, const LitPalette& lit,
                                                  SpriteMode mode);

  private:
    struct Impl;
    explicit SceneRenderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite
