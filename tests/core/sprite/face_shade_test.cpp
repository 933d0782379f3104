#include "core/sprite/face_shade.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "core/svo/bake.h"
#include "core/svo/live_octree.h"
#include "tests/support/must.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::must;

VoxelGrid randomVoxels(std::uint64_t seed, glm::ivec3 size, double fillRate) {
    test::Random random(seed);
    VoxelGrid voxels;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (random.chance(fillRate)) voxels.set({x, y, z}, 1);
    return voxels;
}

// Which cells are solid, without an octree.
struct Solids {
    glm::ivec3 size{0};
    std::vector<bool> cells;

    explicit Solids(const Octree& octree) : size(octree.size) {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    cells.push_back(materialAt(octree.view(), {x, y, z}) != 0);
    }
    [[nodiscard]] bool contains(glm::ivec3 c) const {
        return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < size.x && c.y < size.y && c.z < size.z;
    }
    [[nodiscard]] bool at(glm::ivec3 c) const {
        return contains(c) && cells[static_cast<std::size_t>(c.x + size.x * (c.y + size.y * c.z))];
    }
    // Every face with an empty cell before it.
    [[nodiscard]] std::vector<VoxelFace> faces() const {
        std::vector<VoxelFace> all;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    for (int axis = 0; axis < 3; ++axis)
                        for (const int side : {-1, 1}) {
                            glm::ivec3 front(x, y, z);
                            front[axis] += side;
                            if (at({x, y, z}) && !at(front)) all.push_back({{x, y, z}, axis, side});
                        }
        return all;
    }
};

// Cell by cell from the middle of the face: of the next faces of the grid the one that is met
// first, of equal ones that of the lowest axis.
bool shadowedByHand(const Solids& solids, const VoxelFace& face, glm::ivec3 toward) {
    if (toward[face.axis] * face.side <= 0) return false;
    glm::ivec3 cell = face.voxel;
    cell[face.axis] += face.side;
    glm::ivec3 start = 2 * face.voxel + 1;  // half voxels
    start[face.axis] += face.side;
    while (solids.contains(cell)) {
        if (solids.at(cell)) return true;
        int first = -1;
        std::int64_t way = 0, speed = 1;
        for (int axis = 0; axis < 3; ++axis) {
            if (toward[axis] == 0) continue;
            const int plane = 2 * (cell[axis] + (toward[axis] > 0 ? 1 : 0));
            const std::int64_t own = std::abs(plane - start[axis]);
            const std::int64_t ownSpeed = std::abs(toward[axis]);
            if (first >= 0 && own * speed >= way * ownSpeed) continue;
            first = axis;
            way = own;
            speed = ownSpeed;
        }
        cell[first] += toward[first] > 0 ? 1 : -1;
    }
    return false;
}

// Does a ray from (1/2, 1/2, 0) along `d` come into the inside of the unit cube at `cell` within
// the reach? By slabs, times in exact fractions of 2 |x y z|.
bool entersInside(glm::ivec3 cell, glm::ivec3 d) {
    const std::int64_t whole = std::int64_t{2} * std::abs(d.x * d.y * d.z);
    std::int64_t enter = 0, leave = std::int64_t{1} << 40;
    for (int axis = 0; axis < 3; ++axis) {
        const int start = axis == 2 ? 0 : 1;  // half voxels
        const std::int64_t perHalf = whole / 2 / d[axis];
        const std::int64_t a = (2 * cell[axis] - start) * perHalf;
        const std::int64_t b = (2 * cell[axis] + 2 - start) * perHalf;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    const double length = std::sqrt(static_cast<double>(d.x * d.x + d.y * d.y + d.z * d.z));
    return enter < leave &&
           static_cast<double>(enter) * length < static_cast<double>(kOcclusionReach * whole);
}

std::vector<glm::ivec3> sixteenDirections() {
    std::vector<glm::ivec3> all;
    for (const int x : {-1, 1})
        for (const int y : {-1, 1}) {
            all.emplace_back(2 * x, 2 * y, 11);
            all.emplace_back(4 * x, 4 * y, 5);
            all.emplace_back(11 * x, 3 * y, 10);
            all.emplace_back(3 * x, 11 * y, 10);
        }
    return all;
}

int blockedByHand(const Solids& solids, const VoxelFace& face) {
    int blocked = 0;
    for (const glm::ivec3 direction : sixteenDirections()) {
        bool hit = false;
        for (int w = 0; w <= kOcclusionReach; ++w)
            for (int v = -kOcclusionReach; v <= kOcclusionReach; ++v)
                for (int u = -kOcclusionReach; u <= kOcclusionReach; ++u) {
                    if (glm::ivec3(u, v, w) == glm::ivec3(0)) continue;
                    glm::ivec3 cell = face.voxel;
                    cell[(face.axis + 1) % 3] += u;
                    cell[(face.axis + 2) % 3] += v;
                    cell[face.axis] += face.side * (1 + w);
                    hit = hit || (solids.at(cell) && entersInside({u, v, w}, direction));
                }
        blocked += hit ? 1 : 0;
    }
    return blocked;
}

FaceShader shaderOf(const Octree& octree, glm::ivec3 toward = glm::ivec3(0)) {
    return {octree.view(), {true, toward}};
}

// The directions are spread as the cosine: equal areas of the disc below.
TEST(FaceShade, SixteenDirectionsOfEqualWeight) {
    double height = 0.0;
    for (const glm::ivec3 d : sixteenDirections()) height += d.z / glm::length(glm::dvec3(d));
    // The mean of the cosine, weighted by itself, is 2/3; the middles of 16 equal areas come near.
    EXPECT_NEAR(height / 16, 2.0 / 3.0, 0.08);
    int rays = 0;
    std::set<std::array<int, 3>> offsets;
    const auto steps = occlusionSteps();
    for (std::size_t k = 0; k < steps.size(); k = static_cast<std::size_t>(steps[k].next)) {
        rays += steps[k].rays;
    }
    EXPECT_EQ(rays, kOcclusionRays);
    for (const OcclusionStep& step : steps) {
        offsets.insert({step.offset.x, step.offset.y, step.offset.z});
        EXPECT_GE(step.offset.z, 0);
        EXPECT_LE(step.next, static_cast<int>(steps.size()));
    }
    // Turned and mirrored they are the same.
    for (const auto& [x, y, z] : offsets) {
        EXPECT_TRUE(offsets.contains({y, x, z}));
        EXPECT_TRUE(offsets.contains({-x, y, z}));
    }
}

// A floor with a wall across it.
Octree floorAndWall(int wallHeight) {
    VoxelGrid voxels;
    voxels.fill(IBox::around({0, 0, 0}, {23, 14, 0}), 1);
    voxels.fill(IBox::around({11, 0, 1}, {11, 14, wallHeight}), 2);
    return must(bake(voxels));
}

// At 45 degrees a wall's shadow is as long as the wall is high.
TEST(FaceShade, AWallShadesTheFloorAsFarAsItIsHigh) {
    for (const int height : {1, 3, 5}) {
        const Octree octree = floorAndWall(height);
        const FaceShader shader = shaderOf(octree, shadowDirection({-1.0, 0.0, 1.0}));
        for (int x = 0; x < 24; ++x) {
            if (x == 11) continue;
            EXPECT_EQ(shader.inShadow({{x, 7, 0}, 2, 1}), x > 11 && x <= 11 + height) << x;
        }
        // The wall's far side looks away from the light: that is no shadow. Its near side is lit.
        EXPECT_FALSE(shader.inShadow({{11, 7, 1}, 0, 1}));
        EXPECT_FALSE(shader.inShadow({{11, 7, 1}, 0, -1}));
    }
}

// Rays of a face at the foot of a wall, counted by hand from the cells that the header's directions
// pass: beside it (11, +-3, 10) and (4, +-4, 5) meet the wall in its first layer, (3, +-11, 10) in
// its second, (2, +-2, 11) in its third.
TEST(FaceShade, AWallDarkensTheFloorBesideIt) {
    const auto blocked = [](int height, int away) {
        const Octree octree = floorAndWall(height);
        return shaderOf(octree).blockedRays({{11 + away, 7, 0}, 2, 1});
    };
    EXPECT_EQ(blocked(8, 1), 8);
    EXPECT_EQ(blocked(2, 1), 6);
    EXPECT_EQ(blocked(8, 2), 4);
    EXPECT_EQ(blocked(8, 3), 2);
    EXPECT_EQ(blocked(8, 4), 0);
    EXPECT_EQ(blocked(1, 1), 4);
    EXPECT_EQ(blocked(1, 2), 0);
    EXPECT_EQ(blocked(8, -1), 8);
    const std::array<int, 17> levels{0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    for (int rays = 0; rays <= 16; ++rays) {
        EXPECT_EQ(occlusionLevel(rays), levels[static_cast<std::size_t>(rays)]);
    }
}

TEST(FaceShade, APitIsDark) {
    VoxelGrid voxels;
    voxels.fill(IBox::around({0, 0, 0}, {8, 8, 6}), 1);
    voxels.fill(IBox::around({4, 4, 1}, {4, 4, 6}), 0);
    const Octree octree = must(bake(voxels));
    const FaceShader shader = shaderOf(octree, {0, 0, kShadowDirection});
    EXPECT_EQ(shader.blockedRays({{4, 4, 0}, 2, 1}), kOcclusionRays);
    // Straight up there is a way out.
    EXPECT_FALSE(shader.inShadow({{4, 4, 0}, 2, 1}));
    EXPECT_EQ(shader.shadeOf({{4, 4, 0}, 2, 1}), (FaceShade{kOcclusionLevels - 1, false}));
}

TEST(FaceShade, ABoxInTheOpenHasNoShade) {
    VoxelGrid voxels;
    voxels.fill(IBox::around({0, 0, 0}, {4, 4, 4}), 1);
    const Octree octree = must(bake(voxels));
    const FaceShader shader = shaderOf(octree, {1, 2, 3});
    for (const VoxelFace& face : Solids(octree).faces()) {
        EXPECT_EQ(shader.shadeOf(face), FaceShade{});
    }
}

TEST(FaceShade, RaysAreCastOnlyWhenAsked) {
    const Octree octree = floorAndWall(5);
    const VoxelFace foot{{12, 7, 0}, 2, 1};
    const glm::ivec3 low = shadowDirection({-1.0, 0.0, 1.0});
    EXPECT_EQ(FaceShader(octree.view(), {}).shadeOf(foot), FaceShade{});
    EXPECT_EQ(FaceShader(octree.view(), {false, low}).shadeOf(foot), (FaceShade{0, true}));
    EXPECT_EQ(FaceShader(octree.view(), {true, {}}).shadeOf(foot), (FaceShade{1, false}));
    EXPECT_EQ(FaceShader(octree.view(), {true, low}).shadeOf(foot), (FaceShade{1, true}));
}

// Whatever stands around, and whichever way the light comes: along axes and diagonals, where rays
// meet edges and corners, and anywhere.
TEST(FaceShade, EqualsCountingByHand) {
    test::Random random(404);
    int shadowed = 0, lit = 0;
    std::set<int> counts;
    for (int n = 0; n < 24; ++n) {
        const double fill = n % 3 == 0 ? 0.04 : n % 3 == 1 ? 0.15 : 0.4;
        const Octree octree =
            must(bake(randomVoxels(static_cast<std::uint64_t>(n), {9, 11, 8}, fill)));
        const Solids solids(octree);
        glm::ivec3 toward = random.voxel(-1, 1);
        if (n % 2 == 0) toward = random.voxel(-kShadowDirection, kShadowDirection);
        if (toward == glm::ivec3(0)) toward = {0, 0, 1};
        const FaceShader shader = shaderOf(octree, toward);
        for (const VoxelFace& face : solids.faces()) {
            const bool expected = shadowedByHand(solids, face, toward);
            ++(expected ? shadowed : lit);
            ASSERT_EQ(shader.inShadow(face), expected)
                << "axis " << face.axis << " side " << face.side;
            if (random.chance(0.9)) continue;  // the count by hand is slow
            const int blocked = blockedByHand(solids, face);
            counts.insert(blocked);
            ASSERT_EQ(shader.blockedRays(face), blocked);
        }
    }
    EXPECT_GT(shadowed, 1000);
    EXPECT_GT(lit, 1000);
    EXPECT_GT(counts.size(), 14U);
}

// A live octree has its voxels elsewhere in its root.
TEST(FaceShade, TheOctreesOriginDoesNotMatter) {
    const VoxelGrid voxels = randomVoxels(5, {10, 9, 11}, 0.2);
    const Octree baked = must(bake(voxels));
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    const IBox bounds{glm::ivec3(0), baked.size};
    // A voxel far below moves the root.
    const std::vector<LiveOctree::Edit> edit{{{-40, -7, -3}, 1}};
    ASSERT_TRUE(live.apply(edit));
    const OctreeView moved = live.view(bounds);
    ASSERT_NE(moved.treeFromVoxel, glm::ivec3(0));
    const glm::ivec3 toward = shadowDirection({0.3, -0.5, 0.8});
    const FaceShader one = shaderOf(baked, toward);
    const FaceShader other(moved, {true, toward});
    for (const VoxelFace& face : Solids(baked).faces()) {
        ASSERT_EQ(one.shadeOf(face), other.shadeOf(face));
    }
}

TEST(FaceShade, DirectionsAreRounded) {
    EXPECT_EQ(shadowDirection({0, 0, 3}), glm::ivec3(0, 0, kShadowDirection));
    EXPECT_EQ(shadowDirection({1e-300, 0, -1e-300}),
              glm::ivec3(kShadowDirection, 0, -kShadowDirection));
    EXPECT_EQ(shadowDirection({1, -0.5, 1e-9}), glm::ivec3(kShadowDirection, -4096, 0));
    EXPECT_EQ(shadowDirection({0, 0, 0}), glm::ivec3(0));
    EXPECT_EQ(shadowDirection({std::nan(""), 1, 1}), glm::ivec3(0));
    EXPECT_EQ(shadowDirection({INFINITY, 1, 1}), glm::ivec3(0));
}

}  // namespace
}  // namespace voxprite
