// Baking octrees, and keeping a live one up to date.
#include <cmath>
#include <random>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/rivals.h"
#include "app/cli/bench/vdb_rival.h"
#include "app/cli/stopwatch.h"
#include "core/base/parallel.h"
#include "core/svo/bake.h"
#include "core/svo/bake_on_threads.h"
#include "core/svo/live_octree.h"

namespace voxprite::bench {
namespace {

Json bakeFigure(const BenchModel& model, const char* baker, int threads, double ms) {
    return {{"model", model.name}, {"baker", baker}, {"threads", threads}, {"ms", ms}};
}

using Edits = std::vector<LiveOctree::Edit>;

// A voxel inside the bounds, anywhere.
glm::ivec3 randomVoxel(std::mt19937& random, const Octree& octree) {
    const auto below = [&](int size) {
        return static_cast<int>(random() % static_cast<std::uint32_t>(size));
    };
    const int x = below(octree.size.x);
    const int y = below(octree.size.y);
    const int z = below(octree.size.z);
    return octree.origin + glm::ivec3(x, y, z);
}

// A cube of `edge` voxels around `centre`, turned from what it is to the contrary.
Edits toggledCube(const LiveOctree& live, glm::ivec3 centre, int edge) {
    Edits edits;
    for (int z = 0; z < edge; ++z) {
        for (int y = 0; y < edge; ++y) {
            for (int x = 0; x < edge; ++x) {
                const glm::ivec3 voxel = centre + glm::ivec3(x, y, z) - edge / 2;
                edits.push_back({voxel, live.at(voxel) == 0 ? std::uint8_t{7} : std::uint8_t{0}});
            }
        }
    }
    return edits;
}

// Microseconds an edit, the median of many at different places; each is undone, which counts, too.
Result<double> medianEditUs(LiveOctree& live, const Octree& octree, int edge, int count) {
    std::mt19937 random(7);
    std::vector<double> times;
    for (int k = 0; k < count; ++k) {
        const glm::ivec3 centre = randomVoxel(random, octree);
        for (int pass = 0; pass < 2; ++pass) {
            const Edits edits = toggledCube(live, centre, edge);
            const cli::Stopwatch watch;
            if (Status status = live.apply(edits); !status) return Failure(status.error());
            times.push_back(watch.milliseconds() * 1000.0);
            static_cast<void>(live.takeChanges());
        }
    }
    return median(std::move(times));
}

}  // namespace

Result<Json> benchBake(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    const int all = hardwareThreads();
    for (const BenchModel& model : models) {
        progress(effort, "bake: " + model.name);
        for (const int threads : {0, 1}) {
            Octree octree;
            const double ms = medianMs(effort, [&] {
                octree = *bakeOnThreads(model.voxels, model.voxels.bounds(), threads);
            });
            if (octree != model.octree) return fail(model.name + ": two bakes differ");
            figures.push_back(bakeFigure(model, "bricks", threads == 0 ? all : threads, ms));
        }
        const Result<Octree> naive = bakeNaively(model.voxels);
        if (!naive) return Failure(naive.error());
        if (*naive != model.octree) return fail(model.name + ": the naive bake differs from ours");
        const Effort less{true};
        figures.push_back(bakeFigure(model, "naive", 1, medianMs(less, [&] {
                                         static_cast<void>(bakeNaively(model.voxels));
                                     })));
        const VdbGrid grid(model.voxels);
        if (!grid.nanoVdbHolds(model.voxels)) return fail(model.name + ": NanoVDB's grid differs");
        figures.push_back(bakeFigure(model, "nanovdb", all,
                                     medianMs(less, [&] { static_cast<void>(grid.toNanoVdb()); })));
    }
    return figures;
}

Result<Json> benchUpdate(const std::vector<BenchModel>& models, const Effort& effort) {
    const int count = effort.quick ? 200 : 2000;
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        LiveOctree live;
        if (Status status = live.rebuild(model.voxels); !status) return Failure(status.error());
        for (const auto& [edge, name] : {std::pair{1, "voxel"}, std::pair{8, "box8"}}) {
            const Result<double> us = medianEditUs(live, model.octree, edge, count);
            if (!us) return Failure(us.error());
            figures.push_back({{"model", model.name}, {"edit", name}, {"us", *us}});
        }
    }
    return figures;
}

}  // namespace voxprite::bench
