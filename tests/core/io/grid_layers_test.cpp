#include "core/io/grid_layers.h"

#include <gtest/gtest.h>

#include "tests/support/voxels.h"

namespace voxprite {
namespace {

TEST(GridLayers, ListEveryCellOnce) {
    VoxelGrid grid = test::randomVoxels(3, {20, 17, 19}, 0.3, 255);
    grid.fill({{-70, -70, -70}, {-4, -1, -5}}, 9);  // a cube of 64 stored as one value
    const IBox box = grid.bounds();
    for (const int axis : {1, 2}) {
        test::VoxelMap found;
        int expectedLayer = box.min[axis];
        const int across = axis == 1 ? 2 : 1;
        ASSERT_TRUE(forEachLayer(
            grid, box, axis, [&](int layer, std::span<const std::uint8_t> cells) -> Status {
                EXPECT_EQ(layer, expectedLayer++);
                const auto width = static_cast<std::size_t>(box.size().x);
                EXPECT_EQ(cells.size(), width * static_cast<std::size_t>(box.size()[across]));
                for (std::size_t k = 0; k < cells.size(); ++k) {
                    if (cells[k] == 0) continue;
                    glm::ivec3 v = box.min;
                    v.x += static_cast<int>(k % width);
                    v[across] += static_cast<int>(k / width);
                    v[axis] = layer;
                    found[{v.x, v.y, v.z}] = cells[k];
                }
                return {};
            }));
        EXPECT_EQ(expectedLayer, box.max[axis]);
        EXPECT_EQ(found, test::mapOf(grid)) << axis;
    }
}

TEST(GridLayers, StopWhereTheVisitorFailsAndRefuseWhatIsTooLarge) {
    VoxelGrid grid;
    grid.set({0, 0, 0}, 1);
    int visits = 0;
    const auto failing = [&](int, std::span<const std::uint8_t>) -> Status {
        ++visits;
        return fail("enough");
    };
    EXPECT_EQ(forEachLayer(grid, {{0, 0, 0}, {1, 1, 9}}, 2, failing).error().message, "enough");
    EXPECT_EQ(visits, 1);
    EXPECT_FALSE(forEachLayer(grid, {{0, 0, 0}, {1 << 20, 1 << 20, 1}}, 2, failing));
    EXPECT_FALSE(forEachLayer(grid, {{0, 0, 0}, {1 << 12, 1 << 12, 1 << 12}}, 2, failing));
    EXPECT_EQ(visits, 1);
    EXPECT_TRUE(forEachLayer(grid, {}, 2, failing));
}

}  // namespace
}  // namespace voxprite
