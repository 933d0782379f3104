// Sets of views: their order, their axes, and which of them is nearest.
#include "core/sprite/view_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <tuple>

#include "core/sprite/view_axes.h"
#include "tests/support/must.h"
#include "tests/support/random.h"

namespace voxprite::test {
namespace {

std::vector<ViewSet> allSets() {
    std::vector<ViewSet> sets{ViewSet()};
    for (const int edge : {2, 3, 8, 9, 12, 18, 36, 64}) {
        sets.push_back(must(ViewSet::octahedral(edge)));
        sets.push_back(must(ViewSet::hemisphere(edge)));
    }
    return sets;
}

glm::dvec3 randomDirection(Random& random) {
    while (true) {
        const double x = 2.0 * random.unit() - 1.0;
        const double y = 2.0 * random.unit() - 1.0;
        const glm::dvec3 v{x, y, 2.0 * random.unit() - 1.0};
        const double length = glm::length(v);
        if (length <= 1.0 && length > 0.1) return v / length;
    }
}

// The first of those with the largest product.
int scanned(const ViewSet& set, glm::dvec3 query) {
    int best = 0;
    for (int view = 1; view < set.count(); ++view) {
        if (glm::dot(set.direction(view), query) > glm::dot(set.direction(best), query))
            best = view;
    }
    return best;
}

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

TEST(CanonicalViews, AreTwentySixInTheSnapshotCachesOrder) {
    const ViewSet set;
    ASSERT_EQ(set.count(), 26);
    const glm::ivec3 expected[] = {
        {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},  {0, -1, 0}, {0, 0, 1},    {0, 0, -1},  {-1, -1, 0},
        {-1, 0, -1}, {0, -1, -1}, {-1, 1, 0}, {-1, 0, 1}, {0, -1, 1},   {1, -1, 0},  {1, 0, -1},
        {0, 1, -1},  {1, 1, 0},   {1, 0, 1},  {0, 1, 1},  {-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1},
        {-1, 1, 1},  {1, -1, -1}, {1, -1, 1}, {1, 1, -1}, {1, 1, 1}};
    for (int view = 0; view < 26; ++view) {
        const glm::dvec3 along(expected[view]);
        EXPECT_LT(glm::length(set.direction(view) - along / glm::length(along)), 1e-15) << view;
    }
}

TEST(CanonicalViews, AreDistinctAndCoverAllOctants) {
    const ViewSet set;
    std::set<std::tuple<bool, bool, bool>> octants;
    for (int a = 0; a < set.count(); ++a) {
        const glm::dvec3 v = set.direction(a);
        if (v.x != 0.0 && v.y != 0.0 && v.z != 0.0) octants.insert({v.x > 0, v.y > 0, v.z > 0});
        for (int b = 0; b < a; ++b) EXPECT_GT(glm::length(v - set.direction(b)), 0.5) << a;
    }
    EXPECT_EQ(octants.size(), 8u);
}

TEST(ViewSets, DirectionsAreUnitAndDistinct) {
    for (const ViewSet& set : allSets()) {
        std::set<std::tuple<double, double, double>> seen;
        for (int view = 0; view < set.count(); ++view) {
            const glm::dvec3 v = set.direction(view);
            EXPECT_NEAR(glm::length(v), 1.0, 1e-15);
            seen.insert({std::round(v.x * 1e9), std::round(v.y * 1e9), std::round(v.z * 1e9)});
        }
        EXPECT_EQ(seen.size(), static_cast<std::size_t>(set.count())) << set.name();
    }
}

TEST(ViewSets, AxesAreOrthonormalAndUpright) {
    for (const ViewSet& set : allSets()) {
        for (int view = 0; view < set.count(); ++view) {
            const glm::dmat3 axes = set.axes(view);
            EXPECT_EQ(axes[2], -set.direction(view));
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                    EXPECT_NEAR(glm::dot(axes[a], axes[b]), a == b ? 1.0 : 0.0, 1e-14);
            // right x up = -forward: not mirrored.
            EXPECT_LT(glm::length(glm::cross(axes[0], axes[1]) + axes[2]), 1e-14);
            if (std::abs(axes[2].z) < 0.999999) {
                EXPECT_NEAR(axes[0].z, 0.0, 1e-15);
                EXPECT_GT(axes[1].z, 0.0);
            } else {
                EXPECT_EQ(axes[1], glm::dvec3(1, 0, 0));
            }
        }
    }
}

TEST(ViewSets, HalfSpheresHoldTheHorizonAndTheFourSides) {
    for (const int edge : {2, 8, 12}) {
        const ViewSet set = must(ViewSet::hemisphere(edge));
        for (int view = 0; view < set.count(); ++view) EXPECT_GE(set.direction(view).z, 0.0);
        for (const glm::dvec3 side :
             {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)})
            EXPECT_EQ(set.direction(set.nearest(side).value()), side) << edge;
    }
}

TEST(NearestView, OfAViewIsItself) {
    for (const ViewSet& set : allSets())
        for (int view = 0; view < set.count(); ++view)
            EXPECT_EQ(set.nearest(set.direction(view) * 3.7), view) << set.name();
}

TEST(NearestView, IsTheFirstLargestOfAll) {
    Random random(18);
    for (const ViewSet& set : allSets()) {
        for (int n = 0; n < 4000; ++n) {
            glm::dvec3 query = randomDirection(random);
            if (set.layout() == ViewSet::Layout::hemisphere) query.z = std::abs(query.z);
            // Many on edges and corners of cells, where several are equally near.
            if (n % 4 == 1) query = glm::dvec3(glm::ivec3(query * 4.0));
            if (n % 4 == 2) query[n / 4 % 3] = 0.0;
            if (query == glm::dvec3(0.0)) continue;
            query /= glm::length(query);
            const int nearest = set.nearest(query).value();
            const int expected = scanned(set, query);
            // Two in one direction but for the last bit are one as good as the other.
            if (nearest == expected) continue;
            EXPECT_NEAR(glm::dot(set.direction(nearest), query),
                        glm::dot(set.direction(expected), query), 1e-15)
                << set.name();
        }
    }
}

TEST(NearestView, TiesGoToTheFirstInOrder) {
    const ViewSet set;
    // Between +x, (1,1,0) and ... : halfway from +x to +y both edges and faces tie in pairs.
    const glm::dvec3 between{1.0, std::tan(3.14159265358979323846 / 8.0), 0.0};
    const int nearest = set.nearest(between).value();
    EXPECT_TRUE(nearest == 0 || nearest == 15);
    // Exactly equal: four sides of a half sphere seen from above, four cells of a sphere.
    const ViewSet four = must(ViewSet::hemisphere(2));
    EXPECT_EQ(four.nearest({0, 0, 1}), 0);
    const ViewSet eight = must(ViewSet::octahedral(2));
    EXPECT_EQ(eight.nearest({0, 0, 1}), 0);
    EXPECT_EQ(eight.nearest({0, 0, -1}), 0);
}

TEST(NearestView, BelowAHalfSphereItIsAskedFromTheHorizon) {
    const ViewSet set = must(ViewSet::hemisphere(12));
    Random random(5);
    for (int n = 0; n < 500; ++n) {
        glm::dvec3 query = randomDirection(random);
        query.z = -std::abs(query.z);
        EXPECT_EQ(set.nearest(query), set.nearest({query.x, query.y, 0.0}));
    }
    EXPECT_EQ(set.nearest({0, 0, -1}), set.nearest({0, -1, 0}));
}

TEST(NearestView, WhatHasNoDirectionHasNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const ViewSet& set : allSets()) {
        for (const glm::dvec3 query : {glm::dvec3(0.0), glm::dvec3(nan, 0, 0),
                                       glm::dvec3(0, nan, 1), glm::dvec3(1, 2, infinity)}) {
            EXPECT_FALSE(set.nearest(query));
            EXPECT_FALSE(set.nearest(query, 3));
            EXPECT_TRUE(set.blend(query).empty());
        }
        // Neither overflow nor underflow is a matter of direction.
        EXPECT_EQ(set.nearest({1e300, 2e300, 3e300}), set.nearest({1, 2, 3}));
        EXPECT_EQ(set.nearest({1e-310, 2e-310, 3e-310}), set.nearest({1, 2, 3}));
    }
}

TEST(NearestView, WithHistoryStaysPastTheMiddleByATenthOfTheSpacing) {
    const ViewSet set;
    const double spacing = set.spacing();
    EXPECT_NEAR(spacing, std::sqrt(4.0 * 3.14159265358979323846 / 26.0), 1e-12);
    const auto at = [](double radians) {
        return glm::dvec3(std::cos(radians), std::sin(radians), 0.0);
    };
    const double middle = 3.14159265358979323846 / 8.0;  // between +x and (1, 1, 0)
    EXPECT_EQ(set.nearest(at(middle + 0.01)), 15);
    EXPECT_EQ(set.nearest(at(middle + 0.09 * spacing), 0), 0);
    EXPECT_EQ(set.nearest(at(middle + 0.11 * spacing), 0), 15);
    EXPECT_EQ(set.nearest(at(middle - 0.09 * spacing), 15), 15);
    EXPECT_EQ(set.nearest(at(middle - 0.11 * spacing), 15), 0);
    EXPECT_EQ(set.nearest(at(0.0), 26), 0);  // no such view
}

TEST(ViewSets, HowFarOffTheTrueViewTheyAre) {
    Random random(26);
    const auto measured = [&](const ViewSet& set) {
        double sum = 0.0;
        double worst = 0.0;
        const int tries = 20'000;
        for (int n = 0; n < tries; ++n) {
            glm::dvec3 query = randomDirection(random);
            if (set.layout() == ViewSet::Layout::hemisphere) query.z = std::abs(query.z);
            const double off = degreesBetween(set.direction(set.nearest(query).value()), query);
            sum += off;
            worst = std::max(worst, off);
        }
        return std::pair(sum / tries, worst);
    };
    const auto [mean26, worst26] = measured(ViewSet());
    EXPECT_NEAR(mean26, 15.5, 0.3);
    EXPECT_NEAR(worst26, 27.6, 0.5);
    double before = worst26;
    for (const int edge : {8, 12, 18, 36}) {
        const double worst = measured(must(ViewSet::octahedral(edge))).second;
        EXPECT_LT(worst, before) << edge;
        EXPECT_LT(measured(must(ViewSet::hemisphere(edge))).second, worst) << edge;
        before = worst;
    }
}

TEST(ViewBlend, WeighsTheThreeNearestAndChangesWithoutAStep) {
    Random random(33);
    for (const ViewSet& set : {ViewSet(), must(ViewSet::octahedral(8))}) {
        glm::dvec3 query{1, 0, 0};
        std::vector<double> before;
        for (int n = 0; n < 4000; ++n) {
            query = glm::normalize(query + randomDirection(random) * 1e-4 +
                                   glm::dvec3(0.0, 1.1e-3, 0.7e-3) * query.x -
                                   glm::dvec3(1.1e-3, 0.0, 0.0) * query.y);
            std::vector<double> weights(static_cast<std::size_t>(set.count()), 0.0);
            double sum = 0.0;
            for (const ViewSet::Weighted& one : set.blend(query)) {
                weights[static_cast<std::size_t>(one.view)] = one.weight;
                sum += one.weight;
                EXPECT_GT(one.weight, 0.0);
            }
            EXPECT_NEAR(sum, 1.0, 1e-12);
            EXPECT_EQ(set.blend(query).front().view, scanned(set, query));
            for (std::size_t k = 0; k < before.size(); ++k)
                EXPECT_NEAR(weights[k], before[k], 0.06) << set.name() << " step " << n;
            before = weights;
        }
        for (int view = 0; view < set.count(); ++view) {
            const auto alone = set.blend(set.direction(view));
            EXPECT_EQ(alone.front().view, view);
            EXPECT_GT(alone.front().weight, 1.0 - 1e-6);
        }
    }
}

// Against every turn there is, by tenths of a degree, on points of the box.
TEST(RolledToMatch, DrawsTheBoxsPointsNearTheirPlaces) {
    Random random(77);
    const ViewSet set;
    for (int n = 0; n < 20; ++n) {
        const glm::ivec3 size = random.voxel(1, 40);
        const glm::dvec3 forward = -randomDirection(random);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, randomDirection(random)));
        const glm::dmat3 seen(right, glm::cross(right, forward), forward);
        const glm::dmat3 shown = set.axes(set.nearest(-forward).value());
        std::vector<glm::dvec3> points;
        for (int k = 0; k < 200; ++k) {
            // Both ways along each axis, so that the axes are independent as in the whole box.
            const double x = (random.unit() - 0.5) * size.x;
            const double y = (random.unit() - 0.5) * size.y;
            const double z = (random.unit() - 0.5) * size.z;
            for (int octant = 0; octant < 8; ++octant)
                points.emplace_back((octant & 1) != 0 ? x : -x, (octant & 2) != 0 ? y : -y,
                                    (octant & 4) != 0 ? z : -z);
        }
        // The plane's axes are the world's: drawn and true places are its x and y.
        const auto off = [&](const glm::dmat3& plane) {
            double sum = 0.0;
            for (const glm::dvec3& point : points) {
                const glm::dvec3 drawn =
                    plane[0] * glm::dot(shown[0], point) + plane[1] * glm::dot(shown[1], point);
                const glm::dvec2 gap{drawn.x - glm::dot(seen[0], point),
                                     drawn.y - glm::dot(seen[1], point)};
                sum += glm::dot(gap, gap);
            }
            return sum / static_cast<double>(points.size());
        };
        const double ours = off(rolledToMatch(glm::dmat3(1.0), seen, shown, size));
        double least = ours;
        for (int tenth = 0; tenth < 3600; ++tenth) {
            const double angle = tenth * 3.14159265358979323846 / 1800.0;
            const glm::dvec3 turned{std::cos(angle), std::sin(angle), 0.0};
            const glm::dvec3 up{-turned.y, turned.x, 0.0};
            least = std::min(least, off({turned, up, glm::dvec3(0, 0, 1)}));
        }
        // What is random about the points aside.
        EXPECT_LE(ours, least * 1.02 + 1e-3 * glm::dot(glm::dvec3(size), glm::dvec3(size)));
    }
    // Something tall stays upright, whatever the view.
    const glm::dmat3 seen = set.axes(0);
    const glm::dmat3 tall = rolledToMatch(seen, seen, set.axes(25), {1, 1, 1000});
    EXPECT_NEAR(tall[1].z, 1.0, 1e-5);
    EXPECT_LT(rolledToMatch(seen, seen, set.axes(25), {1, 1, 1})[1].z, 0.99);
    EXPECT_EQ(rolledToMatch(seen, seen, seen, {4, 5, 6}), seen);
}

TEST(ViewSets, NamesAreReadAsTheyAreWritten) {
    for (const ViewSet& set : allSets()) {
        const ViewSet again = must(ViewSet::named(set.name()));
        EXPECT_EQ(again.name(), set.name());
        EXPECT_EQ(again.count(), set.count());
        EXPECT_EQ(again.direction(set.count() - 1), set.direction(set.count() - 1));
    }
    for (const char* name :
         {"", "canonical", "canonical26:3", "octahedral", "octahedral:", "octahedral:1",
          "octahedral:65", "octahedral:8x", "hemisphere:-8", "hemisphere: 8", "cube:4"})
        EXPECT_FALSE(ViewSet::named(name)) << name;
    EXPECT_FALSE(ViewSet::octahedral(1));
    EXPECT_FALSE(ViewSet::hemisphere(65));
}

}  // namespace
}  // namespace voxprite::test
