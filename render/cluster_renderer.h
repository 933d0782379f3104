// Entities of a scene as meshes, as fine as their size on the screen asks for: in perspective, each
// face in the flat colour that a sprite gives it, without outline.
//
// Depth is the frame's own: sprites and meshes hide each other as they stand.
#pragma once

#include <memory>
#include <span>

#include "core/base/result.h"
#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "render/frame.h"
#include "render/gpu_clusters.h"

namespace voxprite {

struct ClusterInstance {
    const GpuClusters* clusters = nullptr;
    const Palette* palette = nullptr;
    PlacedEntity placed;
};

struct ClusterOptions {
    double budgetPx = 1.0;    // screen pixels that a surface may be off; 0: the finest
    bool tintLevels = false;  // colours tell the level of detail
};

struct ClusterStats {
    int instances = 0;
    int drawCalls = 0;
};

class ClusterRenderer {
  public:
    [[nodiscard]] static Result<ClusterRenderer> create();  // needs a current GL 4.5 context
    ~ClusterRenderer();
    ClusterRenderer(ClusterRenderer&&) noexcept;
    ClusterRenderer& operator=(ClusterRenderer&&) noexcept;

    // Draws onto what `frame` holds; camera.viewportPx must be the frame's size. Of the profile the
    // light and the shading matter. Fails when the instances have more palettes than the driver has
    // room for (64 always fit).
    [[nodiscard]] Result<ClusterStats> draw(Frame& frame, const Camera& camera,
                                            const GameProfile& profile,
                                            std::span<const ClusterInstance> instances,
                                            const ClusterOptions& options);

  private:
    struct Impl;
    explicit ClusterRenderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite
