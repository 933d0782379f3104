#include "core/base/oklab.h"

#include <gtest/gtest.h>

#include <cmath>

namespace voxprite {
namespace {

// The paper's matrices with the library's powers, as anybody would write it.
OkLab reference(Rgba8 colour) {
    const auto linear = [](double byte) {
        const double value = byte / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    const double r = linear(colour.x), g = linear(colour.y), b = linear(colour.z);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(OkLab, PublishedValues) {
    const OkLab white = okLabFrom({255, 255, 255, 255});
    EXPECT_NEAR(white.lightness, 1.0, 1e-6);
    EXPECT_NEAR(chromaOf(white), 0.0, 1e-6);
    const OkLab red = okLabFrom({255, 0, 0, 255});
    EXPECT_NEAR(red.lightness, 0.627955, 1e-5);
    EXPECT_NEAR(red.greenRed, 0.224863, 1e-5);
    EXPECT_NEAR(red.blueYellow, 0.125846, 1e-5);
    EXPECT_EQ(okLabFrom({0, 0, 0, 255}).lightness, 0.0);
    EXPECT_NEAR(hueDegreesOf(red), 29.23, 0.01);
    EXPECT_NEAR(hueDegreesOf(okLabFrom({0, 0, 255, 255})), 264.05, 0.01);
    EXPECT_EQ(hueDegreesOf(okLabFrom({90, 90, 90, 255})), 0.0);
}

TEST(OkLab, RootsByNewtonAgreeWithTheLibrarysAndEveryColourComesBack) {
    for (int red = 0; red < 256; red += 15) {
        for (int green = 0; green < 256; green += 5) {
            for (int blue = 0; blue < 256; ++blue) {
                const Rgba8 colour(red, green, blue, 255);
                const OkLab lab = okLabFrom(colour), wanted = reference(colour);
                ASSERT_NEAR(lab.lightness, wanted.lightness, 1e-12);
                ASSERT_NEAR(lab.greenRed, wanted.greenRed, 1e-12);
                ASSERT_NEAR(lab.blueYellow, wanted.blueYellow, 1e-12);
                ASSERT_EQ(rgba8From(lab), colour);
            }
        }
    }
}

TEST(OkLab, MixesAndDistances) {
    const OkLab black = okLabFrom({0, 0, 0, 255}), white = okLabFrom({255, 255, 255, 255});
    // Half as light to the eye is far less than half of the light.
    const Rgba8 middle = rgba8From(mix(black, white, 0.5));
    EXPECT_EQ(middle, Rgba8(99, 99, 99, 255));
    EXPECT_NEAR(squaredDistance(black, white), 1.0, 1e-6);
    // Outside sRGB: cut off, not wrapped round.
    EXPECT_EQ(rgba8From({1.2, 0.0, 0.0}), Rgba8(255, 255, 255, 255));
    EXPECT_EQ(rgba8From({-0.3, 0.0, 0.0}), Rgba8(0, 0, 0, 255));
}

}  // namespace
}  // namespace voxprite
