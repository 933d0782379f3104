#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/trace/lattice_caster.h"
#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/exact_caster.h"
#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

using Real = long double;

// Amanatides & Woo in long double, from the eye on.
PerspectiveHit castReal(const DenseModel& model, glm::dvec3 eye, glm::dvec3 direction) {
    const double length = glm::length(direction);
    Real t[3];
    Real perCell[3];
    Real enter = 0;
    int axis = -1;
    for (int a = 0; a < 3; ++a) {
        const Real d = Real{direction[a]} / length;
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
        const Real d = Real{direction[a]} / length;
        const Real at = eye[a] + enter * d;
        cell[a] = static_cast<int>(std::floor(at));
        if (a == axis) cell[a] = d > 0 ? 0 : model.size[a] - 1;
        if (cell[a] < 0 || cell[a] >= model.size[a]) return {};
        perCell[a] = d == 0 ? 0 : 1 / std::abs(d);
        t[a] = d == 0 ? std::numeric_limits<Real>::infinity()
                      : (cell[a] + (d > 0 ? 1 : 0) - Real{eye[a]}) / d;
    }
    Real now = enter;
    for (;;) {
        if (const std::uint8_t material = model.at(cell); material != 0) {
            if (axis < 0) {
                axis = 0;
                for (int a = 1; a < 3; ++a)
                    if (std::abs(direction[a]) > std::abs(direction[axis])) axis = a;
            }
            return {{material, static_cast<std::uint8_t>(axis), cell}, static_cast<double>(now)};
        }
        axis = t[1] < t[0] ? 1 : 0;
        if (t[2] < t[axis]) axis = 2;
        now = t[axis];
        cell[axis] += direction[axis] > 0 ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= model.size[axis]) return {};
        t[axis] += perCell[axis];
    }
}

// Random eyes around and inside; rays that aim into the model.
void expectRealHits(const DenseModel& model, double reach, int rays, int mostDifferences) {
    const NaiveOctree tree(model);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const glm::dvec3 size(model.size);
    int hits = 0;
    int differences = 0;
    for (int n = 0; n < rays; ++n) {
        const glm::dvec3 side =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        const glm::dvec3 eye = size * 0.5 + side * (glm::length(size) * reach * unit(random));
        const glm::dvec3 target = size * glm::dvec3(unit(random), unit(random), unit(random));
        const glm::dvec3 direction = (target - eye) * std::exp(4 * normal(random));
        const PerspectiveHit want = castReal(model, eye, direction);
        const PerspectiveHit got = castPerspective(tree.view(), eye, direction);
        hits += want.hit.material != 0;
        if (!sameHit(got.hit, want.hit)) {
            ++differences;
        } else if (got.hit.material != 0) {
            ASSERT_NEAR(got.t, want.t, 1e-2 + 1e-9 * want.t);
        }
    }
    EXPECT_GT(hits, rays / 3);
    EXPECT_LE(differences, mostDifferences);
}

TEST(PerspectiveCaster, AgreesWithRealArithmetic) {
    expectRealHits(shell(64), 3.0, 20000, 20);
    expectRealHits(figure(2), 1.0, 20000, 20);
    expectRealHits(randomVoxels({40, 30, 20}, 0.05, 2), 0.6, 20000, 20);
    expectRealHits(shell(32), 5000.0, 20000, 20);
    expectRealHits(solid({9, 1, 3}, 4), 2.0, 20000, 5);
}

TEST(PerspectiveCaster, KnownAnswers) {
    DenseModel model("two", {8, 8, 8});
    model[{2, 3, 4}] = 10;
    model[{6, 3, 4}] = 20;
    const NaiveOctree tree(model);
    const auto cast = [&](glm::dvec3 eye, glm::dvec3 direction) {
        return castPerspective(tree.view(), eye, direction);
    };
    PerspectiveHit hit = cast({-10, 3.5, 4.5}, {2, 0, 0});
    EXPECT_EQ(describe(hit.hit), "material 10 at 2,3,4 through axis 0");
    EXPECT_DOUBLE_EQ(hit.t, 12.0);
    hit = cast({20, 3.5, 4.5}, {-1e-9, 0, 0});
    EXPECT_EQ(describe(hit.hit), "material 20 at 6,3,4 through axis 0");
    EXPECT_DOUBLE_EQ(hit.t, 13.0);
    // What lies behind the eye does not count, from inside or outside the box.
    hit = cast({4.5, 3.5, 4.5}, {1, 0, 0});
    EXPECT_EQ(describe(hit.hit), "material 20 at 6,3,4 through axis 0");
    EXPECT_DOUBLE_EQ(hit.t, 1.5);
    hit = cast({4.5, 3.5, 4.5}, {-1, 0, 0});
    EXPECT_EQ(describe(hit.hit), "material 10 at 2,3,4 through axis 0");
    EXPECT_DOUBLE_EQ(hit.t, 1.5);
    EXPECT_EQ(cast({9.0, 3.5, 4.5}, {1, 0, 0}).hit.material, 0);
    EXPECT_EQ(cast({-1.0, 3.5, 4.5}, {-1, 0, 0}).hit.material, 0);
    EXPECT_EQ(cast({7.5, 3.5, 4.5}, {1, 0, 0}).hit.material, 0);
    EXPECT_EQ(cast({8.0, 3.5, 4.5}, {1, 0, 0}).hit.material, 0);
    EXPECT_EQ(cast({8.0, 3.5, 4.5}, {-1, 0, 0}).hit.material, 20);
    EXPECT_EQ(cast({0.0, 3.5, 4.5}, {1, 0, 0}).hit.material, 10);
    // Inside a solid voxel: that voxel, at once.
    hit = cast({6.25, 3.5, 4.75}, {0.3, -0.9, 0.2});
    EXPECT_EQ(describe(hit.hit), "material 20 at 6,3,4 through axis 1");
    EXPECT_EQ(hit.t, 0.0);
    // A slanted ray: t is measured along the normalised direction.
    hit = cast({2.5, 3.5 - 3, 4.5 - 4}, {0, 3, 4});
    EXPECT_EQ(describe(hit.hit), "material 10 at 2,3,4 through axis 2");
    EXPECT_NEAR(hit.t, 3.5 / 4 * 5, 1e-12);
}

TEST(PerspectiveCaster, TheOctreesOriginChangesNothing) {
    const DenseModel model = randomVoxels({13, 9, 11}, 0.1, 3);
    const NaiveOctree canonical(model);
    const NaiveOctree live(model, 4, {3, 5, 1});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 2.0);
    for (int n = 0; n < 20000; ++n) {
        const glm::dvec3 size(model.size);
        const glm::dvec3 eye = size * glm::dvec3(unit(random), unit(random), unit(random));
        const glm::dvec3 target = size * glm::dvec3(unit(random), unit(random), unit(random));
        const PerspectiveHit a = castPerspective(canonical.view(), eye, target - eye);
        const PerspectiveHit b = castPerspective(live.view(), eye, target - eye);
        ASSERT_TRUE(sameHit(a.hit, b.hit));
        ASSERT_EQ(a.t, b.t);
    }
}

TEST(PerspectiveCaster, NothingIsHitWithoutAProperRay) {
    const NaiveOctree tree(solid({4, 4, 4}, 1));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        for (int a = 0; a < 3; ++a) {
            glm::dvec3 broken(1.0);
            broken[a] = bad;
            EXPECT_EQ(castPerspective(tree.view(), broken, {1, 1, 1}).hit.material, 0);
            EXPECT_EQ(castPerspective(tree.view(), {1, 1, 1}, broken).hit.material, 0);
        }
    }
    EXPECT_EQ(castPerspective(tree.view(), {1, 1, 1}, {0, 0, 0}).hit.material, 0);
    EXPECT_EQ(castPerspective(Octree{}.view(), {1, 1, 1}, {1, 0, 0}).hit.material, 0);
    // Extremes that are proper rays.
    EXPECT_EQ(castPerspective(tree.view(), {1e300, 2, 2}, {-1e300, 0, 0}).hit.material, 1);
    EXPECT_EQ(castPerspective(tree.view(), {1e300, 1e300, 1e300}, {-1, -0.5, -1}).hit.material, 0);
    EXPECT_EQ(castPerspective(tree.view(), {-1, 2, 2}, {1e-310, 0, 0}).hit.material, 1);
    EXPECT_EQ(castPerspective(tree.view(), {-1, 2, 2}, {1, 1e-300, -1e-300}).hit.material, 1);
}

}  // namespace
}  // namespace voxprite::test
