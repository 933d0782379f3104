// One large sprite: what casting a ray a virtual pixel gains over casting one a screen pixel.
#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "app/cli/bench/crowds.h"
#include "app/cli/stopwatch.h"
#include "render/frame.h"
#include "render/gpu_octree.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{1024, 1024};
constexpr double kScreenPxPerPx = 8.0;
constexpr double kFovDegrees = 45.0;

class OneSprite {
  public:
    OneSprite(SceneRenderer& renderer, const BenchModel& model)
        : renderer_(renderer),
          palette_(model.file.empty() ? Palette::standard() : model.document.palette) {
        octree_.upload(model.octree.view());
        // So many virtual pixels a voxel that the longest edge fills three quarters of the picture.
        const glm::ivec3 size = model.octree.size;
        const int longest = std::max({size.x, size.y, size.z});
        const double wanted = 0.75 * kFramePx.y / kScreenPxPerPx / longest;
        profile_.sigma = std::exp2(std::round(std::log2(wanted)));
        profile_.depth = DepthRule::centre;
        profile_.viewStepDegrees = 0.0;
        SceneEntity entity;
        entity.octree = &octree_;
        entity.palette = &palette_;
        entity.placed = placeEntity(Entity{}, {glm::ivec3(0), size}, profile_);
        scene_.entities.push_back(entity);
    }

    // At the distance where a virtual pixel is kScreenPxPerPx wide.
    [[nodiscard]] Camera camera(double yawDegrees) const {
        const double metresPerScreenPx = profile_.voxelSizeMetres / profile_.sigma / kScreenPxPerPx;
        const Camera one = orbitCamera({}, glm::dvec3(0.0), 1.0, kFovDegrees, kFramePx);
        const double distance = metresPerScreenPx / one.metresPerScreenPx(1.0);
        return orbitCamera({yawDegrees, 20.0, 0.0}, scene_.entities[0].placed.centreMetres(),
                           distance, kFovDegrees, kFramePx);
    }
    Result<SceneStats> draw(const Camera& seen, SpriteMode mode) {
        return renderer_.draw(frame_, scene_, seen, profile_, mode);
    }
    Status clear() {
        const Result<SceneStats> drawn =
            renderer_.draw(frame_, Scene{}, camera(0.0), profile_, SpriteMode::spriteBuffer);
        return drawn ? Status{} : Failure(drawn.error());
    }
    [[nodiscard]] Image picture() const { return frame_.readColour(); }
    [[nodiscard]] double sigma() const { return profile_.sigma; }

  private:
    SceneRenderer& renderer_;
    GameProfile profile_;
    Palette palette_;
    GpuOctree octree_;
    Scene scene_;
    Frame frame_{kFramePx};
};

Status checkModesAgree(OneSprite& sprite, const std::string& name) {
    for (const double yaw : {0.0, 33.3, 151.0}) {
        const Camera camera = sprite.camera(yaw);
        const Result<SceneStats> buffered = sprite.draw(camera, SpriteMode::spriteBuffer);
        if (!buffered) return Failure(buffered.error());
        const Image picture = sprite.picture();
        const Result<SceneStats> single = sprite.draw(camera, SpriteMode::singlePass);
        if (!single) return Failure(single.error());
        if (sprite.picture().pixels != picture.pixels)
            return fail(name + ": the two modes give different pictures");
    }
    return {};
}

}  // namespace

Status benchOneSprite(SceneRenderer& renderer, const std::vector<BenchModel>& models,
                      const Effort& effort, Json& out) {
    double yaw = 0.0;
    for (const BenchModel& model : models) {
        OneSprite sprite(renderer, model);
        progress(effort, "one sprite: " + model.name);
        if (Status agree = checkModesAgree(sprite, model.name); !agree) return agree;
        Status status;
        SceneStats stats;
        const auto msOf = [&](SpriteMode mode) {
            return medianMs(effort, [&] {
                yaw += 0.37;
                const Result<SceneStats> drawn = sprite.draw(sprite.camera(yaw), mode);
                if (drawn)
                    stats = *drawn;
                else
                    status = Failure(drawn.error());
                glFinish();
            });
        };
        const auto figure = [&](const char* mode, double ms) -> Json& {
            return out.emplace_back(Json{{"scene", "one_sprite"},
                                         {"model", model.name},
                                         {"mode", mode},
                                         {"entities", 1},
                                         {"sigma", sprite.sigma()},
                                         {"screenPxPerPx", stats.screenPxPerPx},
                                         {"rays", stats.rays},
                                         {"ms", ms}});
        };
        const double clearMs = medianMs(effort, [&] {
            if (Status cleared = sprite.clear(); !cleared) status = cleared;
            glFinish();
        });
        const double singleMs = msOf(SpriteMode::singlePass);
        figure("single_pass", singleMs);
        const double bufferedMs = msOf(SpriteMode::spriteBuffer);
        Json& ours = figure("sprite", bufferedMs);
        ours["clearMs"] = clearMs;  // in both: of a frame that shows nothing
        ours["timesFaster"] = (singleMs - clearMs) / (bufferedMs - clearMs);
        ours["timesFasterWithClear"] = singleMs / bufferedMs;
        if (!status) return status;
    }
    return {};
}

}  // namespace voxprite::bench
