// Rays a second: parallel rays of sprites and perspective rays of the voxel view.
#include <cmath>
#include <memory>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/rivals.h"
#include "core/base/parallel.h"
#include "core/sprite/sprite_view.h"
#include "core/trace/lattice_caster.h"

namespace voxprite::bench {
namespace {

// Views that differ in what they are hard for: along an axis, isometric, and two between.
constexpr OrbitAngles kViews[] = {{0, 0, 0}, {45, 35.264, 0}, {30, 20, 0}, {115, 60, 0}};
constexpr int kPerspectivePx = 256;
constexpr double kSigma = 2.0;

struct View {
    LatticeView lattice;  // parallel rays
    PlacedEntity placed;
    Camera camera;  // perspective rays
};

Result<std::vector<View>> viewsOf(const BenchModel& model) {
    GameProfile profile;
    profile.sigma = kSigma;
    profile.minification = false;
    const IBox bounds{{0, 0, 0}, model.octree.size};
    std::vector<View> views;
    for (const OrbitAngles& angles : kViews) {
        View view;
        view.placed = placeEntity(Entity{}, bounds, profile);
        view.camera =
            orbitCamera(angles, view.placed.centreMetres(), 2.7 * view.placed.radiusMetres(), 45.0,
                        glm::ivec2(kPerspectivePx));
        const Result<SpriteViewResult> sprite = viewSprite(view.placed, view.camera, profile);
        if (!sprite) return Failure(sprite.error());
        if (!sprite->view) return fail(model.name + ": is not seen");
        view.lattice = sprite->view->lattice;
        views.push_back(view);
    }
    return views;
}

// The materials that the rays of a picture hit, row by row: any caster can be put to the same rays.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> materials;
};

template <class Cast>
void castPicture(Picture& picture, int threads, const Cast& cast) {
    parallelFor(picture.height, threads, [&](int firstRow, int lastRow) {
        for (int row = firstRow; row < lastRow; ++row) {
            std::uint8_t* out =
                picture.materials.data() +
                static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width);
            for (int column = 0; column < picture.width; ++column) *out++ = cast(column, row);
        }
    });
}

Picture emptyPicture(int width, int height) {
    return {width, height,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(height))};
}

Ray doubleRay(const LatticeView& lattice, int column, int row) {
    const LatticeRay ray = rayOf(lattice, lattice.first + glm::ivec2(column, row));
    return {glm::dvec3(ray.origin) / std::ldexp(1.0, ray.positionBits), glm::dvec3(ray.direction),
            -std::numeric_limits<double>::infinity()};
}

Ray perspectiveRay(const View& view, int column, int row) {
    const Camera::Ray ray = view.camera.rayThrough(glm::dvec2(column, row) + 0.5);
    const glm::dmat3 voxelFromWorld = glm::transpose(view.placed.worldFromVoxelAxes);
    const glm::dvec3 eye =
        voxelFromWorld * (ray.origin - view.placed.anchorMetres) / view.placed.metresPerVoxel() +
        view.placed.anchor;
    return {eye, voxelFromWorld * ray.direction, 0.0};
}

class CastBench {
  public:
    CastBench(const BenchModel& model, std::vector<View> views, const Effort& effort, Json& out)
        : model_(model), views_(std::move(views)), effort_(effort), out_(out) {
        const glm::dvec3 size(model.octree.size);
        if (size.x * size.y * size.z <= static_cast<double>(DenseGrid::kMaxVoxels)) {
            dense_ = std::make_unique<DenseGrid>(model.octree.view());
        }
    }

    void run() {
        const OctreeView octree = model_.octree.view();
        const auto parallelTruth = [&](const View& v, int x, int y) {
            return castLattice(octree, rayOf(v.lattice, v.lattice.first + glm::ivec2(x, y)))
                .material;
        };
        const auto perspectiveTruth = [&](const View& v, int x, int y) {
            const Ray ray = perspectiveRay(v, x, y);
            return castPerspective(octree, ray.origin, ray.direction).hit.material;
        };
        measure("parallel", "scalar", parallelTruth, parallelTruth);
        measure("perspective", "scalar", perspectiveTruth, perspectiveTruth);
        const auto restart = [&](const Ray& ray) { return castByRestart(octree, ray); };
        measureRival("octree_restart", restart, parallelTruth, perspectiveTruth);
        if (dense_) {
            const auto walk = [&](const Ray& ray) { return dense_->cast(ray); };
            measureRival("dense_dda", walk, parallelTruth, perspectiveTruth);
        }
    }

  private:
    template <class Cast, class Parallel, class Perspective>
    void measureRival(const char* name, const Cast& cast, const Parallel& parallelTruth,
                      const Perspective& perspectiveTruth) {
        measure(
            "parallel", name,
            [&](const View& v, int x, int y) { return cast(doubleRay(v.lattice, x, y)); },
            parallelTruth);
        measure(
            "perspective", name,
            [&](const View& v, int x, int y) { return cast(perspectiveRay(v, x, y)); },
            perspectiveTruth);
    }

    // One figure for one thread, one for all.
    template <class Cast, class Truth>
    void measure(const std::string& kind, const char* name, const Cast& cast, const Truth& truth) {
        double rays = 0.0;
        double differing = 0.0;
        std::vector<Picture> pictures;
        for (const View& view : views_) {
            pictures.push_back(kind == "parallel"
                                   ? emptyPicture(view.lattice.size.x, view.lattice.size.y)
                                   : emptyPicture(kPerspectivePx, kPerspectivePx));
            Picture& picture = pictures.back();
            Picture expected = picture;
            castPicture(picture, 0, [&](int x, int y) { return cast(view, x, y); });
            castPicture(expected, 0, [&](int x, int y) { return truth(view, x, y); });
            for (std::size_t k = 0; k < picture.materials.size(); ++k) {
                differing += picture.materials[k] != expected.materials[k] ? 1.0 : 0.0;
            }
            rays += static_cast<double>(picture.materials.size());
        }
        std::vector<int> threadCounts{1};
        if (hardwareThreads() > 1) threadCounts.push_back(hardwareThreads());
        for (const int threads : threadCounts) {
            const double ms = medianMs(effort_, [&] {
                for (std::size_t k = 0; k < views_.size(); ++k) {
                    castPicture(pictures[k], threads,
                                [&](int x, int y) { return cast(views_[k], x, y); });
                }
            });
            out_.push_back({{"model", model_.name},
                            {"kind", kind},
                            {"caster", name},
                            {"threads", threads},
                            {"mrays_per_s", rays / ms / 1000.0},
                            {"rays", rays},
                            {"differing", differing / rays}});
        }
    }

    const BenchModel& model_;
    std::vector<View> views_;
    Effort effort_;
    Json& out_;
    std::unique_ptr<DenseGrid> dense_;
};

}  // namespace

Result<Json> benchCast(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        Result<std::vector<View>> views = viewsOf(model);
        if (!views) return Failure(views.error());
        CastBench(model, std::move(*views), effort, figures).run();
    }
    return figures;
}

}  // namespace voxprite::bench
