#include "core/measure/ids.h"

#include <gtest/gtest.h>

#include <vector>

namespace voxprite {
namespace {

TEST(CompareIds, CountsOtherThingsAndThingsInOneAlone) {
    // 0 and 1 are no things, and alike.
    const std::vector<std::uint32_t> a{0, 1, 2, 3, 4, 0, 7};
    const std::vector<std::uint32_t> b{1, 0, 2, 4, 1, 5, 7};
    const Result<IdComparison> result = compareIds(a, b, 2);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->covered, 5u);
    EXPECT_EQ(result->differing, 3u);
    EXPECT_EQ(result->onlyOne, 2u);
    EXPECT_DOUBLE_EQ(result->rate(), 0.6);
}

TEST(CompareIds, NothingDiffersFromNothingInNothing) {
    const std::vector<std::uint32_t> none{0, 1, 1};
    const Result<IdComparison> result = compareIds(none, none, 2);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->rate(), 0.0);
    EXPECT_FALSE(compareIds(none, std::vector<std::uint32_t>{0, 1}, 2));
}

}  // namespace
}  // namespace voxprite
