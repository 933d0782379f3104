// Memory that a model takes: the grid that is edited, its live octree, the canonical arrays that a
// game loads, and a step of the undo history that changes every voxel.
#include "app/cli/bench/bench.h"
#include "core/edit/history.h"
#include "core/edit/make_action.h"
#include "core/svo/live_octree.h"

namespace voxprite::bench {
namespace {

// All solid voxels in another colour.
std::size_t bytesOfRecolouring(const VoxelGrid& voxels) {
    Workspace workspace;
    workspace.document.models.front().voxels = voxels;
    VoxelPatch patch;
    patch.changes.reserve(static_cast<std::size_t>(voxels.solidCount()));
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t material) {
        const auto other = static_cast<std::uint8_t>(material == 255 ? 1 : material + 1);
        patch.changes.push_back({v, material, other});
    });
    History history;
    history.execute(workspace, makeAction("recolour", std::move(patch)));
    return history.bytes();
}

}  // namespace

Result<Json> benchMemory(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        progress(effort, "memory: " + model.name);
        LiveOctree live;
        if (Status status = live.rebuild(model.voxels); !status) return Failure(status.error());
        const std::uint64_t voxels = model.voxels.solidCount();
        const auto add = [&](const char* what, std::size_t bytes) {
            figures.push_back(
                {{"model", model.name},
                 {"what", what},
                 {"bytes", bytes},
                 {"bytes_a_voxel", static_cast<double>(bytes) / static_cast<double>(voxels)}});
        };
        add("canonical", model.octree.nodes.size() * sizeof(model.octree.nodes[0]) +
                             model.octree.payloads.size() * sizeof(model.octree.payloads[0]));
        add("live", live.bytes());
        add("grid", model.voxels.bytes());
        add("undo", bytesOfRecolouring(model.voxels));
    }
    return figures;
}

}  // namespace voxprite::bench
