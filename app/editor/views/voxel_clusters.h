// The mesh of the model in the edit view: made in the background, never shown when it is not of the
// very voxels that are shown; and when it is drawn in place of rays.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "app/editor/views/drawing_times.h"
#include "core/sprite/camera.h"
#include "render/gl/timer_query.h"
#include "render/gpu_clusters.h"
#include "render/gpu_octree.h"

namespace voxprite::editor {

class VoxelClusters {
  public:
    // Each frame: starts a mesh where one is wanted and the model has come to rest, and takes over
    // what is ready.
    void follow(const Session& session, DrawBy drawBy);
    // To draw now in place of rays; null: rays.
    [[nodiscard]] const GpuClusters* toDraw(const Session& session, const GpuOctree& octree,
                                            DrawBy drawBy, double radiusPx) const;
    // Around the drawing of the model by rays (null) or clusters.
    void beginFrame(const GpuClusters* drawn, double radiusPx);
    void endFrame();
    // Is a mesh that is wanted still to come? Then follow() has to be called again soon.
    [[nodiscard]] bool pending() const { return pending_; }

  private:
    // What the mesh is of.
    struct Model {
        std::uint64_t revision = 0;
        int frame = 0;
        bool operator==(const Model&) const = default;
    };
    struct Timed {
        gl::TimerQuery timer;
        DrawingWay way = DrawingWay::rays;
        double radiusPx = 0.0;
    };
    void start(const Session& session, const Model& model);

    BackgroundJob job_;
    GpuClusters clusters_;
    std::optional<Model> made_;    // clusters_ are of this
    std::optional<Model> seen_;    // shown last, and unchanged for so many frames
    std::optional<Model> failed_;  // has no mesh
    int stillFrames_ = 0;
    int maxDepth_ = 0;  // of the octree that clusters_ were made from
    DrawingTimes times_;
    std::optional<Timed> timed_;
    bool pending_ = false;
    bool timing_ = false;  // between beginFrame and endFrame
};

}  // namespace voxprite::editor
