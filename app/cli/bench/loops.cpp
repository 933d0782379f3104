// The hot loops, each over the same work in every run: what instructions are counted of, by the
// processor's counters or under callgrind (`./dev bench --instructions`), which finds each loop by
// the name of its function here.
#include <memory>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/counters.h"
#include "app/cli/bench/rivals.h"
#include "app/cli/stopwatch.h"
#include "core/model/game_profile.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "core/sprite/voxel_placement.h"
#include "core/svo/bake_on_threads.h"
#include "core/svo/live_octree.h"
#include "core/trace/lattice.h"
#include "core/trace/lattice_caster.h"
#include "core/trace/packet_caster.h"
#include "core/trace/ray_packet.h"

namespace voxprite::bench {

constexpr int kEdgePx = 256;
constexpr int kClicks = 1000;
constexpr OrbitAngles kFrom{28, 19, 0};

struct LoopWork {
    BenchModel model;
    LatticeView lattice;
    EyePicture eyePicture;
    LiveOctree live;
    std::vector<LiveOctree::Edit> clicks;
};

// Each returns how many rays, voxels or clicks that was. Called once a run and never inlined, so
// that a profiler can tell them apart.
[[gnu::noinline]] std::size_t loopScalarCast(LoopWork& work) {
    const LatticeCaster caster(work.model.octree.view(), work.lattice);
    std::size_t hits = 0;
    for (int j = 0; j < work.lattice.size.y; ++j)
        for (int i = 0; i < work.lattice.size.x; ++i)
            hits += caster.cast(work.lattice.first + glm::ivec2(i, j)).material != 0 ? 1 : 0;
    return hits == 0 ? 0 : static_cast<std::size_t>(kEdgePx) * kEdgePx;
}

[[gnu::noinline]] std::size_t loopPacketCast(LoopWork& work) {
    const PacketCaster caster(work.model.octree.view(), work.lattice);
    const auto hits = std::make_unique_for_overwrite<PacketHits>();
    for (int j = 0; j < kEdgePx; j += PacketHits::kEdge)
        for (int i = 0; i < kEdgePx; i += PacketHits::kEdge)
            caster.cast(work.lattice.first + glm::ivec2(i, j), glm::ivec2(PacketHits::kEdge),
                        *hits);
    return static_cast<std::size_t>(kEdgePx) * kEdgePx;
}

[[gnu::noinline]] std::size_t loopRayPackets(LoopWork& work) {
    const OctreeView octree = work.model.octree.view();
    const auto hits = std::make_unique_for_overwrite<RayPacketHits>();
    for (int j = 0; j < kEdgePx; j += PacketHits::kEdge)
        for (int i = 0; i < kEdgePx; i += PacketHits::kEdge)
            castRayPacket(octree, work.eyePicture, {i, j}, glm::ivec2(PacketHits::kEdge),
                          kMaxOctreeDepth, *hits);
    return static_cast<std::size_t>(kEdgePx) * kEdgePx;
}

[[gnu::noinline]] std::size_t loopBake(LoopWork& work) {
    const Result<Octree> baked = bakeOnThreads(work.model.voxels, work.model.voxels.bounds(), 1);
    return baked ? work.model.voxels.solidCount() : 0;
}

[[gnu::noinline]] std::size_t loopNaiveBake(LoopWork& work) {
    return bakeNaively(work.model.voxels) ? work.model.voxels.solidCount() : 0;
}

[[gnu::noinline]] std::size_t loopLiveUpdate(LoopWork& work) {
    for (const LiveOctree::Edit& click : work.clicks)
        if (!work.live.apply({&click, 1})) return 0;
    return work.clicks.size();
}

namespace {

Result<LoopWork> workOn(BenchModel model) {
    LoopWork work;
    work.model = std::move(model);
    const glm::ivec3 size = work.model.octree.size;
    const glm::dmat3 basis = orbitBasis(kFrom);
    OrthoView ortho{basis[0], basis[1], basis[2]};
    ortho.sigmaInForce =
        std::clamp(kEdgePx / glm::length(glm::dvec3(size)), kLeastSigma, kMostSigma);
    Result<LatticeView> lattice = quantiseView(ortho, size);
    if (!lattice) return Failure(lattice.error());
    work.lattice = *lattice;
    work.lattice.first = glm::ivec2(-kEdgePx / 2);
    work.lattice.size = glm::ivec2(kEdgePx);

    const PlacedEntity placed = placeEntity(Entity{}, {{0, 0, 0}, size}, GameProfile{});
    const Camera camera = orbitCamera(kFrom, placed.centreMetres(), 2.7 * placed.radiusMetres(),
                                      45.0, glm::ivec2(kEdgePx));
    work.eyePicture = eyePicture(voxelPlacement(placed), camera);
    if (Status built = work.live.rebuild(work.model.voxels); !built) return Failure(built.error());
    // Voxels spread over the bounds, set and then cleared again.
    const glm::ivec3 origin = work.model.octree.origin;
    for (int k = 0; k < kClicks; ++k) {
        const int n = k / 2;
        const glm::ivec3 at(n * 37 % size.x, n * 61 % size.y, n * 89 % size.z);
        const auto material = static_cast<std::uint8_t>(k % 2 == 0 ? 7 : 0);
        work.clicks.push_back({origin + at, material});
    }
    return work;
}

}  // namespace

Result<Json> benchLoops(const std::vector<BenchModel>&, const Effort& effort) {
    Json figures = Json::array();
    HardwareCounters counters;
    const auto measure = [&](LoopWork& work, const char* loop, const char* unit,
                             std::size_t (*run)(LoopWork&)) -> Status {
        const cli::Stopwatch watch;
        counters.start();
        const std::size_t units = run(work);
        const HardwareCounters::Counts counts = counters.stop();
        const double ms = watch.milliseconds();
        if (units == 0) return fail(work.model.name + ": " + loop + " did nothing");
        Json figure{{"model", work.model.name}, {"loop", loop}, {"unit", unit}, {"count", units}};
        figure["ms"] = ms;
        addCounts(figure, counts, static_cast<double>(units), unit);
        figures.push_back(std::move(figure));
        return {};
    };
    Result<BenchModel> shell = shellModel(128);
    if (!shell) return Failure(shell.error());
    progress(effort, "loops: " + shell->name);
    Result<LoopWork> work = workOn(std::move(*shell));
    if (!work) return Failure(work.error());
    Status done = measure(*work, "scalar_cast", "ray", loopScalarCast);
    if (done) done = measure(*work, "packet_cast", "ray", loopPacketCast);
    if (done) done = measure(*work, "ray_packets", "ray", loopRayPackets);
    if (done) done = measure(*work, "bake", "voxel", loopBake);
    if (done) done = measure(*work, "naive_bake", "voxel", loopNaiveBake);
    if (done) done = measure(*work, "live_update", "click", loopLiveUpdate);
    if (!done) return Failure(done.error());
    return figures;
}

}  // namespace voxprite::bench
