#include "core/measure/mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace voxprite {
namespace {

// '#' is set.
Mask mask(const std::vector<std::string>& rows) {
    Mask result(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
    std::size_t k = 0;
    for (const std::string& row : rows)
        for (const char c : row) result.set[k++] = c == '#' ? 1 : 0;
    return result;
}

Mask square(int size, int left, int top, int edge) {
    Mask result(size, size);
    for (int y = top; y < top + edge; ++y)
        for (int x = left; x < left + edge; ++x)
            result.set[static_cast<std::size_t>(y * size + x)] = 1;
    return result;
}

Mask random(int width, int height, unsigned seed, unsigned oneIn) {
    std::mt19937 numbers(seed);
    Mask result(width, height);
    for (std::uint8_t& set : result.set) set = numbers() % oneIn == 0 ? 1 : 0;
    return result;
}

bool setAt(const Mask& mask, int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width && y < mask.height &&
           mask.set[static_cast<std::size_t>(y * mask.width + x)] != 0;
}

TEST(Masks, SilhouettesAndColours) {
    Image image(3, 1);
    image.pixels = {Rgba8(9, 9, 9, 127), Rgba8(9, 9, 9, 128), Rgba8(0, 0, 0, 255)};
    EXPECT_EQ(silhouetteOf(image), mask({".##"}));
    EXPECT_EQ(pixelsOfColour(image, Rgba8(0, 0, 0, 255)), mask({"..#"}));
}

TEST(Masks, ErodeAndDilateBySquares) {
    const Mask cross = mask({".....", "..#..", ".###.", "..#..", "....."});
    EXPECT_EQ(eroded(cross, 1), mask({".....", ".....", ".....", ".....", "....."}));
    EXPECT_EQ(dilated(cross, 1), mask({".###.", "#####", "#####", "#####", ".###."}));
    // Beyond the picture nothing is set.
    EXPECT_EQ(eroded(mask({"###", "###", "###"}), 1), mask({"...", ".#.", "..."}));
}

TEST(Masks, AgreeWithLookingAtEveryNeighbour) {
    unsigned seed = 1;
    for (const auto& [width, height] : {std::pair(17, 11), std::pair(1, 9), std::pair(8, 1)}) {
        for (const int radius : {0, 1, 2, 5, 20}) {
            const Mask sparse = random(width, height, ++seed, 12);
            Mask dense = random(width, height, ++seed, 12);
            for (std::uint8_t& set : dense.set) set = set == 0 ? 1 : 0;
            const Mask thin = eroded(dense, radius);
            const Mask thick = dilated(sparse, radius);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    bool all = true, any = false;
                    for (int dy = -radius; dy <= radius; ++dy)
                        for (int dx = -radius; dx <= radius; ++dx) {
                            all = all && setAt(dense, x + dx, y + dy);
                            any = any || setAt(sparse, x + dx, y + dy);
                        }
                    ASSERT_EQ(setAt(thin, x, y), all) << x << "," << y << " by " << radius;
                    ASSERT_EQ(setAt(thick, x, y), any) << x << "," << y << " by " << radius;
                }
        }
    }
}

TEST(BoundaryIou, OfConcentricSquaresByHand) {
    // 20 and 18 pixels wide, both borders a pixel thick: 76 and 68 pixels, none in common.
    EXPECT_EQ(boundaryIou(square(40, 5, 5, 20), square(40, 6, 6, 18), 1), 0.0);
    EXPECT_NEAR(overlapOf(square(40, 5, 5, 20), square(40, 6, 6, 18)).iou(), 0.81, 1e-12);
    // Two pixels thick: 144 and 128 pixels, in common the inner square's outermost 68.
    EXPECT_NEAR(boundaryIou(square(40, 5, 5, 20), square(40, 6, 6, 18), 2), 68.0 / 204.0, 1e-12);
    // As thick as the squares: plain IoU.
    EXPECT_NEAR(boundaryIou(square(40, 5, 5, 20), square(40, 6, 6, 18), 15), 0.81, 1e-12);
}

TEST(BoundaryIou, EqualAndEmpty) {
    const Mask shape = random(30, 20, 3, 2);
    EXPECT_EQ(boundaryIou(shape, shape, 2), 1.0);
    EXPECT_EQ(boundaryIou(Mask(30, 20), Mask(30, 20), 2), 1.0);
    EXPECT_EQ(boundaryIou(shape, Mask(30, 20), 2), 0.0);
    EXPECT_EQ(boundaryDistancePx(512, 512), 14);  // 14.48
    EXPECT_EQ(boundaryDistancePx(3, 3), 1);
}

TEST(LineScores, CountWhatIsFoundWithinTheTolerance) {
    const Mask reference = mask({"####....", "........", "........"});
    const Mask test = mask({"##......", "..#.....", ".......#"});
    const LineScore strict = lineScore(reference, test);
    EXPECT_EQ(strict.precision, 0.5);
    EXPECT_EQ(strict.recall, 0.5);
    EXPECT_EQ(strict.f1(), 0.5);
    const LineScore near = lineScore(reference, test, 1);
    EXPECT_EQ(near.precision, 0.75);
    EXPECT_EQ(near.recall, 1.0);
    EXPECT_NEAR(near.f1(), 1.5 / 1.75, 1e-12);
}

TEST(LineScores, WithoutLines) {
    const Mask line = mask({"###"});
    const Mask none = mask({"..."});
    EXPECT_EQ(lineScore(none, none).f1(), 1.0);
    EXPECT_EQ(lineScore(line, none).recall, 0.0);
    EXPECT_EQ(lineScore(line, none).precision, 1.0);
    EXPECT_EQ(lineScore(line, none).f1(), 0.0);
    EXPECT_EQ(lineScore(none, line).precision, 0.0);
}

}  // namespace
}  // namespace voxprite
