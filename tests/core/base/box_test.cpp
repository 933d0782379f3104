#include "core/base/box.h"

#include <gtest/gtest.h>

#include "core/base/boxed.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

TEST(Box, HalfOpen) {
    const IBox box{{-1, 0, 2}, {1, 1, 3}};
    EXPECT_EQ(box.size(), glm::ivec3(2, 1, 1));
    EXPECT_TRUE(box.contains({-1, 0, 2}));
    EXPECT_TRUE(box.contains({0, 0, 2}));
    EXPECT_FALSE(box.contains({1, 0, 2}));
    EXPECT_FALSE(box.contains({0, 1, 2}));
    EXPECT_TRUE(IBox{}.empty());
    EXPECT_EQ(IBox::around({3, 0, 5}, {1, 2, 5}), (IBox{{1, 0, 5}, {4, 3, 6}}));
}

TEST(Box, UnionAndIntersectionAgreeWithTheirVoxels) {
    test::Random random(1);
    for (int round = 0; round < 200; ++round) {
        const IBox a = IBox::around(random.voxel(-2, 2), random.voxel(-2, 2));
        const IBox b = IBox::around(random.voxel(-2, 2), random.voxel(-2, 2));
        const IBox both = a.intersected(b);
        const IBox around = a.united(b);
        for (int i = 0; i < 216; ++i) {
            const glm::ivec3 v(i % 6 - 3, i / 6 % 6 - 3, i / 36 - 3);
            EXPECT_EQ(both.contains(v), a.contains(v) && b.contains(v));
            EXPECT_TRUE(around.contains(v) || (!a.contains(v) && !b.contains(v)));
        }
        EXPECT_EQ(a.united(IBox{}), a);
        EXPECT_EQ(IBox{}.united(a), a);
        EXPECT_EQ(around.min, glm::min(a.min, b.min));
        EXPECT_EQ(around.max, glm::max(a.max, b.max));
    }
}

TEST(Boxed, CopiesAreApart) {
    Boxed<int> a = 3;
    Boxed<int> b = a;
    *b = 4;
    EXPECT_EQ(*a, 3);
    EXPECT_FALSE(a == b);
    a = b;
    EXPECT_TRUE(a == b);
    *a = 5;
    EXPECT_EQ(*b, 4);
    const Boxed<int>& self = b;
    b = self;
    EXPECT_EQ(*b, 4);
    a = std::move(b);
    EXPECT_EQ(*a, 4);
}

}  // namespace
}  // namespace voxprite
