#include "app/editor/views/voxel_clusters.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace voxprite::editor {
namespace {

// Larger meshes take long to make, and have more triangles than the view has pixels: rays are
// cheaper.
constexpr int kMostEdge = 256;
// While the artist draws, each frame has another model.
constexpr int kRestFrames = 12;

bool isWorthTrying(const IBox& bounds) {
    const glm::ivec3 size = bounds.size();
    return !bounds.empty() && std::max({size.x, size.y, size.z}) <= kMostEdge;
}

// The octree's arrays, for another thread.
struct Snapshot {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint64_t> payloads;
    OctreeView view;

    explicit Snapshot(const OctreeView& octree)
        : nodes(octree.nodes.begin(), octree.nodes.end()),
          payloads(octree.payloads.begin(), octree.payloads.end()),
          view(octree) {
        view.nodes = nodes;
        view.payloads = payloads;
    }
};

}  // namespace

void VoxelClusters::follow(const Session& session, DrawBy drawBy) {
    job_.finish();
    const bool wanted = drawBy == DrawBy::clusters ||
                        (drawBy == DrawBy::automatic && isWorthTrying(session.bounds()));
    const Model model{session.contentsRevision(), session.frame()};
    stillFrames_ = seen_ == model && !session.previews() ? stillFrames_ + 1 : 0;
    seen_ = model;
    const bool known = made_ == model || failed_ == model;
    pending_ = wanted && !known && !session.previews();
    if (pending_ && !job_.running() && stillFrames_ >= kRestFrames) start(session, model);
}

void VoxelClusters::start(const Session& session, const Model& model) {
    auto octree = std::make_shared<Snapshot>(session.shownOctree().view(session.shownBounds()));
    job_.start("Preparing the view", [this, octree, model](JobProgress&) -> BackgroundJob::Done {
        auto mesh = std::make_shared<Result<ClusterMesh>>(buildClusters(octree->view));
        return [this, octree, mesh, model] {
            if (!*mesh) {
                failed_ = model;
                return;
            }
            // Frames of another model say nothing of this one.
            const std::size_t before = clusters_.indexCount();
            const std::size_t now = (*mesh)->indices.size();
            if (now > 2 * before || before > 2 * now) times_.forget();
            clusters_.upload(**mesh);
            made_ = model;
            maxDepth_ = octree->view.maxDepth;
        };
    });
}

const GpuClusters* VoxelClusters::toDraw(const Session& session, const GpuOctree& octree,
                                         DrawBy drawBy, double radiusPx) const {
    if (drawBy == DrawBy::rays || session.previews()) return nullptr;
    if (made_ != Model{session.contentsRevision(), session.frame()}) return nullptr;
    // A preview may have moved the tree, and left it so.
    if (clusters_.treeFromVoxel() != octree.treeFromVoxel() || maxDepth_ != octree.maxDepth()) {
        return nullptr;
    }
    if (drawBy == DrawBy::automatic &&
        times_.faster(radiusPx, clusters_.indexCount() / 3) == DrawingWay::rays)
        return nullptr;
    return &clusters_;
}

void VoxelClusters::beginFrame(const GpuClusters* drawn, double radiusPx) {
    if (timed_) {
        const std::optional<double> ms = timed_->timer.readyMs();
        if (!ms) return;
        times_.took(timed_->way, timed_->radiusPx, *ms);
    }
    timed_.emplace();
    timed_->way = drawn != nullptr ? DrawingWay::clusters : DrawingWay::rays;
    timed_->radiusPx = radiusPx;
    timed_->timer.begin();
    timing_ = true;
}

void VoxelClusters::endFrame() {
    if (!std::exchange(timing_, false)) return;
    timed_->timer.end();
}

}  // namespace voxprite::editor
