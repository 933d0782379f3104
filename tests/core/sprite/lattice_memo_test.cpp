#include "core/sprite/lattice_memo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/parallel.h"
#include "core/sprite/sprite_key.h"
#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

using test::figure;
using test::mustView;
using test::orbit;

TEST(LatticeMemo, GivesWhatQuantisingGives) {
    LatticeMemo memo;
    for (int round = 0; round < 2; ++round) {
        for (const double yaw : {0.0, 12.3, -90.0, 180.0}) {
            for (const double sigma : {1.0, 4.0, 7.5}) {
                for (const glm::ivec3 size : {glm::ivec3(16, 8, 32), glm::ivec3(8, 16, 32)}) {
                    OrthoView view =
                        mustView(figure().centredAt({0, 0, 0}, {}), orbit(yaw, 20, 12), {}).ortho;
                    view.sigmaInForce = sigma;
                    const auto remembered = memo.quantise(view, size);
                    const auto fresh = quantiseView(view, size);
                    ASSERT_TRUE(remembered && fresh);
                    EXPECT_EQ(*remembered, *fresh);
                }
            }
        }
    }
}

// A camera that moves for long never asks twice; exact directions are found at once.
TEST(LatticeMemo, KeepsABoundedNumberOfViews) {
    LatticeMemo memo;
    constexpr int kAsked = static_cast<int>(LatticeMemo::kMostKept) * 5 / 4;
    OrthoView view;
    std::size_t most = 0;
    for (int k = 0; k < kAsked; ++k) {
        view.sigmaInForce = 1.0 + k * 1e-6;
        ASSERT_TRUE(memo.quantise(view, {4, 4, 4}));
        if (k % 1000 == 0) most = std::max(most, memo.kept());
    }
    EXPECT_LE(std::max(most, memo.kept()), LatticeMemo::kMostKept);
    EXPECT_GT(most, LatticeMemo::kMostKept / 4);
    // The last ones are still there.
    const std::size_t before = memo.kept();
    EXPECT_EQ(*memo.quantise(view, {4, 4, 4}), *quantiseView(view, {4, 4, 4}));
    EXPECT_EQ(memo.kept(), before);
}

TEST(LatticeMemo, AnyNumberOfThreadsMayAsk) {
    LatticeMemo memo;
    std::vector<LatticeView> found(4000);
    parallelFor(static_cast<int>(found.size()), 0, [&](int first, int last) {
        for (int k = first; k < last; ++k) {
            OrthoView view;
            view.sigmaInForce = 1.0 + k % 100 * 0.01;
            found[static_cast<std::size_t>(k)] = *memo.quantise(view, {4, 4, 4});
        }
    });
    EXPECT_EQ(memo.kept(), 100U);
    for (std::size_t k = 100; k < found.size(); ++k) EXPECT_EQ(found[k], found[k % 100]);
}

TEST(LatticeMemo, FailsWhereQuantisingFails) {
    LatticeMemo memo;
    OrthoView view;
    view.sigmaInForce = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(memo.quantise(view, {4, 4, 4}));
    EXPECT_FALSE(memo.quantise(view, {4, 4, 4}));
}

TEST(LitPalettes, EqualPalettesHaveEqualNumbers) {
    LitPalettes palettes;
    palettes.beginFrame();
    Palette one = Palette::standard();
    const Palette two = one;
    const auto a = palettes.of(one, {255, 200, 100}, {});
    EXPECT_EQ(palettes.of(two, {255, 200, 100}, {}).number, a.number);
    EXPECT_EQ(*a.lit, litPalette(one, {255, 200, 100}, {}));
    const auto darker = palettes.of(one, {255, 200, 99}, {});
    EXPECT_NE(darker.number, a.number);
    EXPECT_EQ(*darker.lit, litPalette(one, {255, 200, 99}, {}));

    palettes.beginFrame();
    Outline outline;
    outline.enabled = false;
    EXPECT_NE(palettes.of(two, {255, 200, 100}, outline).number, a.number);
    palettes.beginFrame();
    EXPECT_EQ(palettes.of(two, {255, 200, 100}, {}).number, a.number);
    // The same place in memory, another palette.
    one.colours[17].x ^= 1;
    EXPECT_NE(palettes.of(one, {255, 200, 100}, {}).number, a.number);
}

TEST(LitPalettes, TheSameColoursAreOneContent) {
    LitPalettes palettes;
    palettes.beginFrame();
    const Palette one = Palette::standard();
    Palette two = one;
    two.names[9] = "moss";
    Palette three = one;
    three.ramps = {{"", {1, 2}}};
    EXPECT_EQ(palettes.contentOf(one), palettes.contentOf(two));
    EXPECT_NE(palettes.contentOf(one), palettes.contentOf(three));
    const auto multiply = palettes.of(one, {9, 8, 7}, {});
    const auto within = palettes.of(one, {9, 8, 7}, {}, Shading::palette);
    EXPECT_NE(multiply.number, within.number);
    EXPECT_EQ(*within.lit, litPalette(one, {9, 8, 7}, {}, Shading::palette));
    EXPECT_NE(palettes.of(three, {9, 8, 7}, {}, Shading::palette).number, within.number);
    palettes.beginFrame();
    two.colours[4].z ^= 1;
    EXPECT_NE(palettes.contentOf(two), palettes.contentOf(one));
}

// A crowd in many lights keeps all of them from frame to frame; what nobody uses any more goes.
TEST(LitPalettes, KeepsWhatIsUsedAndForgetsTheRest) {
    LitPalettes palettes;
    const Palette palette = Palette::standard();
    const auto light = [](int i) {
        return std::array<std::uint8_t, 3>{static_cast<std::uint8_t>(i & 255),
                                           static_cast<std::uint8_t>(i >> 8), 7};
    };
    std::vector<std::uint64_t> numbers;
    for (int frame = 0; frame < 3; ++frame) {
        palettes.beginFrame();
        for (int i = 0; i < 3000; ++i) {
            const std::uint64_t number = palettes.of(palette, light(i), {}).number;
            if (frame == 0) numbers.push_back(number);
            ASSERT_EQ(number, numbers[static_cast<std::size_t>(i)]);
        }
    }
    // A moving light: always others.
    for (int frame = 0; frame < 400; ++frame) {
        palettes.beginFrame();
        for (int i = 0; i < 50; ++i) {
            static_cast<void>(palettes.of(palette, light(4000 + 50 * frame + i), {}));
        }
        EXPECT_LE(palettes.kept(), 6000 + LitPalettes::kSpare + 50);
    }
    EXPECT_LE(palettes.kept(), 100 + LitPalettes::kSpare + 50);
}

// Palettes that nobody lights, such as those of clusters, are forgotten like those that are lit.
TEST(LitPalettes, ForgetsPalettesThatNobodyLights) {
    LitPalettes palettes;
    Palette palette = Palette::standard();
    for (int frame = 0; frame < 3000; ++frame) {
        palettes.beginFrame();
        palette.colours[1] = {frame & 255, frame >> 8, 7, 255};
        static_cast<void>(palettes.contentOf(palette));
        ASSERT_LE(palettes.kept(), LitPalettes::kSpare + 3);
    }
}

// However many there are, a number stands for one palette.
TEST(LitPalettes, NumbersAreNeverGivenTwice) {
    LitPalettes palettes;
    std::map<std::uint64_t, LitPalette> known;
    Palette palette = Palette::standard();
    for (int frame = 0; frame < 6000; ++frame) {
        palettes.beginFrame();
        palette.colours[1] = {frame & 255, frame >> 8, 7, 255};
        const auto numbered = palettes.of(palette, {255, 200, 100}, {});
        EXPECT_TRUE(known.emplace(numbered.number, *numbered.lit).second);
    }
}

}  // namespace
}  // namespace voxprite
