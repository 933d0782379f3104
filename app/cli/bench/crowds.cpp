// Milliseconds a frame of crowds: 16 models, many entities, sprite buffers against the way of one
// draw an entity and one ray a fragment.
#include "app/cli/bench/crowds.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <random>

#include "core/svo/bake.h"
#include "render/frame.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"

namespace voxprite::bench {
namespace {

constexpr glm::ivec2 kFramePx{1024, 1024};
constexpr int kModels = 16;

void fill(VoxelGrid& grid, glm::ivec3 low, glm::ivec3 high, std::uint8_t colour) {
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) grid.set({x, y, z}, colour);
}

// Somebody with legs, a body, arms and a head; no two are of the same build.
VoxelGrid person(int number) {
    const int width = 8 + number % 4 * 2;
    const int legs = 8 + number / 4 * 3;
    const auto colour = static_cast<std::uint8_t>(1 + 5 * number);
    VoxelGrid grid;
    fill(grid, {3, 0, 0}, {6, 5, legs}, colour);
    fill(grid, {width, 0, 0}, {width + 3, 5, legs}, colour);
    fill(grid, {3, 0, legs}, {width + 3, 6, legs + 12}, colour + 1);
    fill(grid, {0, 1, legs + 3}, {3, 4, legs + 11}, colour + 2);
    fill(grid, {width + 3, 1, legs + 3}, {width + 6, 4, legs + 11}, colour + 2);
    fill(grid, {width / 2, 0, legs + 12}, {width / 2 + 6, 6, legs + 18}, colour + 3);
    return grid;
}

struct Case {
    int entities;
    ViewRule view;
    bool moving;
    SpriteMode mode;
};

double msSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

class CrowdBench {
  public:
    CrowdBench(SceneRenderer& renderer, const Effort& effort, Json& out)
        : renderer_(renderer), effort_(effort), out_(out) {}

    Status prepare() {
        for (int k = 0; k < kModels; ++k) {
            Result<Octree> octree = bake(person(k));
            if (!octree) return Failure(octree.error());
            octrees_.emplace_back().upload(octree->view());
        }
        return {};
    }

    // One way of drawing, with more and more entities until that takes too long.
    Status run(ViewRule view, bool moving, SpriteMode mode) {
        profile_.view = view;
        std::optional<double> first;
        double expected = 0.0;
        for (const int entities : {1, 10, 100, 1'000, 10'000, 100'000}) {
            if (effort_.quick && entities > 10'000) break;
            const Case next{entities, view, moving, mode};
            if (expected > mostMs()) {
                out_.push_back(describe(next));
                out_.back()["ms"] = nullptr;
                out_.back()["skipped"] = "would take about " +
                                         std::to_string(std::lround(expected)) +
                                         " ms a frame, by the scenes before";
                return {};
            }
            const Result<double> ms = measure(next);
            if (!ms) return Failure(ms.error());
            if (!first) first = *ms;
            // Ten times the entities, and what a frame takes with hardly any.
            expected = *first + 10.0 * std::max(*ms - *first, 0.0);
        }
        return {};
    }

  private:
    [[nodiscard]] double mostMs() const { return effort_.quick ? 300.0 : 5000.0; }

    static Json describe(const Case& what) {
        const bool buffered = what.mode == SpriteMode::spriteBuffer;
        return {{"scene", "crowd"},
                {"mode", buffered ? "sprite" : "single_pass"},
                {"entities", what.entities},
                {"view", what.view == ViewRule::cameraForward ? "camera_forward" : "toward_entity"},
                {"camera", what.moving ? "moving" : "still"}};
    }

    // In rows, each turned by a multiple of 45 degrees.
    Scene crowd(int entities) {
        std::mt19937 random(3);
        Scene scene;
        const int columns = columnsOf(entities);
        for (int k = 0; k < entities; ++k) {
            const auto& octree = octrees_[static_cast<std::size_t>(k % kModels)];
            Entity entity;
            entity.yawDegrees = 45.0 * static_cast<double>(random() % 8);
            const auto jitter = [&] { return 0.01 * static_cast<double>(random() % 60); };
            entity.positionMetres = {(k % columns - 0.5 * columns) * kSpacingMetres + jitter(),
                                     groundClearanceMetres(profile_),
                                     (k / columns - 0.5 * columns) * kSpacingMetres + jitter()};
            const IBox bounds{glm::ivec3(0), octree.size()};
            scene.entities.push_back(
                {&octree, &palette_, placeEntity(entity, bounds, profile_), nullptr});
        }
        return scene;
    }

    static int columnsOf(int entities) {
        return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(entities))));
    }

    Result<double> measure(const Case& what) {
        const Scene scene = crowd(what.entities);
        const double extent = columnsOf(what.entities) * kSpacingMetres;
        Status status;
        SceneStats stats;
        std::vector<double> cpuMs;
        const double ms = medianMs(effort_, [&] {
            if (what.moving) yawDegrees_ += 0.37;
            const Camera camera = orbitCamera({yawDegrees_, 25.0, 0.0}, {0.0, 1.5, 0.0},
                                              4.0 + 1.2 * extent, 45.0, kFramePx);
            const auto start = std::chrono::steady_clock::now();
            const Result<SceneStats> drawn =
                renderer_.draw(frame_, scene, camera, profile_, what.mode);
            cpuMs.push_back(msSince(start));
            if (drawn)
                stats = *drawn;
            else
                status = Failure(drawn.error());
            glFinish();
        });
        if (!status) return Failure(status.error());
        const auto middle = cpuMs.begin() + static_cast<std::ptrdiff_t>(cpuMs.size() / 2);
        std::nth_element(cpuMs.begin(), middle, cpuMs.end());
        Json& figure = out_.emplace_back(describe(what));
        figure["drawn"] = stats.drawn;
        figure["rays"] = stats.rays;
        figure["casts"] = stats.casts;
        figure["castsReused"] = stats.castsReused;
        figure["drawCalls"] = stats.drawCalls;
        figure["atlasBytes"] = stats.atlasBytes;
        figure["cpuMs"] = *middle;  // until all commands are given
        figure["ms"] = ms;          // until all is drawn
        return ms;
    }

    static constexpr double kSpacingMetres = 2.5;

    SceneRenderer& renderer_;
    Effort effort_;
    Json& out_;
    GameProfile profile_;
    Palette palette_ = Palette::standard();
    std::vector<GpuOctree> octrees_;
    Frame frame_{kFramePx};
    double yawDegrees_ = 0.0;
};

}  // namespace

Status benchCrowds(SceneRenderer& renderer, const Effort& effort, Json& out) {
    CrowdBench bench(renderer, effort, out);
    if (Status status = bench.prepare(); !status) return status;
    for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
        for (const ViewRule view : {ViewRule::cameraForward, ViewRule::towardEntity}) {
            for (const bool moving : {false, true}) {
                if (Status status = bench.run(view, moving, mode); !status) return status;
            }
        }
    }
    return {};
}

}  // namespace voxprite::bench
