#include "core/sprite/palette_shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "tests/core/sprite/subject.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using Rgb = std::tuple<int, int, int>;
Rgb rgbOf(Rgba8 colour) {
    return {colour.x, colour.y, colour.z};
}

Rgba8 multiplied(Rgba8 c, int light) {
    return {(c.x * light + 127) / 255, (c.y * light + 127) / 255, (c.z * light + 127) / 255, 255};
}

Palette randomPalette(std::uint64_t seed, int colours) {
    test::Random random(seed);
    Palette palette;
    for (int i = 1; i <= colours; ++i) {
        palette.colours[static_cast<std::size_t>(i)] =
            Rgba8(random.between(0, 255), random.between(0, 255), random.between(0, 255), 255);
    }
    return palette;
}

TEST(PaletteShading, MultiplyIsTheFormulaForEveryColourAndLight) {
    const Palette palette = Palette::standard();
    PaletteShader shader(palette);
    for (int light = 0; light < 256; ++light) {
        const ShadedColours& shaded =
            shader.inLight(static_cast<std::uint8_t>(light), Shading::multiply);
        for (std::size_t i = 0; i < 256; ++i) {
            ASSERT_EQ(shaded[i], multiplied(palette.colours[i], light));
        }
    }
}

// What a ramp answers by, worked out by hand: greys of 40, 90, 150 and 220, OKLab lightness about
// 0.276, 0.464, 0.669 and 0.888.
TEST(PaletteShading, ARampIsWalkedFromTheColourDown) {
    Palette palette;
    palette.colours[10] = Rgba8(220, 220, 220, 255);
    palette.colours[20] = Rgba8(40, 40, 40, 255);
    palette.colours[30] = Rgba8(150, 150, 150, 255);
    palette.colours[40] = Rgba8(90, 90, 90, 255);
    palette.colours[50] = Rgba8(155, 155, 155, 255);  // nearer to much, but in no ramp
    palette.ramps = {{"greys", {20, 40, 30, 10}}};
    PaletteShader shader(palette);
    const auto grey = [&](int light, std::size_t index) {
        return int{shader.inLight(static_cast<std::uint8_t>(light), Shading::palette)[index].x};
    };
    EXPECT_EQ(grey(255, 10), 220);
    EXPECT_EQ(grey(230, 10), 220);  // 198 is nearer to 220 than to 150
    EXPECT_EQ(grey(191, 10), 150);  // 165
    EXPECT_EQ(grey(128, 10), 90);   // 110
    EXPECT_EQ(grey(60, 10), 40);    // 52
    EXPECT_EQ(grey(0, 10), 40);
    // Never lighter than itself, and the darkest stays.
    EXPECT_EQ(grey(128, 40), 40);
    EXPECT_EQ(grey(240, 40), 90);
    EXPECT_EQ(grey(0, 20), 40);
    // Without a ramp: anything in the palette.
    EXPECT_EQ(grey(250, 50), 150);
    EXPECT_EQ(grey(150, 50), 90);
}

TEST(PaletteShading, EveryAnswerIsTheNearestThereIs) {
    const Palette palette = randomPalette(3, 40);
    PaletteShader shader(palette);
    std::set<Rgb> known;
    for (int i = 1; i <= 40; ++i) known.insert(rgbOf(palette.colours[static_cast<std::size_t>(i)]));
    for (int light = 0; light < 256; light += 5) {
        const ShadedColours& shaded =
            shader.inLight(static_cast<std::uint8_t>(light), Shading::palette);
        for (std::size_t i = 1; i <= 40; ++i) {
            ASSERT_TRUE(known.contains(rgbOf(shaded[i])));
            const OkLab aim = okLabFrom(multiplied(palette.colours[i], light));
            double nearest = 9.0;
            for (std::size_t k = 1; k <= 40; ++k) {
                nearest = std::min(nearest, squaredDistance(okLabFrom(palette.colours[k]), aim));
            }
            ASSERT_EQ(squaredDistance(okLabFrom(shaded[i]), aim), nearest);
        }
        if (light == 255) {
            EXPECT_EQ(rgbOf(shaded[7]), rgbOf(palette.colours[7]));
        }
    }
}

// A place without a colour is no black to fall back on; a voxel that uses one stays as it is.
TEST(PaletteShading, VacantPlacesAreNotPicked) {
    Palette palette;
    palette.colours[1] = Rgba8(200, 60, 60, 255);
    PaletteShader lonely(palette);
    EXPECT_EQ(lonely.inLight(0, Shading::palette)[1], Rgba8(200, 60, 60, 255));
    EXPECT_EQ(lonely.inLight(90, Shading::palette)[77], Rgba8(0, 0, 0, 255));
    palette.colours[200] = Rgba8(0, 0, 0, 255);
    PaletteShader withBlack(palette);
    EXPECT_EQ(withBlack.inLight(0, Shading::palette)[1], Rgba8(0, 0, 0, 255));
}

// The promise itself: no pixel of a sprite has a colour that is not the artist's.
TEST(PaletteShading, ASpriteHasOnlyThePalettesColours) {
    Palette palette = randomPalette(8, 24);
    palette.ramps = {{"", {5, 2}}, {"", {1, 9, 4, 3}}};
    std::set<Rgb> known;
    for (int i = 1; i <= 24; ++i) known.insert(rgbOf(palette.colours[static_cast<std::size_t>(i)]));
    const test::Subject subject = test::figure();
    int shaded = 0;
    for (const double yaw : {0.0, 33.0, 140.0, 250.0}) {
        const SpriteView view =
            test::mustView(subject.centredAt({0, 0, 0}, {}), test::orbit(yaw, 25, 12), {});
        const LitPalette lit = litPalette(palette, view.light8, {}, Shading::palette);
        const SpriteBuffer sprite = castSprite(subject.octree.view(), view.lattice, lit);
        const SpriteBuffer plain =
            castSprite(subject.octree.view(), view.lattice, litPalette(palette, view.light8, {}));
        EXPECT_EQ(sprite.idsSha256(), plain.idsSha256());
        for (std::size_t i = 0; i < sprite.ids.size(); ++i) {
            if (sprite.ids[i] < kIdFirstVoxel) continue;
            ASSERT_TRUE(known.contains(rgbOf(sprite.colours[i])));
            if (sprite.colours[i] != plain.colours[i]) ++shaded;
        }
    }
    EXPECT_GT(shaded, 1000);
}

TEST(PaletteShading, KnowsWhatItWasMadeFrom) {
    Palette palette = randomPalette(5, 30);
    const PaletteShader shader(palette);
    const auto still = [&](auto change) {
        Palette other = palette;
        change(other);
        return shader.isOf(other);
    };
    EXPECT_TRUE(shader.isOf(palette));
    EXPECT_TRUE(still([](Palette& p) { p.names[3] = "skin"; }));
    EXPECT_TRUE(still([](Palette& p) { p.variants = {{"red", {{3, Rgba8(1, 2, 3, 255)}}}}; }));
    EXPECT_TRUE(still([](Palette& p) { std::swap(p.displayOrder[3], p.displayOrder[4]); }));
    EXPECT_FALSE(still([](Palette& p) { p.colours[3].x ^= 1; }));
    EXPECT_FALSE(still([](Palette& p) { p.ramps = {{"", {3, 4}}}; }));
    EXPECT_FALSE(still([](Palette& p) { p.names[200] = "black of its own"; }));
}

}  // namespace
}  // namespace voxprite
