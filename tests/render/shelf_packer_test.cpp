#include "render/shelf_packer.h"

#include <gtest/gtest.h>

#include <random>

namespace voxprite {
namespace {

struct Taken {
    glm::ivec3 place;
    glm::ivec2 size;
};

bool overlap(const Taken& a, const Taken& b) {
    return a.place.z == b.place.z && a.place.x < b.place.x + b.size.x &&
           b.place.x < a.place.x + a.size.x && a.place.y < b.place.y + b.size.y &&
           b.place.y < a.place.y + a.size.y;
}

TEST(ShelfPacker, WhatIsTakenNeverOverlapsAndLiesOnAPage) {
    constexpr glm::ivec2 kPage{200, 160};
    ShelfPacker packer(kPage);
    packer.addPage();
    packer.addPage();
    std::mt19937 random(11);
    const auto upTo = [&](int n) { return 1 + static_cast<int>(random() % unsigned(n)); };
    std::vector<Taken> taken;
    int refused = 0;
    for (int step = 0; step < 4000; ++step) {
        if (random() % 5 < 2 && !taken.empty()) {
            const std::size_t gone = random() % taken.size();
            packer.giveBack(taken[gone].place, taken[gone].size);
            taken.erase(taken.begin() + static_cast<std::ptrdiff_t>(gone));
            continue;
        }
        const glm::ivec2 size(upTo(60), upTo(40));
        const std::optional<glm::ivec3> place = packer.take(size);
        if (!place) {
            ++refused;
            continue;
        }
        const Taken next{*place, size};
        ASSERT_GE(place->x, 0);
        ASSERT_GE(place->y, 0);
        ASSERT_LE(place->x + size.x, kPage.x);
        ASSERT_LE(place->y + size.y, kPage.y);
        ASSERT_TRUE(place->z == 0 || place->z == 1);
        for (const Taken& other : taken) ASSERT_FALSE(overlap(next, other)) << step;
        taken.push_back(next);
    }
    EXPECT_GT(refused, 0);
    // All given back, a whole page is free again.
    for (const Taken& t : taken) packer.giveBack(t.place, t.size);
    EXPECT_TRUE(packer.take(kPage));
    EXPECT_TRUE(packer.take(kPage));
    EXPECT_FALSE(packer.take({1, 1}));
}

TEST(ShelfPacker, EqualSizesFillAPage) {
    ShelfPacker packer({256, 256});
    EXPECT_FALSE(packer.take({16, 16}));
    packer.addPage();
    for (int k = 0; k < 256; ++k) EXPECT_TRUE(packer.take({16, 16})) << k;
    EXPECT_FALSE(packer.take({16, 16}));
    EXPECT_FALSE(packer.take({257, 1}));
}

TEST(ShelfPacker, SmallRectanglesOfAnyHeightWasteLittle) {
    ShelfPacker packer({256, 256});
    packer.addPage();
    std::mt19937 random(2);
    int area = 0;
    while (true) {
        const glm::ivec2 size(7 + static_cast<int>(random() % 5),
                              7 + static_cast<int>(random() % 5));
        if (!packer.take(size)) break;
        area += size.x * size.y;
    }
    EXPECT_GT(area, 256 * 256 / 2);
}

}  // namespace
}  // namespace voxprite
