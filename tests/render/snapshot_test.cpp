// Snapshots on OpenGL: cast, kept and drawn as on the CPU.
#include <array>
#include <cmath>

#include "render/snapshot_renderer.h"
#include "tests/render/scene_support.h"

namespace voxprite::test {
namespace {

class GpuSnapshots : public Scenes {
  protected:
    void SetUp() override {
        Scenes::SetUp();
        snapshots_.emplace(must(SnapshotRenderer::create()));
    }
    void TearDown() override {
        snapshots_.reset();
        Scenes::TearDown();
    }
    static SnapshotEntity standing(const GpuModel& model, glm::dvec3 anchorMetres,
                                   double yawDegrees = 0.0) {
        return {&model.gpu, &model.palette, model.placedAt(anchorMetres, GameProfile{}, yawDegrees),
                nullptr};
    }
    static SnapshotLight lightOf(const SnapshotEntity& entity, const GameProfile& profile) {
        return {*entity.palette, profile.light, glm::transpose(entity.placed.worldFromVoxelAxes),
                profile.outline, profile.shading};
    }
    struct Drawn {
        Image colour;
        std::vector<float> depth;
        SnapshotStats stats;
    };
    Drawn drawn(std::span<const SnapshotEntity> entities, const Camera& camera,
                const SnapshotRules& rules, const GameProfile& profile = GameProfile{}) {
        Frame frame(camera.viewportPx);
        frame.begin(kBackground);
        const SnapshotStats stats = must(snapshots_->draw(frame, entities, camera, profile, rules));
        return {frame.readColour(), frame.readDepth(), stats};
    }
    // The same by the CPU, from the GPU's own snapshots: so that the blit alone is compared.
    SnapshotCanvas blitted(std::span<const SnapshotEntity> entities, const Camera& camera,
                           const SnapshotRules& rules) {
        SnapshotCanvas canvas(camera.viewportPx, kBackground);
        for (const SnapshotEntity& entity : entities) {
            const SeenSnapshots seen =
                must(seeSnapshots(entity.placed, camera, rules.views, rules.sizePx, rules.choice));
            std::vector<Snapshot> held;
            held.reserve(seen.shown.size());
            std::vector<BlitSource> sources;
            for (const ShownSnapshot& shown : seen.shown) {
                held.push_back(must(snapshots_->cast(entity, GameProfile{}, rules, shown.view)));
                sources.push_back({&held.back(), &shown.plane, shown.weight});
            }
            blitSnapshots(sources, entity.placed.metresPerVoxel(), rules.choice.depth, camera,
                          canvas);
        }
        return canvas;
    }

    std::optional<SnapshotRenderer> snapshots_;
};

// Of ten thousand pixels of models a few may lie on the other side of a voxel's edge: the shader
// aims its rays in single precision.
constexpr double kMostOther = 0.0005;

TEST_F(GpuSnapshots, AreTheCpusButAtEdges) {
    GameProfile profile;
    std::uint64_t covered = 0;
    std::uint64_t silhouettes = 0;
    std::uint64_t colours = 0;
    for (const GpuModel* model : crowdModels()) {
        const SnapshotEntity entity = standing(*model, glm::dvec3(0.0), 30.0);
        for (const int sizePx : {64, 128}) {
            const SnapshotRules rules{ViewSet(), sizePx, {}};
            for (int view = 0; view < rules.views.count(); view += sizePx == 64 ? 1 : 5) {
                const Snapshot gpu = must(snapshots_->cast(entity, profile, rules, view));
                const Snapshot cpu = castSnapshot(model->octree.view(), lightOf(entity, profile),
                                                  rules.views, view, sizePx);
                ASSERT_EQ(gpu.buffer.ids.size(), cpu.buffer.ids.size());
                for (std::size_t at = 0; at < cpu.depth.size(); ++at) {
                    const bool hit = cpu.buffer.ids[at] != kIdEmpty;
                    covered += hit ? 1 : 0;
                    silhouettes += hit != (gpu.buffer.ids[at] != kIdEmpty) ? 1 : 0;
                    if (gpu.buffer.colours[at] != cpu.buffer.colours[at]) {
                        ++colours;
                    } else if (hit) {
                        EXPECT_NEAR(gpu.depth[at], cpu.depth[at], 0.01);
                    }
                }
            }
        }
    }
    EXPECT_GT(covered, 50'000u);
    EXPECT_LE(static_cast<double>(silhouettes), kMostOther * static_cast<double>(covered));
    EXPECT_LE(static_cast<double>(colours), kMostOther * static_cast<double>(covered));
}

TEST_F(GpuSnapshots, AreBlittedAsOnTheCpu) {
    const std::array entities{standing(*figure_, {-0.9, 0.0, 0.3}, 20.0),
                              standing(*letters_, {0.2, 0.0, 0.7}, -75.0),
                              standing(*ball_, {0.7, 0.0, -0.9}, 33.0)};
    for (const SnapshotDepth depth : {SnapshotDepth::centre, SnapshotDepth::perPixel}) {
        for (const bool blend : {false, true}) {
            SnapshotRules rules{must(ViewSet::octahedral(8)), 48, {depth, blend}};
            for (const Camera& eye : {camera(31.0, 12.0), camera(-140.0, 55.0, 9.0, 20.0),
                                      camera(10.0, 89.0), parallel(60.0, 30.0)}) {
                const Drawn gpu = drawn(entities, eye, rules);
                const SnapshotCanvas cpu = blitted(entities, eye, rules);
                std::uint64_t shown = 0;
                std::uint64_t other = 0;
                std::uint64_t depths = 0;
                for (std::size_t at = 0; at < cpu.depths.size(); ++at) {
                    shown += cpu.depths[at] != 0.0f ? 1 : 0;
                    const glm::ivec4 off = glm::abs(glm::ivec4(gpu.colour.pixels[at]) -
                                                    glm::ivec4(cpu.colours.pixels[at]));
                    // A mean of colours may be rounded the other way.
                    other += std::max({off.x, off.y, off.z, off.w}) > (blend ? 1 : 0) ? 1 : 0;
                    depths += std::abs(gpu.depth[at] - cpu.depths[at]) > 1e-4f * cpu.depths[at];
                }
                EXPECT_GT(shown, 3000u);
                EXPECT_LE(other, shown / 500) << "depth " << int(depth) << " blend " << blend;
                EXPECT_LE(depths, shown / 100) << "depth " << int(depth) << " blend " << blend;
            }
        }
    }
}

TEST_F(GpuSnapshots, AreCastOnceAndOnlyForWhatHasChanged) {
    std::vector<SnapshotEntity> entities;
    for (int n = 0; n < 30; ++n)
        entities.push_back(standing(*figure_, {0.3 * n - 4.0, 0.0, -0.2 * n}));
    const SnapshotRules rules{ViewSet(), 32, {}};
    const Camera eye = camera(20.0, 30.0, 14.0);
    const Drawn first = drawn(entities, eye, rules);
    EXPECT_EQ(first.stats.drawn, 30);
    EXPECT_EQ(first.stats.drawCalls, 1);
    EXPECT_GE(first.stats.cast, 1);
    EXPECT_LT(first.stats.cast, 9);  // they share views
    EXPECT_EQ(first.stats.held, first.stats.cast);
    EXPECT_GT(first.stats.bytes, 0u);
    const Drawn again = drawn(entities, eye, rules);
    EXPECT_EQ(again.stats.cast, 0);
    EXPECT_EQ(again.colour, first.colour);
    EXPECT_EQ(again.depth, first.depth);
    // Another model's voxels or colours, and another light.
    entities[3] = standing(*ball_, {0.0, 0.0, 0.0});
    EXPECT_EQ(drawn(entities, eye, rules).stats.cast, 1);
    figure_->palette.colours[1] = Rgba8(1, 2, 3, 255);
    EXPECT_EQ(drawn(entities, eye, rules).stats.cast, first.stats.cast);
    GameProfile dark;
    dark.light.ambient = 0.1;
    EXPECT_EQ(drawn(entities, eye, rules, dark).stats.cast, first.stats.cast + 1);
    const VoxelGrid other = solidBox(figure_->octree.size);
    figure_->gpu.upload(must(bake(other)).view());
    EXPECT_EQ(drawn(entities, eye, rules, dark).stats.cast, first.stats.cast);
}

TEST_F(GpuSnapshots, StayWithinTheirMemoryAndLoseNoPicture) {
    std::vector<SnapshotEntity> entities;
    for (int n = 0; n < 24; ++n)
        entities.push_back(standing(*figure_, {0.35 * n - 4.0, 0.0, 0.2 * n - 2.0}, 15.0 * n));
    const SnapshotRules rules{must(ViewSet::hemisphere(12)), 32, {}};
    const Camera eye = camera(20.0, 30.0, 14.0);
    const Drawn roomy = drawn(entities, eye, rules);
    EXPECT_EQ(roomy.stats.drawCalls, 1);
    const std::uint64_t each = 8u * 32u * 32u;
    snapshots_.emplace(must(SnapshotRenderer::create(4 * each)));
    const Drawn tight = drawn(entities, eye, rules);
    EXPECT_GT(tight.stats.drawCalls, 1);
    EXPECT_LE(tight.stats.held, 4);
    EXPECT_LE(tight.stats.bytes, 4 * each);
    EXPECT_EQ(mismatches(roomy.colour, tight.colour), 0u);
}

TEST_F(GpuSnapshots, OfWhatIsNotSeenNothingIsCast) {
    const Camera eye = camera(0.0, 0.0);
    const std::array entities{standing(*figure_, eye.eyeMetres - eye.forward * 5.0),
                              standing(*figure_, eye.eyeMetres + eye.forward * 5000.0)};
    const Drawn nothing = drawn(entities, eye, {ViewSet(), 32, {}});
    EXPECT_EQ(nothing.stats.unseen, 2);
    EXPECT_EQ(nothing.stats.cast, 0);
    for (const float depth : nothing.depth) EXPECT_EQ(depth, 0.0f);
    EXPECT_FALSE(snapshots_->cast(entities[0], GameProfile{}, {ViewSet(), 0, {}}, 0));
}

// Kind `sprite` on OpenGL: the scene's entities with a set of views.
TEST_F(GpuSnapshots, SpritesOfTheirViewsAreTheExactSprites) {
    GameProfile profile = plainProfile();
    const ViewSet sets[] = {ViewSet(), must(ViewSet::octahedral(12))};
    for (const GpuModel* model : crowdModels()) {
        for (const ViewSet& views : sets) {
            for (const double sigma : {1.5, 4.0}) {
                profile.sigma = sigma;
                profile.depth = sigma == 4.0 ? DepthRule::perPixel : DepthRule::groundSafe;
                for (int view = 1; view < views.count(); view += views.count() / 5) {
                    Scene scene;
                    scene.background = kBackground;
                    scene.entities = {entity(*model, glm::dvec3(0.0), profile)};
                    PlacedEntity& placed = scene.entities[0].placed;
                    placed.anchorMetres -= placed.centreMetres();
                    const glm::dmat3 axes = views.axes(view);
                    Camera eye = camera(0.0, 0.0);
                    eye.right = worldFromVoxel(axes[0]);
                    eye.up = worldFromVoxel(axes[1]);
                    eye.forward = worldFromVoxel(axes[2]);
                    eye.eyeMetres = eye.forward * -5.0;
                    const Picture exact = Scenes::draw(scene, eye, profile);
                    scene.entities[0].views = &views;
                    scene.entities[0].representation = Representation::snapshot;
                    const Picture snapshot = Scenes::draw(scene, eye, profile);
                    EXPECT_EQ(exact.stats.drawn, 1);
                    EXPECT_EQ(mismatches(exact.colour, snapshot.colour), 0u) << views.name();
                    EXPECT_EQ(exact.depth, snapshot.depth);
                    EXPECT_EQ(snapshot.stats.casts, 0u);  // one sprite, one place in the atlas
                }
            }
        }
    }
}

}  // namespace
}  // namespace voxprite::test
