#include "core/io/colour_reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/oklab.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

Rgba8 grey(int value) {
    const auto byte = static_cast<std::uint8_t>(value);
    return {byte, byte, byte, 255};
}

TEST(ColourReduction, FewColoursKeepTheirOwnIndexInTheirOrder) {
    ColourCount count;
    for (int k = 254; k >= 0; --k) count.add(grey(k), 3);
    count.add(grey(7));
    const ReducedColours reduced = reduceColours(count);
    EXPECT_TRUE(reduced.exact());
    EXPECT_FALSE(reduced.warning());
    EXPECT_EQ(reduced.used, 255);
    for (int k = 0; k < 255; ++k) {
        EXPECT_EQ(reduced.indexOf(grey(k)), 255 - k);
        EXPECT_EQ(reduced.palette.colours[reduced.indexOf(grey(k))], grey(k));
    }
    EXPECT_TRUE(validate(reduced.palette));
}

TEST(ColourReduction, AColourThatWasNotCountedGetsTheNearest) {
    ColourCount count;
    count.add(Rgba8(255, 0, 0, 255));
    count.add(Rgba8(0, 0, 255, 255));
    const ReducedColours reduced = reduceColours(count);
    EXPECT_EQ(reduced.indexOf(Rgba8(200, 30, 20, 255)), 1);
    EXPECT_EQ(reduced.indexOf(Rgba8(0, 30, 200, 255)), 2);
}

TEST(ColourReduction, AlphaTellsColoursApart) {
    ColourCount count;
    count.add(Rgba8(9, 9, 9, 255));
    count.add(Rgba8(9, 9, 9, 128));
    const ReducedColours reduced = reduceColours(count);
    EXPECT_EQ(reduced.used, 2);
    EXPECT_EQ(reduced.palette.colours[reduced.indexOf(Rgba8(9, 9, 9, 128))].w, 128);
}

TEST(ColourReduction, NoColoursAreAnEmptyPalette) {
    const ReducedColours reduced = reduceColours(ColourCount{});
    EXPECT_EQ(reduced.used, 0);
    EXPECT_TRUE(reduced.exact());
}

// Two well apart heaps of colours and one lonely one: a palette of three has one of each.
TEST(ColourReduction, GroupsAreFoundByHowTheyLook) {
    ColourCount count;
    for (int k = 0; k < 10; ++k) {
        count.add(Rgba8(200 + k, 10, 10, 255), 100);
        count.add(Rgba8(10, 10, 200 + k, 255), 100);
    }
    count.add(Rgba8(0, 255, 0, 255), 10);
    const ReducedColours reduced = reduceColours(count, 3);
    ASSERT_EQ(reduced.used, 3);
    EXPECT_FALSE(reduced.exact());
    ASSERT_TRUE(reduced.warning());
    EXPECT_NE(reduced.warning()->find("21 colours"), std::string::npos);
    std::set<std::uint8_t> reds, blues;
    for (int k = 0; k < 10; ++k) {
        reds.insert(reduced.indexOf(Rgba8(200 + k, 10, 10, 255)));
        blues.insert(reduced.indexOf(Rgba8(10, 10, 200 + k, 255)));
    }
    EXPECT_EQ(reds.size(), 1u);
    EXPECT_EQ(blues.size(), 1u);
    EXPECT_NE(*reds.begin(), *blues.begin());
    EXPECT_EQ(reduced.palette.colours[reduced.indexOf(Rgba8(0, 255, 0, 255))],
              Rgba8(0, 255, 0, 255));
}

ColourCount manyColours(int colours, bool backwards = false) {
    test::Random random(11);
    std::vector<std::pair<Rgba8, std::uint64_t>> list;
    for (int k = 0; k < colours; ++k) {
        list.emplace_back(
            Rgba8(random.between(0, 255), random.between(0, 255), random.between(0, 255), 255),
            static_cast<std::uint64_t>(random.between(1, 50)));
    }
    if (backwards) std::ranges::reverse(list);
    ColourCount count;
    for (const auto& [colour, times] : list) count.add(colour, times);
    return count;
}

TEST(ColourReduction, TheOrderOfCountingDoesNotMatter) {
    for (const int colours : {3000, 60'000}) {
        const ColourCount count = manyColours(colours);
        const ReducedColours one = reduceColours(count);
        const ReducedColours other = reduceColours(manyColours(colours, true));
        EXPECT_EQ(one.palette, other.palette);
        std::size_t different = 0;
        for (const ColourCount::Entry& entry : count.entries()) {
            if (one.indexOf(entry.colour) != other.indexOf(entry.colour)) ++different;
        }
        EXPECT_EQ(different, 0u);
        EXPECT_GE(one.used, 250);
        EXPECT_LE(one.meanDistance, 0.05);
        EXPECT_LE(one.maxDistance, 0.15);
    }
}

TEST(ColourReduction, EveryColourOfThePaletteWasThereAndIsNearest) {
    const ColourCount count = manyColours(2000);
    const ReducedColours reduced = reduceColours(count);
    std::set<std::uint32_t> there;
    for (const auto& [colour, times] : count.entries()) {
        there.insert(std::uint32_t{colour.x} << 16 | std::uint32_t{colour.y} << 8 | colour.z);
        const OkLab lab = okLabFrom(colour);
        const auto distance = [&](int index) {
            return squaredDistance(
                okLabFrom(reduced.palette.colours[static_cast<std::size_t>(index)]), lab);
        };
        for (int k = 1; k <= reduced.used; ++k) {
            ASSERT_LE(distance(reduced.indexOf(colour)), distance(k));
        }
    }
    for (int k = 1; k <= reduced.used; ++k) {
        const Rgba8 colour = reduced.palette.colours[static_cast<std::size_t>(k)];
        EXPECT_TRUE(there.contains(std::uint32_t{colour.x} << 16 | std::uint32_t{colour.y} << 8 |
                                   colour.z));
    }
}

}  // namespace
}  // namespace voxprite
