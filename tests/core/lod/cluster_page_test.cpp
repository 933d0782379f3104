// The records as bytes, read back by hand at the offsets that seed 003 documents.
#include "core/lod/cluster_page.h"

#include <gtest/gtest.h>

#include <cstring>

namespace voxprite {
namespace {

std::uint32_t wordAt(ByteView bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) |
           static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

float floatAt(ByteView bytes, std::size_t offset) {
    return std::bit_cast<float>(wordAt(bytes, offset));
}

// Every field another value, in the order of its offset: 1 at byte 0, 2 at byte 4 ...
ClusterPage countedPage() {
    ClusterPage page;
    page.centre = {1, 2, 3};
    page.radius = 4;
    page.lodBoundsCentre = {5, 6, 7};
    page.lodBoundsRadius = 8;
    page.parentBoundsCentre = {9, 10, 11};
    page.parentBoundsRadius = 12;
    page.lodError = 13;
    page.parentError = 14;
    page.firstIndex = 15;
    page.indexCount = 16;
    return page;
}

TEST(ClusterPage, Is64BytesWithEveryFieldInItsPlace) {
    ByteWriter out;
    writeClusterPage(countedPage(), out);
    ASSERT_EQ(out.size(), 64u);
    for (std::size_t i = 0; i < 14; ++i) {
        EXPECT_EQ(floatAt(out.bytes(), 4 * i), static_cast<float>(i + 1)) << "byte " << 4 * i;
    }
    EXPECT_EQ(wordAt(out.bytes(), 56), 15u);
    EXPECT_EQ(wordAt(out.bytes(), 60), 16u);
}

TEST(ClusterPage, PagesFollowEachOtherWithoutGaps) {
    ByteWriter out;
    ClusterPage second = countedPage();
    second.centre.x = -1.0f;
    writeClusterPage(countedPage(), out);
    writeClusterPage(second, out);
    ASSERT_EQ(out.size(), 128u);
    EXPECT_EQ(floatAt(out.bytes(), 64), -1.0f);
}

TEST(ClusterPage, LiesInMemoryAsItIsUploaded) {
    ByteWriter out;
    writeClusterPage(countedPage(), out);
    const ClusterPage page = countedPage();
    EXPECT_EQ(std::memcmp(&page, out.bytes().data(), sizeof(page)), 0);
}

TEST(ClusterPage, ARootsInfiniteErrorStaysInfinite) {
    ClusterPage root = countedPage();
    root.parentError = std::numeric_limits<float>::infinity();
    ByteWriter out;
    writeClusterPage(root, out);
    EXPECT_EQ(wordAt(out.bytes(), 52), 0x7F80'0000u);
}

TEST(ClusterCutParams, Are96BytesWithEveryFieldInItsPlace) {
    ClusterCutParams params;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            params.worldFromTree[column][row] = static_cast<float>(4 * column + row + 1);
    }
    params.cameraPosition = {17, 18, 19};
    params.tanHalfFovY = 20;
    params.viewportHeight = 21;
    params.pixelBudget = 22;
    params.worldScale = 23;
    params.clusterCount = 24;
    ByteWriter out;
    writeClusterCutParams(params, out);
    ASSERT_EQ(out.size(), 96u);
    for (std::size_t i = 0; i < 23; ++i) {
        EXPECT_EQ(floatAt(out.bytes(), 4 * i), static_cast<float>(i + 1)) << "byte " << 4 * i;
    }
    EXPECT_EQ(wordAt(out.bytes(), 92), 24u);
    EXPECT_EQ(std::memcmp(&params, out.bytes().data(), sizeof(params)), 0);
}

TEST(ClusterCutParams, TheNearDistanceTravelsInTheMatrixBottomRow) {
    ClusterCutParams params;
    params.worldFromTree[0][3] = 0.25f;
    EXPECT_EQ(params.nearDistance(), 0.25f);
    ByteWriter out;
    writeClusterCutParams(params, out);
    EXPECT_EQ(floatAt(out.bytes(), 12), 0.25f);
}

}  // namespace
}  // namespace voxprite
