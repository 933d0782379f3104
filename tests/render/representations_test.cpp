// A scene in which entities are drawn by something else than their exact sprites, and the figures
// by which that is chosen.
#include "core/measure/compare.h"
#include "core/measure/mask.h"
#include "core/sprite/view_set.h"
#include "render/measure_representations.h"
#include "tests/render/scene_support.h"

namespace voxprite::test {
namespace {

constexpr RepresentationChoice kSprite{};
constexpr RepresentationChoice kSnapshot{Representation::snapshot, 0};
constexpr RepresentationChoice kClusters{Representation::clusters, 0};
constexpr RepresentationChoice coarse(int levels) {
    return {Representation::coarse, levels};
}

int drawnBy(const SceneStats& stats, Representation kind) {
    return stats.drawnBy[static_cast<std::size_t>(kind)];
}

class Representations : public Scenes {
  protected:
    void SetUp() override {
        Scenes::SetUp();
        levels_ = std::make_unique<GpuModelLevels>(must(buildModelLevels(figure_->octree)));
    }
    void TearDown() override {
        levels_.reset();
        Scenes::TearDown();
    }
    Scene alone(RepresentationChoice choice, const GameProfile& profile) const {
        Scene scene;
        scene.background = kBackground;
        scene.entities = {voxprite::drawnBy(entity(*figure_, {0, 0, 0}, profile, 20), choice,
                                            levels_.get(), views_)};
        return scene;
    }
    MeasuredModel measured(const GameProfile& profile) const {
        return {&figure_->gpu, &figure_->palette, figure_->placedAt({3, 1, 2}, profile),
                levels_.get(), &views_,           1.0};
    }

    std::unique_ptr<GpuModelLevels> levels_;
    ViewSet views_;
};

TEST_F(Representations, AModelOffersWhatItHasLevelsFor) {
    EXPECT_EQ(choicesOf(*levels_),
              (std::vector<RepresentationChoice>{kSprite, kSnapshot, kClusters, coarse(1),
                                                 coarse(2), coarse(3)}));
    for (const RepresentationChoice choice : choicesOf(*levels_)) {
        EXPECT_TRUE(levels_->offers(choice));
    }
    EXPECT_FALSE(levels_->offers(coarse(0)));
    EXPECT_FALSE(levels_->offers(coarse(4)));
    const GpuModelLevels none;
    EXPECT_EQ(choicesOf(none), (std::vector<RepresentationChoice>{kSprite, kSnapshot}));
    // What is not there is drawn as it is.
    const SceneEntity exact = entity(*figure_, {0, 0, 0}, {}, 20);
    EXPECT_EQ(voxprite::drawnBy(exact, coarse(1), &none, views_).octree, exact.octree);
    EXPECT_EQ(voxprite::drawnBy(exact, kClusters, &none, views_).representation,
              Representation::sprite);
}

TEST_F(Representations, SizeIsTheModelsRadiusOnTheScreen) {
    const PlacedEntity placed = figure_->placedAt({0.5, 0.2, -1.0}, {});
    const Camera view = camera(30, 20, 9.0);
    const double sizePx = representationSizePx(placed, view);
    // As far to the side as the radius is long: so many pixels to the side.
    const glm::dvec3 centre = placed.centreMetres();
    const auto at = view.project(centre);
    const auto beside = view.project(centre + view.right * placed.radiusMetres());
    EXPECT_NEAR(beside.screenPx.x - at.screenPx.x, sizePx, 1e-9);
    Camera away = view;
    away.forward = -away.forward;
    away.right = -away.right;
    EXPECT_TRUE(std::isnan(representationSizePx(placed, away)));
}

TEST_F(Representations, ASnapshotIsTheSpriteOfTheNearestView) {
    const GameProfile profile = plainProfile();
    const Camera view = camera(33, 24);
    const Scene scene = alone(kSnapshot, profile);
    const PlacedEntity& placed = scene.entities.front().placed;
    const SpriteView seen = *must(viewSnapshot(placed, view, profile, views_)).view;
    const SpriteBuffer buffer =
        castSprite(figure_->octree.view(), seen.lattice,
                   litPalette(figure_->palette, seen.light8, profile.outline));
    const CompositeSprite sprite{&seen, &buffer, nullptr};
    const Picture drawn = draw(scene, view, profile);
    EXPECT_LE(mismatches(drawn.colour, composite({&sprite, 1}, view, kBackground)), 2u);
    EXPECT_GT(mismatches(drawn.colour, draw(alone(kSprite, profile), view, profile).colour), 100u);
    EXPECT_EQ(drawnBy(drawn.stats, Representation::snapshot), 1);
}

// The editor's set of views is changed where it lies, and nothing else need be.
TEST_F(Representations, AnotherSetOfViewsInTheSamePlaceIsShown) {
    const GameProfile profile = plainProfile();
    const Camera view = camera(33, 24);
    const Scene scene = alone(kSnapshot, profile);
    const Image coarsely = draw(scene, view, profile).colour;
    views_ = must(ViewSet::octahedral(12));
    const Image changed = draw(scene, view, profile).colour;
    EXPECT_GT(mismatches(changed, coarsely), 100u);
    renderer_.emplace(must(SceneRenderer::create()));
    EXPECT_EQ(mismatches(draw(scene, view, profile).colour, changed), 0u);
}

TEST_F(Representations, SnapshotsOfACrowdAreCastOnceAView) {
    const GameProfile profile = plainProfile();
    Scene scene;
    for (int k = 0; k < 200; ++k) {
        const glm::dvec3 at(0.9 * (k % 20) - 9.0, 0.0, -0.9 * (k / 20));
        scene.entities.push_back(voxprite::drawnBy(entity(*figure_, at, profile, 90.0), kSnapshot,
                                                   levels_.get(), views_));
    }
    const Camera view = orbitCamera({10, 25, 0}, {0, 1, -4}, 30.0, 45.0, kViewport);
    const Picture drawn = draw(scene, view, profile);
    EXPECT_EQ(drawnBy(drawn.stats, Representation::snapshot), 200);
    EXPECT_LE(drawn.stats.casts, 6u);
    EXPECT_GT(drawn.stats.casts, 1u);
    EXPECT_EQ(drawn.stats.casts + drawn.stats.castsReused, 200u);
}

TEST_F(Representations, ACoarseModelCoversTheFineOne) {
    GameProfile profile = plainProfile();
    profile.outline.enabled = false;
    for (const double yaw : {0.0, 45.0, 111.0}) {
        const Camera view = camera(yaw, 20);
        const Image exact = draw(alone(kSprite, profile), view, profile).colour;
        for (int left = 1; left <= 3; ++left) {
            const Picture drawn = draw(alone(coarse(left), profile), view, profile);
            EXPECT_EQ(drawnBy(drawn.stats, Representation::coarse), 1);
            std::uint64_t uncovered = 0, covered = 0;
            for (std::size_t k = 0; k < exact.pixels.size(); ++k) {
                if (exact.pixels[k] == kBackground) continue;
                ++covered;
                if (drawn.colour.pixels[k] == kBackground) ++uncovered;
            }
            EXPECT_GT(covered, 1000u);
            // Of a voxel's edge a sample may see one side here and the other there.
            EXPECT_LE(uncovered, covered / 100) << yaw << " " << left;
        }
    }
}

TEST_F(Representations, ClustersStandWhereTheSpriteDoes) {
    GameProfile profile = plainProfile();
    profile.outline.enabled = false;
    const Camera view = camera(33, 24, 30.0);
    Scene scene = alone(kClusters, profile);
    scene.clusterBudgetPx = 0.0;
    const Picture mesh = draw(scene, view, profile);
    const Picture sprite = draw(alone(kSprite, profile), view, profile);
    EXPECT_EQ(drawnBy(mesh.stats, Representation::clusters), 1);
    EXPECT_EQ(mesh.stats.drawn, 1);
    EXPECT_EQ(mesh.stats.unseen, 0);
    EXPECT_GE(mesh.stats.drawCalls, 1);
    std::uint64_t differing = 0, covered = 0;
    for (std::size_t k = 0; k < mesh.colour.pixels.size(); ++k) {
        const bool inMesh = mesh.colour.pixels[k] != kBackground;
        const bool inSprite = sprite.colour.pixels[k] != kBackground;
        covered += inSprite;
        differing += inMesh != inSprite;
    }
    EXPECT_GT(covered, 150u);
    EXPECT_LT(differing, covered / 5);
}

// All kinds in one scene hide each other by depth, whatever their order in the scene.
TEST_F(Representations, KindsAreComposedByDepth) {
    GameProfile profile = plainProfile();
    const Camera view = orbitCamera({0, 5, 0}, {0, 1.5, 0}, 14.0, 45.0, kViewport);
    const std::vector<RepresentationChoice> kinds{kSprite, kSnapshot, kClusters, coarse(1)};
    for (std::size_t front = 0; front < kinds.size(); ++front) {
        for (std::size_t back = 0; back < kinds.size(); ++back) {
            Scene both, near;
            const auto at = [&](RepresentationChoice kind, double x, double z) {
                return voxprite::drawnBy(entity(*figure_, {x, 0, z}, profile), kind, levels_.get(),
                                         views_);
            };
            near.entities = {at(kinds[front], 0.0, 3.0)};
            both.entities = {at(kinds[front], 0.0, 3.0), at(kinds[back], 1.5, -3.0)};
            const Picture alone = draw(near, view, profile);
            const Picture drawn = draw(both, view, profile);
            std::ranges::reverse(both.entities);
            EXPECT_EQ(draw(both, view, profile).colour, drawn.colour);
            std::uint64_t hidden = 0, shown = 0;
            for (std::size_t k = 0; k < alone.colour.pixels.size(); ++k) {
                const bool inFront = alone.colour.pixels[k].w == 255;
                hidden += inFront && drawn.colour.pixels[k] != alone.colour.pixels[k];
                shown += !inFront && drawn.colour.pixels[k].w == 255;
            }
            EXPECT_EQ(hidden, 0u) << front << " before " << back;
            EXPECT_GT(shown, 20u) << front << " before " << back;
        }
    }
}

TEST_F(Representations, OfASceneThatStandsStillAnotherChoiceIsSeen) {
    const GameProfile profile = plainProfile();
    const Camera view = camera(33, 24);
    const Image sprite = draw(alone(kSprite, profile), view, profile).colour;
    const Image snapshot = draw(alone(kSnapshot, profile), view, profile).colour;
    EXPECT_NE(sprite, snapshot);
    EXPECT_NE(draw(alone(kClusters, profile), view, profile).colour, snapshot);
    EXPECT_EQ(draw(alone(kSnapshot, profile), view, profile).colour, snapshot);
    EXPECT_EQ(draw(alone(kSprite, profile), view, profile).colour, sprite);
}

TEST_F(Representations, AModelShowsAsLargeAsItIsMeasured) {
    const GameProfile profile = plainProfile();
    const PlacedEntity placed = figure_->placedAt({0, 0, 0}, profile);
    for (const double sizePx : {4.0, 31.0, 128.0}) {
        const Camera view = cameraAtSize(placed.radiusMetres(), sizePx, {40, 30, 0},
                                         glm::ivec2(edgeAtSize(sizePx)));
        EXPECT_TRUE(validate(view));
        PlacedEntity atOrigin = placed;
        atOrigin.anchorMetres -= placed.centreMetres();
        EXPECT_NEAR(representationSizePx(atOrigin, view), sizePx, 1e-9 * sizePx);
        const Image picture = must(
            pictureAtSize(*renderer_, measured(profile), profile, kSprite, sizePx, {40, 30, 0}));
        const Mask silhouette = silhouetteOf(picture);
        EXPECT_GT(silhouette.count(), 0u);
        for (int k = 0; k < picture.width; ++k) {
            EXPECT_EQ(picture.at(k, 0).w + picture.at(0, k).w +
                          picture.at(k, picture.height - 1).w + picture.at(picture.width - 1, k).w,
                      0);
        }
    }
}

TEST_F(Representations, FiguresAreTheWorstOfTheirViews) {
    const GameProfile profile = plainProfile();
    const MeasuringPlan plan{.sizesPx = {8, 24}, .views = 3, .seed = 9, .costs = false};
    const RepresentationTable table =
        must(measureRepresentations(*renderer_, measured(profile), profile, plan));
    ASSERT_EQ(table.size(), 6u);
    for (const RepresentationFigures& figures : table) {
        ASSERT_EQ(figures.bySize.size(), 2u);
        for (const auto& figure : figures.bySize) {
            double worst = 0.0;
            for (const OrbitAngles& view : viewsOf(plan)) {
                const auto picture = [&](RepresentationChoice choice) {
                    return must(pictureAtSize(*renderer_, measured(profile), profile, choice,
                                              figure.sizePx, view));
                };
                worst =
                    std::max(worst, must(flipInside(picture(kSprite), picture(figures.choice))));
            }
            EXPECT_EQ(figure.error, worst);
            EXPECT_EQ(figure.microseconds, 0.0);
            EXPECT_EQ(figure.error > 0.0, figures.choice != kSprite);
        }
    }
    EXPECT_LT(errorAt(*figuresOf(table, coarse(1)), 24), errorAt(*figuresOf(table, coarse(3)), 24));
}

TEST_F(Representations, CostsAreMeasuredStepByStep) {
    const GameProfile profile = plainProfile();
    RepresentationMeter meter(measured(profile), profile, {.sizesPx = {8}, .views = 1});
    double share = -1.0;
    int steps = 0;
    for (; !meter.done(); ++steps) {
        EXPECT_GT(meter.share(), share);
        share = meter.share();
        ASSERT_TRUE(meter.step(*renderer_));
    }
    EXPECT_EQ(steps, 12);  // six compared, six timed
    EXPECT_EQ(meter.share(), 1.0);
    double most = 0.0;
    for (const RepresentationFigures& figures : meter.table()) {
        EXPECT_GE(figures.bySize.front().microseconds, 0.0);
        most = std::max(most, figures.bySize.front().microseconds);
    }
    EXPECT_GT(most, 0.0);
}

// What the choice promises: at views that were not measured, too, nothing is off the exact sprite
// by more than the budget (a little, where another view is worse than those measured).
TEST_F(Representations, WhatIsChosenStaysWithinTheBudget) {
    const GameProfile profile = plainProfile();
    const MeasuringPlan plan{.sizesPx = {6, 12, 24}, .views = 8, .seed = 3, .costs = false};
    RepresentationTable table =
        must(measureRepresentations(*renderer_, measured(profile), profile, plan));
    // The sprite dearest and each next one cheaper, so that all are wanted where they are allowed.
    for (std::size_t k = 0; k < table.size(); ++k) {
        for (auto& figure : table[k].bySize) figure.microseconds = 10.0 - static_cast<double>(k);
    }
    std::array<int, kRepresentations> chosen{};
    for (const double budget : {0.1, 0.25, 0.35, 0.5}) {
        for (const double sizePx : {5.0, 9.0, 18.0, 24.0}) {
            const RepresentationChoice choice =
                choose(table, sizePx, {.errorBudget = budget}, std::nullopt);
            ++chosen[static_cast<std::size_t>(choice.kind)];
            double sum = 0.0;
            const MeasuringPlan others{.views = 5, .seed = 77};
            for (const OrbitAngles& view : viewsOf(others)) {
                const auto picture = [&](RepresentationChoice by) {
                    return must(
                        pictureAtSize(*renderer_, measured(profile), profile, by, sizePx, view));
                };
                const double error = must(flipInside(picture(kSprite), picture(choice)));
                EXPECT_LE(error, 1.5 * budget);
                sum += error;
            }
            EXPECT_LE(sum / others.views, budget);
        }
    }
    EXPECT_GT(chosen[0], 0);
    EXPECT_GT(chosen[1] + chosen[2] + chosen[3], 4);
}

}  // namespace
}  // namespace voxprite::test
