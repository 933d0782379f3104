// The choice among representations, on made-up figures.
#include "core/lod/representation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace voxprite {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr RepresentationChoice kSprite{};
constexpr RepresentationChoice kSnapshot{Representation::snapshot, 0};
constexpr RepresentationChoice kClusters{Representation::clusters, 0};
constexpr RepresentationChoice kCoarse1{Representation::coarse, 1};
constexpr RepresentationChoice kCoarse2{Representation::coarse, 2};

// Cheap and wrong near by, dear and right: as figures of real models are.
RepresentationTable likely() {
    return {{kSprite, {{8, 0, 20}, {32, 0, 100}, {128, 0, 900}}},
            {kSnapshot, {{8, 0.02, 2}, {32, 0.06, 4}, {128, 0.2, 30}}},
            {kClusters, {{8, 0.1, 10}, {32, 0.08, 50}, {128, 0.03, 300}}},
            {kCoarse1, {{8, 0.01, 15}, {32, 0.05, 70}, {128, 0.1, 500}}}};
}

TEST(RepresentationFigures, AnErrorBetweenTwoSizesIsTheGreaterOfBoth) {
    const RepresentationFigures figures{kSnapshot, {{10, 0.1, 1}, {20, 0.3, 1}, {40, 0.2, 1}}};
    EXPECT_EQ(errorAt(figures, 10), 0.1);
    EXPECT_EQ(errorAt(figures, 11), 0.3);
    EXPECT_EQ(errorAt(figures, 20), 0.3);
    EXPECT_EQ(errorAt(figures, 39), 0.3);
    EXPECT_EQ(errorAt(figures, 40), 0.2);
}

TEST(RepresentationFigures, BeyondWhatWasMeasured) {
    const RepresentationFigures figures{kSnapshot, {{10, 0.1, 3}, {20, 0.3, 5}}};
    EXPECT_EQ(errorAt(figures, 0.0), 0.1);
    EXPECT_EQ(errorAt(figures, 9.0), 0.1);
    EXPECT_EQ(errorAt(figures, 20.01), kInfinite);
    EXPECT_EQ(microsecondsAt(figures, 1.0), 3.0);
    EXPECT_EQ(microsecondsAt(figures, 1e9), 5.0);
    for (const double none : {kNan, -1.0, kInfinite}) {
        EXPECT_EQ(errorAt(figures, none), kInfinite) << none;
    }
    EXPECT_EQ(microsecondsAt(figures, kNan), kInfinite);
    EXPECT_EQ(errorAt({kSnapshot, {}}, 10.0), kInfinite);
    EXPECT_EQ(microsecondsAt({kSnapshot, {}}, 10.0), kInfinite);
}

TEST(RepresentationFigures, TheExactSpriteHasNoErrorAtAnySize) {
    const RepresentationFigures figures{kSprite, {{10, 0, 3}}};
    for (const double size : {0.0, 10.0, 1e6, kInfinite, kNan})
        EXPECT_EQ(errorAt(figures, size), 0);
}

TEST(RepresentationFigures, CostIsLinearInTheLogarithmOfTheSize) {
    const RepresentationFigures figures{kSprite, {{10, 0, 100}, {40, 0, 300}}};
    EXPECT_DOUBLE_EQ(microsecondsAt(figures, 20), 200.0);
    double last = 0.0;
    for (double size = 5.0; size < 80.0; size *= 1.07) {
        EXPECT_GE(microsecondsAt(figures, size), last);
        last = microsecondsAt(figures, size);
    }
}

TEST(ChooseRepresentation, TheCheapestWithinTheBudget) {
    const RepresentationTable table = likely();
    EXPECT_EQ(choose(table, 8, {.errorBudget = 0.02}, {}), kSnapshot);
    EXPECT_EQ(choose(table, 8, {.errorBudget = 0.01}, {}), kCoarse1);
    EXPECT_EQ(choose(table, 8, {.errorBudget = 0.0}, {}), kSprite);
    EXPECT_EQ(choose(table, 32, {.errorBudget = 0.05}, {}), kCoarse1);
    EXPECT_EQ(choose(table, 32, {.errorBudget = 0.1}, {}), kSnapshot);
    EXPECT_EQ(choose(table, 128, {.errorBudget = 0.05}, {}), kClusters);
    EXPECT_EQ(choose(table, 128, {.errorBudget = 1.0}, {}), kSnapshot);
}

TEST(ChooseRepresentation, OfEquallyCheapOnesTheOneWithLessError) {
    const RepresentationTable table{
        {kSprite, {{10, 0, 9}}}, {kCoarse2, {{10, 0.03, 5}}}, {kCoarse1, {{10, 0.02, 5}}}};
    EXPECT_EQ(choose(table, 10, {.errorBudget = 0.1}, {}), kCoarse1);
}

TEST(ChooseRepresentation, NothingKnownIsTheSprite) {
    EXPECT_EQ(choose({}, 10, {}, {}), kSprite);
    EXPECT_EQ(choose({}, 10, {}, kSnapshot), kSprite);
    EXPECT_EQ(choose({{kSnapshot, {}}}, 10, {}, kSnapshot), kSprite);
    // Larger than anything that was measured.
    EXPECT_EQ(choose(likely(), 500, {.errorBudget = 1.0}, {}), kSprite);
    EXPECT_EQ(choose(likely(), 500, {.errorBudget = 1.0}, kSnapshot), kSprite);
}

TEST(ChooseRepresentation, WhatIsNoNumberIsNeverTaken) {
    for (const auto previous : {std::optional<RepresentationChoice>{}, std::optional(kSnapshot)}) {
        for (const double size : {kNan, -3.0, kInfinite}) {
            EXPECT_EQ(choose(likely(), size, {.errorBudget = 1.0}, previous), kSprite) << size;
        }
        EXPECT_EQ(choose(likely(), 8, {.errorBudget = kNan}, previous), kSprite);
        EXPECT_EQ(choose(likely(), 8, {.errorBudget = -1.0}, previous), kSprite);
        const RepresentationTable broken{{kSprite, {{8, 0, 20}}}, {kSnapshot, {{8, kNan, 1}}}};
        EXPECT_EQ(choose(broken, 8, {.errorBudget = 1.0}, previous), kSprite);
    }
    const RepresentationTable free{{kSprite, {{8, 0, 20}}}, {kSnapshot, {{8, 0, kNan}}}};
    EXPECT_EQ(choose(free, 8, {}, {}), kSprite);
}

TEST(ChooseRepresentation, AForcedOneIsTakenWhateverItCosts) {
    for (const RepresentationChoice forced : {kSprite, kSnapshot, kClusters, kCoarse2}) {
        EXPECT_EQ(choose(likely(), 128, {.errorBudget = 0.0, .forced = forced}, kSprite), forced);
        EXPECT_EQ(choose({}, kNan, {.forced = forced}, {}), forced);
    }
}

TEST(ChooseRepresentation, LeavingAndComingBackHappenAtDifferentSizes) {
    const RepresentationTable table{{kSprite, {{1, 0, 100}, {1000, 0, 100}}},
                                    {kSnapshot, {{1, 0.0, 1}, {100, 0.05, 1}, {101, 0.5, 1}}}};
    const ChoiceRules rules{.errorBudget = 0.1, .band = 0.2};
    EXPECT_EQ(choose(table, 99, rules, kSnapshot), kSnapshot);
    EXPECT_EQ(choose(table, 100.5, rules, kSnapshot), kSprite);
    EXPECT_EQ(choose(table, 99, rules, kSprite), kSprite);
    EXPECT_EQ(choose(table, 85, rules, kSprite), kSprite);
    EXPECT_EQ(choose(table, 80, rules, kSprite), kSnapshot);
}

TEST(ChooseRepresentation, ALittleCheaperIsNotWorthAChange) {
    const RepresentationTable table{{kSprite, {{20, 0, 100}}}, {kSnapshot, {{20, 0, 90}}}};
    EXPECT_EQ(choose(table, 10, {.band = 0.15}, kSprite), kSprite);
    EXPECT_EQ(choose(table, 10, {.band = 0.05}, kSprite), kSnapshot);
    EXPECT_EQ(choose(table, 10, {.band = 0.15}, {}), kSnapshot);
}

// Tables with any errors, and costs that grow with the size as areas do at most.
RepresentationTable randomTable(std::mt19937& random) {
    const auto unit = [&] { return std::generate_canonical<double, 32>(random); };
    RepresentationTable table;
    for (const RepresentationChoice choice : {kSprite, kSnapshot, kClusters, kCoarse1, kCoarse2}) {
        RepresentationFigures figures{choice, {}};
        const double cost = std::exp(6.0 * unit()), power = 2.0 * unit();
        for (double size = 2.0; size < 600.0; size *= 2.0) {
            const double error = choice == kSprite ? 0.0 : 0.3 * unit() * unit();
            figures.bySize.push_back({size, error, cost * std::pow(size / 2.0, power)});
        }
        table.push_back(figures);
    }
    return table;
}

TEST(ChooseRepresentation, IsWithinTheBudgetAlongEveryPath) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> step(-0.3, 0.3), budget(0.0, 0.2);
    for (int path = 0; path < 200; ++path) {
        const RepresentationTable table = randomTable(random);
        const ChoiceRules rules{.errorBudget = budget(random)};
        std::optional<RepresentationChoice> previous;
        double size = 30.0;
        for (int k = 0; k < 100; ++k) {
            size = std::min(1000.0, size * std::exp(step(random)));
            previous = choose(table, size, rules, previous);
            ASSERT_LE(errorAt(*figuresOf(table, *previous), size), rules.errorBudget);
        }
    }
}

TEST(ChooseRepresentation, IsTheCheapestWithoutAPast) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> logSize(0.0, 6.5), budget(0.0, 0.2);
    for (int k = 0; k < 500; ++k) {
        const RepresentationTable table = randomTable(random);
        const double size = std::exp(logSize(random));
        const ChoiceRules rules{.errorBudget = budget(random)};
        const double chosen =
            microsecondsAt(*figuresOf(table, choose(table, size, rules, {})), size);
        for (const RepresentationFigures& other : table) {
            if (errorAt(other, size) > rules.errorBudget) continue;
            ASSERT_LE(chosen, microsecondsAt(other, size));
        }
    }
}

TEST(ChooseRepresentation, ATremblingSizeNeverBringsBackWhatWasLeft) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> logSize(1.0, 6.0), tremble(-0.065, 0.065);
    int changes = 0;
    for (int k = 0; k < 400; ++k) {
        const RepresentationTable table = randomTable(random);
        const double centre = std::exp(logSize(random));
        // Coming from somewhere else.
        RepresentationChoice now = choose(table, 3.0 * centre, {}, {});
        now = choose(table, centre * std::exp(tremble(random)), {}, now);
        std::set<std::pair<int, int>> left;
        for (int frame = 0; frame < 200; ++frame) {
            const RepresentationChoice next =
                choose(table, centre * std::exp(tremble(random)), {}, now);
            if (next == now) continue;
            ++changes;
            left.emplace(static_cast<int>(now.kind), now.levels);
            ASSERT_FALSE(left.contains({static_cast<int>(next.kind), next.levels})) << k;
            now = next;
        }
    }
    EXPECT_GT(changes, 0);
}

}  // namespace
}  // namespace voxprite
