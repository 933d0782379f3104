#include "core/measure/temporal.h"

#include <gtest/gtest.h>

#include <limits>

namespace voxprite {
namespace {

constexpr Rgba8 kRed{200, 30, 30, 255};
constexpr Rgba8 kBlue{30, 30, 200, 255};

// A square of `edge` pixels from (left, 4) on, in a picture of 24 x 24.
Image square(int left, Rgba8 colour = kRed, int edge = 8) {
    Image image(24, 24);
    for (int y = 4; y < 4 + edge; ++y)
        for (int x = left; x < left + edge; ++x) image.at(x, y) = colour;
    return image;
}

TEST(TemporalMeter, StillPicturesHaveNothingToCount) {
    TemporalMeter meter;
    for (int k = 0; k < 4; ++k) ASSERT_TRUE(meter.add(square(3), 0.5));
    EXPECT_EQ(meter.figures().frames, 4);
    EXPECT_EQ(meter.figures().degrees, 1.5);  // of the first frame there is no turn
    EXPECT_EQ(meter.figures().changed, 0.0);
    EXPECT_EQ(meter.figures().flips, 0.0);
    EXPECT_EQ(meter.figures().crawl, 0.0);
}

// A square of 8 x 8 moves by one: a column goes, one comes. Together they cover 72 pixels.
TEST(TemporalMeter, ASquareThatMovesByAPixel) {
    TemporalMeter meter;
    ASSERT_TRUE(meter.add(square(3), 9.0));
    ASSERT_TRUE(meter.add(square(4), 2.0));
    const TemporalFigures& figures = meter.figures();
    EXPECT_DOUBLE_EQ(figures.changed, 16.0 / 72.0);
    EXPECT_EQ(figures.flips, 0.0);
    // Borders of 28 pixels each: all 8 of the left column go, but the rows above and below keep
    // their place: they share 2 * 7 of top and bottom, and nothing of the sides.
    EXPECT_DOUBLE_EQ(figures.crawl, (28.0 + 28.0 - 2.0 * 14.0) / (28.0 + 28.0 - 14.0));
    EXPECT_DOUBLE_EQ(figures.aDegree(figures.changed), 16.0 / 72.0 / 2.0);
}

TEST(TemporalMeter, ThereAndBackIsAFlipAndOnwardIsNone) {
    TemporalMeter back, onward;
    for (const int left : {3, 4, 3}) ASSERT_TRUE(back.add(square(left), 1.0));
    for (const int left : {3, 4, 5}) ASSERT_TRUE(onward.add(square(left), 1.0));
    // 16 pixels change and change back, of the 72 that the three frames cover.
    EXPECT_DOUBLE_EQ(back.figures().flips, 16.0 / 72.0);
    EXPECT_EQ(onward.figures().flips, 0.0);
    EXPECT_DOUBLE_EQ(back.figures().changed, onward.figures().changed);
}

TEST(TemporalMeter, ColoursFlipWithoutACrawlingBorder) {
    TemporalMeter meter;
    ASSERT_TRUE(meter.add(square(3, kRed), 1.0));
    ASSERT_TRUE(meter.add(square(3, kBlue), 1.0));
    ASSERT_TRUE(meter.add(square(3, kRed), 1.0));
    EXPECT_DOUBLE_EQ(meter.figures().changed, 2.0);
    EXPECT_DOUBLE_EQ(meter.figures().flips, 1.0);
    EXPECT_EQ(meter.figures().crawl, 0.0);
}

TEST(TemporalMeter, TheColourOfNothingIsNoColour) {
    TemporalMeter meter;
    ASSERT_TRUE(meter.add(Image(5, 5, Rgba8(9, 9, 9, 0)), 1.0));
    ASSERT_TRUE(meter.add(Image(5, 5, Rgba8(0)), 1.0));
    EXPECT_EQ(meter.figures().changed, 0.0);
}

TEST(TemporalMeter, RefusesWhatIsNoFrameOfTheWay) {
    TemporalMeter meter;
    EXPECT_FALSE(meter.add(Image(), 1.0));
    ASSERT_TRUE(meter.add(Image(4, 4), 1.0));
    EXPECT_FALSE(meter.add(Image(4, 5), 1.0));
    EXPECT_FALSE(meter.add(Image(4, 4), -1.0));
    EXPECT_FALSE(meter.add(Image(4, 4), std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(meter.figures().frames, 1);
    EXPECT_EQ(meter.figures().aDegree(1.0), 0.0);
}

}  // namespace
}  // namespace voxprite
