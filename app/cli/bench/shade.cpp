// What occlusion and shadows cost and change: sprites on the processor and on OpenGL, and the voxel
// view, of which the shade between voxels is a choice of its own.
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/cli/bench/bench.h"
#include "app/cli/stopwatch.h"
#include "core/measure/compare.h"
#include "render/scene_renderer.h"
#include "render/voxel_view.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{512, 512};
constexpr double kStrength = 0.6;
constexpr double kLongestPx = 256.0;  // of the model's longest edge in its sprite

struct Kind {
    const char* name;
    double occlusion, shadow;
};
constexpr std::array kKinds{Kind{"off", 0.0, 0.0}, Kind{"occlusion", kStrength, 0.0},
                            Kind{"shadow", 0.0, kStrength}, Kind{"both", kStrength, kStrength}};

GameProfile profileFor(const BenchModel& model) {
    const glm::ivec3 size = model.octree.size;
    const int longest = std::max({size.x, size.y, size.z});
    GameProfile profile;
    profile.sigma =
        std::clamp(std::exp2(std::floor(std::log2(kLongestPx / longest))), kLeastSigma, kMostSigma);
    profile.minification = false;
    return profile;
}

class ShadeBench {
  public:
    ShadeBench(SceneRenderer& renderer, VoxelView& voxelView, const BenchModel& model,
               const Effort& effort)
        : renderer_(renderer),
          voxelView_(voxelView),
          model_(model),
          effort_(effort),
          palette_(model.file.empty() ? Palette::standard() : model.document.palette),
          profile_(profileFor(model)),
          placed_(placeEntity(Entity{}, {glm::ivec3(0), model.octree.size}, profile_)) {
        gpu_.upload(model.octree.view());
    }

    Status run(Json& out) {
        std::optional<Image> plain;
        for (const Kind& kind : kKinds) {
            profile_.light.occlusion = kind.occlusion;
            profile_.light.shadow = kind.shadow;
            const Result<SpriteViewResult> seen = viewSprite(placed_, camera(35.0), profile_);
            if (!seen) return Failure(seen.error());
            const SpriteView& view = *seen->view;
            const LitPalette lit = litPalette(palette_, view.light8, profile_.outline);
            SpriteBuffer buffer;
            const double castMs = medianMs(
                effort_, [&] { buffer = castSprite(model_.octree.view(), view.lattice, lit, 1); });
            const Image image = buffer.image();
            if (!plain) plain = image;
            const Result<ImageComparison> change = compareImages(*plain, image);
            if (!change) return Failure(change.error());
            const Result<double> frame = frameMs();
            if (!frame) return Failure(frame.error());
            const auto hits = static_cast<double>(buffer.opaqueCount());
            out.push_back({{"model", model_.name},
                           {"scene", "sprite"},
                           {"shade", kind.name},
                           {"sigma", profile_.sigma},
                           {"hits", buffer.opaqueCount()},
                           {"ns_a_hit", 1e6 * castMs / hits},
                           {"ms", *frame},
                           {"changed", static_cast<double>(change->mismatched) / hits},
                           {"flip", change->flipInside}});
        }
        runVoxels(out);
        return {};
    }

  private:
    [[nodiscard]] Camera camera(double yawDegrees) const {
        return orbitCamera({yawDegrees, 25.0, 0.0}, placed_.centreMetres(),
                           3.0 * placed_.radiusMetres(), 45.0, kFramePx);
    }

    // A sprite that is seen anew in every frame.
    [[nodiscard]] Result<double> frameMs() {
        Scene scene;
        SceneEntity entity;
        entity.octree = &gpu_;
        entity.palette = &palette_;
        entity.placed = placed_;
        scene.entities.push_back(entity);
        std::optional<Error> failed;
        const double ms = medianMs(effort_, [&] {
            yawDegrees_ += 0.37;
            const auto drawn = renderer_.draw(frame_, scene, camera(yawDegrees_), profile_,
                                              SpriteMode::spriteBuffer);
            if (!drawn) failed = drawn.error();
            glFinish();
        });
        if (failed) return tl::unexpected(*failed);
        return ms;
    }

    void runVoxels(Json& out) {
        const auto add = [&](const char* shade, VoxelOcclusion occlusion, bool shadow) {
            VoxelViewOptions options;
            options.occlusion = occlusion;
            options.shadow = shadow;
            const double ms = medianMs(effort_, [&] {
                voxelView_.draw(frame_, gpu_, palette_, placed_, camera(35.0), options);
                glFinish();
            });
            out.push_back(
                {{"model", model_.name}, {"scene", "voxels"}, {"shade", shade}, {"ms", ms}});
        };
        add("off", VoxelOcclusion::off, false);
        add("corners", VoxelOcclusion::corners, false);
        add("rays", VoxelOcclusion::rays, false);
        add("shadow", VoxelOcclusion::off, true);
    }

    SceneRenderer& renderer_;
    VoxelView& voxelView_;
    const BenchModel& model_;
    Effort effort_;
    Palette palette_;
    GameProfile profile_;
    PlacedEntity placed_;
    GpuOctree gpu_;
    Frame frame_{kFramePx};
    double yawDegrees_ = 0.0;
};

}  // namespace

Result<Json> benchShade(const std::vector<BenchModel>& models, const Effort& effort) {
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    Result<VoxelView> voxelView = VoxelView::create();
    if (!voxelView) return Failure(voxelView.error());
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        // A quick run takes the first sample, and the corpus (of which there is little, too).
        const bool sample = model.name.starts_with("samples/");
        if (model.file.empty() || (effort.quick && sample && !figures.empty())) continue;
        progress(effort, "shade: " + model.name);
        if (Status done = ShadeBench(*renderer, *voxelView, model, effort).run(figures); !done) {
            return Failure(done.error());
        }
    }
    return figures;
}

}  // namespace voxprite::bench
