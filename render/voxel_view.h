// The perspective (or orthographic) view of the voxels themselves, cast from the same octree, with
// true depth. The artist edits here.
#pragma once

#include <memory>
#include <optional>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/sprite_view.h"
#include "render/frame.h"
#include "render/gpu_clusters.h"
#include "render/gpu_octree.h"
#include "render/voxel_occlusion.h"

namespace voxprite {

struct VoxelViewOptions {
    bool edges = true;  // darkened voxel edges when they are wide enough to see
    VoxelOcclusion occlusion = VoxelOcclusion::corners;
    bool ground = true;   // a soft grid plane under the model: cells of 1 and 8 voxels
    bool shadow = false;  // that of the light, on voxels and on the plane under the model
    Light light;
    // The sprite's own light instead of a softer one, in the same integers: each face is exactly
    // the colour that a sprite gives it, with the light's occlusion and shadow (edges and what is
    // chosen above apart).
    bool spriteLight = false;
    Shading shading = Shading::multiply;  // of the sprite's light
    Rgba8 backgroundTop{58, 62, 70, 255};
    Rgba8 backgroundBottom{34, 36, 41, 255};
    // The model's mesh, which must be that of the octree: it is drawn in place of casting a ray for
    // each pixel, and looks the same where it is as fine as the voxels. Null: rays.
    const GpuClusters* clusters = nullptr;
    double clusterBudgetPx = 1.0;  // screen pixels that a surface may be off
    bool tintLevels = false;       // of clusters: colours tell the level of detail
    // Of rays: levels below the octree's root that are looked at. A node at the last of them that
    // holds anything is one cube in the colour of its first voxel (RaycastOptions::maxDepth).
    int maxDepth = kMaxOctreeDepth;
};

// How light a face is in the softer light: half-lambert (Valve 2004), so that faces turned away
// keep their shape. Both directions of length 1, in one space; one value for each face.
[[nodiscard]] float halfLambert(glm::dvec3 normal, glm::dvec3 towardLight, double ambient);

class VoxelView {
  public:
    [[nodiscard]] static Result<VoxelView> create();  // needs a current GL 4.5 context
    ~VoxelView();
    VoxelView(VoxelView&&) noexcept;
    VoxelView& operator=(VoxelView&&) noexcept;

    // Clears and draws into `frame`. camera.viewportPx must be the frame's size.
    void draw(Frame& frame, const GpuOctree& octree, const Palette& palette,
              const PlacedEntity& placed, const Camera& camera, const VoxelViewOptions& options);
    // Another model over what was drawn, such as the frame before (onion skin): where it is nearer
    // it shows, translucent (`tint`'s alpha) and in a colour between its own and the tint's.
    void drawGhost(Frame& frame, const GpuOctree& octree, const Palette& palette,
                   const PlacedEntity& placed, const Camera& camera,
                   const VoxelViewOptions& options, Rgba8 tint);
    // Voxels of the model that are selected: covered by the tint (its alpha says how much), with a
    // dashed line around them at `scale` device pixels a pixel. Where something hides them, a
    // faint tint alone.
    void drawMarked(Frame& frame, const GpuOctree& octree, const PlacedEntity& placed,
                    const Camera& camera, Rgba8 tint, float scale);
    // A software driver compiles what draws marks when they are first drawn, which takes longer
    // than a frame may. Called while nothing else is to do, this has it done before, a step a call;
    // false: there is nothing left to do. Any octree and view will do.
    bool prepareMarks(const GpuOctree& octree, const PlacedEntity& placed, const Camera& camera);

  private:
    struct Impl;
    explicit VoxelView(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite
