// Clusters: how long they take to build, what each level costs, and what a budget saves and shows.
#include <algorithm>
#include <cstdint>
#include <ctime>
#include <glm/geometric.hpp>
#include <optional>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/cluster_frames.h"
#include "app/cli/stopwatch.h"
#include "core/lod/cluster_cut.h"
#include "core/lod/cluster_mesh.h"
#include "core/measure/mask.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "render/cluster_pass.h"
#include "render/cluster_renderer.h"
#include "render/frame.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{512, 512};
constexpr double kFovDegrees = 45.0;
constexpr double kLastingMs = 1000.0;  // longer builds are measured once
constexpr int kMostOverhangPx = 64;    // what is searched

// Medians, of the time that passed and of that in which the processor worked on it (on all threads
// together): the latter hardly depends on what else the machine does.
Result<Json> buildFigure(const BenchModel& model, int threads, const Effort& effort) {
    std::vector<double> passed;
    std::vector<double> worked;
    Result<ClusterMesh> mesh;
    do {
        const std::clock_t start = std::clock();
        const cli::Stopwatch watch;
        mesh = buildClusters(model.octree.view(), {.threads = threads});
        if (!mesh) return Failure(mesh.error());
        passed.push_back(watch.milliseconds());
        worked.push_back(1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    } while (static_cast<int>(passed.size()) < effort.minRuns() && passed[0] < kLastingMs);
    return Json{{"model", model.name},
                {"threads", threads},
                {"build_ms", median(passed)},
                {"processor_ms", median(worked)},
                {"clusters", mesh->pages.size()},
                {"triangles", mesh->indices.size() / 3},
                {"bytes", mesh->bytes()}};
}

void levelFigures(const BenchModel& model, const ClusterMesh& mesh, Json& out) {
    for (std::size_t level = 0; level < mesh.levels.size(); ++level) {
        const ClusterLevel& each = mesh.levels[level];
        const std::uint64_t bytes =
            each.quadCount * (4 * sizeof(ClusterVertex) + 6 * sizeof(std::uint32_t)) +
            each.pageCount * (sizeof(ClusterPage) + 1);
        out.push_back({{"model", model.name},
                       {"level", level},
                       {"error_voxels", each.errorVoxels},
                       {"clusters", each.pageCount},
                       {"triangles", 2 * each.quadCount},
                       {"bytes", bytes}});
    }
}

// One model before a camera, a voxel at most a pixel wide, drawn from clusters.
class View {
  public:
    View(ClusterRenderer& renderer, const BenchModel& model, const ClusterMesh& mesh)
        : renderer_(renderer), mesh_(mesh), palette_(Palette::standard()) {
        gpu_.upload(mesh);
        const IBox box{glm::ivec3(0), model.octree.size};
        placed_ = placeEntity(Entity{}, box, profile_);
        // A voxel is a pixel wide, or less where the model would not fit the picture.
        const Camera one = orbitCamera({}, glm::dvec3(0.0), 1.0, kFovDegrees, kFramePx);
        const double radius =
            0.5 * profile_.voxelSizeMetres * glm::length(glm::dvec3(model.octree.size));
        const double distance =
            std::max(profile_.voxelSizeMetres / one.metresPerScreenPx(1.0), 2.7 * radius);
        camera_ =
            orbitCamera({30.0, 25.0, 0.0}, placed_.centreMetres(), distance, kFovDegrees, kFramePx);
    }

    [[nodiscard]] std::vector<std::uint32_t> cut(double budgetPx) const {
        std::vector<std::uint32_t> chosen;
        selectCutPerCluster(
            mesh_.pages,
            clusterCutParams(clusterView(placed_, mesh_.treeFromVoxel, camera_, budgetPx),
                             mesh_.reach, static_cast<std::uint32_t>(mesh_.pages.size())),
            chosen);
        return chosen;
    }
    Result<Mask> silhouette(double budgetPx) {
        frame_.begin({0, 0, 0, 0});
        const ClusterInstance instance{&gpu_, &palette_, placed_};
        ClusterOptions options;
        options.budgetPx = budgetPx;
        const auto drawn =
            renderer_.draw(frame_, camera_, profile_, std::span(&instance, 1), options);
        if (!drawn) return Failure(drawn.error());
        return silhouetteOf(frame_.readColour());
    }

  private:
    ClusterRenderer& renderer_;
    const ClusterMesh& mesh_;
    GameProfile profile_;
    Palette palette_;
    GpuClusters gpu_;
    PlacedEntity placed_;
    Camera camera_;
    Frame frame_{kFramePx};
};

// Pixels of `a` that `b` has not.
std::uint64_t without(const Mask& a, const Mask& b) {
    return a.count() - overlapOf(a, b).common;
}

// By how many pixels, along an axis or a diagonal, a silhouette sticks out of the exact one.
std::optional<int> overhangPx(const Mask& exact, const Mask& shown) {
    for (int px = 0; px <= kMostOverhangPx; ++px) {
        if (without(shown, dilated(exact, px)) == 0) return px;
    }
    return {};
}

Status budgetFigures(ClusterRenderer& renderer, const BenchModel& model, const ClusterMesh& mesh,
                     Json& out) {
    View view(renderer, model, mesh);
    const Result<Mask> exact = view.silhouette(0.0);
    if (!exact) return Failure(exact.error());
    for (const double budgetPx : {0.0, 1.0, 2.0, 4.0, 8.0, 16.0}) {
        const std::vector<std::uint32_t> chosen = view.cut(budgetPx);
        std::uint64_t indices = 0;
        for (const std::uint32_t page : chosen) indices += mesh.pages[page].indexCount;
        const Result<Mask> shown = view.silhouette(budgetPx);
        if (!shown) return Failure(shown.error());
        const std::optional<int> overhang = overhangPx(*exact, *shown);
        out.push_back({{"model", model.name},
                       {"budget_px", budgetPx},
                       {"clusters", chosen.size()},
                       {"triangles", indices / 3},
                       {"overhang_px", overhang ? Json(*overhang) : Json(nullptr)},
                       {"missing_px", without(*exact, *shown)}});
    }
    return {};
}

}  // namespace

Result<Json> benchClusters(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    Result<ClusterRenderer> renderer = ClusterRenderer::create();
    if (!renderer) return Failure(renderer.error());
    for (const BenchModel& model : models) {
        progress(effort, "clusters: " + model.name);
        for (const int threads : {1, 0}) {
            if (Result<Json> figure = buildFigure(model, threads, effort))
                figures.push_back(std::move(*figure));
        }
        const Result<ClusterMesh> mesh = buildClusters(model.octree.view());
        if (!mesh) {
            figures.push_back({{"model", model.name}, {"refused", mesh.error().message}});
            continue;
        }
        levelFigures(model, *mesh, figures);
        if (mesh->pages.empty()) continue;
        if (Status ok = budgetFigures(*renderer, model, *mesh, figures); !ok)
            return Failure(ok.error());
    }
    if (Status ok = benchClusterFrames(models, effort, figures); !ok) return Failure(ok.error());
    return figures;
}

}  // namespace voxprite::bench
