// Milliseconds a frame by OpenGL: every mode, one entity and a field of them, the camera moving so
// that every frame has to cast anew.
#include <glad/gl.h>

#include <cmath>
#include <memory>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/crowds.h"
#include "render/frame.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"
#include "render/voxel_view.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{512, 512};

class FrameBench {
  public:
    FrameBench(SceneRenderer& renderer, VoxelView& voxelView, const Effort& effort, Json& out)
        : renderer_(renderer), voxelView_(voxelView), effort_(effort), out_(out) {}

    Status run(const BenchModel& model) {
        GpuOctree octree;
        octree.upload(model.octree.view());
        palette_ = model.file.empty() ? Palette::standard() : model.document.palette;
        const PlacedEntity placed = placeEntity(Entity{}, {{0, 0, 0}, model.octree.size}, profile_);
        for (const int edge : {1, 4}) {
            const Scene scene = field(octree, placed, edge);
            for (const auto& [mode, name] : {std::pair{SpriteMode::spriteBuffer, "sprite"},
                                             std::pair{SpriteMode::singlePass, "single_pass"}}) {
                Status status = measureScene(model.name, scene, mode, name);
                if (!status) return status;
            }
        }
        measureVoxels(model.name, octree, placed);
        return {};
    }

  private:
    // edge x edge entities side by side on the ground.
    Scene field(const GpuOctree& octree, const PlacedEntity& placed, int edge) const {
        Scene scene;
        scene.ground = Ground{};
        const double spacing = 2.0 * placed.radiusMetres();
        for (int row = 0; row < edge; ++row) {
            for (int column = 0; column < edge; ++column) {
                PlacedEntity entity = placed;
                entity.anchorMetres = {(column - (edge - 1) / 2.0) * spacing,
                                       groundClearanceMetres(profile_),
                                       (row - (edge - 1) / 2.0) * spacing};
                scene.entities.push_back({&octree, &palette_, entity, nullptr});
            }
        }
        return scene;
    }

    // The next camera of an orbit that never repeats a view.
    Camera nextCamera(double radiusMetres, glm::dvec3 target) {
        yawDegrees_ += 0.37;
        return orbitCamera({yawDegrees_, 25.0, 0.0}, target, 2.7 * radiusMetres, 45.0, kFramePx);
    }

    Status measureScene(const std::string& name, const Scene& scene, SpriteMode mode,
                        const char* modeName) {
        const PlacedEntity& first = scene.entities.front().placed;
        const auto count = static_cast<double>(scene.entities.size());
        const double radius = first.radiusMetres() * std::sqrt(count);
        Status status;
        std::uint64_t rays = 0;
        const double ms = medianMs(effort_, [&] {
            const Camera camera = nextCamera(radius, {0.0, first.centreMetres().y, 0.0});
            const Result<SceneStats> stats = renderer_.draw(frame_, scene, camera, profile_, mode);
            if (!stats)
                status = Failure(stats.error());
            else
                rays = stats->rays;
            glFinish();
        });
        out_.push_back({{"scene", name},
                        {"mode", modeName},
                        {"entities", scene.entities.size()},
                        {"rays", rays},
                        {"ms", ms}});
        return status;
    }

    void measureVoxels(const std::string& name, const GpuOctree& octree,
                       const PlacedEntity& placed) {
        const double ms = medianMs(effort_, [&] {
            const Camera camera = nextCamera(placed.radiusMetres(), placed.centreMetres());
            voxelView_.draw(frame_, octree, palette_, placed, camera, {});
            glFinish();
        });
        out_.push_back({{"scene", name},
                        {"mode", "voxels"},
                        {"entities", 1},
                        {"rays", kFramePx.x * kFramePx.y},
                        {"ms", ms}});
    }

    SceneRenderer& renderer_;
    VoxelView& voxelView_;
    Effort effort_;
    Json& out_;
    GameProfile profile_;
    Palette palette_;
    Frame frame_{kFramePx};
    double yawDegrees_ = 0.0;
};

}  // namespace

Result<Json> benchFrame(const std::vector<BenchModel>& models, const Effort& effort) {
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    Result<VoxelView> voxelView = VoxelView::create();
    if (!voxelView) return Failure(voxelView.error());
    Json figures = Json::array();
    FrameBench bench(*renderer, *voxelView, effort, figures);
    for (const BenchModel& model : models) {
        progress(effort, "frame: " + model.name);
        if (Status status = bench.run(model); !status) return Failure(status.error());
    }
    if (Status status = benchOneSprite(*renderer, models, effort, figures); !status) {
        return Failure(status.error());
    }
    if (Status status = benchCrowds(*renderer, effort, figures); !status) {
        return Failure(status.error());
    }
    return figures;
}

}  // namespace voxprite::bench
