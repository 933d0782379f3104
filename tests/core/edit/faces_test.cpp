#include "core/edit/faces.h"

#include <gtest/gtest.h>

#include <array>

#include "core/edit/regions.h"
#include "core/edit/symmetry.h"
#include "tests/support/edits.h"
#include "tests/support/positions.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::afterPatch;
using test::mapOf;
using test::Random;
using test::VoxelMap;

TEST(Faces, ArePulledOutInTheirColoursAndPushedInAgain) {
    Random random(51);
    for (int round = 0; round < 60; ++round) {
        VoxelGrid voxels = test::randomVoxels(random.next(), {10, 10, 10}, 0.05, 3);
        voxels.fill({{1, 1, 1}, {9, 9, 5}}, 2);
        voxels.fill({{4, 1, 1}, {9, 9, 5}}, 3);
        const Document document = test::documentOf(voxels);
        glm::ivec3 normal(0);
        normal[round % 3] = round % 2 == 0 ? 1 : -1;
        const glm::ivec3 seed = random.voxel(1, 8);
        const VoxelSet face =
            faceRegion(voxels, seed, normal, {Neighbours::six, round % 5 != 0}).value();
        const int layers = random.between(-4, 4);
        VoxelMap expected = mapOf(voxels);
        face.forEach([&](glm::ivec3 v) {
            for (int i = 1; i <= layers; ++i) {
                const glm::ivec3 at = v + normal * i;
                expected.try_emplace({at.x, at.y, at.z}, voxels.get(v));
            }
            for (int i = 0; i < -layers; ++i) {
                const glm::ivec3 at = v - normal * i;
                expected.erase({at.x, at.y, at.z});
            }
        });
        const MovedFace moved{face, normal};
        const VoxelPatch patch = patchFaces(document, 0, {&moved, 1}, layers).value();
        ASSERT_EQ(afterPatch(document, patch), expected);
    }
}

TEST(Faces, TakeAColourAndKeepWithinLimits) {
    const Document document = test::documentOf(test::solidBox({4, 4, 2}, 5));
    const VoxelSet top = faceRegion(document.models[0].voxels, {1, 1, 1}, {0, 0, 1}, {}).value();
    EXPECT_EQ(top.count(), 16u);
    const IBox half{{0, 0, 0}, {2, 4, 9}};
    const std::array faces{MovedFace{top, {0, 0, 1}}};
    const VoxelPatch patch =
        patchFaces(document, 0, faces, 3, std::uint8_t{9}, {half, nullptr}).value();
    EXPECT_EQ(patch.changes.size(), 2u * 4 * 3);
    for (const VoxelChange& change : patch.changes) {
        EXPECT_EQ(change.after, 9);
        EXPECT_TRUE(half.contains(change.position));
    }
    EXPECT_TRUE(patchFaces(document, 0, faces, 0).value().changes.empty());
    EXPECT_FALSE(patchFaces(document, 0, faces, kMaxFaceLayers + 1));
}

TEST(Faces, MoveTogetherUnderSymmetry) {
    const Document document = test::documentOf(test::solidBox({6, 6, 6}, 5));
    const VoxelGrid& voxels = document.models[0].voxels;
    const Symmetry symmetry{{true, false, false}, {6, 0, 0}};
    std::vector<MovedFace> faces;
    for (const Placement& image : imagesOf(symmetry)) {
        const glm::ivec3 normal = image.rotation.apply({1, 0, 0});
        const glm::ivec3 seed = image.applyToVoxel({5, 3, 3});
        faces.push_back({faceRegion(voxels, seed, normal, {}).value(), normal});
    }
    VoxelGrid expected;
    expected.fill({{-2, 0, 0}, {8, 6, 6}}, 5);
    EXPECT_EQ(afterPatch(document, patchFaces(document, 0, faces, 2).value()), mapOf(expected));
}

}  // namespace
}  // namespace voxprite
