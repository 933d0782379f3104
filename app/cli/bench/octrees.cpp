// Baking octrees, and keeping a live one up to date.
#include <glad/gl.h>

#include <algorithm>
#include <random>
#include <ranges>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/openvdb_rivals.h"
#include "app/cli/bench/rivals.h"
#include "app/cli/stopwatch.h"
#include "core/base/parallel.h"
#include "core/svo/bake.h"
#include "core/svo/bake_on_threads.h"
#include "core/svo/live_octree.h"
#include "render/gpu_octree.h"

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

// The ball of a brush of radius 8, likewise.
Edits toggledBall(const LiveOctree& live, glm::ivec3 centre) {
    Edits edits = toggledCube(live, centre, 17);
    std::erase_if(edits, [&](const LiveOctree::Edit& edit) {
        const glm::ivec3 d = edit.voxel - centre;
        return d.x * d.x + d.y * d.y + d.z * d.z > 64;
    });
    return edits;
}

// Whether there is a context to upload to.
bool hasGl() {
    return glFinish != nullptr;
}

// Microseconds an edit by `apply`, the median of many at different places; each is undone, which
// counts, too. Single voxels are too quick for the clock: of them it times a hundred.
template <class MakeEdits, class Apply>
Result<double> medianEditUs(const LiveOctree& live, const Octree& octree, int count, int batch,
                            const MakeEdits& makeEdits, const Apply& apply) {
    std::mt19937 random(7);
    std::vector<double> times;
    for (int k = 0; k < count; k += batch) {
        std::vector<Edits> todo, undo;
        for (int i = 0; i < batch; ++i) {
            todo.push_back(makeEdits(randomVoxel(random, octree)));
            Edits back;
            for (const LiveOctree::Edit& edit : todo.back()) {
                back.push_back({edit.voxel, live.at(edit.voxel)});
            }
            undo.push_back(std::move(back));
        }
        std::ranges::reverse(undo);
        for (const std::vector<Edits>* pass : {&todo, &undo}) {
            const cli::Stopwatch watch;
            for (const Edits& edits : *pass) {
                if (Status status = apply(edits); !status) return Failure(status.error());
            }
            times.push_back(watch.milliseconds() * 1000.0 / batch);
        }
    }
    return median(std::move(times));
}

Result<std::unique_ptr<OpenVdbGrid>> openVdbGridOf(const VoxelGrid& voxels) {
    const Result<const OpenVdbRivals*> rivals = openVdbRivals();
    if (!rivals) return Failure(rivals.error());
    std::unique_ptr<OpenVdbGrid> grid = (*rivals)->grid();
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t material) { grid->set(v, material); });
    return grid;
}

bool holds(const OpenVdbGrid::NanoVdb& grid, const VoxelGrid& voxels) {
    bool same = true;
    voxels.forEachSolid(
        [&](glm::ivec3 v, std::uint8_t material) { same = same && grid.get(v) == material; });
    return same;
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
        const Result<std::unique_ptr<OpenVdbGrid>> grid = openVdbGridOf(model.voxels);
        if (!grid) return Failure(grid.error());
        if (!holds(*(*grid)->toNanoVdb(), model.voxels)) {
            return fail(model.name + ": NanoVDB's grid differs");
        }
        figures.push_back(bakeFigure(model, "nanovdb", all, medianMs(less, [&] {
                                         static_cast<void>((*grid)->toNanoVdb());
                                     })));
    }
    return figures;
}

Result<Json> benchUpdate(const std::vector<BenchModel>& models, const Effort& effort) {
    const int count = effort.quick ? 200 : 2000;
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        progress(effort, "update: " + model.name);
        LiveOctree live;
        if (Status status = live.rebuild(model.voxels); !status) return Failure(status.error());
        const Result<std::unique_ptr<OpenVdbGrid>> grid = openVdbGridOf(model.voxels);
        if (!grid) return Failure(grid.error());
        GpuOctree gpu;
        const IBox bounds = model.voxels.bounds();
        const auto patch = [&](const Edits& edits) { return live.apply(edits); };
        // As the editor does it, until the driver has what changed.
        const auto patchAndUpload = [&](const Edits& edits) {
            Status status = live.apply(edits);
            gpu.update(live.view(bounds), live.takeChanges());
            glFinish();
            return status;
        };
        const auto writeVdb = [&](const Edits& edits) -> Status {
            for (const LiveOctree::Edit& edit : edits) (*grid)->set(edit.voxel, edit.material);
            return {};
        };
        const auto measure = [&](const char* edit, int edits, int batch,
                                 const auto& makeEdits) -> Status {
            const auto add = [&](const char* updater, const auto& apply) -> Status {
                const Result<double> us =
                    medianEditUs(live, model.octree, edits, batch, makeEdits, apply);
                if (!us) return Failure(us.error());
                figures.push_back(
                    {{"model", model.name}, {"edit", edit}, {"updater", updater}, {"us", *us}});
                return {};
            };
            if (Status done = add("octree", patch); !done) return done;
            static_cast<void>(live.takeChanges());
            if (hasGl()) {
                gpu.upload(live.view(bounds));
                if (Status done = add("octree_uploaded", patchAndUpload); !done) return done;
            }
            return add("openvdb", writeVdb);
        };
        const auto voxel = [&](glm::ivec3 v) { return toggledCube(live, v, 1); };
        const auto box = [&](glm::ivec3 v) { return toggledCube(live, v, 8); };
        const auto ball = [&](glm::ivec3 v) { return toggledBall(live, v); };
        const auto beyond = [&](glm::ivec3) {
            return Edits{{model.octree.origin - model.octree.size, 7}};
        };
        if (Status done = measure("voxel", count, 100, voxel); !done) return Failure(done.error());
        if (Status done = measure("box8", count, 1, box); !done) return Failure(done.error());
        if (Status done = measure("brush8", count, 1, ball); !done) return Failure(done.error());
        if (Status done = measure("beyond", count, 1, beyond); !done) return Failure(done.error());
    }
    return figures;
}

}  // namespace voxprite::bench
