#include "core/model/voxel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <set>
#include <thread>
#include <vector>

#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::mapOf;
using test::Random;
using test::VoxelMap;

std::tuple<int, int, int> key(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

// The same store, plainly: what the grid is compared with.
class Reference {
  public:
    void set(glm::ivec3 v, std::uint8_t value) {
        if (value == 0) {
            map_.erase(key(v));
        } else {
            map_[key(v)] = value;
        }
    }
    void fill(const IBox& box, std::uint8_t value) {
        for (int x = box.min.x; x < box.max.x; ++x) {
            for (int y = box.min.y; y < box.max.y; ++y) {
                for (int z = box.min.z; z < box.max.z; ++z) set({x, y, z}, value);
            }
        }
    }
    [[nodiscard]] IBox bounds() const {
        IBox box;
        for (const auto& [position, value] : map_) {
            const auto [x, y, z] = position;
            box = box.united({{x, y, z}, {x + 1, y + 1, z + 1}});
        }
        return box;
    }
    [[nodiscard]] const VoxelMap& map() const { return map_; }

  private:
    VoxelMap map_;
};

void expectSame(const VoxelGrid& grid, const Reference& reference) {
    EXPECT_EQ(mapOf(grid), reference.map());
    EXPECT_EQ(grid.solidCount(), reference.map().size());
    EXPECT_EQ(grid.empty(), reference.map().empty());
    EXPECT_EQ(grid.bounds(), reference.bounds());
}

TEST(VoxelGrid, StartsEmpty) {
    const VoxelGrid grid;
    EXPECT_TRUE(grid.empty());
    EXPECT_EQ(grid.solidCount(), 0u);
    EXPECT_EQ(grid.bounds(), IBox{});
    EXPECT_EQ(grid.get({0, 0, 0}), 0);
    grid.forEachBlock([](const VoxelBlock&) { ADD_FAILURE(); });
    EXPECT_EQ(grid, VoxelGrid{});
}

TEST(VoxelGrid, FollowsAPlainStoreThroughRandomEdits) {
    Random random(3);
    VoxelGrid grid;
    Reference reference;
    for (int step = 0; step < 4000; ++step) {
        const auto value =
            static_cast<std::uint8_t>(random.chance(0.4) ? 0 : random.between(1, 255));
        if (random.chance(0.02)) {
            const IBox box = IBox::around(random.voxel(-20, 20), random.voxel(-20, 20));
            grid.fill(box, value);
            reference.fill(box, value);
        } else {
            const glm::ivec3 v = random.voxel(-20, 20);
            grid.set(v, value);
            reference.set(v, value);
            ASSERT_EQ(grid.get(v), value);
        }
        if (step % 500 == 0) expectSame(grid, reference);
    }
    expectSame(grid, reference);
    const VoxelGrid::Reader reader(grid);
    for (int i = 0; i < 20000; ++i) {
        const glm::ivec3 v = random.voxel(-30, 30);
        const auto found = reference.map().find(key(v));
        const int expected = found == reference.map().end() ? 0 : found->second;
        ASSERT_EQ(reader.get(v), expected);
        ASSERT_EQ(grid.get(v), expected);
    }
}

TEST(VoxelGrid, FilledTilesCountEveryVoxel) {
    VoxelGrid grid;
    Reference reference;
    // Whole leaves and a whole 64-cube inside, and a rim around them.
    const IBox box{{-3, -1, -70}, {70, 66, 5}};
    grid.fill(box, 9);
    reference.fill(box, 9);
    expectSame(grid, reference);
    // Into a tile: one voxel of another colour, one hole, a hole that leaves exactly the rim.
    grid.set({8, 8, -60}, 7);
    reference.set({8, 8, -60}, 7);
    grid.set({40, 40, -40}, 0);
    reference.set({40, 40, -40}, 0);
    expectSame(grid, reference);
    const IBox inside{{-2, 0, -69}, {69, 65, 4}};
    grid.fill(inside, 0);
    reference.fill(inside, 0);
    expectSame(grid, reference);
}

TEST(VoxelGrid, ErasedVoxelsLeaveNoTrace) {
    VoxelGrid grid;
    grid.fill({{0, 0, 0}, {64, 64, 64}}, 5);
    grid.set({100, 0, 0}, 5);
    grid.set({100, 0, 0}, 0);
    grid.fill({{-100, -100, -100}, {200, 200, 200}}, 0);
    EXPECT_TRUE(grid.empty());
    EXPECT_EQ(grid.bounds(), IBox{});
    EXPECT_EQ(grid, VoxelGrid{});
    grid.set({1, 2, 3}, 4);
    grid.clear();
    EXPECT_EQ(grid, VoxelGrid{});
    grid.set({1, 2, 3}, 4);
    EXPECT_EQ(grid.solidCount(), 1u);
}

TEST(VoxelGrid, CoordinatesMayBeFarApart) {
    VoxelGrid grid;
    const glm::ivec3 low(-kMaxCoordinate);
    const glm::ivec3 high(kMaxCoordinate);
    grid.set(low, 1);
    grid.set(high, 2);
    EXPECT_EQ(grid.get(low), 1);
    EXPECT_EQ(grid.get(high), 2);
    EXPECT_EQ(grid.solidCount(), 2u);
    EXPECT_EQ(grid.bounds(), IBox::around(low, high));
    EXPECT_LT(grid.bytes(), 100'000u);
    grid.fill(IBox::around(low, high), 0);
    EXPECT_TRUE(grid.empty());
}

TEST(VoxelGrid, CopiesAreDeep) {
    VoxelGrid a = test::figure();
    const VoxelGrid b = a;
    a.set({0, 0, 0}, 200);
    EXPECT_EQ(b.get({0, 0, 0}), 0);
    EXPECT_FALSE(a == b);
    a = b;
    EXPECT_EQ(a, b);
    const VoxelGrid& self = a;
    a = self;
    EXPECT_EQ(a, b);
    const VoxelGrid moved = std::move(a);
    EXPECT_EQ(moved, b);
    a = VoxelGrid{};
    EXPECT_TRUE(a.empty());
}

TEST(VoxelGrid, EqualityIsThatOfTheVoxelsAlone) {
    // One cube as a tile, as leaves, and as leaves within a root cell that held more.
    VoxelGrid tile;
    tile.fill({{0, 0, 0}, {64, 64, 64}}, 3);
    VoxelGrid leaves;
    for (int x = 0; x < 64; ++x) {
        for (int y = 0; y < 64; ++y) {
            for (int z = 0; z < 64; ++z) leaves.set({x, y, z}, 3);
        }
    }
    EXPECT_GT(leaves.bytes(), tile.bytes());
    EXPECT_TRUE(tile == leaves);
    EXPECT_TRUE(leaves == tile);
    leaves.set({600, 600, 600}, 1);
    EXPECT_FALSE(tile == leaves);
    leaves.set({600, 600, 600}, 0);
    EXPECT_TRUE(tile == leaves);
    // As many voxels, but one of another colour; then one elsewhere.
    leaves.set({63, 63, 63}, 4);
    EXPECT_FALSE(tile == leaves);
    EXPECT_FALSE(leaves == tile);
    leaves.set({63, 63, 63}, 0);
    leaves.set({64, 0, 0}, 3);
    EXPECT_EQ(tile.solidCount(), leaves.solidCount());
    EXPECT_FALSE(tile == leaves);
    EXPECT_FALSE(leaves == tile);
}

TEST(VoxelGrid, BlocksHoldEverySolidVoxelOnce) {
    VoxelGrid grid = test::randomVoxels(5, {40, 30, 20}, 0.3, 255);
    grid.fill({{-64, -64, -64}, {0, 0, 0}}, 8);
    grid.fill({{80, 0, 0}, {88, 8, 8}}, 9);
    VoxelMap fromBlocks;
    grid.forEachBlock([&](const VoxelBlock& block) {
        ASSERT_TRUE(block.edgeVoxels == 8 || block.edgeVoxels == 64);
        ASSERT_EQ(block.voxels == nullptr, block.uniformValue != 0);
        int solid = 0;
        for (int i = 0; i < block.edgeVoxels * block.edgeVoxels * block.edgeVoxels; ++i) {
            const int edge = block.edgeVoxels;
            const glm::ivec3 local(i / (edge * edge), i / edge % edge, i % edge);
            const std::uint8_t value = block.voxels != nullptr
                                           ? block.voxels[(local.x << 6) | (local.y << 3) | local.z]
                                           : block.uniformValue;
            if (block.voxels != nullptr) {
                const std::uint64_t bit = block.solid[local.x] >> (local.y << 3 | local.z) & 1u;
                ASSERT_EQ(bit, value != 0 ? 1u : 0u);
            }
            if (value == 0) continue;
            ++solid;
            ASSERT_TRUE(fromBlocks.emplace(key(block.origin + local), value).second);
        }
        EXPECT_GT(solid, 0);
    });
    EXPECT_EQ(fromBlocks, mapOf(grid));
}

TEST(VoxelGrid, RegionsHoldTheSameBlocks) {
    VoxelGrid grid = test::randomVoxels(6, {150, 90, 70}, 0.002, 255);
    grid.fill({{-64, -64, -64}, {0, 0, 0}}, 8);           // a tile of 64
    grid.fill({{-2048, 512, 0}, {-1536, 1024, 512}}, 9);  // one of 512
    grid.fill({{200, 0, 0}, {208, 8, 8}}, 10);            // one of 8
    grid.set({300, 5, 5}, 1);
    grid.set({300, 5, 5}, 0);  // a block of nothing
    using Key = std::tuple<int, int, int, int, int, const std::uint8_t*>;
    const auto keyOf = [](const VoxelBlock& b) {
        return Key{b.origin.x, b.origin.y, b.origin.z, b.edgeVoxels, b.uniformValue, b.voxels};
    };
    for (const IBox& part : {IBox{{-5000, -5000, -5000}, {5000, 5000, 5000}},
                             IBox{{-70, 3, 8}, {17, 71, 16}}, IBox{{64, 0, 0}, {65, 90, 1}}}) {
        std::set<Key> blocks, fromRegions;
        grid.forEachBlock([&](const VoxelBlock& block) {
            const IBox box{block.origin, block.origin + block.edgeVoxels};
            if (block.edgeVoxels > 8 || !box.intersected(part).empty()) blocks.insert(keyOf(block));
        });
        grid.forEachRegion([&](const VoxelRegion& region) {
            if (region.blocks == nullptr) {
                fromRegions.insert(
                    keyOf({region.origin, region.edgeVoxels, region.uniformValue, nullptr}));
                return;
            }
            int count = 0;
            VoxelGrid::forEachBlockIn(region, part, [&](const VoxelBlock& block) {
                ++count;
                EXPECT_TRUE(fromRegions.insert(keyOf(block)).second);
            });
            EXPECT_LE(count, region.blockCount);
        });
        EXPECT_EQ(fromRegions, blocks);
    }
}

TEST(VoxelGrid, BoundsFollowWhatIsErased) {
    Random random(8);
    for (int model = 0; model < 40; ++model) {
        VoxelGrid grid;
        Reference reference;
        const auto put = [&](const IBox& box, std::uint8_t value) {
            grid.fill(box, value);
            reference.fill(box, value);
        };
        for (int k = 0; k < 60; ++k) {
            const glm::ivec3 v = random.voxel(-100, 100);
            put({v, v + 1}, 3);
        }
        if (model % 2 == 0) put({{-8, -16, 0}, {16, 8, 8}}, 4);
        // Voxel by voxel from outside: blocks that hold nothing any more stay behind.
        while (!reference.map().empty()) {
            const IBox bounds = reference.bounds();
            ASSERT_EQ(grid.bounds(), bounds);
            const int axis = random.between(0, 2);
            IBox rim = bounds;
            const int thickness = random.between(1, 40);
            if (random.chance(0.5)) {
                rim.min[axis] = std::max(rim.min[axis], rim.max[axis] - thickness);
            } else {
                rim.max[axis] = std::min(rim.max[axis], rim.min[axis] + thickness);
            }
            std::vector<glm::ivec3> gone;
            for (const auto& [position, value] : reference.map()) {
                const auto [x, y, z] = position;
                if (rim.contains({x, y, z})) gone.emplace_back(x, y, z);
            }
            for (const glm::ivec3 v : gone) {
                grid.set(v, 0);
                reference.set(v, 0);
            }
        }
        EXPECT_EQ(grid.bounds(), IBox{});
    }
}

// Two ways of drawing the same voxels, in another order, through tiles and without.
TEST(VoxelGrid, TheOrderOfVisitsDependsOnTheVoxelsAlone) {
    using Visits = std::vector<std::pair<std::tuple<int, int, int>, std::uint8_t>>;
    const auto visitsOf = [](const VoxelGrid& grid) {
        Visits visits;
        grid.forEachSolid(
            [&](glm::ivec3 v, std::uint8_t value) { visits.emplace_back(key(v), value); });
        return visits;
    };
    const IBox box{{-70, -9, -65}, {10, 70, 17}};
    VoxelGrid filled;
    filled.fill(box, 1);
    VoxelGrid drawn;
    drawn.set({1000, 1000, -1000}, 1);
    for (int z = box.max.z - 1; z >= box.min.z; --z) {
        for (int y = box.min.y; y < box.max.y; ++y) {
            for (int x = box.max.x - 1; x >= box.min.x; --x) drawn.set({x, y, z}, 1);
        }
    }
    drawn.set({1000, 1000, -1000}, 0);
    const Visits visits = visitsOf(filled);
    EXPECT_EQ(visits, visitsOf(drawn));
    EXPECT_EQ(visits.size(), filled.solidCount());
}

TEST(VoxelGrid, WritesAndReadsWholeBlocks) {
    Random random(19);
    VoxelGrid grid;
    Reference reference;
    grid.fill({{0, 0, 0}, {64, 64, 64}}, 7);  // one tile, which the blocks divide
    reference.fill({{0, 0, 0}, {64, 64, 64}}, 7);
    std::array<std::uint8_t, 512> values;
    for (int round = 0; round < 40; ++round) {
        const glm::ivec3 origin = random.voxel(-3, 3) * 8;
        const bool empty = round % 5 == 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = empty ? 0 : static_cast<std::uint8_t>(random.between(0, 3));
            reference.set(origin + glm::ivec3(i >> 6, (i >> 3) & 7, i & 7), values[i]);
        }
        grid.setBlock(origin, values.data());
        const VoxelBlock block = grid.blockAt(origin + 5);
        if (block.voxels != nullptr) {
            EXPECT_EQ(block.origin, origin);
            EXPECT_TRUE(std::equal(values.begin(), values.end(), block.voxels));
        } else {
            EXPECT_TRUE(empty);
            EXPECT_EQ(block.uniformValue, 0);
        }
    }
    expectSame(grid, reference);
}

TEST(VoxelGrid, KnowsTheBlockOfEveryPosition) {
    VoxelGrid grid;
    grid.fill({{0, 0, 0}, {64, 64, 64}}, 7);
    grid.set({-1, -1, -1}, 3);
    const auto expectBlock = [&](glm::ivec3 v, glm::ivec3 origin, int edge, int value) {
        const VoxelBlock block = grid.blockAt(v);
        EXPECT_EQ(block.origin, origin);
        EXPECT_EQ(block.edgeVoxels, edge);
        EXPECT_EQ(block.uniformValue, value);
        EXPECT_EQ(block.voxels == nullptr, edge != 8 || value != 0 || v.x >= 0);
    };
    expectBlock({5, 60, 33}, {0, 0, 0}, 64, 7);
    expectBlock({70, 5, 5}, {64, 0, 0}, 64, 0);
    expectBlock({-3, -3, -3}, {-8, -8, -8}, 8, 0);
    expectBlock({5000, 0, 0}, {4608, 0, 0}, 512, 0);
    EXPECT_EQ(grid.cubeCount(), 8u * 8 * 8 + 1);
}

TEST(VoxelGrid, CopiesShareTheirVoxelsUntilOneIsWrittenTo) {
    VoxelGrid grid;
    grid.set({1, 2, 3}, 7);
    const auto* voxels = grid.blockAt({0, 0, 0}).voxels;
    ASSERT_NE(voxels, nullptr);
    const std::vector<std::function<void(VoxelGrid&)>> writes{
        [](VoxelGrid& g) {
            g.set({1, 2, 3}, 9);
        },
        [](VoxelGrid& g) {
            g.fill({{0, 0, 0}, {2, 3, 4}}, 0);
        },
        [](VoxelGrid& g) {
            g.setBlock({0, 0, 0}, std::array<std::uint8_t, 512>{1}.data());
        },
        [](VoxelGrid& g) { g.clear(); }};
    for (const auto& write : writes) {
        VoxelGrid copy = grid;
        const VoxelGrid other = copy;
        EXPECT_EQ(copy.blockAt({0, 0, 0}).voxels, voxels);
        EXPECT_EQ(copy, grid);
        write(copy);
        EXPECT_NE(copy, grid);
        EXPECT_EQ(grid.get({1, 2, 3}), 7);
        EXPECT_EQ(other, grid);
        // Whoever is left alone with them writes to them in place.
        EXPECT_EQ(grid.blockAt({0, 0, 0}).voxels, voxels);
    }
    grid.set({1, 2, 4}, 8);
    EXPECT_EQ(grid.blockAt({0, 0, 0}).voxels, voxels);
}

TEST(VoxelGrid, CopiesAreReadWhileOneIsWrittenTo) {
    VoxelGrid grid;
    grid.fill({{0, 0, 0}, {40, 40, 40}}, 3);
    grid.set({5, 5, 5}, 4);
    std::vector<std::jthread> readers;
    std::atomic<int> wrong = 0;
    for (int k = 0; k < 4; ++k) {
        readers.emplace_back([copy = grid, &wrong] {
            for (int i = 0; i < 2'000; ++i) {
                const VoxelGrid again = copy;
                if (again.get({i % 40, 7, 7}) != 3 || again.get({5, 5, 5}) != 4) ++wrong;
            }
        });
    }
    for (int i = 0; i < 2'000; ++i) grid.set({i % 40, 7, 7}, 9);
    readers.clear();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(grid.get({39, 7, 7}), 9);
}

}  // namespace
}  // namespace voxprite
