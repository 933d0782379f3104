#include "core/edit/symmetry.h"

#include <gtest/gtest.h>

#include "tests/support/positions.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::key;
using test::Positions;
using test::positionsOf;
using test::Random;

TEST(Symmetry, MirrorsAboutBoundariesAndMiddles) {
    Symmetry symmetry;
    symmetry.on = {true, false, false};
    symmetry.planeDoubled = {8, 0, 0};  // between the voxels 3 and 4
    const std::vector<glm::ivec3> one{{3, 5, 7}};
    EXPECT_EQ(mirrored(one, symmetry), (std::vector<glm::ivec3>{{3, 5, 7}, {4, 5, 7}}));
    symmetry.planeDoubled.x = 7;  // through the voxel 3
    EXPECT_EQ(mirrored(one, symmetry), (std::vector<glm::ivec3>{{3, 5, 7}, {3, 5, 7}}));
    symmetry.planeDoubled.x = -1;  // through the voxel -1
    EXPECT_EQ(mirrored(one, symmetry), (std::vector<glm::ivec3>{{3, 5, 7}, {-5, 5, 7}}));
}

TEST(Symmetry, TheCentreOfABoxMapsTheBoxToItself) {
    const IBox box{{-3, 2, 5}, {4, 10, 6}};  // odd, even, one
    Symmetry symmetry{{true, true, true}, Symmetry::planesThroughCentre(box)};
    for (const Placement& image : imagesOf(symmetry)) EXPECT_EQ(image.applyToBox(box), box);
}

TEST(Symmetry, AnyCombinationIsClosedUnderItsMirrors) {
    Random random(11);
    for (int round = 0; round < 64; ++round) {
        Symmetry symmetry;
        symmetry.on = {(round & 1) != 0, (round & 2) != 0, (round & 4) != 0};
        symmetry.planeDoubled = random.voxel(-9, 9);
        const std::size_t axes = symmetry.on[0] + symmetry.on[1] + symmetry.on[2];
        EXPECT_EQ(imagesOf(symmetry).size(), std::size_t{1} << axes);
        EXPECT_EQ(symmetry.any(), axes > 0);
        std::vector<glm::ivec3> positions;
        for (int i = 0; i < 30; ++i) positions.push_back(random.voxel(-12, 12));
        // By reflecting the centre of the voxel about the plane, axis by axis.
        Positions expected = positionsOf(positions);
        for (int axis = 0; axis < 3; ++axis) {
            if (!symmetry.on[static_cast<std::size_t>(axis)]) continue;
            for (const auto& [x, y, z] : Positions(expected)) {
                glm::ivec3 v(x, y, z);
                const double plane = symmetry.planeDoubled[axis] / 2.0;
                const double centre = 2 * plane - (v[axis] + 0.5);
                v[axis] = static_cast<int>(centre - 0.5);
                expected.insert(key(v));
            }
        }
        EXPECT_EQ(positionsOf(mirrored(positions, symmetry)), expected);
        EXPECT_EQ(positionsOf(mirrored(VoxelSet(positions), symmetry)), expected);
    }
}

TEST(Symmetry, BlocksAreMirroredWhole) {
    Symmetry symmetry{{true, false, false}, {0, 0, 0}};
    const VoxelSet both = mirrored(VoxelSet(IBox{{0, 0, 0}, {512, 512, 512}}), symmetry);
    EXPECT_EQ(both, VoxelSet(IBox{{-512, 0, 0}, {512, 512, 512}}));
    EXPECT_LT(both.grid().bytes(), 200'000u);
}

}  // namespace
}  // namespace voxprite
