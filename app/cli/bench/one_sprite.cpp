// One large sprite: what casting a ray a virtual pixel gains over casting one a screen pixel.
#include <glad/gl.h>

#include <algorithm>
#include <array>
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
        profile_.sigma =
            std::clamp(std::exp2(std::round(std::log2(wanted))), kLeastSigma, kMostSigma);
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
    Result<SceneStats> clear() {
        return renderer_.draw(frame_, Scene{}, camera(0.0), profile_, SpriteMode::spriteBuffer);
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

// Of frames drawn in turns, so that what else the machine does weighs on all of them; the fastest
// are those it disturbed least.
struct Times {
    double medianMs = 0.0;
    double fastestMs = 0.0;

    Times() = default;
    explicit Times(const std::vector<double>& ms)
        : medianMs(median(ms)), fastestMs(*std::min_element(ms.begin(), ms.end())) {}
};
struct TimesOfAll {
    Times single, buffered;
    Times clear;  // of a frame that shows nothing
};

Result<TimesOfAll> timesOf(OneSprite& sprite, const Effort& effort, SceneStats& single,
                           SceneStats& buffered) {
    std::array<std::vector<double>, 3> ms;
    double yaw = 0.0;
    const auto drawn = [&](std::size_t kind) -> Result<SceneStats> {
        yaw += 0.37;
        const cli::Stopwatch watch;
        const Camera camera = sprite.camera(yaw);
        Result<SceneStats> stats = kind == 0   ? sprite.draw(camera, SpriteMode::singlePass)
                                   : kind == 1 ? sprite.draw(camera, SpriteMode::spriteBuffer)
                                               : sprite.clear();
        glFinish();
        ms[kind].push_back(watch.milliseconds());
        return stats;
    };
    const cli::Stopwatch total;
    while (static_cast<int>(ms[0].size()) < effort.minRuns() ||
           total.milliseconds() < 3.0 * effort.budgetMs()) {
        for (std::size_t kind = 0; kind < ms.size(); ++kind) {
            const Result<SceneStats> stats = drawn(kind);
            if (!stats) return Failure(stats.error());
            if (kind == 0) single = *stats;
            if (kind == 1) buffered = *stats;
        }
    }
    return TimesOfAll{Times(ms[0]), Times(ms[1]), Times(ms[2])};
}

}  // namespace

Status benchOneSprite(SceneRenderer& renderer, const std::vector<BenchModel>& models,
                      const Effort& effort, Json& out) {
    for (const BenchModel& model : models) {
        if (effort.quick && &model + 2 < models.data() + models.size()) continue;
        OneSprite sprite(renderer, model);
        progress(effort, "one sprite: " + model.name);
        if (Status agree = checkModesAgree(sprite, model.name); !agree) return agree;
        SceneStats single, buffered;
        const Result<TimesOfAll> times = timesOf(sprite, effort, single, buffered);
        if (!times) return Failure(times.error());
        const auto figure = [&](const char* mode, const SceneStats& stats, double ms) -> Json& {
            return out.emplace_back(Json{{"scene", "one_sprite"},
                                         {"model", model.name},
                                         {"mode", mode},
                                         {"entities", 1},
                                         {"sigma", sprite.sigma()},
                                         {"screenPxPerPx", stats.screenPxPerPx},
                                         {"rays", stats.rays},
                                         {"ms", ms}});
        };
        figure("single_pass", single, times->single.medianMs);
        Json& ours = figure("sprite", buffered, times->buffered.medianMs);
        const double clear = times->clear.fastestMs;
        const double theirs = times->single.fastestMs;
        const double fastest = times->buffered.fastestMs;
        ours["clearMs"] = clear;
        ours["timesFaster"] = (theirs - clear) / std::max(fastest - clear, 1e-3);
        ours["timesFasterWithClear"] = theirs / fastest;
    }
    return {};
}

}  // namespace voxprite::bench
