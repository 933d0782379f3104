#include "app/cli/bench/cluster_frames.h"

#include <glad/gl.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/cli/text_table.h"
#include "core/lod/cluster_cut.h"
#include "core/lod/cluster_mesh.h"
#include "render/cluster_pass.h"
#include "render/frame.h"
#include "render/gpu_clusters.h"
#include "render/gpu_octree.h"
#include "render/voxel_view.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{1024, 768};
constexpr std::array kBudgetsPx{0.0, 1.0, 2.0, 4.0};
// In radii of the model, from its middle.
constexpr std::array kDistances{std::pair{"near", 1.3}, std::pair{"filling", 2.62},
                                std::pair{"far", 12.0}};

// Of all threads: what software drawing costs on a machine that does other things, too.
double processorMs() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto ms = [](const timeval& time) {
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

class FrameBench {
  public:
    FrameBench(VoxelView& view, const Effort& effort, Json& out)
        : view_(view), effort_(effort), out_(out) {}

    Status run(const BenchModel& model) {
        const Result<ClusterMesh> mesh = buildClusters(model.octree.view());
        if (!mesh) return {};  // too large: benchClusters says so
        GpuOctree octree;
        octree.upload(model.octree.view());
        GpuClusters clusters;
        clusters.upload(*mesh);
        const PlacedEntity placed =
            placeEntity(Entity{}, IBox{glm::ivec3(0), model.octree.size}, GameProfile{});
        const Palette palette = model.file.empty() ? Palette::standard() : model.document.palette;
        for (const auto& [name, radii] : kDistances) {
            if (effort_.quick && std::string_view(name) != "filling") continue;
            const Camera camera = orbitCamera({30.0, 25.0, 0.0}, placed.centreMetres(),
                                              radii * placed.radiusMetres(), 45.0, kFramePx);
            const auto draw = [&](const VoxelViewOptions& options) {
                view_.draw(frame_, octree, palette, placed, camera, options);
            };
            VoxelViewOptions options;
            measure(model.name, name, "rays", [&] { draw(options); });
            const Image exact = frame_.readColour();
            const std::vector<float> depth = frame_.readDepth();
            options.clusters = &clusters;
            for (const double budget : kBudgetsPx) {
                options.clusterBudgetPx = budget;
                Json& figure = measure(model.name, name, "clusters", [&] { draw(options); });
                figure["budget_px"] = budget;
                figure["triangles"] = trianglesOf(*mesh, placed, camera, budget);
                figure["wrong"] = wrongShare(exact, depth);
            }
        }
        return {};
    }

  private:
    template <class Draw>
    Json& measure(const std::string& model, const char* distance, const char* mode, Draw draw) {
        int frames = -1;  // the first is not counted
        double processor = 0.0;
        const double ms = medianMs(effort_, [&] {
            const double before = processorMs();
            draw();
            glFinish();
            if (++frames > 0) processor += processorMs() - before;
        });
        out_.push_back({{"model", model},
                        {"distance", distance},
                        {"mode", mode},
                        {"ms", ms},
                        {"processor_ms", processor / frames}});
        return out_.back();
    }

    static std::uint64_t trianglesOf(const ClusterMesh& mesh, const PlacedEntity& placed,
                                     const Camera& camera, double budgetPx) {
        std::vector<std::uint32_t> chosen;
        selectCutPerCluster(
            mesh.pages,
            clusterCutParams(clusterView(placed, mesh.treeFromVoxel, camera, budgetPx), mesh.reach,
                             static_cast<std::uint32_t>(mesh.pages.size())),
            chosen);
        std::uint64_t indices = 0;
        for (const std::uint32_t page : chosen) indices += mesh.pages[page].indexCount;
        return indices / 3;
    }

    // Of the pixels that show the model in either picture.
    double wrongShare(const Image& exact, const std::vector<float>& depth) const {
        const Image shown = frame_.readColour();
        const std::vector<float> shownDepth = frame_.readDepth();
        std::uint64_t wrong = 0, all = 0;
        for (std::size_t k = 0; k < depth.size(); ++k) {
            if (depth[k] == 0.0f && shownDepth[k] == 0.0f) continue;
            ++all;
            const glm::ivec3 off =
                glm::abs(glm::ivec3(shown.pixels[k]) - glm::ivec3(exact.pixels[k]));
            wrong += std::max({off.x, off.y, off.z}) > 4;  // shades of rounding show to nobody
        }
        return all == 0 ? 0.0 : static_cast<double>(wrong) / static_cast<double>(all);
    }

    VoxelView& view_;
    Effort effort_;
    Json& out_;
    Frame frame_{kFramePx};
};

}  // namespace

Status benchClusterFrames(const std::vector<BenchModel>& models, const Effort& effort, Json& out) {
    Result<VoxelView> view = VoxelView::create();
    if (!view) return Failure(view.error());
    FrameBench bench(*view, effort, out);
    for (const int edge : {64, 128, 256, 512}) {
        if (effort.quick && edge > 64) break;
        const Result<BenchModel> shell = shellModel(edge);
        if (!shell) return Failure(shell.error());
        progress(effort, "cluster frames: " + shell->name);
        if (Status status = bench.run(*shell); !status) return status;
    }
    for (const BenchModel& model : models) {
        if (effort.quick || model.name.starts_with("shell")) continue;
        progress(effort, "cluster frames: " + model.name);
        if (Status status = bench.run(model); !status) return status;
    }
    return {};
}

std::string clusterFrameTable(const Json& figures) {
    std::vector<std::vector<std::string>> rows{{"model", "distance", "rays, ms"}};
    for (const double budget : kBudgetsPx) {
        rows[0].push_back("clusters, " + cli::textOf(budget) + " px: ms (wrong pixels)");
    }
    for (const Json& figure : figures) {
        if (!figure.contains("distance")) continue;
        const std::string ms = cli::textOf(std::round(figure["processor_ms"].get<double>()));
        if (figure["mode"] == "rays") {
            rows.push_back(
                {figure["model"].get<std::string>(), figure["distance"].get<std::string>(), ms});
            continue;
        }
        const double wrong = std::round(1000.0 * figure["wrong"].get<double>()) / 10.0;
        rows.back().push_back(ms + " (" + cli::textOf(wrong) + " %)");
    }
    return cli::textOf(rows, cli::TableStyle::markdown);
}

}  // namespace voxprite::bench
