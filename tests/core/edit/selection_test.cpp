#include "core/edit/selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>

#include "tests/support/positions.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::key;
using test::Positions;
using test::positionsOf;
using test::Random;

Positions solidWhere(const VoxelGrid& voxels, const std::function<bool(glm::ivec3)>& choose) {
    Positions positions;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t) {
        if (choose(v)) positions.insert(key(v));
    });
    return positions;
}

TEST(Selection, HoldsOnlyWhatIsSolid) {
    Random random(31);
    VoxelGrid voxels = test::randomVoxels(5, {20, 20, 20}, 0.4, 5);
    voxels.fill({{64, 0, 0}, {128, 64, 64}}, 3);
    EXPECT_EQ(selectAll(voxels).count(), voxels.solidCount());
    for (int round = 0; round < 20; ++round) {
        const IBox box = IBox::around(random.voxel(-5, 70), random.voxel(-5, 70));
        EXPECT_EQ(positionsOf(selectBox(voxels, box)),
                  solidWhere(voxels, [&](glm::ivec3 v) { return box.contains(v); }));
    }
}

TEST(Selection, AddsRemovesNarrowsAndInverts) {
    const VoxelGrid voxels = test::randomVoxels(6, {24, 24, 24}, 0.5, 5);
    const VoxelSet left = selectBox(voxels, {{0, 0, 0}, {14, 24, 24}});
    const VoxelSet low = selectBox(voxels, {{0, 0, 0}, {24, 24, 9}});
    const auto inLeft = [](glm::ivec3 v) { return v.x < 14; };
    const auto inLow = [](glm::ivec3 v) { return v.z < 9; };
    const auto expect = [&](SelectMode mode, const std::function<bool(glm::ivec3)>& choose) {
        EXPECT_EQ(positionsOf(combined(left, low, mode)), solidWhere(voxels, choose));
    };
    expect(SelectMode::replace, inLow);
    expect(SelectMode::add, [&](glm::ivec3 v) { return inLeft(v) || inLow(v); });
    expect(SelectMode::remove, [&](glm::ivec3 v) { return inLeft(v) && !inLow(v); });
    expect(SelectMode::intersect, [&](glm::ivec3 v) { return inLeft(v) && inLow(v); });
    EXPECT_EQ(positionsOf(inverted(voxels, left)),
              solidWhere(voxels, [&](glm::ivec3 v) { return !inLeft(v); }));
    EXPECT_EQ(inverted(voxels, inverted(voxels, left)), left);
    EXPECT_EQ(inverted(voxels, VoxelSet()), selectAll(voxels));
}

TEST(Selection, ForgetsWhatIsNoLongerSolid) {
    VoxelGrid voxels = test::solidBox({4, 4, 4});
    const VoxelSet selection = selectBox(voxels, {{0, 0, 0}, {2, 4, 4}});
    voxels.fill({{0, 0, 0}, {1, 4, 4}}, 0);
    EXPECT_EQ(stillSolid(voxels, selection), VoxelSet(IBox{{1, 0, 0}, {2, 4, 4}}));
}

// Against asking voxel by voxel; in blocks large and small, cut by planes that lie anywhere.
TEST(Selection, InsideHalfSpacesIsWhatTheMiddlesSay) {
    VoxelGrid voxels;
    voxels.fill({{-130, 0, 0}, {10, 40, 136}}, 3);
    voxels.fill({{-5, 30, 120}, {30, 60, 150}}, 4);
    test::Random random(5);
    for (int round = 0; round < 6; ++round) {
        std::vector<HalfSpace> sides;
        for (int i = 0; i <= round % 4; ++i) {
            const glm::dvec3 normal(random.between(-9, 9), random.between(-9, 9),
                                    random.between(-9, 9));
            const glm::dvec3 through(random.between(-130, 20), random.between(0, 50),
                                     random.between(0, 140));
            sides.push_back({normal, glm::dot(normal, through) + 0.25});
        }
        VoxelSet expected;
        voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t) {
            const bool inside = std::ranges::all_of(sides, [&](const HalfSpace& side) {
                return glm::dot(side.normal, glm::dvec3(v) + 0.5) >= side.offset;
            });
            if (inside) expected.insert(v);
        });
        EXPECT_EQ(selectInside(voxels, sides), expected) << round;
    }
    EXPECT_EQ(selectInside(voxels, {}), selectAll(voxels));
}

TEST(StillSolid, IsWhatIsSolidOfIt) {
    VoxelGrid voxels;
    voxels.fill({{-8, 0, 0}, {72, 72, 80}}, 3);  // whole blocks, and a rim
    VoxelSet selection(IBox{{0, 0, 0}, {70, 70, 70}});
    EXPECT_EQ(stillSolid(voxels, selection), selection);
    for (const glm::ivec3 gone : {glm::ivec3(69, 69, 69), glm::ivec3(0), glm::ivec3(33, 20, 7)}) {
        voxels.set(gone, 0);
        selection.erase(gone);
        EXPECT_EQ(stillSolid(voxels, VoxelSet(IBox{{0, 0, 0}, {70, 70, 70}})), selection);
        EXPECT_EQ(stillSolid(voxels, selection), selection);
    }
}

}  // namespace
}  // namespace voxprite
