#include "core/svo/brick_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/svo/octree.h"

namespace voxprite {
namespace {

using Voxels = std::array<std::uint8_t, 512>;

// By the description of octants alone.
std::uint64_t plainBrick(const Voxels& voxels, unsigned i) {
    std::uint64_t payload = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::ivec3 v =
            4 * octantCorner(i >> 3) + 2 * octantCorner(i & 7u) + octantCorner(octant);
        const auto at = static_cast<std::size_t>(v.x << 6 | v.y << 3 | v.z);
        payload |= std::uint64_t{voxels[at]} << (8 * octant);
    }
    return payload;
}

std::array<std::uint64_t, 8> solidOf(const Voxels& voxels) {
    std::array<std::uint64_t, 8> solid{};
    for (std::size_t n = 0; n < 512; ++n) {
        if (voxels[n] != 0) solid[n >> 6] |= std::uint64_t{1} << (n & 63u);
    }
    return solid;
}

void expectAsPlain(const Voxels& voxels) {
    std::uint64_t any = 0, all = 0;
    std::array<std::uint64_t, 64> payloads{};
    cutIntoBricks(voxels.data(), payloads.data());
    for (unsigned i = 0; i < 64; ++i) {
        const std::uint64_t payload = plainBrick(voxels, i);
        unsigned solid = 0;
        for (unsigned octant = 0; octant < 8; ++octant) {
            solid += payloadMaterial(payload, octant) != 0 ? 1 : 0;
        }
        any |= std::uint64_t{solid > 0 ? 1u : 0u} << i;
        all |= std::uint64_t{solid == 8 ? 1u : 0u} << i;
        ASSERT_EQ(payloads[i], payload) << "brick " << i;
        ASSERT_EQ(brickOf(voxels.data(), i), payload) << "brick " << i;
    }
    const std::array<std::uint64_t, 8> solid = solidOf(voxels);
    ASSERT_EQ(bricksWithAny(solid.data()), any);
    ASSERT_EQ(bricksWithAll(solid.data()), all);
}

TEST(BrickOrder, EverySingleVoxelAndEverySingleHole) {
    for (std::size_t n = 0; n < 512; ++n) {
        Voxels one{};
        one[n] = 200;
        expectAsPlain(one);
        Voxels hole;
        hole.fill(9);
        hole[n] = 0;
        expectAsPlain(hole);
    }
}

TEST(BrickOrder, RandomCubesOfEveryDensity) {
    std::mt19937 random(9);
    for (unsigned density = 0; density <= 256; ++density) {
        Voxels voxels{};
        for (std::uint8_t& voxel : voxels) {
            if (random() % 256 < density) voxel = static_cast<std::uint8_t>(1 + random() % 255);
        }
        expectAsPlain(voxels);
    }
}

TEST(BrickOrder, RowsAreTakenFromTwoBlocks) {
    std::mt19937 random(10);
    std::array<std::uint8_t, 64> first{}, next{};
    std::generate(first.begin(), first.end(), [&] { return static_cast<std::uint8_t>(random()); });
    std::generate(next.begin(), next.end(), [&] { return static_cast<std::uint8_t>(random()); });
    for (int shift = 0; shift < 8; ++shift) {
        for (int count = 0; count <= 8; ++count) {
            std::array<std::uint64_t, 9> rows;
            rows.fill(77);
            copyRows(first.data(), next.data(), shift, count, rows.data());
            for (int row = 0; row < count; ++row) {
                for (int z = 0; z < 8; ++z) {
                    const std::uint8_t expected =
                        z + shift < 8 ? first[8 * row + z + shift] : next[8 * row + z + shift - 8];
                    EXPECT_EQ(payloadMaterial(rows[row], static_cast<unsigned>(z)), expected);
                }
            }
            EXPECT_EQ(rows[count], 77u);  // and no more than that
        }
    }
}

}  // namespace
}  // namespace voxprite
