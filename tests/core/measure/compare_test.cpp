#include "core/measure/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/measure/flip.h"

namespace voxprite {
namespace {

Image noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Image image(width, height);
    for (Rgba8& pixel : image.pixels) {
        const auto bits = random();
        pixel = Rgba8(bits & 255, bits >> 8 & 255, bits >> 16 & 255, 255);
    }
    return image;
}

TEST(CompareImages, EqualPicturesDifferInNothing) {
    const Image image = noise(40, 30, 1);
    const auto result = compareImages(image, image);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->pixels, 1200u);
    EXPECT_EQ(result->mismatched, 0u);
    EXPECT_EQ(result->mismatchRate, 0.0);
    EXPECT_EQ(result->silhouetteXor, 0u);
    EXPECT_EQ(result->iou, 1.0);
    EXPECT_EQ(result->flipMean, 0.0);
    EXPECT_FALSE(result->psnr.has_value());
    EXPECT_EQ(result->ssim, 1.0);
}

TEST(CompareImages, ColourOfTransparentPixelsDoesNotCount) {
    const Image a(8, 8, Rgba8(255, 0, 0, 0));
    const Image b(8, 8, Rgba8(0, 255, 0, 0));
    const auto result = compareImages(a, b);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->mismatched, 0u);
    EXPECT_EQ(result->iou, 1.0);
    EXPECT_FALSE(result->psnr.has_value());
}

TEST(CompareImages, AlphaAloneIsAMismatch) {
    const Image a(4, 4, Rgba8(0, 0, 0, 255));
    const Image b(4, 4, Rgba8(0, 0, 0, 254));
    const auto result = compareImages(a, b);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->mismatched, 16u);
    EXPECT_EQ(result->silhouetteXor, 0u);
    // One step in one of four channels: MSE 1/4.
    EXPECT_NEAR(result->psnr.value_or(0.0), 10.0 * std::log10(255.0 * 255.0 * 4.0), 1e-12);
}

TEST(CompareImages, SilhouettesOfShiftedSquares) {
    Image a(20, 20);
    Image b(20, 20);
    for (int y = 5; y < 15; ++y) {
        for (int x = 5; x < 15; ++x) {
            a.at(x, y) = Rgba8(200, 100, 50, 255);
            b.at(x + 2, y) = Rgba8(200, 100, 50, 255);
        }
    }
    const auto result = compareImages(a, b);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->mismatched, 40u);
    EXPECT_EQ(result->mismatchRate, 0.1);
    EXPECT_EQ(result->silhouetteXor, 40u);
    EXPECT_DOUBLE_EQ(result->iou, 80.0 / 120.0);
}

// Of 10 x 10 pixels each, shifted by 2: 120 are covered, 40 of them by one alone; `a` has 100.
TEST(CompareImages, SharesOfWhatIsCovered) {
    Image a(40, 20);
    Image b(40, 20);
    for (int y = 5; y < 15; ++y) {
        for (int x = 5; x < 15; ++x) {
            a.at(x, y) = Rgba8(200, 100, 50, 255);
            b.at(x + 2, y) = Rgba8(200, 100, 50, 255);
        }
    }
    const auto result = compareImages(a, b);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->covered, 120u);
    EXPECT_DOUBLE_EQ(result->mismatchInside, 40.0 / 120.0);
    EXPECT_DOUBLE_EQ(result->silhouetteXorShare, 0.4);
    const auto equal = compareImages(a, a);
    ASSERT_TRUE(equal);
    EXPECT_EQ(equal->covered, 100u);
    EXPECT_EQ(equal->silhouetteXorShare, 0.0);
    const auto nothingWanted = compareImages(Image(40, 20), b);
    ASSERT_TRUE(nothingWanted);
    EXPECT_TRUE(std::isinf(nothingWanted->silhouetteXorShare));
}

// The farther the display, the more a pixel is blurred away: fine noise is seen less.
TEST(CompareImages, FlipGoesByPixelsADegree) {
    const Image a = noise(48, 48, 4);
    const Image b = noise(48, 48, 5);
    const auto near = compareImages(a, b, 20.0);
    const auto usual = compareImages(a, b);
    const auto far = compareImages(a, b, 134.0);
    ASSERT_TRUE(near && usual && far);
    EXPECT_GT(near->flipMean, usual->flipMean);
    EXPECT_GT(usual->flipMean, far->flipMean);
    EXPECT_EQ(near->mismatched, far->mismatched);
    const auto map = flipErrors(a, b, 20.0);
    ASSERT_TRUE(map);
    double sum = 0.0;
    for (const double error : map->values) sum += error;
    EXPECT_NEAR(sum / (48.0 * 48.0), near->flipMean, 1e-12);
}

TEST(CompareImages, PsnrByHand) {
    // One of 100 pixels differs by 10 in one channel: MSE = 100 / 400.
    const Image a(10, 10, Rgba8(50, 60, 70, 255));
    Image b = a;
    b.at(3, 4).y = 70;
    const auto result = compareImages(a, b);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->psnr.value_or(0.0), 10.0 * std::log10(255.0 * 255.0 / 0.25), 1e-12);
}

TEST(CompareImages, IsSymmetric) {
    Image a = noise(33, 27, 2);
    const Image b = noise(33, 27, 3);
    for (int x = 0; x < 20; ++x) a.at(x, 5).w = 0;
    const auto ab = compareImages(a, b);
    const auto ba = compareImages(b, a);
    ASSERT_TRUE(ab && ba);
    EXPECT_EQ(ab->mismatched, ba->mismatched);
    EXPECT_EQ(ab->silhouetteXor, ba->silhouetteXor);
    EXPECT_EQ(ab->iou, ba->iou);
    EXPECT_EQ(ab->psnr, ba->psnr);
    EXPECT_DOUBLE_EQ(ab->flipMean, ba->flipMean);
    EXPECT_DOUBLE_EQ(ab->ssim, ba->ssim);
}

TEST(CompareImages, BlackAgainstTransparentIsBlackAgainstGrey) {
    const Image black(24, 24, Rgba8(0, 0, 0, 255));
    const Image transparent(24, 24, Rgba8(0));
    const Image grey(24, 24, kComparisonBackground);
    const auto seen = compareImages(black, transparent);
    const auto same = compareImages(black, grey);
    ASSERT_TRUE(seen && same);
    EXPECT_EQ(seen->flipMean, same->flipMean);
    EXPECT_EQ(seen->ssim, same->ssim);
    EXPECT_GT(seen->flipMean, 0.3);
}

// A picture that is looked at once and compared twice gives the same figures.
TEST(CompareImages, KeptPicturesCompareAsTheyDoAlone) {
    const Image a = noise(40, 30, 1), b = noise(40, 30, 2), c = noise(40, 30, 3);
    const ComparedPicture kept(a, 30.0);
    for (const Image* other : {&b, &c, &a}) {
        const auto one = compareImages(kept, ComparedPicture(*other, 30.0));
        const auto alone = compareImages(a, *other, 30.0);
        ASSERT_TRUE(one && alone);
        EXPECT_EQ(one->flipMean, alone->flipMean);
        EXPECT_EQ(one->flipInside, alone->flipInside);
        EXPECT_EQ(one->ssim, alone->ssim);
    }
}

TEST(CompareImages, RefusesWhatCannotBeCompared) {
    const auto sizes = compareImages(Image(4, 5), Image(5, 4));
    ASSERT_FALSE(sizes);
    EXPECT_NE(sizes.error().message.find("4x5 and 5x4"), std::string::npos)
        << sizes.error().message;
    EXPECT_FALSE(compareImages(Image(0, 0), Image(0, 0)));
}

TEST(CompareImages, FlipInsideDoesNotDependOnTheEmptyRoomAround) {
    const auto framed = [](int edge, Rgba8 colour) {
        Image image(edge, edge);
        const int from = edge / 2 - 6;
        for (int y = from; y < from + 12; ++y) {
            for (int x = from; x < from + 12; ++x) image.at(x, y) = colour;
        }
        return image;
    };
    const Rgba8 red(200, 40, 30, 255), green(40, 160, 60, 255);
    const auto small = compareImages(framed(60, red), framed(60, green));
    const auto large = compareImages(framed(120, red), framed(120, green));
    ASSERT_TRUE(small && large);
    EXPECT_GT(small->flipInside, 0.2);
    EXPECT_NEAR(large->flipInside, small->flipInside, 1e-9);
    EXPECT_GT(small->flipMean, 2.0 * large->flipMean);
}

TEST(CompareImages, FlipInsideIsTheMeanOverEithersSilhouette) {
    Image a(50, 40), b(50, 40);
    for (int y = 10; y < 30; ++y) {
        for (int x = 10; x < 30; ++x) a.at(x, y) = Rgba8(230, 220, 40, 255);
        for (int x = 17; x < 37; ++x) b.at(x, y) = Rgba8(230, 220, 40, 255);
    }
    const auto onGrey = [](Image image) {
        for (Rgba8& pixel : image.pixels) {
            if (pixel.w == 0) pixel = kComparisonBackground;
        }
        return image;
    };
    const Plane errors = flipMap(onGrey(a), onGrey(b));
    double sum = 0.0;
    for (int y = 10; y < 30; ++y) {
        for (int x = 10; x < 37; ++x) sum += errors.at(x, y);
    }
    const auto whole = compareImages(a, b);
    const auto alone = flipInside(a, b);
    ASSERT_TRUE(whole && alone);
    EXPECT_NEAR(whole->flipInside, sum / (20 * 27), 1e-12);
    EXPECT_EQ(*alone, whole->flipInside);
    EXPECT_EQ(*flipInside(a, a), 0.0);
    EXPECT_EQ(*flipInside(Image(5, 5), Image(5, 5, Rgba8(9, 9, 9, 0))), 0.0);
    EXPECT_FALSE(flipInside(a, Image(50, 41)));
    EXPECT_FALSE(flipInside(Image(), Image()));
}

}  // namespace
}  // namespace voxprite
