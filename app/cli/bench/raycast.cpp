// The octree ray cast on models of depth 5 to 9: rays a second on the processor and in OpenGL, and
// full-screen frames of the voxel view; down to the voxels, and to two levels above them.
#include <glad/gl.h>

#include <array>
#include <glm/matrix.hpp>
#include <span>

#include "app/cli/bench/bench.h"
#include "core/base/parallel.h"
#include "core/sprite/voxel_placement.h"
#include "render/frame.h"
#include "render/gpu_octree.h"
#include "render/ray_batch.h"
#include "render/voxel_view.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{1920, 1080};
constexpr glm::ivec2 kQuickFramePx{960, 540};
constexpr int kLevelsLeftOut = 2;
constexpr OrbitAngles kViews[] = {{30, 20, 0}, {115, 60, 0}, {0, 0, 0}, {45, 35.264, 0}};

// The eye rays of several pictures, in voxel space.
std::vector<Ray> eyeRaysOf(const PlacedEntity& placed, int edgePx) {
    const VoxelPlacement placement = voxelPlacement(placed);
    std::vector<Ray> rays;
    for (const OrbitAngles& angles : kViews) {
        const Camera camera = orbitCamera(angles, placed.centreMetres(),
                                          2.7 * placed.radiusMetres(), 45.0, glm::ivec2(edgePx));
        for (int row = 0; row < edgePx; ++row) {
            for (int column = 0; column < edgePx; ++column) {
                const Camera::Ray ray = camera.rayThrough(glm::dvec2(column, row) + 0.5);
                rays.push_back(voxelRay(placement, {ray.origin, ray.direction}));
            }
        }
    }
    return rays;
}

class RaycastBench {
  public:
    RaycastBench(RayBatch& batch, VoxelView& view, const Effort& effort, Json& out)
        : batch_(batch),
          view_(view),
          effort_(effort),
          out_(out),
          framePx_(effort.quick ? kQuickFramePx : kFramePx),
          frame_(framePx_) {}

    Status run(const BenchModel& model, const char* kind) {
        const int depth = model.octree.maxDepth;
        const OctreeView octree = model.octree.view();
        const PlacedEntity placed = placeEntity(Entity{}, {{0, 0, 0}, octree.size}, GameProfile{});
        const std::vector<Ray> rays = eyeRaysOf(placed, effort_.quick ? 64 : 256);
        GpuOctree gpu;
        gpu.upload(octree);
        if (Status fits = gpu.status(); !fits) return fits;
        for (const int limit : {depth, depth - kLevelsLeftOut}) {
            const auto figure = [&](const char* by) -> Json& {
                return out_.emplace_back(
                    Json{{"model", kind}, {"depth", depth}, {"maxDepth", limit}, {"by", by}});
            };
            const RaycastCounters counters = castOnCpu(octree, rays, limit, figure);
            if (counters.guardReached != 0) return fail(model.name + ": the guard was reached");
            castOnGl(octree, gpu, rays, limit, figure);
            drawFrames(gpu, placed, limit, figure);
        }
        return {};
    }

  private:
    template <class Figure>
    RaycastCounters castOnCpu(const OctreeView& octree, const std::vector<Ray>& rays, int limit,
                              const Figure& figure) {
        const auto count = static_cast<double>(rays.size());
        RaycastCounters counters;
        std::uint64_t hits = 0;
        for (const Ray& ray : rays)
            hits += raycast(octree, ray, {.maxDepth = limit}, &counters).hit ? 1 : 0;
        std::vector<std::uint8_t> values(rays.size());
        for (const int threads : {1, hardwareThreads()}) {
            const double ms = medianMs(effort_, [&] {
                parallelFor(static_cast<int>(rays.size()), threads, [&](int first, int last) {
                    for (auto k = static_cast<std::size_t>(first);
                         k < static_cast<std::size_t>(last); ++k)
                        values[k] = raycast(octree, rays[k], {.maxDepth = limit}).value;
                });
            });
            Json& one = figure("cpu");
            one["threads"] = threads;
            one["mrays_per_s"] = count / ms / 1000.0;
            one["hits"] = static_cast<double>(hits) / count;
            one["iterations_a_ray"] = static_cast<double>(counters.iterations) / count;
            one["nodes_a_ray"] = static_cast<double>(counters.nodes) / count;
            if (hardwareThreads() == 1) break;
        }
        return counters;
    }

    template <class Figure>
    void castOnGl(const OctreeView& octree, const GpuOctree& gpu, const std::vector<Ray>& rays,
                  int limit, const Figure& figure) {
        std::vector<QuantisedRay> quantised;
        quantised.reserve(rays.size());
        for (const Ray& ray : rays) quantised.push_back(quantiseRay(octree, ray, limit));
        batch_.upload(quantised);
        const double ms = medianMs(effort_, [&] {
            batch_.cast(gpu);
            glFinish();
        });
        std::size_t differing = 0;
        const std::vector<LatticeHit> hits = batch_.readHits();
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const LatticeHit want = castQuantised(octree, quantised[k]);
            const bool same = hits[k].material == want.material &&
                              (want.material == 0 ||
                               (hits[k].voxel == want.voxel && hits[k].faceAxis == want.faceAxis));
            differing += same ? 0 : 1;
        }
        Json& one = figure("gl");
        one["mrays_per_s"] = static_cast<double>(rays.size()) / ms / 1000.0;
        one["differing"] = differing;
    }

    template <class Figure>
    void drawFrames(const GpuOctree& gpu, const PlacedEntity& placed, int limit,
                    const Figure& figure) {
        VoxelViewOptions options;
        options.maxDepth = limit;
        double yaw = 0.0;
        const double ms = medianMs(effort_, [&] {
            yaw += 0.37;
            const Camera camera = orbitCamera({yaw, 20.0, 0.0}, placed.centreMetres(),
                                              1.8 * placed.radiusMetres(), 45.0, framePx_);
            view_.draw(frame_, gpu, palette_, placed, camera, options);
            glFinish();
        });
        Json& one = figure("frame");
        one["size"] = {framePx_.x, framePx_.y};
        one["ms"] = ms;
        one["frames_per_s"] = 1000.0 / ms;
    }

    RayBatch& batch_;
    VoxelView& view_;
    Effort effort_;
    Json& out_;
    glm::ivec2 framePx_;
    Palette palette_ = Palette::standard();
    Frame frame_;
};

}  // namespace

Result<Json> benchRaycast(const std::vector<BenchModel>&, const Effort& effort) {
    Result<RayBatch> batch = RayBatch::create();
    if (!batch) return Failure(batch.error());
    Result<VoxelView> view = VoxelView::create();
    if (!view) return Failure(view.error());
    Json figures = Json::array();
    RaycastBench bench(*batch, *view, effort, figures);
    constexpr std::array kKinds{std::pair{"shell", &shellModel},
                                std::pair{"random", &scatteredModel}};
    for (int depth = 5; depth <= (effort.quick ? 6 : 9); ++depth) {
        for (const auto& [kind, make] : kKinds) {
            const Result<BenchModel> model = make(1 << depth);
            if (!model) return Failure(model.error());
            progress(effort, "raycast: " + model->name);
            if (Status status = bench.run(*model, kind); !status) return Failure(status.error());
        }
    }
    return figures;
}

}  // namespace voxprite::bench
