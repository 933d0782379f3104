// What is selected, and what floats, as it shows over the edit view.
#pragma once

#include "app/editor/session.h"
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
    // What it was made from.
    struct Source {
        std::uint64_t selection = 0;
        Placement entityFromModel;
        bool operator==(const Source&) const = default;
    };
    GpuOctree octree_;
    IBox box_;  // entity space; empty: nothing is shown
    std::optional<Source> source_;
};

}  // namespace voxprite::editor
