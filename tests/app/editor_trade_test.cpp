// Speed against accuracy: what is measured behind the window, what is done with it, and the map of
// errors.
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/editor/session/trade_moves.h"
#include "app/editor/views/error_heat.h"
#include "app/editor/views/heat_ramp.h"
#include "app/trade/choice.h"
#include "core/base/oklab.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/io/formats.h"
#include "core/measure/compare.h"
#include "core/svo/bake.h"
#include "tests/render/gl_test.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

class EditorTrade : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(saveDocument(folder_ / "m.vox", test::documentOf(test::figure()), {}));
        ASSERT_TRUE(session_.open(folder_ / "m.vox"));
    }
    [[nodiscard]] trade::Setting inForce() const {
        return settingInForce(session_.profile(), RepresentationSettings());
    }
    // As little as can be measured: what matters here is who measures, and when.
    static trade::Plan smallPlan() {
        trade::Plan plan = TradeStudy::usualPlan();
        plan.sizesPx = {24.0};  // large enough for sigmas to differ
        plan.views = 1;
        plan.frames = 2;
        plan.leastRepeats = 1;
        plan.idealSamples = 20;
        return plan;
    }
    // A frame of the editor.
    void follow() {
        now_ += 1.0;
        study_.wait();
        study_.follow(session_, std::vector{inForce()}, now_);
    }
    void followUntil(std::size_t points) {
        for (int k = 0; k < 400 && study_.curve().points.size() < points; ++k) follow();
        ASSERT_GE(study_.curve().points.size(), points);
    }
    void finish() {
        follow();
        for (int k = 0; k < 400 && study_.busy(); ++k) follow();
        ASSERT_FALSE(study_.busy());
        ASSERT_EQ(study_.problem(), "");
    }
    // What the engine says itself of the document as it is now.
    [[nodiscard]] trade::Point measuredDirectly(const trade::Setting& setting) const {
        const auto model = std::make_shared<const trade::Model>(trade::Model{
            "m",
            test::must(bake(flatten(session_.document(), session_.frame()), session_.bounds())),
            session_.shownPalette(), session_.document().entity});
        trade::Meter meter = test::must(trade::Meter::create(model, study_.plan()));
        return *test::must(meter.measure({trade::Axis::game, setting}));
    }
    static void expectSameErrors(const trade::Point& a, const trade::Point& b) {
        EXPECT_EQ(a.error(trade::Yardstick::sprite), b.error(trade::Yardstick::sprite)) << a.name;
        EXPECT_EQ(a.error(trade::Yardstick::perspective), b.error(trade::Yardstick::perspective))
            << a.name;
        EXPECT_EQ(a.rays(), b.rays()) << a.name;
    }
    void setSigma(double sigma) {
        GameProfile after = session_.profile();
        after.sigma = sigma;
        ASSERT_TRUE(session_.perform(makeAction("Sigma", ProfileEdit{session_.profile(), after})));
    }
    void fillABlock() {
        ASSERT_TRUE(session_.perform(makeAction(
            "Attach",
            patchBox(session_.document(), 0, {{2, 0, 20}, {14, 6, 30}}, EditMode::attach, 5))));
    }

    test::TemporaryFolder folder_;
    Session session_;
    TradeStudy study_{smallPlan()};
    double now_ = 0.0;
};

TEST_F(EditorTrade, WhatIsMeasuredBehindTheWindowIsWhatTheEngineSays) {
    EXPECT_FALSE(study_.busy());
    EXPECT_FALSE(study_.reference());
    follow();
    EXPECT_TRUE(study_.busy());
    EXPECT_TRUE(study_.curve().points.empty()) << "a model is left alone for a moment";
    finish();
    const std::vector<trade::Point>& points = study_.curve().points;
    ASSERT_GT(points.size(), 10u);
    EXPECT_EQ(study_.share(), 1.0);
    EXPECT_EQ(points.front().axis, trade::Axis::game);
    EXPECT_EQ(study_.find(inForce()), &points.front());
    for (const std::size_t k : {std::size_t{0}, points.size() / 2, points.size() - 1}) {
        expectSameErrors(points[k], measuredDirectly(points[k].setting));
    }
    // In the order of the plan, each once, and nothing that the view cannot show.
    for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_EQ(study_.find(points[k].setting), &points[k]);
        EXPECT_TRUE(canBeShown(points[k].setting)) << points[k].name;
        if (k == 0) continue;
        EXPECT_LE(points[k - 1].axis, points[k].axis);
    }
}

TEST_F(EditorTrade, WhatIsInForceMovesAlongTheCurveAndNotTheCurveWithIt) {
    finish();
    const std::size_t points = study_.curve().points.size();
    const trade::Setting reference = *study_.reference();
    setSigma(3.25);
    EXPECT_EQ(study_.find(inForce()), nullptr);
    follow();
    EXPECT_TRUE(study_.busy());
    finish();
    EXPECT_EQ(study_.curve().points.size(), points);
    EXPECT_EQ(study_.reference(), reference);
    ASSERT_NE(study_.find(inForce()), nullptr);
    expectSameErrors(*study_.find(inForce()), measuredDirectly(inForce()));
    EXPECT_GT(study_.find(inForce())->error(trade::Yardstick::sprite), 0.0);
    // Pinned, it is what errors are against: it has none itself.
    study_.pin(inForce());
    finish();
    EXPECT_EQ(study_.reference(), inForce());
    EXPECT_EQ(study_.find(inForce())->error(trade::Yardstick::sprite), 0.0);
}

TEST_F(EditorTrade, WhatWasMeasuredOfAnOlderModelIsDropped) {
    followUntil(2);
    const double before = study_.curve().points.front().error(trade::Yardstick::perspective);
    // One is being measured as the model changes.
    now_ += 1.0;
    study_.follow(session_, std::vector{inForce()}, now_);
    fillABlock();
    follow();
    EXPECT_TRUE(study_.curve().points.empty());
    EXPECT_EQ(study_.find(inForce()), nullptr);
    EXPECT_TRUE(study_.busy());
    followUntil(1);
    expectSameErrors(study_.curve().points.front(), measuredDirectly(inForce()));
    EXPECT_NE(study_.curve().points.front().error(trade::Yardstick::perspective), before);
}

TEST_F(EditorTrade, MeasuringIsStoppedAndTakenUpAgain) {
    followUntil(2);
    study_.cancel();
    for (int k = 0; k < 5; ++k) follow();
    EXPECT_TRUE(study_.cancelled());
    EXPECT_FALSE(study_.busy());
    EXPECT_LT(study_.curve().points.size(), 6u);
    EXPECT_GE(study_.curve().points.size(), 2u) << "what is known stays";
    study_.again();
    followUntil(3);
    EXPECT_FALSE(study_.cancelled());
    // Nobody looks: nothing goes on, and later it does where it was.
    const std::size_t known = study_.curve().points.size();
    study_.rest();
    study_.wait();
    EXPECT_EQ(study_.curve().points.size(), known);
    followUntil(known + 1);
    study_.forget();
    EXPECT_FALSE(study_.busy());
    EXPECT_TRUE(study_.curve().points.empty());
}

TEST_F(EditorTrade, AModelWithoutVoxelsSaysSo) {
    Session empty;
    for (int k = 0; k < 4; ++k) {
        now_ += 1.0;
        study_.wait();
        study_.follow(empty, {}, now_);
    }
    EXPECT_FALSE(study_.busy());
    EXPECT_NE(study_.problem(), "");
}

TEST_F(EditorTrade, TheCheapestWithinAnErrorIsOneStepThatCanBeUndone) {
    finish();
    TradeSettings settings;
    settings.cost = trade::Cost::rays;  // the same on every machine
    settings.errorBudget = kMostTradeError;
    const trade::Point* best = cheapestWithinMyError(study_, settings);
    ASSERT_NE(best, nullptr);
    EXPECT_LE(best->error(settings.yardstick), settings.errorBudget);
    EXPECT_TRUE(trade::fitsProfile(best->setting));
    for (const trade::Point& point : study_.curve().points) {
        if (!trade::fitsProfile(point.setting) ||
            point.error(settings.yardstick) > settings.errorBudget)
            continue;
        EXPECT_GE(point.rays(), best->rays()) << point.name;
    }
    EXPECT_LT(best->rays(), study_.find(inForce())->rays());

    const GameProfile before = session_.profile();
    auto step = profileStep(session_, best->setting, "cheapest");
    ASSERT_TRUE(step);
    ASSERT_TRUE(session_.perform(std::move(*step)));
    EXPECT_EQ(session_.history().position(), 1u);
    EXPECT_EQ(inForce(), best->setting);
    EXPECT_FALSE(profileStep(session_, best->setting, "again")) << "it is in force already";
    ASSERT_TRUE(session_.undo());
    EXPECT_EQ(session_.profile(), before);
    settings.errorBudget = -1.0;
    EXPECT_EQ(cheapestWithinMyError(study_, settings), nullptr);
}

TEST(EditorTradeSettings, AreReadAsTheyAreWritten) {
    TradeSettings settings;
    settings.yardstick = trade::Yardstick::perspective;
    settings.cost = trade::Cost::rays;
    settings.errorBudget = 0.07;
    settings.profileOnly = false;
    settings.wipe = 0.25;
    settings.heatYardstick = HeatYardstick::reference;
    trade::Setting setting;
    setting.sigma = 2.0;
    setting.viewStepDegrees = 5.0;
    setting.mode = SpriteMode::singlePass;
    setting.proxy = ProxyShape::box;
    setting.occlusion = 0.5;
    settings.saved.push_back({"coarse views", setting});
    setting.drawnBy = Representation::coarse;
    setting.coarseLevels = 2;
    settings.b = setting;
    EXPECT_EQ(tradeSettingsFrom(toJson(settings)), settings);
    EXPECT_EQ(tradeSettingsFrom(nlohmann::json::object()), TradeSettings());
    // What no profile takes is left out, and nothing else with it.
    nlohmann::json json = toJson(settings);
    json["b"]["sigma"] = -3.0;
    json["saved"].push_back({{"name", "bad"}, {"setting", {{"view_set", "square:9"}}}});
    json["error_budget"] = 1e9;
    const TradeSettings read = tradeSettingsFrom(json);
    EXPECT_FALSE(read.b);
    EXPECT_EQ(read.saved, settings.saved);
    EXPECT_EQ(read.errorBudget, kMostTradeError);
}

TEST(EditorTradeSettings, AreWhatProfileAndSceneSayTogether) {
    GameProfile profile;
    profile.sigma = 3.0;
    RepresentationSettings representations;
    EXPECT_EQ(settingInForce(profile, representations), trade::settingOf(profile));
    for (const DrawRule rule :
         {DrawRule::exact, DrawRule::snapshot, DrawRule::clusters, DrawRule::coarse}) {
        representations.rule = rule;
        representations.views = "octahedral:8";
        representations.coarserLevels = 2;
        representations.clusterBudgetPx = 3.0;
        const trade::Setting setting = settingInForce(profile, representations);
        EXPECT_EQ(representations.forced(), choiceOf(setting));
        // From anywhere else it leads back there.
        const RepresentationSettings back = representationsWith(RepresentationSettings(), setting);
        EXPECT_EQ(settingInForce(trade::profileWith(GameProfile(), setting), back), setting);
    }
}

TEST(EditorHeatRamp, MoreIsAlwaysBrighter) {
    double before = -1.0;
    for (int k = 0; k <= 64; ++k) {
        const double lightness = okLabFrom(heatColour(k / 64.0)).lightness;
        EXPECT_GT(lightness, before) << k;
        EXPECT_LT(lightness, k == 0 ? 0.2 : before + 0.03) << k;
        before = lightness;
    }
    EXPECT_GT(before, 0.9);
    EXPECT_EQ(heatColour(-1.0), heatColour(0.0));
    EXPECT_EQ(heatColour(7.0), heatColour(1.0));
    EXPECT_EQ(heatColour(std::nan("")), heatColour(1.0));
}

// A blot in the middle of an empty picture.
Image blot(unsigned seed) {
    test::Random random(seed);
    Image image(72, 56);
    for (int y = 14; y < 40; ++y) {
        for (int x = 20; x < 50; ++x) {
            const auto value = random.next();
            if (value % 5 == 0) continue;
            image.at(x, y) = Rgba8(value >> 8 & 255u, value >> 16 & 255u, value >> 24 & 255u, 255);
        }
    }
    return image;
}

TEST(EditorHeatMap, HasTheErrorsOfTheWholePictures) {
    const Image a = blot(1), b = blot(2);
    const HeatMap map = test::must(heatMapOf(a, b));
    EXPECT_EQ(map.mean, test::must(flipInside(a, b))) << "bit for bit: the cut changes nothing";
    EXPECT_FALSE(map.equal);
    EXPECT_LT(map.image.width * map.image.height, a.width * a.height);
    const Plane errors = test::must(flipErrors(a, b));
    for (const glm::ivec2 at : {glm::ivec2(21, 15), glm::ivec2(33, 30), glm::ivec2(49, 39)}) {
        const bool covered = a.at(at.x, at.y).w > 0 || b.at(at.x, at.y).w > 0;
        ASSERT_EQ(map.at(at).has_value(), covered);
        if (!covered) continue;
        EXPECT_EQ(*map.at(at), errors.at(at.x, at.y));
        const glm::ivec2 in = at - map.min;
        EXPECT_EQ(map.image.at(in.x, in.y), heatColour(errors.at(at.x, at.y)));
    }
    EXPECT_FALSE(map.at({0, 0}));
    EXPECT_FALSE(map.at({-5, 900}));

    const HeatMap none = test::must(heatMapOf(a, a));
    EXPECT_TRUE(none.equal);
    EXPECT_EQ(none.mean, 0.0);
    const HeatMap nothing = test::must(heatMapOf(Image(8, 8), Image(8, 8)));
    EXPECT_TRUE(nothing.image.pixels.empty());
    EXPECT_FALSE(heatMapOf(Image(8, 8), Image(9, 8)));
}

class EditorErrorHeat : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        octree_.emplace();
        const Octree octree = test::must(bake(test::figure()));
        placed_.modelSize = octree.view().size;
        placed_.anchor = {8, 4, 0};
        octree_->upload(octree.view());
        palette_ = test::documentOf(test::figure()).palette;
        renderer_.emplace(test::must(SceneRenderer::create()));
        terms_.camera.target = {0, 1.6, 0};
        terms_.camera.distance = 6.0;
        terms_.camera.yawDegrees = 31.0;
        terms_.camera.pitchDegrees = 17.0;
        terms_.sizePx = {120, 110};
        heat_ = std::make_unique<ErrorHeat>();
    }
    void TearDown() override {
        heat_.reset();
        renderer_.reset();
        octree_.reset();
        GlTest::TearDown();
    }
    // Frames of the editor until the map is there.
    const HeatMap* map() {
        for (int frame = 0; frame < 20; ++frame) {
            follow();
            heat_->wait();
        }
        return heat_->map();
    }
    void follow() {
        history_ = {};
        ErrorHeat::Subject subject;
        subject.octree = &*octree_;
        subject.placed = placed_;
        subject.shown = {&*octree_, &palette_, placed_, &history_};
        subject.camera = terms_.camera.camera(terms_.sizePx);
        ASSERT_TRUE(heat_->follow(terms_, subject, *renderer_));
    }
    Image picture(const GameProfile& profile) {
        Frame frame(terms_.sizePx);
        Scene scene;
        scene.entities.push_back({&*octree_, &palette_, placed_});
        static_cast<void>(renderer_->draw(frame, scene, terms_.camera.camera(terms_.sizePx),
                                          profile, SpriteMode::spriteBuffer));
        return frame.readColour();
    }

    std::optional<GpuOctree> octree_;
    PlacedEntity placed_;
    Palette palette_;
    ViewHistory history_;
    ErrorHeat::Terms terms_;
    std::optional<SceneRenderer> renderer_;
    std::unique_ptr<ErrorHeat> heat_;
};

TEST_F(EditorErrorHeat, ComparesWhatShowsWithTheYardstickThatWasChosen) {
    terms_.profile.viewStepDegrees = 15.0;
    terms_.profile.sigma = 2.0;
    terms_.reference.sigma = 3.0;
    GameProfile exact = terms_.profile;
    exact.viewStepDegrees = 0.0;
    const double mean = test::must(flipInside(picture(exact), picture(terms_.profile)));
    EXPECT_GT(mean, 0.05);
    ASSERT_NE(map(), nullptr);
    EXPECT_EQ(map()->mean, mean);

    terms_.yardstick = HeatYardstick::reference;
    const double other = test::must(flipInside(picture(terms_.reference), picture(terms_.profile)));
    ASSERT_NE(map(), nullptr);
    EXPECT_EQ(map()->mean, other);
    EXPECT_NE(other, mean);

    terms_.yardstick = HeatYardstick::perspective;
    ASSERT_NE(map(), nullptr);
    EXPECT_GT(map()->mean, 0.05);
    EXPECT_NE(map()->mean, other);

    // The exact sprite is its own yardstick.
    terms_.yardstick = HeatYardstick::exactView;
    terms_.profile.viewStepDegrees = 0.0;
    ASSERT_NE(map(), nullptr);
    EXPECT_TRUE(map()->equal);
    EXPECT_FALSE(heat_->busy());
}

TEST_F(EditorErrorHeat, NoMapIsShownOfAPictureThatIsNoMore) {
    terms_.profile.viewStepDegrees = 15.0;
    ASSERT_NE(map(), nullptr);
    // A hand that turns the view: nothing is drawn for it, and nothing of before is shown.
    for (int frame = 0; frame < 6; ++frame) {
        terms_.camera.yawDegrees += 0.5;
        follow();
        EXPECT_EQ(heat_->map(), nullptr);
        EXPECT_TRUE(heat_->busy());
    }
    ASSERT_NE(map(), nullptr);
    heat_->clear();
    EXPECT_EQ(heat_->map(), nullptr);
    EXPECT_FALSE(heat_->busy());
}

}  // namespace
}  // namespace voxprite::editor
