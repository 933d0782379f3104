#include "app/cli/trade/growth.h"

#include <glad/gl.h>

#include <cmath>

#include "app/cli/bench/crowd_scene.h"
#include "app/trade/drawer.h"
#include "core/base/stopwatch.h"
#include "core/base/thread_stopwatch.h"
#include "core/svo/bake.h"
#include "render/gpu_octree.h"
#include "render/measure_representations.h"
#include "render/scene_renderer.h"

namespace voxprite::trade {
namespace {

constexpr int kRepeats = 5;
constexpr double kSizePx = 32.0;  // small, so that it is the casting that counts
constexpr double kTurnDegrees = 3.0;
constexpr int kCrowdPx = 512;

GameProfile plainProfile(double sigma) {
    GameProfile profile;
    profile.sigma = sigma;
    profile.minification = false;  // the sigma that is asked for
    return profile;
}

std::shared_ptr<const Model> shellModel(int size, Status& status) {
    Result<Octree> octree = shellOctree(size);
    if (!octree) {
        status = Failure(octree.error());
        return nullptr;
    }
    return std::make_shared<const Model>(
        Model{"shell" + std::to_string(size), std::move(*octree), Palette::standard(), Entity{}});
}

// A sprite seen anew in every frame, on one thread of the processor.
Result<Growth::Sample> drawSprite(const std::shared_ptr<const Model>& model,
                                  const GameProfile& profile, double sizePx, double size) {
    ModelParts parts(model, profile);
    Result<Drawer> drawer = Drawer::create(parts, profile, settingOf(profile));
    if (!drawer) return Failure(drawer.error());
    Growth::Sample sample;
    sample.size = size;
    std::vector<double> times;
    for (int k = 0; k <= kRepeats; ++k) {
        drawer->forget();
        const Camera camera =
            cameraAtSize(parts.placed().radiusMetres(), sizePx,
                         {17.0 + kTurnDegrees * k, 24.0, 0.0}, glm::ivec2(edgeAtSize(sizePx)));
        const ThreadStopwatch watch;
        const Result<Shown> shown = drawer->draw(camera, false);
        if (!shown) return Failure(shown.error());
        if (k > 0) times.push_back(watch.milliseconds());
        if (k != 1) continue;
        sample.rays = static_cast<double>(drawer->counts().rays);
        sample.bytes = drawer->bytes();
    }
    sample.milliseconds = spreadOf(std::move(times));
    return sample;
}

// Adds a sample for each size until it was stopped; false then.
template <class Make>
Result<bool> addSamples(Growth& growth, const std::vector<double>& sizes, const Progress& progress,
                        Make make) {
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        if (!progress.reached(static_cast<double>(k) / static_cast<double>(sizes.size())))
            return false;
        Result<Growth::Sample> sample = make(sizes[k]);
        if (!sample) return Failure(sample.error());
        growth.samples.push_back(std::move(*sample));
    }
    return true;
}

Result<Growth::Sample> drawCrowd(SceneRenderer& renderer, const std::vector<Octree>& models,
                                 const std::vector<GpuOctree>& octrees, const Palette& palette,
                                 int entities) {
    GameProfile profile;
    const std::vector<bench::CrowdMember> members = bench::crowd(models, entities, profile);
    Scene scene;
    std::vector<ViewHistory> histories(members.size());
    for (std::size_t k = 0; k < members.size(); ++k)
        scene.entities.push_back({&octrees[static_cast<std::size_t>(members[k].model)], &palette,
                                  members[k].placed, &histories[k]});
    Growth::Sample sample;
    sample.size = entities;
    std::vector<double> times;
    Frame frame(glm::ivec2{kCrowdPx});
    for (int k = 0; k <= kRepeats; ++k) {
        const Camera camera =
            orbitCamera({kTurnDegrees * k, 25.0, 0.0}, glm::dvec3(0.0),
                        bench::crowdExtentMetres(entities) + 8.0, 45.0, frame.sizePx());
        const Stopwatch watch;
        const Result<SceneStats> stats =
            renderer.draw(frame, scene, camera, profile, SpriteMode::spriteBuffer);
        if (!stats) return Failure(stats.error());
        glFinish();
        sample.bytes = static_cast<double>(stats->atlasBytes);
        if (k == 0) continue;
        times.push_back(watch.milliseconds());
        sample.rays += static_cast<double>(stats->rays) / kRepeats;
    }
    sample.milliseconds = spreadOf(std::move(times));
    return sample;
}

Result<bool> growWithEntities(Growth& growth, bool quick, const Progress& progress) {
    const Result<std::vector<Octree>> models = bench::crowdModels();
    if (!models) return Failure(models.error());
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    std::vector<GpuOctree> octrees(models->size());
    for (std::size_t k = 0; k < octrees.size(); ++k) octrees[k].upload((*models)[k].view());
    const Palette palette = Palette::standard();
    std::vector<double> counts{1, 10, 100, 1000};
    if (!quick) counts.insert(counts.end(), {10000, 100000});
    return addSamples(growth, counts, progress, [&](double count) {
        return drawCrowd(*renderer, *models, octrees, palette, static_cast<int>(count));
    });
}

}  // namespace

Result<Octree> shellOctree(int size) {
    VoxelGrid grid;
    const double radius = size / 2.0, hollow = radius - 1.0;
    // How far a column reaches from the middle, or less than 0.
    const auto reach = [](double r, double x, double y) {
        const double left = r * r - x * x - y * y;
        return left < 0.0 ? -1.0 : std::sqrt(left);
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double dx = x + 0.5 - radius, dy = y + 0.5 - radius;
            const double outer = reach(radius, dx, dy), inner = reach(hollow, dx, dy);
            for (int z = 0; z < size; ++z) {
                const double dz = std::abs(z + 0.5 - radius);
                if (dz > outer) continue;
                if (dz < inner) {  // on to the other side
                    z = std::max(z, static_cast<int>(radius + inner - 1.5));
                    continue;
                }
                const int octant = (dx >= 0) + 2 * (dy >= 0) + 4 * (z + 0.5 >= radius);
                grid.set({x, y, z}, static_cast<std::uint8_t>(1 + octant));
            }
        }
    return bake(grid);
}

Result<std::vector<Growth>> measureGrowth(bool quick, bool gl, const Progress& progress) {
    std::vector<Growth> all;
    Status status;

    Growth& model = all.emplace_back();
    model.key = "model_size";
    model.title = "model size";
    model.unit = "voxels an edge";
    model.what = "a hollow ball seen anew, sigma 1, one thread of the processor";
    std::vector<double> edges{16, 32, 64, 128};
    if (!quick) edges.insert(edges.end(), {256, 512, 1024});
    Result<bool> done = addSamples(
        model, edges, progress.part(0.0, 0.4), [&](double edge) -> Result<Growth::Sample> {
            const auto shell = shellModel(static_cast<int>(edge), status);
            if (!status) return Failure(status.error());
            return drawSprite(shell, plainProfile(1.0), kSizePx, edge);
        });
    if (!done) return Failure(done.error());
    if (!*done) return all;

    const auto shell = shellModel(64, status);
    if (!status) return Failure(status.error());
    Growth& sigma = all.emplace_back();
    sigma.key = "sigma";
    sigma.title = "sigma";
    sigma.unit = "virtual pixels a voxel";
    sigma.what = "a hollow ball of 64 cubed seen anew, one thread of the processor";
    done = addSamples(
        sigma, {0.25, 0.5, 1, 2, 4, 8, 16}, progress.part(0.4, 0.55),
        [&](double value) { return drawSprite(shell, plainProfile(value), kSizePx, value); });
    if (!done) return Failure(done.error());
    if (!*done) return all;

    for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
        const bool buffer = mode == SpriteMode::spriteBuffer;
        Growth& screen = all.emplace_back();
        screen.key = buffer ? "screen" : "screen_single_pass";
        screen.title = buffer ? "screen size" : "screen size, single_pass";
        screen.unit = "pixels across the model";
        screen.what = std::string("a hollow ball of 64 cubed, sigma 2, ") +
                      (buffer ? "sprite_buffer" : "single_pass") + ", one thread of the processor";
        GameProfile profile = plainProfile(2.0);
        profile.mode = mode;
        done = addSamples(
            screen, {64, 128, 256, 512, 1024},
            progress.part(buffer ? 0.55 : 0.6, buffer ? 0.6 : 0.7),
            [&](double across) { return drawSprite(shell, profile, 0.5 * across, across); });
        if (!done) return Failure(done.error());
        if (!*done) return all;
    }

    Growth& entities = all.emplace_back();
    entities.key = "entities";
    entities.title = "entities";
    entities.unit = "entities of 16 models";
    entities.what = "a crowd with a moving camera, 512 x 512, OpenGL";
    if (!gl) {
        entities.notRun = "needs OpenGL";
        return all;
    }
    done = growWithEntities(entities, quick, progress.part(0.7, 1.0));
    if (!done) return Failure(done.error());
    return all;
}

}  // namespace voxprite::trade
