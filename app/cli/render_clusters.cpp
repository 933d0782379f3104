// The picture of `voxprite render --mode clusters`.
#include <map>

#include "app/cli/render_shot.h"
#include "app/cli/stopwatch.h"
#include "core/lod/cluster_mesh.h"
#include "render/cluster_pass.h"
#include "render/cluster_renderer.h"
#include "render/frame.h"
#include "render/gl/timer_query.h"

namespace voxprite::cli {
namespace {

// By the rule that the GPU follows, so that nothing has to be read back.
ChosenClusters chosenClusters(const Shot& shot, const ClusterMesh& mesh) {
    const ClusterCutParams params = clusterCutParams(
        clusterView(shot.placed, mesh.treeFromVoxel, shot.camera, shot.clusterBudgetPx), mesh.reach,
        static_cast<std::uint32_t>(mesh.pages.size()));
    std::vector<std::uint32_t> chosen;
    selectCutPerCluster(mesh.pages, params, chosen);
    std::map<int, ChosenClusters::Level> levels;
    for (const std::uint32_t page : chosen) {
        ChosenClusters::Level& level = levels[mesh.pageLevels[page]];
        level.level = mesh.pageLevels[page];
        ++level.clusters;
        level.triangles += mesh.pages[page].indexCount / 3;
    }
    ChosenClusters result;
    for (const auto& [number, level] : levels) result.levels.push_back(level);
    result.allClusters = mesh.pages.size();
    result.bytes = mesh.bytes();
    return result;
}

}  // namespace

Result<Drawn> drawClusters(const Shot& shot, Times& times) {
    if (Status fits = Frame::checkSize(shot.camera.viewportPx); !fits) {
        return Failure(fits.error());
    }
    Stopwatch watch;
    const Result<ClusterMesh> mesh = buildClusters(shot.octree.view());
    if (!mesh) return Failure(mesh.error());
    times.emplace_back("build", watch.lapMilliseconds());
    Result<ClusterRenderer> renderer = ClusterRenderer::create();
    if (!renderer) return Failure(renderer.error());
    GpuClusters clusters;
    clusters.upload(*mesh);
    times.emplace_back("start", watch.lapMilliseconds());

    Frame frame(shot.camera.viewportPx);
    const ClusterInstance instance{&clusters, &shot.palette, shot.placed};
    gl::TimerQuery timer;
    // The first frame pays for what drivers put off until then.
    for (int k = 0; k < 2; ++k) {
        frame.begin(shot.background);
        timer.begin();
        const Result<ClusterStats> stats =
            renderer->draw(frame, shot.camera, shot.profile, {&instance, 1},
                           {.budgetPx = shot.clusterBudgetPx, .tintLevels = shot.tintLevels});
        timer.end();
        if (!stats) return Failure(stats.error());
    }
    times.emplace_back("draw", timer.waitMs());
    Drawn drawn;
    drawn.image = frame.readColour();
    if (shot.ground) drawGround(*shot.ground, shot.camera, frame.readDepth(), *drawn.image);
    drawn.clusters = chosenClusters(shot, *mesh);
    return drawn;
}

}  // namespace voxprite::cli
