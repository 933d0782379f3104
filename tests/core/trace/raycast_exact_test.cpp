// The ray cast against walks that share nothing with it: exact fractions cell by cell, and real
// numbers in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/exact_caster.h"
#include "tests/core/trace/raycast_rays.h"

namespace voxprite::test {
namespace {

using Real = long double;

std::vector<DenseModel> models() {
    std::vector<DenseModel> models;
    models.push_back(solid({1, 1, 1}, 7));
    models.push_back(solid({2, 2, 2}, 8));
    models.push_back(solid({5, 3, 6}, 9));
    models.push_back(randomVoxels({1, 1, 13}, 0.4, 1));
    models.push_back(randomVoxels({7, 11, 5}, 0.02, 3));
    models.push_back(randomVoxels({16, 16, 16}, 0.005, 4));
    models.push_back(randomVoxels({9, 9, 9}, 0.5, 5));
    models.push_back(shell(32));
    models.push_back(figure(1));
    return models;
}

// The first solid voxel of a cube in the order of octants, by looking at all of them.
std::uint8_t firstInOctantOrder(const DenseModel& model, glm::ivec3 corner, int level) {
    if (level == 0) return model.at(corner);
    for (int octant = 0; octant < 8; ++octant) {
        const glm::ivec3 child =
            corner + octantCorner(static_cast<unsigned>(octant)) * (1 << (level - 1));
        if (const std::uint8_t value = firstInOctantOrder(model, child, level - 1); value != 0)
            return value;
    }
    return 0;
}

// The model as its octree looks down to nodes of edge 2^level: a voxel for each of them. Its
// minimum corner lies in the root's.
DenseModel coarse(const DenseModel& model, glm::ivec3 treeFromVoxel, int level) {
    const int edge = 1 << level;
    DenseModel nodes(model.name + " / " + std::to_string(edge),
                     (treeFromVoxel + model.size + (edge - 1)) / edge);
    for (int z = 0; z < nodes.size.z; ++z)
        for (int y = 0; y < nodes.size.y; ++y)
            for (int x = 0; x < nodes.size.x; ++x)
                nodes[{x, y, z}] =
                    firstInOctantOrder(model, glm::ivec3(x, y, z) * edge - treeFromVoxel, level);
    return nodes;
}

// What castQuantised has to find, from the same integers. `corner` is that of the nodes in the
// tree.
LatticeHit exactHit(const DenseModel& nodes, const QuantisedRay& ray, glm::ivec3 corner) {
    LatticeRay line;
    line.origin =
        glm::i64vec3(ray.origin) - glm::i64vec3(corner) * (std::int64_t{1} << ray.positionBits);
    line.direction = ray.direction;
    line.positionBits = ray.positionBits + ray.leafLevel;
    LatticeHit hit = ray.inside ? castExactRay(nodes, line, true) : castExact(nodes, line);
    hit.voxel *= 1 << ray.leafLevel;
    return hit;
}

TEST(Raycast, EqualsTheSortedListOfAllCrossingsAtEveryDepth) {
    Rays rays(1);
    for (const DenseModel& model : models()) {
        const NaiveOctree tree(model);
        for (int depth = 0; depth <= tree.octree.maxDepth; ++depth) {
            const int level = tree.octree.maxDepth - depth;
            const DenseModel nodes = coarse(model, glm::ivec3(0), level);
            int hits = 0;
            for (int n = 0; n < 3000; ++n) {
                const Ray ray = n % 3 == 0   ? rays.common(model.size, 1.5)
                                : n % 3 == 1 ? rays.special(model.size)
                                             : rays.grazing(model.size);
                const QuantisedRay quantised = quantiseRay(tree.view(), ray, depth);
                const LatticeHit got = castQuantised(tree.view(), quantised);
                LatticeHit want;
                if (quantised.meetsBox) want = exactHit(nodes, quantised, glm::ivec3(0));
                ASSERT_TRUE(sameHit(got, want))
                    << model.name << " depth " << depth << ' ' << describe(ray) << "\n got "
                    << describe(got) << "\nwant " << describe(want);
                hits += got.material != 0;
            }
            EXPECT_GT(hits, 150) << model.name << " depth " << depth;
        }
    }
}

// Where quantising changes nothing, the whole ray cast is exact: fractions of the ray's own numbers
// give the same voxel and face, and the same t and point.
TEST(Raycast, RaysOfSmallFractionsAreExact) {
    Rays rays(2);
    for (const DenseModel& model : models()) {
        const NaiveOctree tree(model);
        int hits = 0;
        for (int n = 0; n < 20000; ++n) {
            const Ray ray = rays.special(model.size);
            LatticeRay line;
            line.positionBits = 3;
            line.origin = glm::i64vec3(ray.origin * 8.0);
            line.direction = glm::ivec3(ray.direction * 4.0);
            const LatticeHit want = castExactRay(model, line, startsInside(model, line));
            const RaycastHit got = raycast(tree.view(), ray);
            ASSERT_EQ(got.hit, want.material != 0) << model.name << ' ' << describe(ray);
            if (!got.hit) continue;
            ++hits;
            ASSERT_EQ(got.voxel, want.voxel) << model.name << ' ' << describe(ray);
            ASSERT_EQ(got.value, want.material);
            if (want.faceAxis == 3) {
                ASSERT_EQ(got.t, 0.0);
                ASSERT_EQ(got.point, ray.origin);
                continue;
            }
            ASSERT_EQ(got.axis, want.faceAxis) << model.name << ' ' << describe(ray);
            const double d = ray.direction[got.axis];
            const int face = want.voxel[got.axis] + (d < 0.0 ? 1 : 0);
            const double steps = (face - ray.origin[got.axis]) / d;
            ASSERT_DOUBLE_EQ(got.t, steps * glm::length(ray.direction));
            ASSERT_EQ(got.point, ray.origin + ray.direction * steps);
        }
        EXPECT_GT(hits, 500) << model.name;
    }
}

TEST(Raycast, ALiveOctreesPlaceChangesNothing) {
    const DenseModel model = randomVoxels({13, 9, 11}, 0.1, 3);
    Rays rays(4);
    for (const glm::ivec3 corner : {glm::ivec3(3, 5, 1), glm::ivec3(51, 0, 40)}) {
        const NaiveOctree live(model, 6, corner);
        for (int depth = 0; depth <= 6; ++depth) {
            const DenseModel nodes = coarse(model, corner, 6 - depth);
            for (int n = 0; n < 2000; ++n) {
                const Ray ray =
                    n % 2 == 0 ? rays.common(model.size, 1.0) : rays.special(model.size);
                const QuantisedRay quantised = quantiseRay(live.view(), ray, depth);
                const LatticeHit got = castQuantised(live.view(), quantised);
                LatticeHit want;
                if (quantised.meetsBox) want = exactHit(nodes, quantised, glm::ivec3(0));
                want.voxel -= corner;
                ASSERT_TRUE(sameHit(got, want)) << "depth " << depth << ' ' << describe(ray);
            }
        }
    }
}

// What lies outside the root is empty; no arithmetic goes wrong far from it.
TEST(Raycast, BoundsMayReachBeyondTheRoot) {
    const DenseModel model = randomVoxels({12, 12, 12}, 0.2, 41);
    Rays rays(5);
    for (const glm::ivec3 offset : {glm::ivec3(-3, 0, 0), glm::ivec3(-2, -5, 3),
                                    glm::ivec3(4, 4, -4), glm::ivec3(-60000, 2, 60000)}) {
        const NaiveOctree live(model, 3, offset);
        DenseModel visible = model;
        for (int k = 0; k < 12 * 12 * 12; ++k) {
            const glm::ivec3 voxel{k % 12, k / 12 % 12, k / 144};
            const glm::ivec3 tree = voxel + offset;
            if (!IBox{glm::ivec3(0), glm::ivec3(8)}.contains(tree)) visible[voxel] = 0;
        }
        for (int n = 0; n < 3000; ++n) {
            const Ray ray = rays.special(model.size);
            const QuantisedRay quantised = quantiseRay(live.view(), ray, 3);
            const LatticeHit got = castQuantised(live.view(), quantised);
            LatticeHit want;
            if (quantised.meetsBox) want = exactHit(visible, quantised, offset);
            ASSERT_TRUE(sameHit(got, want)) << describe(ray);
        }
    }
}

// The bound of the header: how far the line walked strays from the ray inside the box.
TEST(Raycast, QuantisingMovesTheLineByNoMoreThanItsBound) {
    Rays rays(6);
    double worst = 0.0;
    for (const int depth : {1, 4, 7, 9, 12, 16}) {
        Octree octree;
        octree.nodes[0] = node::uniform(1);
        octree.maxDepth = depth;
        octree.size = glm::ivec3(1 << depth);
        const double slack = raySlack(octree.view());
        for (int n = 0; n < 4000; ++n) {
            const Ray ray = rays.common(octree.size, n % 2 == 0 ? 1.0 : 1000.0);
            const QuantisedRay q = quantiseRay(octree.view(), ray, depth);
            if (!q.meetsBox) continue;
            const double lost = glm::length(ray.origin) * std::exp2(-51);
            for (const double share : {0.0, 0.3, 1.0}) {
                const Real s = Real{q.enter} + Real{share} * octree.size.x;
                for (int a = 0; a < 3; ++a) {
                    const Real real = ray.origin[a] + s * q.scaled[a];
                    const Real walked =
                        std::ldexp(Real(q.origin[a]), -q.positionBits) +
                        (s - q.enter) * std::ldexp(Real(q.direction[a]), -kRayDirectionBits);
                    const double off = static_cast<double>(std::abs(real - walked));
                    ASSERT_LE(off, slack + lost) << "depth " << depth << ' ' << describe(ray);
                    worst = std::max(worst, (off - lost) / slack);
                }
            }
        }
    }
    EXPECT_GT(worst, 0.5);  // the bound is not idle
}

// Amanatides & Woo in long double, from the origin on. `t` of the hit, and its face.
struct RealHit {
    LatticeHit hit;
    double t = 0.0;
};

RealHit castReal(const DenseModel& model, const Ray& ray) {
    const glm::dvec3 eye = ray.origin;
    const double length = glm::length(ray.direction);
    Real t[3];
    Real perCell[3];
    Real enter = 0;
    int axis = -1;
    for (int a = 0; a < 3; ++a) {
        const Real d = Real{ray.direction[a]} / length;
        if (d == 0) {
            if (eye[a] < 0 || eye[a] >= model.size[a]) return {};
            continue;
        }
        const Real near = ((d > 0 ? 0 : model.size[a]) - Real{eye[a]}) / d;
        const Real far = ((d > 0 ? model.size[a] : 0) - Real{eye[a]}) / d;
        if (far < 0) return {};
        if (near > enter) {
            enter = near;
            axis = a;
        }
    }
    glm::ivec3 cell{0};
    for (int a = 0; a < 3; ++a) {
        const Real d = Real{ray.direction[a]} / length;
        cell[a] = static_cast<int>(std::floor(eye[a] + enter * d));
        if (a == axis) cell[a] = d > 0 ? 0 : model.size[a] - 1;
        if (cell[a] < 0 || cell[a] >= model.size[a]) return {};
        perCell[a] = d == 0 ? 0 : 1 / std::abs(d);
        t[a] = d == 0 ? std::numeric_limits<Real>::infinity()
                      : (cell[a] + (d > 0 ? 1 : 0) - Real{eye[a]}) / d;
    }
    Real now = enter;
    for (;;) {
        if (const std::uint8_t material = model.at(cell); material != 0)
            return {{material, static_cast<std::uint8_t>(axis < 0 ? 3 : axis), cell},
                    static_cast<double>(now)};
        axis = t[1] < t[0] ? 1 : 0;
        if (t[2] < t[axis]) axis = 2;
        now = t[axis];
        cell[axis] += ray.direction[axis] > 0 ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= model.size[axis]) return {};
        t[axis] += perCell[axis];
    }
}

// Random rays pass edges nearer than the bound now and then, and then only see the other side.
void expectRealHits(const DenseModel& model, double reach, int most) {
    const NaiveOctree tree(model);
    const double slack =
        raySlack(tree.view()) + glm::length(glm::dvec3(model.size)) * reach * std::exp2(-50);
    constexpr int kRays = 20000;
    Rays rays(7);
    int hits = 0;
    int differences = 0;
    for (int n = 0; n < kRays; ++n) {
        const Ray ray = rays.common(model.size, reach);
        const RealHit want = castReal(model, ray);
        const RaycastHit got = raycast(tree.view(), ray);
        hits += want.hit.material != 0;
        const bool same = got.hit == (want.hit.material != 0) &&
                          (!got.hit || (got.voxel == want.hit.voxel &&
                                        (want.hit.faceAxis == 3 || got.axis == want.hit.faceAxis)));
        differences += same ? 0 : 1;
        if (!got.hit) continue;
        if (same) {
            ASSERT_NEAR(got.t, want.t, 1e-9 * (1.0 + want.t));
        }
        for (int a = 0; a < 3; ++a) {
            ASSERT_GE(got.point[a], got.voxel[a] - slack);
            ASSERT_LE(got.point[a], got.voxel[a] + 1 + slack);
        }
    }
    EXPECT_GT(hits, kRays / 3);
    EXPECT_LE(differences, most);
}

TEST(Raycast, AgreesWithRealArithmetic) {
    expectRealHits(shell(64), 3.0, 20);
    expectRealHits(figure(2), 1.0, 20);
    expectRealHits(randomVoxels({40, 30, 20}, 0.05, 2), 0.6, 20);
    expectRealHits(shell(32), 5000.0, 20);
    expectRealHits(solid({9, 1, 3}, 4), 2.0, 5);
}

}  // namespace
}  // namespace voxprite::test
