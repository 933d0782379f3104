#include "core/model/placement.h"

#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>
#include <vector>

#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::Random;

// All 48, from the format's bytes.
std::vector<SignedPermutation> allRotations() {
    std::vector<SignedPermutation> rotations;
    for (int byte = 0; byte < 128; ++byte) {
        if (const auto rotation = SignedPermutation::fromVoxByte(byte)) {
            rotations.push_back(*rotation);
        }
    }
    return rotations;
}

glm::dmat3 matrixOf(const SignedPermutation& rotation) {
    glm::dmat3 matrix(0.0);
    for (int row = 0; row < 3; ++row) {
        const auto r = static_cast<std::size_t>(row);
        matrix[rotation.axis[r]][row] = rotation.sign[r];
    }
    return matrix;
}

Placement randomPlacement(Random& random) {
    static const std::vector<SignedPermutation> rotations = allRotations();
    return {rotations[static_cast<std::size_t>(random.between(0, 47))], random.voxel(-50, 50)};
}

TEST(Placement, TheFormatHasFortyEightRotations) {
    EXPECT_EQ(allRotations().size(), 48u);
    for (int byte = 0; byte < 128; ++byte) {
        const auto rotation = SignedPermutation::fromVoxByte(byte);
        const int first = byte & 3;
        const int second = (byte >> 2) & 3;
        const bool valid = first < 3 && second < 3 && first != second;
        ASSERT_EQ(rotation.has_value(), valid) << byte;
        EXPECT_EQ(rotation ? rotation->toVoxByte() : byte, byte);
    }
    EXPECT_FALSE(SignedPermutation::fromVoxByte(-1));
    EXPECT_FALSE(SignedPermutation::fromVoxByte(4 + 128));
    EXPECT_EQ(SignedPermutation::fromVoxByte(5).error().message,
              "rotation 5 is none of the 48 signed permutations");
}

// The example of the format's documentation: 0 1 0 / 0 0 -1 / -1 0 0 is 1 | 2 << 2 | 1 << 5 | 1
// << 6.
TEST(Placement, ReadsTheDocumentedExample) {
    const auto rotation = SignedPermutation::fromVoxByte(1 | 2 << 2 | 1 << 5 | 1 << 6);
    ASSERT_TRUE(rotation);
    EXPECT_EQ(rotation->apply({10, 20, 30}), glm::ivec3(20, -30, -10));
    EXPECT_EQ(SignedPermutation{}.toVoxByte(), 4);
}

TEST(Placement, MirrorsAreThoseOfNegativeDeterminant) {
    int mirrors = 0;
    for (const SignedPermutation& rotation : allRotations()) {
        EXPECT_EQ(rotation.determinant(), static_cast<int>(glm::determinant(matrixOf(rotation))));
        mirrors += rotation.determinant() < 0;
    }
    EXPECT_EQ(mirrors, 24);
    for (const int byte : {20, 36, 41, 49, 68, 81, 97}) {
        EXPECT_EQ(SignedPermutation::fromVoxByte(byte)->determinant(), -1) << byte;
    }
}

TEST(Placement, RotationsComposeAndInvertAsMatrices) {
    for (const SignedPermutation& a : allRotations()) {
        EXPECT_EQ(a * a.inverse(), SignedPermutation{});
        EXPECT_EQ(a.inverse() * a, SignedPermutation{});
        for (const SignedPermutation& b : allRotations()) {
            EXPECT_EQ(matrixOf(a * b), matrixOf(a) * matrixOf(b));
        }
    }
}

// The cell [v, v + 1) goes to the cell around the image of its middle.
TEST(Placement, CellsFollowTheirMiddle) {
    Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const Placement placement = randomPlacement(random);
        const glm::ivec3 v = random.voxel(-9, 9);
        const glm::dvec3 middle = matrixOf(placement.rotation) * (glm::dvec3(v) + 0.5) +
                                  glm::dvec3(placement.translation);
        EXPECT_EQ(placement.applyToVoxel(v), glm::ivec3(glm::floor(middle)));
    }
    const Placement mirrored{{{0, 1, 2}, {-1, 1, 1}}, {0, 0, 0}};
    EXPECT_EQ(mirrored.applyToVoxel({0, 0, 0}), glm::ivec3(-1, 0, 0));
    EXPECT_EQ(mirrored.applyToVoxel({5, 6, 7}), glm::ivec3(-6, 6, 7));
}

TEST(Placement, ComposesAndInverts) {
    Random random(12);
    for (int i = 0; i < 2000; ++i) {
        const Placement a = randomPlacement(random);
        const Placement b = randomPlacement(random);
        const glm::ivec3 v = random.voxel(-99, 99);
        EXPECT_EQ((a * b).applyToVoxel(v), a.applyToVoxel(b.applyToVoxel(v)));
        EXPECT_EQ(a.inverse().applyToVoxel(a.applyToVoxel(v)), v);
        EXPECT_EQ(a * a.inverse(), Placement{});
    }
}

TEST(Placement, BoxesHoldExactlyTheirVoxels) {
    Random random(13);
    for (int i = 0; i < 500; ++i) {
        const Placement placement = randomPlacement(random);
        const IBox box = IBox::around(random.voxel(-4, 4), random.voxel(-4, 4));
        IBox around;
        for (int x = box.min.x; x < box.max.x; ++x) {
            for (int y = box.min.y; y < box.max.y; ++y) {
                for (int z = box.min.z; z < box.max.z; ++z) {
                    const glm::ivec3 v = placement.applyToVoxel({x, y, z});
                    around = around.united({v, v + 1});
                }
            }
        }
        EXPECT_EQ(placement.applyToBox(box), around);
        EXPECT_EQ(placement.applyToBox(IBox{}), IBox{});
    }
}

}  // namespace
}  // namespace voxprite
