#include "core/lod/cluster_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "core/lod/cluster_cut.h"
#include "core/lod/validate_clusters.h"
#include "core/svo/bake.h"
#include "core/svo/coarsen.h"
#include "core/svo/live_octree.h"
#include "tests/core/lod/quad_faces.h"
#include "tests/support/must.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::must;

struct Subject {
    std::string name;
    Octree octree;
    test::VoxelMap voxels;  // in tree space
};

Subject subjectOf(std::string name, const VoxelGrid& voxels) {
    Subject subject{std::move(name), must(bake(voxels)), {}};
    const glm::ivec3 origin = subject.octree.origin;
    for (const auto& [at, material] : test::mapOf(voxels)) {
        const auto& [x, y, z] = at;
        subject.voxels[{x - origin.x, y - origin.y, z - origin.z}] = material;
    }
    return subject;
}

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    all.push_back(subjectOf("one voxel", test::solidBox({1, 1, 1})));
    all.push_back(subjectOf("box", test::solidBox({33, 17, 9}, 200)));
    all.push_back(subjectOf("figure", test::figure()));
    all.push_back(subjectOf("shell", test::shellSphere(40)));
    all.push_back(subjectOf("asymmetric", test::asymmetric()));
    all.push_back(subjectOf("sparse", test::randomVoxels(1, {20, 30, 10}, 0.02, 5)));
    all.push_back(subjectOf("noise", test::randomVoxels(2, {19, 18, 21}, 0.5, 3)));
    // Nearly solid, so that faces are dropped across borders.
    all.push_back(subjectOf("holes", test::randomVoxels(3, {24, 20, 33}, 0.99, 2)));
    // Solid, but of two materials: bricks inside draw nothing.
    all.push_back(subjectOf("mixed", test::randomVoxels(4, {24, 24, 24}, 1.0, 2)));
    return all;
}

ClusterMesh meshOf(const Subject& subject, int brickCells = 16) {
    return must(buildClusters(subject.octree.view(), {.brickCells = brickCells}));
}

TEST(BuildClusters, LevelZeroShowsExactlyTheOpenFacesInTheirColours) {
    for (const Subject& subject : subjects()) {
        test::CellFaces open;
        for (const auto& [at, material] : subject.voxels) {
            const auto& [x, y, z] = at;
            const std::array<std::array<int, 3>, 6> steps{
                {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
            for (int face = 0; face < 6; ++face) {
                const auto& s = steps[static_cast<std::size_t>(face)];
                if (!subject.voxels.contains({x + s[0], y + s[1], z + s[2]}))
                    open[{x, y, z, face}] = material;
            }
        }
        for (const int brickCells : {4, 8, 16, 32})
            EXPECT_EQ(test::facesOf(meshOf(subject, brickCells), 0), open) << subject.name;
    }
}

TEST(BuildClusters, EveryLevelShowsWhatItsRuleSays) {
    for (const Subject& subject : subjects()) {
        for (const int brickCells : {4, 16}) {
            const ClusterMesh mesh = meshOf(subject, brickCells);
            ASSERT_EQ(mesh.levels.size(), static_cast<std::size_t>(subject.octree.maxDepth + 1));
            for (int level = 0; level <= subject.octree.maxDepth; ++level) {
                test::CellFaces drawn = test::facesOf(mesh, level);
                const Octree coarse = must(coarsen(subject.octree.view(), glm::ivec3(0), level));
                for (auto& [at, material] : drawn) {
                    EXPECT_EQ(material, materialAt(coarse.view(), {at[0], at[1], at[2]}))
                        << subject.name;
                    material = 0;
                }
                EXPECT_EQ(drawn, test::requiredFaces(subject.voxels, level, brickCells))
                    << subject.name << " level " << level << " bricks of " << brickCells;
            }
        }
    }
}

TEST(BuildClusters, PagesKeepTheRulesOfTheCut) {
    for (const Subject& subject : subjects()) {
        for (const int brickCells : {4, 8, 16, 32}) {
            const ClusterMesh mesh = meshOf(subject, brickCells);
            const Status valid = validateClusters(mesh.pages, mesh.indices.size());
            EXPECT_TRUE(valid) << subject.name << ": " << valid.error().message;
            EXPECT_EQ(mesh.pageLevels.size(), mesh.pages.size());
            EXPECT_EQ(mesh.reach, clusterReach(mesh.pages));
            // Roots are those of the last level, and it is a single page.
            EXPECT_EQ(mesh.levels.back().pageCount, 1u);
            for (std::size_t i = 0; i < mesh.pages.size(); ++i) {
                const bool last = i + 1 == mesh.pages.size();
                EXPECT_EQ(std::isinf(mesh.pages[i].parentError), last);
            }
        }
    }
}

TEST(BuildClusters, SpheresHoldWhatIsDrawn) {
    for (const Subject& subject : subjects()) {
        const ClusterMesh mesh = meshOf(subject, 8);
        for (const ClusterPage& page : mesh.pages) {
            for (std::uint32_t i = 0; i < page.indexCount; ++i) {
                const ClusterVertex& v = mesh.vertices[mesh.indices[page.firstIndex + i]];
                const glm::dvec3 at(v.x, v.y, v.z);
                EXPECT_LE(glm::length(at - glm::dvec3(page.centre)),
                          static_cast<double>(page.radius));
                EXPECT_LE(glm::length(at - glm::dvec3(page.lodBoundsCentre)),
                          static_cast<double>(page.lodBoundsRadius) * (1 + 1e-6));
                EXPECT_TRUE(glm::all(glm::lessThanEqual(mesh.bounds.min, glm::ivec3(at))) &&
                            glm::all(glm::lessThanEqual(glm::ivec3(at), mesh.bounds.max)));
            }
        }
    }
}

TEST(BuildClusters, ALevelsErrorIsHowFarItsSurfaceMayBe) {
    double closest = 1e9;  // to the promise, by which it would have been broken
    for (const Subject& subject : subjects()) {
        const ClusterMesh mesh = meshOf(subject, 8);
        for (int level = 0; level < 3 && level <= subject.octree.maxDepth; ++level) {
            const auto promised =
                static_cast<double>(mesh.levels[static_cast<std::size_t>(level)].errorVoxels);
            EXPECT_FLOAT_EQ(static_cast<float>(promised),
                            static_cast<float>(std::sqrt(3.0) * ((1 << level) - 1)));
            const int edge = 1 << level;
            // The corners of a cell are its points farthest from a voxel in it.
            for (const auto& [at, material] : test::facesOf(mesh, level)) {
                const glm::ivec3 cell = glm::ivec3(at[0], at[1], at[2]) * edge;
                for (unsigned corner = 0; corner < 8; ++corner) {
                    const glm::dvec3 point(cell + octantCorner(corner) * edge);
                    double nearest = 1e9;
                    for (int i = 0; i < edge * edge * edge; ++i) {
                        const glm::ivec3 v =
                            cell + glm::ivec3(i % edge, i / edge % edge, i / edge / edge);
                        if (!subject.voxels.contains({v.x, v.y, v.z})) continue;
                        const glm::dvec3 low(v);
                        nearest = std::min(nearest,
                                           glm::length(point - glm::clamp(point, low, low + 1.0)));
                    }
                    EXPECT_LE(nearest, promised + 1e-6);
                    if (level > 0) closest = std::min(closest, promised - nearest);
                }
            }
        }
    }
    EXPECT_NEAR(closest, 0.0, 1e-6);  // no smaller promise would do
}

TEST(BuildClusters, TrianglesFaceOutward) {
    for (const Subject& subject : subjects()) {
        const ClusterMesh mesh = meshOf(subject);
        EXPECT_EQ(mesh.vertices.size() * 6, mesh.indices.size() * 4);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            glm::ivec3 at[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const ClusterVertex& v = mesh.vertices[mesh.indices[i + k]];
                at[k] = {v.x, v.y, v.z};
            }
            const int face = mesh.vertices[mesh.indices[i]].face;
            const glm::dvec3 normal =
                glm::cross(glm::dvec3(at[1] - at[0]), glm::dvec3(at[2] - at[0]));
            glm::dvec3 outward(0.0);
            outward[face % 3] = face < 3 ? 1.0 : -1.0;
            EXPECT_EQ(glm::length(normal), glm::dot(normal, outward));
            EXPECT_GT(glm::length(normal), 0.0);
        }
    }
}

TEST(BuildClusters, MoreToleranceNeverTakesMoreTriangles) {
    for (const Subject& subject : subjects()) {
        if (subject.name == "noise" || subject.name == "holes" || subject.name == "mixed") continue;
        const ClusterMesh mesh = meshOf(subject);
        std::uint64_t before = std::numeric_limits<std::uint64_t>::max();
        for (float threshold = 0.0f; threshold < 200.0f; threshold += 0.5f) {
            std::vector<std::uint32_t> cut;
            selectCut(mesh.pages, threshold, cut);
            std::uint64_t triangles = 0;
            for (const std::uint32_t i : cut) triangles += mesh.pages[i].indexCount / 3;
            EXPECT_LE(triangles, before) << subject.name << " at " << threshold;
            EXPECT_GT(triangles, 0u);
            before = triangles;
        }
        EXPECT_EQ(before, 12u) << subject.name;
    }
}

TEST(BuildClusters, GreedyQuadsAreAsFewAsTheyCanBeOnABox) {
    const ClusterMesh box = meshOf(subjectOf("box", test::solidBox({32, 32, 32})));
    // Each side is cut at the bricks' borders: 2 x 2 quads.
    EXPECT_EQ(box.levels[0].quadCount, 24u);
    EXPECT_EQ(box.levels[0].pageCount, 8u);
    EXPECT_EQ(box.levels[1].quadCount, 6u);
    EXPECT_EQ(box.bytes(), box.vertices.size() / 4 * 56 + box.pages.size() * 65);
}

TEST(BuildClusters, TheNumberOfThreadsChangesNothing) {
    for (const Subject& subject : subjects()) {
        const ClusterMesh one = must(buildClusters(subject.octree.view(), {.threads = 1}));
        const ClusterMesh all = must(buildClusters(subject.octree.view(), {.threads = 0}));
        EXPECT_EQ(one.vertices, all.vertices);
        EXPECT_EQ(one.indices, all.indices);
        EXPECT_EQ(one.pages, all.pages);
        EXPECT_EQ(one.levels, all.levels);
    }
}

TEST(BuildClusters, OfALiveOctreeAreThoseOfItsTree) {
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(test::figure()));
    // Grown toward below, so that the tree's origin is not the model's corner any more.
    const std::vector<LiveOctree::Edit> edits{{{-3, -2, -1}, 7}};
    ASSERT_TRUE(live.apply(edits));
    const OctreeView view = live.view(live.solidBounds());
    ASSERT_NE(view.treeFromVoxel, glm::ivec3(0));
    const ClusterMesh mesh = must(buildClusters(view, {.brickCells = 8}));
    EXPECT_EQ(mesh.treeFromVoxel, view.treeFromVoxel);
    test::VoxelMap voxels = test::mapOf(test::figure());
    voxels[{-3, -2, -1}] = 7;
    test::VoxelMap inTree;
    const glm::ivec3 shift = view.treeFromVoxel - live.solidBounds().min;
    for (const auto& [at, material] : voxels) {
        const auto& [x, y, z] = at;
        inTree[{x + shift.x, y + shift.y, z + shift.z}] = material;
    }
    for (std::size_t level = 0; level < mesh.levels.size(); ++level) {
        test::CellFaces drawn = test::facesOf(mesh, static_cast<int>(level));
        for (auto& [at, material] : drawn) material = 0;
        EXPECT_EQ(drawn, test::requiredFaces(inTree, static_cast<int>(level), 8));
    }
}

TEST(BuildClusters, OfNothingAreNone) {
    const ClusterMesh mesh = must(buildClusters(Octree{}.view()));
    EXPECT_TRUE(mesh.pages.empty());
    EXPECT_TRUE(mesh.levels.empty());
    EXPECT_TRUE(mesh.indices.empty());
    EXPECT_EQ(mesh.bytes(), 0u);
}

TEST(BuildClusters, ReachTheFarCornerOfTheLargestTreeTheyTake) {
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 1);
    voxels.set({32767, 32767, 32767}, 2);
    const Octree octree = must(bake(voxels));
    const ClusterMesh mesh = must(buildClusters(octree.view()));
    EXPECT_EQ(mesh.bounds, (IBox{glm::ivec3(0), glm::ivec3(32768)}));
    EXPECT_EQ(mesh.levels[0].quadCount, 12u);
    EXPECT_TRUE(validateClusters(mesh.pages, mesh.indices.size()));

    voxels.set({32768, 0, 0}, 1);
    const auto refused = buildClusters(must(bake(voxels)).view());
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().message, testing::HasSubstr("32,768"));
}

TEST(BuildClusters, TakeNoMoreMemoryThanAllowed) {
    const Subject noise = subjectOf("noise", test::randomVoxels(2, {19, 18, 21}, 0.5, 3));
    const std::uint64_t bytes = meshOf(noise).indices.size() / 6 * 56;
    EXPECT_TRUE(buildClusters(noise.octree.view(), {.mostBytes = bytes}).has_value());
    for (const int threads : {1, 0}) {
        const auto refused =
            buildClusters(noise.octree.view(), {.threads = threads, .mostBytes = bytes - 1});
        ASSERT_FALSE(refused.has_value());
        EXPECT_THAT(refused.error().message, testing::HasSubstr("too large for clusters"));
    }
}

TEST(BuildClusters, RefusesOtherBricks) {
    for (const int brickCells : {-16, 0, 1, 2, 3, 5, 64}) {
        EXPECT_FALSE(buildClusters(Octree{}.view(), {.brickCells = brickCells}).has_value());
    }
}

TEST(BuildClusters, ALargeSolidCostsItsSurfaceOnly) {
    // All of one material: bricks inside are never looked at.
    VoxelGrid voxels;
    voxels.fill({glm::ivec3(0), glm::ivec3(64)}, 3);
    Octree octree = must(bake(voxels));
    octree.maxDepth = 9;  // the same root word over a larger cube
    octree.size = glm::ivec3(512);
    ASSERT_EQ(octree.nodes, std::vector<std::uint32_t>{3});
    const ClusterMesh mesh = must(buildClusters(octree.view()));
    EXPECT_EQ(mesh.levels[0].pageCount, 32u * 32 * 32 - 30 * 30 * 30);
    EXPECT_EQ(mesh.levels[0].quadCount, 6u * 32 * 32);
}

}  // namespace
}  // namespace voxprite
