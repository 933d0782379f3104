#include "core/lod/validate_clusters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/lod/cluster_cut.h"
#include "tests/core/lod/nested_groups.h"

namespace voxprite {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Changes one page of the example with three levels: 0..3 finest, 4 and 5, 6 the root.
template <class Change>
Status withPage(std::size_t number, const Change& change) {
    auto pages = test::threeLevels();
    change(pages[number]);
    return validateClusters(pages, 36);
}

void expectRefused(const Status& status, const char* reason, std::uint64_t page) {
    ASSERT_FALSE(status.has_value()) << reason;
    EXPECT_THAT(status.error().message, testing::HasSubstr(reason));
    EXPECT_EQ(status.error().offset, page * 64);
}

TEST(ValidateClusters, AcceptsTheExampleAndNothingAtAll) {
    EXPECT_TRUE(validateClusters(test::threeLevels(), 36));
    EXPECT_TRUE(validateClusters({}, 0));
}

TEST(ValidateClusters, EveryNumberIsChecked) {
    for (const float bad : {kNan, kInfinity, -kInfinity, 2e6f}) {
        for (std::size_t i : {0u, 4u}) {
            const char* sphere = "sphere that is none";
            expectRefused(withPage(i, [&](auto& p) { p.centre.x = bad; }), sphere, i);
            expectRefused(withPage(i, [&](auto& p) { p.radius = bad; }), sphere, i);
            expectRefused(withPage(i, [&](auto& p) { p.lodBoundsCentre.y = bad; }), sphere, i);
            expectRefused(withPage(i, [&](auto& p) { p.lodBoundsRadius = bad; }), sphere, i);
            expectRefused(withPage(i, [&](auto& p) { p.parentBoundsCentre.z = bad; }), sphere, i);
            expectRefused(withPage(i, [&](auto& p) { p.parentBoundsRadius = bad; }), sphere, i);
            expectRefused(withPage(i, [&](auto& p) { p.lodError = bad; }), "an error out", i);
        }
    }
    for (const float bad : {kNan, -kInfinity, -1.0f, 0.0f, 1e-7f, 2e6f}) {
        expectRefused(withPage(0, [&](auto& p) { p.parentError = bad; }), "parent error out", 0);
    }
    expectRefused(withPage(2, [](auto& p) { p.radius = -1.0f; }), "sphere that is none", 2);
    expectRefused(withPage(4, [](auto& p) { p.lodError = 1e-7f; }), "an error out", 4);
}

TEST(ValidateClusters, TrianglesAreWholeAndThere) {
    expectRefused(withPage(3, [](auto& p) { p.indexCount = 4; }), "broken triangle", 3);
    expectRefused(withPage(3, [](auto& p) { p.indexCount = 39; }), "beyond the end", 3);
    expectRefused(withPage(3, [](auto& p) { p.firstIndex = 7; }), "beyond the end", 3);
    expectRefused(withPage(3, [](auto& p) { p.firstIndex = 0xFFFF'FFFF; }), "beyond the end", 3);
}

TEST(ValidateClusters, ErrorsDouble) {
    expectRefused(withPage(4, [](auto& p) { p.parentError = 1.999f; }), "less than twice", 4);
    expectRefused(withPage(4, [](auto& p) { p.parentError = 0.5f; }), "less than twice", 4);
}

TEST(ValidateClusters, SpheresHoldThoseOfFinerGroups) {
    expectRefused(withPage(0, [](auto& p) { p.lodBoundsCentre.x = 0.01f; }), "sticks out", 0);
    expectRefused(withPage(0, [](auto& p) { p.lodBoundsRadius = 1.01f; }), "sticks out", 0);
    EXPECT_TRUE(withPage(0, [](auto& p) {
        p.lodBoundsRadius = 0.25f;
        p.lodBoundsCentre = {0.75f, 0, 0};
    }));
}

TEST(ValidateClusters, GroupsFitTogetherBitForBit) {
    // The parents' error, but seen near another sphere.
    expectRefused(withPage(1, [](auto& p) { p.parentBoundsCentre.y = 1e-7f; }),
                  "replaced by clusters that are not there", 1);
    expectRefused(withPage(1, [](auto& p) { p.parentError = 1.5f; }),
                  "replaced by clusters that are not there", 1);
    // A root that nothing leads to.
    expectRefused(withPage(6, [](auto& p) { p.lodError = 3.0f; }),
                  "replaced by clusters that are not there", 4);
    auto pages = test::threeLevels();
    pages.push_back(pages[6]);
    pages[7].lodBoundsCentre.x = 0.5f;
    pages[7].lodBoundsRadius = 0.5f;
    expectRefused(validateClusters(pages, 36), "replaces clusters that are not there", 7);
}

// The reason for the rules: what breaks one of them can be chosen twice or not at all.
TEST(ValidateClusters, WhatItRefusesMayLeaveAHole) {
    auto pages = test::threeLevels();
    for (std::size_t i = 0; i < 4; ++i) pages[i].parentError = 0.5f;  // and level 1 begins at 1
    ASSERT_FALSE(validateClusters(pages, 36));
    std::vector<std::uint32_t> cut;
    selectCut(pages, 0.75f, cut);
    EXPECT_TRUE(cut.empty());
}

TEST(ValidateClusters, AcceptsRandomGroups) {
    test::Random random(7);
    for (int round = 0; round < 200; ++round) {
        const auto groups = test::randomGroups(random, 5);
        const Status status = validateClusters(groups.pages, 3);
        EXPECT_TRUE(status) << status.error().message;
    }
}

}  // namespace
}  // namespace voxprite
