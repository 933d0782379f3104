// Milliseconds a frame of crowds: 16 models, many entities; ours against the specification's way.
#include "app/cli/bench/crowds.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "app/cli/bench/crowd_scene.h"
#include "app/cli/bench/seed_rival.h"
#include "app/cli/stopwatch.h"
#include "core/sprite/view_axes.h"
#include "render/frame.h"
#include "render/gl/timer_query.h"
#include "render/gpu_octree.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{1024, 1024};
constexpr int kAlwaysDrawn = 100;  // however slow the machine is

enum class Way : std::uint8_t { sprite, singlePass, seed };

struct Case {
    Way way = Way::sprite;
    ViewRule view = ViewRule::towardEntity;
    bool moving = false;
    double viewStepDegrees = 0.0;
    int entities = 1;
};

const char* nameOf(Way way) {
    switch (way) {
        case Way::sprite:
            return "sprite";
        case Way::singlePass:
            return "single_pass";
        case Way::seed:
            return "seed";
    }
    return "";
}

Json describe(const Case& what) {
    return {{"scene", "crowd"},
            {"mode", nameOf(what.way)},
            {"entities", what.entities},
            {"view", what.view == ViewRule::cameraForward ? "camera_forward" : "toward_entity"},
            {"camera", what.moving ? "moving" : "still"},
            {"viewStep", what.viewStepDegrees}};
}

class CrowdBench {
  public:
    CrowdBench(SceneRenderer& renderer, SeedRenderer seed, std::vector<Octree> models,
               const Effort& effort, Json& out)
        : renderer_(renderer),
          seed_(std::move(seed)),
          models_(std::move(models)),
          effort_(effort),
          out_(out) {
        for (const Octree& octree : models_) gpuModels_.emplace_back().upload(octree.view());
    }

    // One way of drawing, with more and more entities until that takes too long.
    Status run(Case what) {
        std::optional<double> first;
        double expected = 0.0;
        for (const int entities : {1, 10, 100, 1'000, 10'000, 100'000}) {
            if (effort_.quick && entities > 10'000) break;
            what.entities = entities;
            if (entities > kAlwaysDrawn && expected > mostMs(what.way)) {
                out_.push_back(describe(what));
                out_.back()["ms"] = nullptr;
                out_.back()["skipped"] = "would take about " +
                                         std::to_string(std::lround(expected)) +
                                         " ms a frame, by the scenes before";
                return {};
            }
            progress(effort_, describe(what).dump());
            const Result<double> ms = measure(what);
            if (!ms) return Failure(ms.error());
            if (!first) first = *ms;
            // Ten times the entities, and what a frame takes with hardly any.
            expected = *first + 10.0 * std::max(*ms - *first, 0.0);
        }
        return {};
    }

  private:
    // A frame that takes longer is not waited for.
    [[nodiscard]] double mostMs(Way way) const {
        if (effort_.quick) return 250.0;
        return way == Way::sprite ? 60'000.0 : 5000.0;
    }

    struct Drawn {
        int entities = 0;
        double rays = 0.0;
        double casts = 0.0;
        double castsReused = 0.0;
        int drawCalls = 0;
        std::uint64_t atlasBytes = 0;
    };

    // The next frame of the scene that `measure` has set up.
    Result<Drawn> drawFrame(const Case& what, const Camera& camera) {
        if (what.way == Way::seed) {
            const int drawn = seed_.draw(frame_, members_, camera, profile_).entities;
            return Drawn{.entities = drawn, .drawCalls = drawn};
        }
        const SpriteMode mode =
            what.way == Way::sprite ? SpriteMode::spriteBuffer : SpriteMode::singlePass;
        const Result<SceneStats> stats = renderer_.draw(frame_, scene_, camera, profile_, mode);
        if (!stats) return Failure(stats.error());
        return Drawn{stats->drawn,
                     static_cast<double>(stats->rays),
                     static_cast<double>(stats->casts),
                     static_cast<double>(stats->castsReused),
                     stats->drawCalls,
                     stats->atlasBytes};
    }

    void makeScene(const Case& what) {
        profile_ = GameProfile{};
        profile_.view = what.view;
        profile_.viewStepDegrees = what.viewStepDegrees;
        members_ = crowd(models_, what.entities, profile_);
        histories_.assign(members_.size(), ViewHistory{});
        scene_ = Scene{};
        for (std::size_t k = 0; k < members_.size(); ++k)
            scene_.entities.push_back({&gpuModels_[static_cast<std::size_t>(members_[k].model)],
                                       &palette_, members_[k].placed, &histories_[k]});
    }

    Camera nextCamera(const Case& what) {
        if (what.moving) yawDegrees_ += 0.37;
        return orbitCamera({yawDegrees_, 25.0, 0.0}, {0.0, 1.5, 0.0},
                           4.0 + 1.2 * crowdExtentMetres(what.entities), 45.0, kFramePx);
    }

    Result<double> measure(const Case& what) {
        makeScene(what);
        const Result<Drawn> start = drawFrame(what, nextCamera(what));  // casts what is shown
        if (!start) return Failure(start.error());
        glFinish();
        const cli::Stopwatch total;
        std::vector<double> wallMs, cpuMs, gpuMs;
        // Of the last frame; but rays and casts are those of all of them, for with a view step most
        // frames cast nothing.
        Drawn drawn, sum;
        while (wanted(wallMs, total.milliseconds())) {
            const Camera camera = nextCamera(what);
            const cli::Stopwatch frame;
            gpuTimer_.begin();
            const Result<Drawn> next = drawFrame(what, camera);
            gpuTimer_.end();
            cpuMs.push_back(frame.milliseconds());
            if (!next) return Failure(next.error());
            drawn = *next;
            sum.rays += drawn.rays;
            sum.casts += drawn.casts;
            sum.castsReused += drawn.castsReused;
            glFinish();
            wallMs.push_back(frame.milliseconds());
            gpuMs.push_back(gpuTimer_.waitMs());
        }
        if (what.way == Way::seed)
            drawn.rays = static_cast<double>(
                seed_.countRays(frame_, members_, nextCamera(what), profile_).rays);
        const auto frames = static_cast<double>(wallMs.size());
        const double ms = median(wallMs);
        Json& figure = out_.emplace_back(describe(what));
        figure["drawn"] = drawn.entities;
        // Means a frame.
        figure["rays"] = what.way == Way::seed ? drawn.rays : sum.rays / frames;
        figure["casts"] = sum.casts / frames;
        figure["castsReused"] = sum.castsReused / frames;
        figure["firstRays"] = start->rays;  // of the frame that casts all that is shown
        figure["firstCasts"] = start->casts;
        figure["drawCalls"] = drawn.drawCalls;
        figure["atlasBytes"] = drawn.atlasBytes;
        figure["processBytes"] = processBytes();
        figure["cpuMs"] = median(cpuMs);  // until all commands are given
        figure["gpuMs"] = median(gpuMs);  // between the first command and the end of the last
        figure["ms"] = ms;                // until all is drawn
        figure["meanMs"] = std::accumulate(wallMs.begin(), wallMs.end(), 0.0) / frames;
        figure["mostMs"] = *std::ranges::max_element(wallMs);
        if (what.way == Way::seed && what.entities <= 100) {
            const Result<double> off = seedOff(what);
            if (!off) return Failure(off.error());
            figure["differing"] = *off;
        }
        return ms;
    }

    // The share of the pixels that sprites cover which either way leaves empty and the other does
    // not: the rival draws the same scene, on its own grid.
    Result<double> seedOff(const Case& what) {
        const Camera camera = nextCamera(what);
        seed_.draw(frame_, members_, camera, profile_);
        const Image theirs = frame_.readColour();
        const Result<SceneStats> drawn =
            renderer_.draw(frame_, scene_, camera, profile_, SpriteMode::spriteBuffer);
        if (!drawn) return Failure(drawn.error());
        const Image ours = frame_.readColour();
        double either = 0.0, one = 0.0;
        for (std::size_t k = 0; k < ours.pixels.size(); ++k) {
            const bool a = ours.pixels[k].w != 0, b = theirs.pixels[k].w != 0;
            either += a || b ? 1.0 : 0.0;
            one += a != b ? 1.0 : 0.0;
        }
        return either > 0.0 ? one / either : 0.0;
    }

    // Fewer frames where one takes long.
    [[nodiscard]] bool wanted(const std::vector<double>& ms, double sofarMs) const {
        if (ms.empty()) return true;
        if (sofarMs < effort_.budgetMs()) return true;
        return static_cast<int>(ms.size()) < effort_.minRuns() && ms.back() < effort_.budgetMs();
    }

    SceneRenderer& renderer_;
    SeedRenderer seed_;
    std::vector<Octree> models_;
    std::vector<GpuOctree> gpuModels_;
    Effort effort_;
    Json& out_;
    GameProfile profile_;
    Palette palette_ = Palette::standard();
    std::vector<CrowdMember> members_;
    std::vector<ViewHistory> histories_;
    Scene scene_;
    Frame frame_{kFramePx};
    gl::TimerQuery gpuTimer_;
    double yawDegrees_ = 0.0;
};

}  // namespace

Status benchCrowds(SceneRenderer& renderer, const Effort& effort, Json& out) {
    Result<std::vector<Octree>> models = crowdModels();
    if (!models) return Failure(models.error());
    Result<SeedRenderer> seed = SeedRenderer::create(*models, Palette::standard());
    if (!seed) return Failure(seed.error());
    CrowdBench bench(renderer, std::move(*seed), std::move(*models), effort, out);
    std::vector<Case> cases;
    for (const ViewRule view : {ViewRule::cameraForward, ViewRule::towardEntity}) {
        for (const bool moving : {false, true}) {
            cases.push_back({Way::sprite, view, moving, 0.0});
            if (moving) cases.push_back({Way::sprite, view, moving, kUsualViewStepDegrees});
            cases.push_back({Way::singlePass, view, moving, 0.0});
            if (view == ViewRule::cameraForward) cases.push_back({Way::seed, view, moving, 0.0});
        }
    }
    for (const Case& what : cases)
        if (Status status = bench.run(what); !status) return status;
    return {};
}

}  // namespace voxprite::bench
