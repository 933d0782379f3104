// Meshes whose voxels are known: boxes, balls, plates, boxes in boxes, boxes with a side missing.
#include "core/io/mesh_voxels.h"

#include <gtest/gtest.h>

#include "core/io/nearest_triangle.h"
#include "tests/core/io/mesh_shapes.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

constexpr glm::vec4 kRed(1.0f, 0.0f, 0.0f, 1.0f), kBlue(0.0f, 0.0f, 1.0f, 1.0f);

TEST(MeshVoxels, ABoxIsItsVoxels) {
    TriangleMesh mesh = emptyMesh();
    addBox(mesh, {0.1, 0.2, 0.3}, {0.9, 0.6, 0.5}, kRed);
    const LoadedDocument loaded = must(voxelsOf(mesh, options(8)));
    EXPECT_EQ(voxelsIn(loaded).bounds(), (IBox{{0, 0, 0}, {8, 4, 2}}));
    EXPECT_EQ(voxelsIn(loaded).solidCount(), 64u);
    EXPECT_EQ(colourIn(loaded, {3, 2, 1}), Rgba8(255, 0, 0, 255));
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_NEAR(loaded.document.authored.voxelSizeMetres, 0.1, 1e-12);
    EXPECT_TRUE(validate(loaded.document));
    // The mesh's origin.
    EXPECT_EQ(loaded.document.entity.anchorVoxels, glm::dvec3(-1.0, -2.0, -3.0));
}

TEST(MeshVoxels, HollowIsWhatHasAnEmptyNeighbour) {
    TriangleMesh mesh = emptyMesh();
    addBox(mesh, glm::dvec3(0.0), glm::dvec3(6.0, 5.0, 4.0));
    const LoadedDocument loaded = must(voxelsOf(mesh, options(6, false)));
    EXPECT_EQ(voxelsIn(loaded).solidCount(), 6u * 5 * 4 - 4 * 3 * 2);
    EXPECT_EQ(voxelsIn(loaded).get({1, 1, 1}), 0);
    EXPECT_NE(voxelsIn(loaded).get({0, 2, 2}), 0);
}

TEST(MeshVoxels, VoxelsAUnitChooseTheSize) {
    TriangleMesh mesh = emptyMesh();
    addBox(mesh, glm::dvec3(0.0), glm::dvec3(2.0, 1.0, 1.0));
    MeshReadOptions fine = options(8);
    fine.voxelsPerUnit = 5.0;
    const LoadedDocument loaded = must(voxelsOf(mesh, fine));
    EXPECT_EQ(voxelsIn(loaded).bounds().size(), glm::ivec3(10, 5, 5));
    EXPECT_EQ(loaded.document.authored.voxelSizeMetres, 0.2);
}

// Against the ball itself, but for cells whose centre is nearly on the surface.
TEST(MeshVoxels, ABallIsFilledAsTheBallIs) {
    constexpr int kAcross = 40;
    const LoadedDocument solid = must(voxelsOf(sphere(96, 192), options(kAcross)));
    const LoadedDocument hollow = must(voxelsOf(sphere(96, 192), options(kAcross, false)));
    int judged = 0;
    for (glm::ivec3 v(0); v.z < kAcross; ++v.z) {
        for (v.y = 0; v.y < kAcross; ++v.y) {
            for (v.x = 0; v.x < kAcross; ++v.x) {
                const glm::dvec3 centre = glm::dvec3(v) + 0.5 - kAcross / 2.0;
                const double depth = kAcross / 2.0 - std::sqrt(glm::dot(centre, centre));
                if (std::abs(depth) < 0.25) continue;
                ++judged;
                ASSERT_EQ(voxelsIn(solid).get(v) != 0, depth > 0.0)
                    << v.x << ' ' << v.y << ' ' << v.z;
                if (depth > 2.0) {
                    ASSERT_EQ(voxelsIn(hollow).get(v), 0);
                }
            }
        }
    }
    EXPECT_GT(judged, 55'000);
    EXPECT_TRUE(solid.warnings.empty());
    // What is seen from outside is the same.
    EXPECT_EQ(voxelsIn(hollow).bounds(), voxelsIn(solid).bounds());
}

TEST(MeshVoxels, CavitiesAndGapsOfOneVoxelStayOpen) {
    TriangleMesh mesh = emptyMesh();
    addBox(mesh, glm::dvec3(0.0), glm::dvec3(8.0, 8.0, 8.0));
    addBox(mesh, glm::dvec3(3.0), glm::dvec3(4.0), kRed, /*insideOut=*/true);
    addBox(mesh, {9.0, 0.0, 0.0}, {10.0, 8.0, 8.0}, kBlue);
    const LoadedDocument loaded = must(voxelsOf(mesh, options(10)));
    EXPECT_EQ(voxelsIn(loaded).solidCount(), 8u * 8 * 8 - 1 + 8 * 8);
    EXPECT_EQ(voxelsIn(loaded).get({3, 3, 3}), 0);
    EXPECT_EQ(voxelsIn(loaded).get({8, 4, 4}), 0);
    EXPECT_EQ(colourIn(loaded, {2, 3, 3}), Rgba8(255, 0, 0, 255));
    EXPECT_EQ(colourIn(loaded, {9, 3, 3}), Rgba8(0, 0, 255, 255));
}

TEST(MeshVoxels, WhatIsThinnerThanAVoxelIsKept) {
    for (const double at : {2.0, 2.3, 2.5, 2.71, 3.0}) {
        TriangleMesh mesh = emptyMesh();
        addBox(mesh, glm::dvec3(0.0), glm::dvec3(3.0, 6.0, 6.0));
        addBox(mesh, {2.5, 1.0, at}, {10.0, 5.0, at + 0.2}, kRed);
        const LoadedDocument loaded = must(voxelsOf(mesh, options(10)));
        for (int x = 3; x < 10; ++x) {
            for (int y = 1; y < 5; ++y) {
                int layers = 0;
                for (int z = 0; z < 6; ++z) layers += voxelsIn(loaded).get({x, y, z}) != 0;
                ASSERT_GE(layers, 1) << at << ": " << x << ' ' << y;
                ASSERT_LE(layers, 2) << at << ": " << x << ' ' << y;
            }
        }
    }
}

TEST(MeshVoxels, OpenMeshesAreTheirSurfaceAndAreToldOf) {
    TriangleMesh mesh = emptyMesh();
    mesh.triangles.push_back(triangle({0, 0, 0}, {9, 0, 0}, {9, 9, 0}, kRed));
    mesh.triangles.push_back(triangle({0, 0, 0}, {9, 9, 0}, {0, 9, 0}, kRed));
    for (const bool solid : {false, true}) {
        const LoadedDocument loaded = must(voxelsOf(mesh, options(9, solid)));
        EXPECT_EQ(voxelsIn(loaded).solidCount(), 81u);
        EXPECT_EQ(voxelsIn(loaded).bounds().size(), glm::ivec3(9, 9, 1));
        ASSERT_EQ(loaded.warnings.size(), 1u);
        EXPECT_NE(loaded.warnings[0].find("not closed"), std::string::npos);
    }
}

// A box without its lid is open, and stays so; with a slit in a side it is filled all the same.
TEST(MeshVoxels, AFloodFillsWhatItDoesNotReach) {
    TriangleMesh open = emptyMesh();
    addBox(open, glm::dvec3(0.0), glm::dvec3(12.0), kRed, false, 1 << 5);
    const LoadedDocument cup = must(voxelsOf(open, options(12)));
    EXPECT_EQ(voxelsIn(cup).get({6, 6, 6}), 0);
    EXPECT_NE(voxelsIn(cup).get({6, 6, 0}), 0);
    EXPECT_EQ(cup.warnings.size(), 1u);
    TriangleMesh slit = emptyMesh();
    addBox(slit, glm::dvec3(0.0), glm::dvec3(12.0), kRed, false, 1 << 5);
    slit.triangles.push_back(triangle({0, 0, 12}, {12, 0, 12}, {12, 5.7, 12}));
    slit.triangles.push_back(triangle({0, 0, 12}, {12, 5.7, 12}, {0, 5.7, 12}));
    slit.triangles.push_back(triangle({0, 6.3, 12}, {12, 6.3, 12}, {12, 12, 12}));
    slit.triangles.push_back(triangle({0, 6.3, 12}, {12, 12, 12}, {0, 12, 12}));
    const LoadedDocument filled = must(voxelsOf(slit, options(13)));
    EXPECT_NE(voxelsIn(filled).get({6, 6, 6}), 0);
    EXPECT_EQ(filled.warnings.size(), 1u);
}

// Turned triangles do not matter to what is inside.
TEST(MeshVoxels, MixedWindingsAreFilledByCounting) {
    TriangleMesh mesh = emptyMesh();
    addBox(mesh, glm::dvec3(0.0), glm::dvec3(6.0));
    std::swap(mesh.triangles[0].corners[0], mesh.triangles[0].corners[1]);
    std::swap(mesh.triangles[7].corners[0], mesh.triangles[7].corners[1]);
    const LoadedDocument loaded = must(voxelsOf(mesh, options(6)));
    EXPECT_EQ(voxelsIn(loaded).solidCount(), 216u);
    EXPECT_TRUE(loaded.warnings.empty());
}

// Each voxel shows the texel that lies on it, the edges' too; leaves are cut out.
TEST(MeshVoxels, ATexturedSquareIsItsPicture) {
    TriangleMesh mesh = emptyMesh();
    Image image(5, 3);
    for (int k = 0; k < 15; ++k) {
        image.pixels[static_cast<std::size_t>(k)] =
            Rgba8(10 * k, 255 - 16 * k, 7 * k, k == 7 ? 0 : 255);
    }
    mesh.textures = {image};
    mesh.materials[0].texture = 0;
    mesh.materials[0].leastAlpha = 0.5;
    const glm::dvec3 at[4] = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {0, 3, 0}};
    const glm::vec2 uv[4] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    for (const auto& [a, b, c] : {std::tuple(0, 1, 2), std::tuple(0, 2, 3)}) {
        MeshTriangle half = triangle(at[a], at[b], at[c]);
        half.corners[0].uv = uv[a];
        half.corners[1].uv = uv[b];
        half.corners[2].uv = uv[c];
        mesh.triangles.push_back(half);
    }
    const LoadedDocument loaded = must(voxelsOf(mesh, options(5)));
    EXPECT_EQ(voxelsIn(loaded).solidCount(), 14u);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            const Rgba8 texel = image.at(x, 2 - y);
            if (texel.w == 0) {
                EXPECT_EQ(voxelsIn(loaded).get({x, y, 0}), 0);
            } else {
                EXPECT_EQ(colourIn(loaded, {x, y, 0}), texel) << x << ' ' << y;
            }
        }
    }
}

TEST(MeshVoxels, ColoursBetweenCornersAreMixedInLight) {
    TriangleMesh mesh = emptyMesh();
    mesh.triangles.push_back(triangle({0, 0, 0}, {16, 0, 0}, {16, 1, 0}));
    mesh.triangles.push_back(triangle({0, 0, 0}, {16, 1, 0}, {0, 1, 0}));
    for (MeshTriangle& half : mesh.triangles) {
        for (MeshCorner& corner : half.corners) {
            corner.colour = glm::vec4(glm::vec3(static_cast<float>(corner.position.x) / 16), 1.0f);
        }
    }
    const LoadedDocument loaded = must(voxelsOf(mesh, options(16)));
    // (k + 1/2) / 16 of the light, as bytes of sRGB.
    EXPECT_EQ(colourIn(loaded, {0, 0, 0}), Rgba8(49, 49, 49, 255));
    EXPECT_EQ(colourIn(loaded, {8, 0, 0}), Rgba8(193, 193, 193, 255));
    EXPECT_EQ(colourIn(loaded, {15, 0, 0}), Rgba8(251, 251, 251, 255));
}

TEST(MeshVoxels, ThreadsDoNotChangeTheResult) {
    Random random(5);
    TriangleMesh mesh = sphere(24, 48);
    for (MeshTriangle& t : mesh.triangles) {
        for (MeshCorner& corner : t.corners) {
            corner.colour = glm::vec4(random.unit(), random.unit(), random.unit(), 1.0);
        }
    }
    addBox(mesh, {-1.0, -0.2, -0.3}, {1.3, 0.3, 0.1}, kRed);
    for (const bool solid : {false, true}) {
        const LoadedDocument one = must(voxelsOf(mesh, options(48, solid, 1)));
        const LoadedDocument two = must(voxelsOf(mesh, options(48, solid, 2)));
        EXPECT_EQ(one.document, two.document);
    }
}

// What lies inside takes no place in the palette from what is seen.
TEST(MeshVoxels, FillingChangesNoColourThatIsSeen) {
    TriangleMesh mesh = sphere(24, 48);
    for (MeshTriangle& t : mesh.triangles) {
        for (MeshCorner& corner : t.corners) {
            corner.colour = glm::vec4(glm::vec3(corner.position) * 0.5f + 0.5f, 1.0f);
        }
    }
    const LoadedDocument hollow = must(voxelsOf(mesh, options(40, false)));
    const LoadedDocument solid = must(voxelsOf(mesh, options(40, true)));
    EXPECT_EQ(hollow.document.palette, solid.document.palette);
    EXPECT_EQ(hollow.warnings, solid.warnings);
    EXPECT_EQ(hollow.warnings.size(), 1u);
    EXPECT_GT(voxelsIn(solid).solidCount(), 2 * voxelsIn(hollow).solidCount());
    voxelsIn(hollow).forEachSolid(
        [&](glm::ivec3 v, std::uint8_t value) { ASSERT_EQ(voxelsIn(solid).get(v), value); });
}

TEST(MeshVoxels, LimitsAreTold) {
    TriangleMesh mesh = emptyMesh();
    EXPECT_EQ(voxelsOf(mesh, options(8)).error().message, "the file holds no triangles");
    mesh.triangles.push_back(triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));
    EXPECT_EQ(voxelsOf(mesh, options(8)).error().message, "the mesh has no extent");
    addBox(mesh, glm::dvec3(0.0), glm::dvec3(1.0));
    EXPECT_FALSE(voxelsOf(mesh, options(0)));
    EXPECT_FALSE(voxelsOf(mesh, options(kMaxMeshResolution + 1)));
    MeshReadOptions huge = options(8);
    huge.voxelsPerUnit = 1e5;
    const auto refused = voxelsOf(mesh, huge);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("at most 1024"), std::string::npos);
    // Surface everywhere: ten thousand squares across the space at the highest resolution.
    TriangleMesh dense = emptyMesh();
    for (int k = 0; k < 1000; ++k) {
        addBox(dense, {0.0, 0.0, 0.0}, {1000.0, 1000.0, 1.0 + k}, kRed);
    }
    const auto tooMuch = voxelsOf(dense, options(1000));
    ASSERT_FALSE(tooMuch);
    EXPECT_NE(tooMuch.error().message.find("too much surface"), std::string::npos);
}

// By comparing with every triangle.
TEST(NearestTriangle, IsTheNearestWhateverTheHint) {
    Random random(11);
    std::vector<MeshTriangle> triangles;
    const auto point = [&] { return glm::dvec3(random.unit(), random.unit(), random.unit()); };
    for (int k = 0; k < 300; ++k) {
        const glm::dvec3 at = point();
        triangles.push_back(triangle(at, at + 0.2 * point(), at + 0.2 * point()));
        if (k % 5 == 0) triangles.push_back(triangles.back());  // ties
    }
    triangles.push_back(triangle({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}));
    triangles.push_back(triangle({0.1, 0.1, 0.1}, {0.4, 0.1, 0.1}, {0.9, 0.1, 0.1}));
    const NearestTriangle tree(triangles);
    for (int k = 0; k < 500; ++k) {
        const glm::dvec3 from = 3.0 * point() - 1.0;
        SurfacePoint best = nearestOnTriangle(triangles[0], 0, from);
        for (std::uint32_t t = 1; t < triangles.size(); ++t) {
            const SurfacePoint other = nearestOnTriangle(triangles[t], t, from);
            if (other.squaredDistance < best.squaredDistance) best = other;
        }
        const auto hint =
            static_cast<std::uint32_t>(random.between(0, static_cast<int>(triangles.size()) - 1));
        const SurfacePoint found = tree.nearest(from, hint);
        ASSERT_EQ(found.triangle, best.triangle);
        ASSERT_EQ(found.squaredDistance, best.squaredDistance);
        const glm::dvec3 w = found.weights;
        ASSERT_NEAR(w.x + w.y + w.z, 1.0, 1e-12);
        ASSERT_GE(std::min({w.x, w.y, w.z}), 0.0);
    }
}

}  // namespace
}  // namespace voxprite::test
