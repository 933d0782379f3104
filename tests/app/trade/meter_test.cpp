// Settings measured on a small model: what must be exact is, what must grow grows, and it is the
// same on every run and by both backends.
#include "app/trade/meter.h"

#include <gtest/gtest.h>

#include <map>

#include "app/trade/choice.h"
#include "app/trade/drawer.h"
#include "app/trade/gl_stage.h"
#include "core/svo/bake.h"
#include "render/gl/context.h"
#include "render/measure_representations.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::trade {
namespace {

using test::must;

std::shared_ptr<const Model> figureModel() {
    return std::make_shared<const Model>(
        Model{"figure", must(bake(test::figure())), Palette::standard(), Entity{}});
}

Plan smallPlan() {
    Plan plan = quickPlan(GameProfile{});
    plan.sizesPx = {28};
    plan.profile.sigma = 2.0;
    plan.frames = 6;
    return plan;
}

using Points = std::map<std::string, Point>;

Points measureAll(const Plan& plan, GlStage* gl, const std::vector<Axis>& axes = allAxes()) {
    Meter meter = must(Meter::create(figureModel(), plan, gl));
    Points points;
    for (const AxisSetting& each :
         settingsAlong(axes, plan.profile, meter.mostLevels(), Effort::quick)) {
        if (!meter.offers(each.setting)) continue;
        Point point = must(meter.measure(each)).value();
        EXPECT_TRUE(points.emplace(point.name, point).second) << point.name;
    }
    return points;
}

void expectSame(const PictureErrors& a, const PictureErrors& b, const std::string& name) {
    EXPECT_EQ(a.mismatch, b.mismatch) << name;
    EXPECT_EQ(a.voxels, b.voxels) << name;
    EXPECT_EQ(a.silhouette, b.silhouette) << name;
    EXPECT_EQ(a.iou, b.iou) << name;
    EXPECT_EQ(a.boundaryIou, b.boundaryIou) << name;
    EXPECT_EQ(a.outlineKept, b.outlineKept) << name;
    EXPECT_EQ(a.outlineTrue, b.outlineTrue) << name;
    EXPECT_EQ(a.flip, b.flip) << name;
    EXPECT_EQ(a.flipWorst, b.flipWorst) << name;
    EXPECT_EQ(a.psnr, b.psnr) << name;
    EXPECT_EQ(a.ssim, b.ssim) << name;
}

void expectSameFigures(const Point& a, const Point& b) {
    ASSERT_EQ(a.bySize.size(), b.bySize.size());
    for (std::size_t k = 0; k < a.bySize.size(); ++k) {
        const AtSize &one = a.bySize[k], &other = b.bySize[k];
        expectSame(one.sprite, other.sprite, a.name);
        expectSame(one.perspective, other.perspective, a.name);
        EXPECT_EQ(one.numbers.has_value(), other.numbers.has_value());
        if (one.numbers && other.numbers) {
            EXPECT_EQ(one.numbers->voxels, other.numbers->voxels) << a.name;
            EXPECT_EQ(one.numbers->samples, other.numbers->samples) << a.name;
        }
        EXPECT_EQ(one.time.changedADegree, other.time.changedADegree) << a.name;
        EXPECT_EQ(one.time.flipsADegree, other.time.flipsADegree) << a.name;
        EXPECT_EQ(one.time.crawlADegree, other.time.crawlADegree) << a.name;
        EXPECT_EQ(one.costs->rays, other.costs->rays) << a.name;
        EXPECT_EQ(one.costs->casts, other.costs->casts) << a.name;
        EXPECT_EQ(one.costs->bytes, other.costs->bytes) << a.name;
    }
}

const AtSize& only(const Points& points, const std::string& name) {
    return points.at(name).bySize.front();
}

TEST(Meter, SettingsAreWorthWhatTheyMustBe) {
    Plan plan = smallPlan();
    plan.sizesPx = {40};  // where sigma 2 is in force
    const Points points = measureAll(plan, nullptr);
    const AtSize& game = only(points, "as the game has it");
    EXPECT_EQ(game.sprite.flip, 0.0);
    EXPECT_EQ(game.sprite.mismatch, 0.0);
    EXPECT_EQ(game.sprite.voxels, 0.0);
    EXPECT_EQ(game.sprite.outlineKept, 1.0);
    EXPECT_FALSE(game.sprite.psnr);
    EXPECT_GT(game.perspective.flip, 0.05);  // the style leaves something out
    EXPECT_GT(game.perspective.iou, 0.8);    // and shows the same thing
    EXPECT_FALSE(game.perspective.outlineKept);
    ASSERT_TRUE(game.numbers);
    EXPECT_LT(game.numbers->voxels, 0.02);
    EXPECT_EQ(game.sigmaInForce, 2.0);

    // The same pixels, more rays.
    const AtSize& single = only(points, "single_pass");
    EXPECT_EQ(single.sprite.mismatch, 0.0);
    EXPECT_GT(single.costs->rays, 2.0 * game.costs->rays);

    // Coarser steps: fewer rays, and farther off.
    const AtSize &fine = only(points, "views every 1°"), &wide = only(points, "views every 15°");
    EXPECT_EQ(game.costs->casts, 1.0);
    EXPECT_LT(wide.costs->rays, fine.costs->rays);
    EXPECT_GT(wide.sprite.flip, fine.sprite.flip);
    EXPECT_GT(fine.sprite.flip, 0.0);

    // Smaller sigma: fewer rays. What the style leaves out is more.
    const AtSize &half = only(points, "sigma 0.5"), &one = only(points, "sigma 1");
    EXPECT_LT(half.costs->rays, one.costs->rays);
    EXPECT_LT(one.costs->rays, game.costs->rays);
    EXPECT_GT(half.perspective.flip, one.perspective.flip);
    EXPECT_GT(one.perspective.flip, game.perspective.flip);

    // Denser sets are less unlike, and hold more.
    const AtSize &few = only(points, "snapshots of 26 views"),
                 &many = only(points, "snapshots of 1296 views");
    EXPECT_GT(few.sprite.flip, many.sprite.flip);
    EXPECT_LT(few.costs->bytes, many.costs->bytes);
    EXPECT_LT(few.costs->rays, game.costs->rays);

    EXPECT_EQ(only(points, "octree coarser by 1").sprite.voxels, std::nullopt);
    EXPECT_LT(only(points, "octree coarser by 1").sprite.flip,
              only(points, "octree coarser by 2").sprite.flip);
    for (const auto& [name, point] : points)
        for (const AtSize& size : point.bySize) {
            EXPECT_GE(size.costs->milliseconds.runs, 2) << name;
            EXPECT_LE(size.costs->milliseconds.least, size.costs->milliseconds.median) << name;
            EXPECT_LE(size.costs->milliseconds.median, size.costs->milliseconds.most) << name;
            EXPECT_EQ(size.costs->backend, "cpu") << name;
        }
}

// Wide steps change seldom: what they save shows on a way that is long enough.
TEST(Meter, TheWiderTheStepTheFewerTheRays) {
    Plan plan = quickPlan(GameProfile{});
    plan.sizesPx = {28};
    plan.profile.sigma = 2.0;
    plan.views = 1;
    plan.leastRepeats = 1;
    const Points points = measureAll(plan, nullptr, {Axis::game, Axis::viewStep});
    const auto rays = [&](const char* name) { return only(points, name).costs->rays; };
    EXPECT_GE(rays("as the game has it"), rays("views every 2.5°"));
    EXPECT_GT(rays("views every 2.5°"), 1.5 * rays("views every 5°"));
    EXPECT_GT(rays("views every 5°"), 1.5 * rays("views every 15°"));
    EXPECT_LT(only(points, "views every 15°").costs->casts, 0.3);
}

TEST(Meter, ACameraThatOnlyRollsIsNotStill) {
    Plan plan = smallPlan();
    plan.costs = false;
    for (int k = 0; k < 8; ++k) plan.recordedWay.push_back({30.0, 20.0, 2.0 * k});
    Meter meter = must(Meter::create(figureModel(), plan));
    const AxisSetting game{Axis::game, settingOf(plan.profile)};
    const double rolling = must(meter.measure(game)).value().bySize.front().time.changedADegree;
    EXPECT_GT(rolling, 0.0);
    // Twice as fast: about half as much a degree changes with every frame.
    EXPECT_LT(rolling, 0.5);
}

// A long way holds no more pictures than fit the bound, and casts again what had to go.
TEST(Drawer, KeepsNoMorePicturesThanItsBound) {
    GameProfile profile;
    profile.minification = false;
    profile.sigma = 32.0;
    ModelParts parts(figureModel(), profile);
    Drawer drawer = must(Drawer::create(parts, profile, settingOf(profile)));
    // The casts until then, after one more view.
    const auto seen = [&](int view) {
        const Camera camera = cameraAtSize(parts.placed().radiusMetres(), 8.0,
                                           {10.0 * view, 20.0, 0.0}, glm::ivec2(16));
        EXPECT_TRUE(drawer.draw(camera, false));
        return static_cast<int>(drawer.counts().casts);
    };
    EXPECT_EQ(seen(0), 1);
    EXPECT_EQ(seen(0), 1);
    int casts = 1;
    while (casts < 36 && drawer.counts().castBytes <= kMostKeptBytes) casts = seen(casts);
    ASSERT_GT(drawer.counts().castBytes, kMostKeptBytes);
    EXPECT_LE(drawer.counts().mostKeptBytes, kMostKeptBytes);
    EXPECT_EQ(seen(casts - 1), casts);
    EXPECT_EQ(seen(0), casts + 1);
}

// Timed again: more runs, nothing else.
TEST(Meter, TimesAgain) {
    Meter meter = must(Meter::create(figureModel(), smallPlan()));
    const Point first = must(meter.measure({Axis::game, settingOf(smallPlan().profile)})).value();
    Point again = first;
    ASSERT_TRUE(must(meter.timeAgain(again)));
    for (std::size_t k = 0; k < first.bySize.size(); ++k) {
        const Costs &before = *first.bySize[k].costs, &after = *again.bySize[k].costs;
        EXPECT_EQ(after.milliseconds.runs, before.milliseconds.runs + 2);
        EXPECT_EQ(after.runsMilliseconds.front().size(), before.runsMilliseconds.front().size());
        EXPECT_EQ(after.milliseconds.runs, static_cast<int>(after.runsMilliseconds.size()));
        EXPECT_LE(after.milliseconds.least, before.milliseconds.least);
        EXPECT_GE(after.milliseconds.most, before.milliseconds.most);
        EXPECT_EQ(after.rays, before.rays);
        EXPECT_EQ(after.bytes, before.bytes);
    }
}

// Slowly round: a step comes once in many frames, and what it changes stays.
TEST(Meter, SnappedViewsChangeInStepsAndNeverFlickerBack) {
    Plan plan = smallPlan();
    plan.costs = false;
    plan.views = 1;
    plan.frames = 120;
    plan.degreesAFrame = 0.15;
    Meter meter = must(Meter::create(figureModel(), plan));
    AxisSetting setting{Axis::game, settingOf(plan.profile)};
    const Point every = must(meter.measure(setting)).value();
    setting.setting.viewStepDegrees = 5.0;
    const Point snapped = must(meter.measure(setting)).value();
    EXPECT_FALSE(every.bySize.front().costs);
    EXPECT_GT(every.bySize.front().time.changedADegree, 0.0);
    EXPECT_GT(snapped.bySize.front().time.changedADegree, 0.0);
    EXPECT_EQ(snapped.bySize.front().time.flipsADegree, 0.0);
}

TEST(Meter, TheSameSeedGivesTheSameFiguresOnEveryRunAndByBothBackends) {
    Plan plan = smallPlan();
    plan.profile.light.shadow = 0.5;
    const Points first = measureAll(plan, nullptr);
    const gl::HeadlessContext context = must(gl::HeadlessContext::create());
    GlStage stage = must(GlStage::create());
    const Points byGl = measureAll(plan, &stage);
    EXPECT_GT(byGl.size(), first.size());  // clusters are drawn by OpenGL alone
    for (const auto& [name, point] : first) expectSameFigures(point, byGl.at(name));

    const std::vector<Axis> steps{Axis::game, Axis::viewStep};
    for (const auto& [name, point] : measureAll(plan, nullptr, steps))
        expectSameFigures(point, first.at(name));
    plan.seed = 2;
    const Points other = measureAll(plan, nullptr, steps);
    EXPECT_NE(only(other, "views every 5°").sprite.flip, only(first, "views every 5°").sprite.flip);
}

TEST(Meter, WhatIsStoppedGivesNothing) {
    Meter meter = must(Meter::create(figureModel(), smallPlan()));
    std::stop_source stop;
    int reports = 0;
    const Progress progress(
        [&](double share) {
            EXPECT_GE(share, 0.0);
            EXPECT_LE(share, 1.0);
            if (++reports == 3) stop.request_stop();
        },
        stop.get_token());
    const Result<std::optional<Point>> point =
        meter.measure({Axis::game, settingOf(smallPlan().profile)}, progress);
    ASSERT_TRUE(point);
    EXPECT_FALSE(point->has_value());
    EXPECT_EQ(reports, 3);
}

TEST(Meter, RefusesWhatCannotBeMeasured) {
    const auto empty = std::make_shared<const Model>(Model{"nothing", Octree{}, {}, {}});
    EXPECT_FALSE(Meter::create(empty, smallPlan()));
    Plan plan = smallPlan();
    plan.sizesPx = {100, 50};
    EXPECT_FALSE(Meter::create(figureModel(), plan));
    plan.sizesPx = {1e9};
    EXPECT_FALSE(Meter::create(figureModel(), plan));
    plan = smallPlan();
    plan.frames = 0;
    EXPECT_FALSE(Meter::create(figureModel(), plan));
    Meter meter = must(Meter::create(figureModel(), smallPlan()));
    AxisSetting clusters{Axis::clusters, settingOf(smallPlan().profile)};
    clusters.setting.drawnBy = Representation::clusters;
    EXPECT_FALSE(meter.offers(clusters.setting));
    EXPECT_FALSE(meter.measure(clusters));
}

}  // namespace
}  // namespace voxprite::trade
