// One setting of one model, drawn frame by frame as a game would: what was cast stays, and a frame
// casts only what it lacks. On one thread of the processor; buffers come from the GPU instead when
// there is a stage (they are the same, bit for bit).
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "app/trade/model_parts.h"
#include "core/sprite/sprite_view.h"

namespace voxprite::trade {

// Of the pictures that one keeps; beyond it the oldest go, and are cast again when they are seen
// again.
inline constexpr std::size_t kMostKeptBytes = std::size_t{64} << 20;

class Drawer {
  public:
    // `parts` (and `stage`, if any) are used as long as this lives.
    [[nodiscard]] static Result<Drawer> create(ModelParts& parts, const GameProfile& game,
                                               const Setting& setting, GlStage* stage = nullptr);

    // Forgets what was cast, the views before and the counts.
    void forget();
    // With `history` views have the hysteresis of frames that follow one another.
    [[nodiscard]] Result<Shown> draw(const Camera& camera, bool history);

    struct Counts {
        std::uint64_t rays = 0;
        std::uint64_t casts = 0;
        double castMilliseconds = 0.0;  // sums over the casts
        std::uint64_t castBytes = 0;
        std::uint64_t mostKeptBytes = 0;  // of pictures, at any one time
    };
    [[nodiscard]] const Counts& counts() const { return counts_; }
    // Of all that was kept to draw it: the octree and pictures, of a set of views all of them.
    [[nodiscard]] double bytes() const;
    // To make what is made beforehand: levels, and all pictures of a set of views.
    [[nodiscard]] double prepareMilliseconds() const;

    // What the last draw() saw, and the buffer shown; none when it was unseen or has no lattice.
    struct Cast {
        SpriteView view;
        const SpriteBuffer* buffer = nullptr;
    };
    [[nodiscard]] const std::optional<Cast>& lastCast() const { return last_; }
    [[nodiscard]] const OctreeView& octree() const { return octree_; }

  private:
    Drawer(ModelParts& parts, const GameProfile& game, const Setting& setting, GlStage* stage);

    struct Kept {
        LatticeView lattice;
        FaceLights lights;
        std::unique_ptr<SpriteBuffer> buffer;  // its place in memory stays
        [[nodiscard]] std::size_t bytes() const;
    };
    // Counts what was cast for the newest of them, and lets the oldest go.
    template <class Pictures>
    void keepWithin(Pictures& kept, double milliseconds, std::size_t rays);
    [[nodiscard]] Result<const SpriteBuffer*> bufferOf(const SpriteView& view);
    [[nodiscard]] Result<Shown> drawSeed(const Camera& camera, ViewHistory* history);
    [[nodiscard]] Result<Shown> drawSinglePass(const SpriteView& view, const Camera& camera);

    ModelParts* parts_;
    GameProfile profile_;
    Setting setting_;
    GlStage* stage_;
    OctreeView octree_;
    PlacedEntity placed_;
    bool ownVoxels_ = true;  // cells are voxels of the model
    double prepared_ = 0.0;
    std::optional<ViewSet> views_;
    std::optional<SnapshotLight> light_;  // of snapshots of kind seed
    ViewHistory history_;
    std::deque<Kept> kept_;
    std::deque<Snapshot> snapshots_;  // of kind seed
    std::size_t keptBytes_ = 0;       // of both
    std::optional<Cast> last_;
    Counts counts_;
};

}  // namespace voxprite::trade
