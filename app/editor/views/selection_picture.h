// What is selected, and what floats, as it shows over the edit view.
#pragma once

#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"
#include "core/svo/octree.h"
#include "render/gpu_octree.h"
#include "render/voxel_view.h"

namespace voxprite::editor {

class SelectionPicture {
  public:
    // Brought up to date with the session, once a frame. Of very many voxels it is made behind the
    // window; until then what was marked before stays. Needs the window's GL context. A number that
    // changes with what is to be seen; 0: nothing.
    [[nodiscard]] std::uint64_t follow(const Session& session);
    // It is on its way: follow() has to be called again soon.
    [[nodiscard]] bool prepares() const { return job_.running(); }
    // For scripts, which do one thing after another.
    void finish();
    // At `scale` device pixels a pixel.
    void draw(VoxelView& view, Frame& frame, const Camera& camera, float scale) const;

  private:
    // What it was made from; where that lies is not a part of it, so that moving it is cheap.
    struct Source {
        VoxelGrid voxels;
        SignedPermutation rotation;
        int scale = 1;
        bool operator==(const Source&) const = default;
    };
    struct Baked {
        Octree octree;
        IBox box;
    };
    [[nodiscard]] static Baked bakeOf(const Source& source);
    void make(Source source);
    void show(const Baked& baked);
    void showNothing();

    BackgroundJob job_;
    GpuOctree octree_;
    IBox box_;  // entity space; empty: nothing is shown
    Source source_;
    std::uint64_t revision_ = 0;  // of the selection that is wanted
    std::uint64_t shown_ = 0;     // and of the one that is shown
    Placement entityFromModel_;
};

}  // namespace voxprite::editor
