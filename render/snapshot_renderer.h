// Snapshots of kind `seed` (core/billboard/snapshot.h) on OpenGL: cast by the voxel view when they
// are first shown, kept in the layers of two texture arrays, and drawn as flat pictures, any number
// of entities in one draw.
//
// (Kind `sprite` is the scene renderer's: an entity with a set of views, SceneEntity::views.)
//
// Against the CPU's snapshots and blit: the same pictures but where a ray of the voxel view, which
// aims in single precision, passes an edge on the other side: of ten thousand pixels five at most.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/billboard/snapshot_blit.h"
#include "core/model/palette.h"
#include "render/frame.h"
#include "render/gpu_octree.h"

namespace voxprite {

struct SnapshotEntity {
    const GpuOctree* octree = nullptr;
    const Palette* palette = nullptr;
    PlacedEntity placed;
    ViewHistory* history = nullptr;  // may be null: no hysteresis
};

struct SnapshotRules {
    ViewSet views;
    int sizePx = kUsualSnapshotPx;  // 1 ... kMostSnapshotPx
    SnapshotChoice choice;
};

struct SnapshotStats {
    int drawn = 0;
    int unseen = 0;
    int cast = 0;             // snapshots made for this draw
    int drawCalls = 0;        // that put snapshots onto the screen
    int held = 0;             // snapshots on the GPU
    std::uint64_t bytes = 0;  // that those take
};

class SnapshotRenderer {
  public:
    // Snapshots asked for longest ago go when more than `mostBytes` would be held; one draw's
    // snapshots are drawn in parts rather than beyond it. Needs a current GL 4.5 context.
    [[nodiscard]] static Result<SnapshotRenderer> create(std::uint64_t mostBytes = 64u << 20);
    ~SnapshotRenderer();
    SnapshotRenderer(SnapshotRenderer&&) noexcept;
    SnapshotRenderer& operator=(SnapshotRenderer&&) noexcept;

    // Draws over `frame` where it is nearer than what is there, by reversed depth, and writes its
    // own. camera.viewportPx must be the frame's size. Of the profile the light and shading count;
    // another light, shading, set of views or size forgets what is held, another octree or palette
    // that of its own.
    [[nodiscard]] Result<SnapshotStats> draw(Frame& frame, std::span<const SnapshotEntity> entities,
                                             const Camera& camera, const GameProfile& profile,
                                             const SnapshotRules& rules);

    // The snapshot of a view read back, its ids all kIdFirstVoxel where it is not empty.
    [[nodiscard]] Result<Snapshot> cast(const SnapshotEntity& entity, const GameProfile& profile,
                                        const SnapshotRules& rules, int view);

  private:
    struct Impl;
    explicit SnapshotRenderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite
