#include "core/trace/nearest_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

using Real = long double;

// sin^2 of the angle between f and v, and whether they point to the same side.
Real sineSquared(glm::dvec3 f, glm::ivec3 v) {
    const Real x = Real{f.y} * v.z - Real{f.z} * v.y;
    const Real y = Real{f.z} * v.x - Real{f.x} * v.z;
    const Real z = Real{f.x} * v.y - Real{f.y} * v.x;
    const Real ff = Real{f.x} * f.x + Real{f.y} * f.y + Real{f.z} * f.z;
    const Real vv = Real{1} * v.x * v.x + Real{1} * v.y * v.y + Real{1} * v.z * v.z;
    return (x * x + y * y + z * z) / (ff * vv);
}

Real along(glm::dvec3 f, glm::ivec3 v) {
    return Real{f.x} * v.x + Real{f.y} * v.y + Real{f.z} * v.z;
}

glm::dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return {normal(random), normal(random), normal(random)};
}

TEST(NearestDirection, NoVectorWithinTheBitsIsNearer) {
    std::mt19937 random(1);
    for (int bits = 0; bits <= 4; ++bits) {
        const int reach = 1 << bits;
        for (int n = 0; n < 60; ++n) {
            const glm::dvec3 f = randomDirection(random);
            Real best = 2;
            for (int x = -reach; x <= reach; ++x)
                for (int y = -reach; y <= reach; ++y)
                    for (int z = -reach; z <= reach; ++z)
                        if (const glm::ivec3 v{x, y, z}; along(f, v) > 0)
                            best = std::min(best, sineSquared(f, v));
            const glm::ivec3 found = nearestDirection(f, bits);
            EXPECT_GT(along(f, found), 0);
            EXPECT_NEAR(static_cast<double>(sineSquared(f, found) / best), 1.0, 1e-9)
                << bits << " bits: " << f.x << " " << f.y << " " << f.z;
        }
    }
}

// For 13 bits every scale is tried, and around each rounded vector its 26 neighbours.
TEST(NearestDirection, NoScaleGivesANearerOneAt13Bits) {
    std::mt19937 random(2);
    for (int n = 0; n < 12; ++n) {
        const glm::dvec3 f = randomDirection(random);
        const double largest = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
        Real best = 2;
        for (int scale = 1; scale <= 8192; ++scale) {
            const glm::dvec3 scaled = f * (scale / largest);
            const glm::ivec3 middle(std::lround(scaled.x), std::lround(scaled.y),
                                    std::lround(scaled.z));
            for (int k = 0; k < 27; ++k) {
                const glm::ivec3 v = middle + glm::ivec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                if (v == glm::ivec3(0) || std::abs(v.x) > 8192 || std::abs(v.y) > 8192 ||
                    std::abs(v.z) > 8192)
                    continue;
                best = std::min(best, sineSquared(f, v));
            }
        }
        const Real found = sineSquared(f, nearestDirection(f, 13));
        EXPECT_LE(static_cast<double>(found / best), 1.0 + 1e-6);
        EXPECT_LT(static_cast<double>(std::sqrt(found)), 1e-5);
    }
}

TEST(NearestDirection, AxesAndDiagonalsComeOutAsSmallIntegers) {
    for (const glm::dvec3& direction : canonicalDirections()) {
        const glm::ivec3 want(direction);
        EXPECT_EQ(nearestDirection(direction, 13), want);
        EXPECT_EQ(nearestDirection(glm::normalize(direction), 13), want);
        // As a camera computes them: off by a few units in the last place.
        const glm::dvec3 noisy = glm::normalize(direction) + glm::dvec3(1, -2, 1.5) * 1e-16;
        EXPECT_EQ(nearestDirection(noisy, 13), want);
    }
    EXPECT_EQ(nearestDirection({2, 1, 0}, 13), glm::ivec3(2, 1, 0));
    EXPECT_EQ(nearestDirection({-3, 5, 7}, 13), glm::ivec3(-3, 5, 7));
    EXPECT_EQ(nearestDirection(glm::dvec3(8191, -8192, 1) * 1e-3, 13), glm::ivec3(8191, -8192, 1));
}

TEST(NearestDirection, HasNoCommonDivisorAndStaysWithinTheBits) {
    std::mt19937 random(3);
    for (int n = 0; n < 300; ++n) {
        const glm::ivec3 v = nearestDirection(randomDirection(random), 10);
        EXPECT_EQ(std::gcd(v.x, std::gcd(v.y, v.z)), 1);
        EXPECT_LE(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), 1024);
    }
}

TEST(NearestDirection, FollowsMirrorsAndExchangesOfAxes) {
    std::mt19937 random(4);
    for (int n = 0; n < 100; ++n) {
        const glm::dvec3 f = randomDirection(random);
        const glm::ivec3 v = nearestDirection(f, 13);
        EXPECT_EQ(nearestDirection(-f, 13), -v);
        EXPECT_EQ(nearestDirection({f.x, -f.y, f.z}, 13), glm::ivec3(v.x, -v.y, v.z));
        EXPECT_EQ(nearestDirection({f.z, f.x, f.y}, 13), glm::ivec3(v.z, v.x, v.y));
        EXPECT_EQ(nearestDirection({f.y, f.x, f.z}, 13), glm::ivec3(v.y, v.x, v.z));
        // A power of two changes no digit.
        EXPECT_EQ(nearestDirection(f * 1024.0, 13), v);
    }
}

}  // namespace
}  // namespace voxprite::test
