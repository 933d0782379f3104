#include "app/trade/choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace voxprite::trade {
namespace {

Point point(double error, double milliseconds, const std::string& backend = "cpu") {
    Point made;
    AtSize size;
    size.sizePx = 64;
    size.sprite.flip = error;
    size.perspective.flip = 1.0 - error;
    size.costs.emplace();
    size.costs->milliseconds = {milliseconds, milliseconds, milliseconds, 1};
    size.costs->rays = 1000.0 / milliseconds;
    size.costs->backend = backend;
    made.bySize = {size};
    return made;
}

Curve curveOf(std::vector<Point> points) {
    Curve curve;
    curve.backend = "cpu";
    curve.points = std::move(points);
    return curve;
}

TEST(ParetoFront, IsWhatNothingBeats) {
    const Curve curve = curveOf({point(0.0, 9.0), point(0.1, 5.0), point(0.2, 6.0),  // beaten by 1
                                 point(0.3, 1.0), point(0.3, 1.0),                   // twice
                                 point(0.1, 7.0)});  // dearer than 1
    EXPECT_EQ(paretoFront(curve, Yardstick::sprite), (std::vector<std::size_t>{3, 1, 0}));
    // By the other yardstick the cheapest is the most accurate, too.
    EXPECT_EQ(paretoFront(curve, Yardstick::perspective), (std::vector<std::size_t>{3}));
    EXPECT_EQ(paretoFront(curveOf({}), Yardstick::sprite), std::vector<std::size_t>{});
}

TEST(ParetoFront, LeavesOutWhatHasNoCostOrAForeignOne) {
    Curve curve = curveOf({point(0.0, 1.0, "gl"), point(0.5, 2.0), point(0.1, 0.1)});
    curve.points[2].bySize.front().costs.reset();
    EXPECT_EQ(paretoFront(curve, Yardstick::sprite), (std::vector<std::size_t>{1}));
}

// The same rays to the same picture: the second's luck with the clock is not taken for a gain.
TEST(ParetoFront, OfTheSameWorkTheFirstCounts) {
    Curve curve = curveOf({point(0.0, 9.0), point(0.0, 8.0)});
    EXPECT_EQ(paretoFront(curve, Yardstick::sprite), (std::vector<std::size_t>{1}));
    curve.points[1].bySize.front().costs->rays = curve.points[0].bySize.front().costs->rays;
    EXPECT_EQ(paretoFront(curve, Yardstick::sprite), (std::vector<std::size_t>{0}));
    EXPECT_EQ(cheapestWithin(curve, 0.0), 0u);
}

// By definition, over all pairs.
TEST(ParetoFront, AgreesWithTheDefinition) {
    std::mt19937 random(5);
    const auto tenth = [&] { return static_cast<double>(random() % 10); };
    for (int round = 0; round < 50; ++round) {
        std::vector<Point> points;
        for (int k = 0; k < 30; ++k) points.push_back(point(tenth() / 10.0, 1.0 + tenth()));
        const Curve curve = curveOf(points);
        const std::vector<std::size_t> front = paretoFront(curve, Yardstick::sprite);
        const auto error = [&](std::size_t k) { return points[k].error(Yardstick::sprite); };
        const auto cost = [&](std::size_t k) { return points[k].milliseconds(); };
        for (std::size_t k = 0; k < points.size(); ++k) {
            bool beaten = false;
            for (std::size_t j = 0; j < points.size(); ++j) {
                const bool noWorse = error(j) <= error(k) && cost(j) <= cost(k);
                const bool better = error(j) < error(k) || cost(j) < cost(k) || j < k;
                beaten |= j != k && noWorse && better;
            }
            const bool on = std::find(front.begin(), front.end(), k) != front.end();
            EXPECT_EQ(on, !beaten);
        }
    }
}

TEST(Budgets, TheCheapestWithinAnErrorAndTheBestWithinATime) {
    Curve curve = curveOf({point(0.0, 9.0), point(0.1, 5.0), point(0.3, 1.0)});
    EXPECT_EQ(cheapestWithin(curve, 0.1), 1u);
    EXPECT_EQ(cheapestWithin(curve, 0.05), 0u);
    EXPECT_EQ(cheapestWithin(curve, 1.0), 2u);
    EXPECT_EQ(cheapestWithin(curve, -1.0), std::nullopt);
    EXPECT_EQ(bestWithin(curve, 5.0), 1u);
    EXPECT_EQ(bestWithin(curve, 100.0), 0u);
    EXPECT_EQ(bestWithin(curve, 0.5), std::nullopt);
    // What no profile can say.
    curve.points[1].setting.drawnBy = Representation::snapshot;
    Wish wish;
    wish.profileOnly = true;
    EXPECT_EQ(cheapestWithin(curve, 0.1, wish), 0u);
    EXPECT_EQ(bestWithin(curve, 5.0, wish), 2u);
}

TEST(Settings, AreThereOnceAndSayWhatDiffers) {
    GameProfile profile;
    profile.light.occlusion = 0.4;
    const std::vector<AxisSetting> all = settingsAlong(allAxes(), profile, 3, Effort::full);
    EXPECT_EQ(all.front(), (AxisSetting{Axis::game, settingOf(profile)}));
    for (std::size_t a = 0; a < all.size(); ++a) {
        const std::string name = describe(all[a].setting, settingOf(profile));
        EXPECT_EQ(name == "as the game has it", a == 0);
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_NE(all[a].setting, all[b].setting);
            EXPECT_NE(name, describe(all[b].setting, settingOf(profile)));
        }
        // What a profile can say, it says.
        if (fitsProfile(all[a].setting)) {
            EXPECT_EQ(settingOf(profileWith(profile, all[a].setting)), all[a].setting);
        }
    }
    int light = 0;
    for (const AxisSetting& each : all) light += each.axis == Axis::light ? 1 : 0;
    EXPECT_EQ(light, 1);
}

TEST(Figures, SpreadsAreThoseOfTheValues) {
    const Spread odd = spreadOf({5, 1, 3});
    EXPECT_EQ(odd.least, 1.0);
    EXPECT_EQ(odd.median, 3.0);
    EXPECT_EQ(odd.most, 5.0);
    EXPECT_EQ(odd.runs, 3);
    EXPECT_EQ(spreadOf({4, 1, 2, 3}).median, 2.5);
    EXPECT_EQ(spreadOf({}).runs, 0);
}

// Two runs, each disturbed in another part: the least is what neither disturbance is in.
TEST(Figures, TheLeastOfRunsIsTakenPartByPart) {
    const Spread spread = spreadOfParts({{1, 9, 1}, {5, 2, 1}});
    EXPECT_EQ(spread.least, 4.0);
    EXPECT_EQ(spread.median, 9.5);
    EXPECT_EQ(spread.most, 11.0);
    EXPECT_EQ(spread.runs, 2);
    EXPECT_EQ(spreadOfParts({{2, 3}}).least, 5.0);
    EXPECT_EQ(spreadOfParts({}).runs, 0);
}

}  // namespace
}  // namespace voxprite::trade
