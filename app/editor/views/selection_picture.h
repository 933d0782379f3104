// What is selected, and what floats, as it shows over the edit view.
#pragma once

#include "app/editor/session/session.h"
#include "render/gpu_octree.h"
#include "render/voxel_view.h"

namespace voxprite::editor {

class SelectionPicture {
  public:
    // Brought up to date with the session. Needs the window's GL context. A number that changes
    // with what is to be seen; 0: nothing.
    [[nodiscard]] std::uint64_t follow(const Session& session);
    // At `scale` device pixels a pixel.
    void draw(VoxelView& view, Frame& frame, const Session& session, const Camera& camera,
              float scale) const;

  private:
    // What it was made from; where that lies is not a part of it, so that moving it is cheap.
    struct Source {
        VoxelGrid voxels;
        SignedPermutation rotation;
        int scale = 1;
        bool operator==(const Source&) const = default;
    };
    void bakeAgain();

    GpuOctree octree_;
    IBox box_;  // entity space; empty: nothing is shown
    Source source_;
    std::uint64_t revision_ = 0;  // of the selection that is shown
    Placement entityFromModel_;
};

}  // namespace voxprite::editor
