// Rays a second: parallel rays of sprites and perspective rays of the voxel view.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/rivals.h"
#include "core/base/parallel.h"
#include "core/sprite/sprite_view.h"
#include "core/trace/lattice_caster.h"
#include "core/trace/raycast.h"

namespace voxprite::bench {
namespace {

// Two views of no special direction, and those that are hard: along an axis and isometric.
constexpr OrbitAngles kViews[] = {{30, 20, 0}, {115, 60, 0}, {0, 0, 0}, {45, 35.264, 0}};
// Of the model's longest edge on the sprite: about as many rays whatever the model's size.
constexpr double kEdgePx = 256.0;

// The rays of one picture, made beforehand: what is measured is casting alone.
struct Rays {
    std::vector<Ray> rays;
    std::vector<LatticeRay> latticeRays;  // the same ones as integers; parallel rays only
};

Rays parallelRays(const LatticeView& lattice) {
    Rays rays;
    for (int row = 0; row < lattice.size.y; ++row) {
        for (int column = 0; column < lattice.size.x; ++column) {
            const LatticeRay ray = rayOf(lattice, lattice.first + glm::ivec2(column, row));
            rays.latticeRays.push_back(ray);
            rays.rays.push_back({glm::dvec3(ray.origin) / std::ldexp(1.0, ray.positionBits),
                                 glm::dvec3(ray.direction),
                                 -std::numeric_limits<double>::infinity()});
        }
    }
    return rays;
}

Rays perspectiveRays(const PlacedEntity& placed, const Camera& camera) {
    const glm::dmat3 voxelFromWorld = glm::transpose(placed.worldFromVoxelAxes);
    Rays rays;
    for (int row = 0; row < camera.viewportPx.y; ++row) {
        for (int column = 0; column < camera.viewportPx.x; ++column) {
            const Camera::Ray ray = camera.rayThrough(glm::dvec2(column, row) + 0.5);
            const glm::dvec3 eye =
                voxelFromWorld * (ray.origin - placed.anchorMetres) / placed.metresPerVoxel() +
                placed.anchor;
            rays.rays.push_back({eye, voxelFromWorld * ray.direction, 0.0});
        }
    }
    return rays;
}

void append(Rays& all, Rays more) {
    all.rays.insert(all.rays.end(), more.rays.begin(), more.rays.end());
    all.latticeRays.insert(all.latticeRays.end(), more.latticeRays.begin(), more.latticeRays.end());
}

// The rays of all views, parallel and perspective.
struct Load {
    Rays parallel, perspective;
};

Result<Load> loadOf(const BenchModel& model, const Effort& effort) {
    GameProfile profile;
    const glm::ivec3 size = model.octree.size;
    profile.sigma = std::clamp(kEdgePx / std::max({size.x, size.y, size.z}), 1.0 / 64.0, 2.0);
    profile.minification = false;
    const PlacedEntity placed = placeEntity(Entity{}, {{0, 0, 0}, size}, profile);
    Load load;
    for (const OrbitAngles& angles : std::span(kViews).first(effort.quick ? 2 : 4)) {
        const Camera camera =
            orbitCamera(angles, placed.centreMetres(), 2.7 * placed.radiusMetres(), 45.0,
                        glm::ivec2(effort.quick ? 128 : 256));
        const Result<SpriteViewResult> sprite = viewSprite(placed, camera, profile);
        if (!sprite) return Failure(sprite.error());
        if (!sprite->view) return fail(model.name + ": is not seen");
        append(load.parallel, parallelRays(sprite->view->lattice));
        append(load.perspective, perspectiveRays(placed, camera));
    }
    return load;
}

using Materials = std::vector<std::uint8_t>;

template <class Cast>
void castAll(Materials& hits, int threads, const Cast& cast) {
    constexpr int chunk = 256;
    const int count = static_cast<int>(hits.size());
    parallelFor((count + chunk - 1) / chunk, threads, [&](int first, int last) {
        const int end = std::min(count, last * chunk);
        for (auto k = static_cast<std::size_t>(first * chunk); k < static_cast<std::size_t>(end);
             ++k) {
            hits[k] = cast(k);
        }
    });
}

class CastBench {
  public:
    CastBench(const BenchModel& model, const Load& load, const Effort& effort, Json& out)
        : model_(model), octree_(model.octree.view()), load_(load), effort_(effort), out_(out) {}

    void run() {
        const auto& latticeRays = load_.parallel.latticeRays;
        const auto& eyeRays = load_.perspective.rays;
        const Materials noTruth;
        const Materials parallelTruth =
            measure("parallel", "scalar", latticeRays.size(), noTruth,
                    [&](std::size_t k) { return castLattice(octree_, latticeRays[k]).material; });
        const Materials perspectiveTruth =
            measure("perspective", "scalar", eyeRays.size(), noTruth, [&](std::size_t k) {
                return raycast(octree_, {eyeRays[k].origin, eyeRays[k].direction}).value;
            });
        const auto measureRival = [&](const char* name, const auto& cast) {
            const auto& rays = load_.parallel.rays;
            measure("parallel", name, rays.size(), parallelTruth,
                    [&](std::size_t k) { return cast(rays[k]); });
            measure("perspective", name, eyeRays.size(), perspectiveTruth,
                    [&](std::size_t k) { return cast(eyeRays[k]); });
        };
        measureRival("octree_restart", [&](const Ray& ray) { return castByRestart(octree_, ray); });
        const glm::dvec3 size(octree_.size);
        if (size.x * size.y * size.z > static_cast<double>(DenseGrid::kMaxVoxels)) return;
        const DenseGrid dense(octree_);
        measureRival("dense_dda", [&](const Ray& ray) { return dense.cast(ray); });
    }

  private:
    // One figure for one thread, one for all; what was hit. `truth` is empty for our own caster.
    template <class Cast>
    Materials measure(const char* kind, const char* name, std::size_t count, const Materials& truth,
                      const Cast& cast) {
        Materials hits(count);
        std::vector<int> threadCounts{1};
        if (hardwareThreads() > 1) threadCounts.push_back(hardwareThreads());
        for (const int threads : threadCounts) {
            const double ms = medianMs(effort_, [&] { castAll(hits, threads, cast); });
            Json figure{{"model", model_.name},
                        {"kind", kind},
                        {"caster", name},
                        {"threads", threads},
                        {"mrays_per_s", static_cast<double>(count) / ms / 1000.0},
                        {"rays", count}};
            if (!truth.empty()) figure["differing"] = differing(hits, truth);
            out_.push_back(std::move(figure));
        }
        return hits;
    }

    // The share of rays that a rival, in floating point, sees end elsewhere than we do.
    static double differing(const Materials& a, const Materials& b) {
        std::size_t count = 0;
        for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k] ? 1 : 0;
        return static_cast<double>(count) / static_cast<double>(a.size());
    }

    const BenchModel& model_;
    OctreeView octree_;
    const Load& load_;
    Effort effort_;
    Json& out_;
};

}  // namespace

Result<Json> benchCast(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        const Result<Load> load = loadOf(model, effort);
        if (!load) return Failure(load.error());
        CastBench(model, *load, effort, figures).run();
    }
    return figures;
}

}  // namespace voxprite::bench
