#include "core/sheet/pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "tests/support/must.h"

namespace voxprite::test {
namespace {

void expectApart(const Packing& packing, const std::vector<glm::ivec2>& sizes, int padding) {
    ASSERT_EQ(packing.corners.size(), sizes.size());
    for (std::size_t a = 0; a < sizes.size(); ++a) {
        const glm::ivec2 low = packing.corners[a];
        const glm::ivec2 high = low + sizes[a];
        ASSERT_TRUE(low.x >= 0 && low.y >= 0 && high.x <= packing.size.x &&
                    high.y <= packing.size.y);
        for (std::size_t b = a + 1; b < sizes.size(); ++b) {
            const glm::ivec2 otherLow = packing.corners[b];
            const glm::ivec2 otherHigh = otherLow + sizes[b];
            ASSERT_TRUE(otherLow.x >= high.x + padding || otherHigh.x + padding <= low.x ||
                        otherLow.y >= high.y + padding || otherHigh.y + padding <= low.y)
                << a << " and " << b;
        }
    }
}

TEST(PackRectangles, KeepsThemApartAndWastesLittle) {
    std::mt19937 random(5);
    for (const int padding : {0, 1, 3}) {
        std::vector<glm::ivec2> sizes;
        std::int64_t area = 0;
        for (int k = 0; k < 150; ++k) {
            sizes.emplace_back(1 + random() % 40, 1 + random() % 40);
            area +=
                static_cast<std::int64_t>(sizes.back().x + padding) * (sizes.back().y + padding);
        }
        const Packing packing = must(packRectangles(sizes, padding, 4096));
        expectApart(packing, sizes, padding);
        EXPECT_LT(static_cast<std::int64_t>(packing.size.x) * packing.size.y, area * 5 / 4);
        EXPECT_LT(std::max(packing.size.x, packing.size.y),
                  3 * std::min(packing.size.x, packing.size.y));
    }
}

TEST(PackRectangles, EqualSquaresFillASquare) {
    const Packing packing = must(packRectangles(std::vector<glm::ivec2>(16, {10, 10}), 0, 64));
    EXPECT_EQ(packing.size, glm::ivec2(40, 40));
}

TEST(PackRectangles, OneStandsInTheCorner) {
    const Packing packing = must(packRectangles({{7, 3}}, 5, 16));
    EXPECT_EQ(packing.size, glm::ivec2(7, 3));
    EXPECT_EQ(packing.corners[0], glm::ivec2(0));
}

TEST(PackRectangles, FillsAPictureToItsLastPixel) {
    const Packing packing = must(packRectangles(std::vector<glm::ivec2>(4, {16, 16}), 0, 32));
    EXPECT_EQ(packing.size, glm::ivec2(32, 32));
    // Padding stands between, not around.
    const Packing padded = must(packRectangles(std::vector<glm::ivec2>(4, {15, 15}), 2, 32));
    EXPECT_EQ(padded.size, glm::ivec2(32, 32));
}

TEST(PackRectangles, SaysWhatDoesNotFit) {
    const auto tooWide = packRectangles({{33, 1}}, 0, 32);
    ASSERT_FALSE(tooWide);
    EXPECT_EQ(tooWide.error().message, "1 sprites do not fit a picture of 32x32");
    EXPECT_FALSE(packRectangles(std::vector<glm::ivec2>(5, {16, 16}), 0, 32));
}

}  // namespace
}  // namespace voxprite::test
