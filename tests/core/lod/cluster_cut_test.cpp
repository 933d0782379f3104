#include "core/lod/cluster_cut.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/core/lod/literal_cut.h"
#include "tests/core/lod/nested_groups.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::Random;
using testing::ElementsAre;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kNan64 = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity64 = std::numeric_limits<double>::infinity();

std::vector<std::uint32_t> uniformCut(std::span<const ClusterPage> pages, float threshold) {
    std::vector<std::uint32_t> out;
    selectCut(pages, threshold, out);
    return out;
}

std::vector<std::uint32_t> cutOf(std::span<const ClusterPage> pages, const ClusterView& view) {
    std::vector<std::uint32_t> out;
    selectCutPerCluster(
        pages,
        clusterCutParams(view, clusterReach(pages), static_cast<std::uint32_t>(pages.size())), out);
    return out;
}

std::uint32_t trianglesOf(std::span<const ClusterPage> pages,
                          const std::vector<std::uint32_t>& cut) {
    std::uint32_t triangles = 0;
    for (const std::uint32_t i : cut) triangles += pages[i].indexCount / 3;
    return triangles;
}

ClusterView viewFrom(glm::dvec3 camera) {
    ClusterView view;
    view.cameraPosition = camera;
    view.tanHalfFovY = 0.5;
    view.viewportHeightPx = 1080.0;
    return view;
}

TEST(SelectCut, AThresholdOfZeroIsTheFinestLevel) {
    const auto pages = test::threeLevels();
    EXPECT_THAT(uniformCut(pages, 0.0f), ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(trianglesOf(pages, uniformCut(pages, 0.0f)), 40u);
}

TEST(SelectCut, BetweenTwoErrorsIsTheMiddleLevelAndBeyondAllTheRoot) {
    const auto pages = test::threeLevels();
    EXPECT_THAT(uniformCut(pages, 1.5f), ElementsAre(4, 5));
    EXPECT_THAT(uniformCut(pages, 5.0f), ElementsAre(6));
}

TEST(SelectCut, IntervalsHoldTheirLowerEndAndNotTheirUpper) {
    const auto pages = test::threeLevels();
    EXPECT_THAT(uniformCut(pages, 1.0f), ElementsAre(4, 5));
    EXPECT_THAT(uniformCut(pages, std::nextafter(1.0f, 0.0f)), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(uniformCut(pages, 2.0f), ElementsAre(6));
    for (std::uint32_t i = 0; i < pages.size(); ++i) {
        EXPECT_THAT(uniformCut(pages, pages[i].lodError), testing::Contains(i));
    }
}

TEST(SelectCut, MoreToleranceNeverTakesMoreTriangles) {
    const auto pages = test::threeLevels();
    std::uint32_t before = std::numeric_limits<std::uint32_t>::max();
    for (const float threshold : {0.0f, 0.5f, 1.0f, 1.5f, 2.0f, 3.0f, 100.0f}) {
        const std::uint32_t triangles = trianglesOf(pages, uniformCut(pages, threshold));
        EXPECT_GT(triangles, 0u);
        EXPECT_LE(triangles, before);
        before = triangles;
    }
}

TEST(SelectCut, ThresholdsThatAreNoneAreTheNearestThatIs) {
    const auto pages = test::threeLevels();
    EXPECT_THAT(uniformCut(pages, -1.0f), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(uniformCut(pages, kNan), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(uniformCut(pages, kInfinity), ElementsAre(6));
}

TEST(SelectCut, ClearsItsOutputAndKeepsItsMemory) {
    const auto pages = test::threeLevels();
    std::vector<std::uint32_t> out(100, 77);
    const std::uint32_t* memory = out.data();
    selectCut(pages, 0.0f, out);
    EXPECT_THAT(out, ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(out.data(), memory);
    selectCutPerCluster(pages, clusterCutParams(viewFrom({0, 0, 1e6}), 1.0, 7), out);
    EXPECT_THAT(out, ElementsAre(6));
    EXPECT_EQ(out.data(), memory);
}

TEST(InstanceErrorThreshold, GrowsWithTheDistanceOfTheSurface) {
    const auto at = [](double z) {
        return instanceErrorThreshold(glm::vec3(0.0f), 1.0f,
                                      clusterCutParams(viewFrom({0, 0, z}), 1.0, 1));
    };
    // 1 px * (z - 1) * 0.5 / 540.
    EXPECT_FLOAT_EQ(at(2.0), 0.5f / 540.0f);
    EXPECT_FLOAT_EQ(at(51.0), 25.0f / 540.0f);
    const auto pages = test::threeLevels();
    EXPECT_LE(trianglesOf(pages, uniformCut(pages, at(5000.0))),
              trianglesOf(pages, uniformCut(pages, at(2.0))));
    // A scale of 2 halves it: 1 px * (51 - 2) * 0.5 / (2 * 540).
    ClusterView large = viewFrom({0, 0, 51});
    large.worldFromTree = glm::dmat4(2.0);
    large.worldFromTree[3][3] = 1.0;
    EXPECT_FLOAT_EQ(instanceErrorThreshold(glm::vec3(0.0f), 1.0f, clusterCutParams(large, 1.0, 1)),
                    24.5f / 1080.0f);
}

TEST(InstanceErrorThreshold, IsAlwaysAThreshold) {
    ClusterView view = viewFrom({0, 0, 2});
    view.tanHalfFovY = 0.0;
    const auto threshold = [&] {
        return instanceErrorThreshold(glm::vec3(0.0f), 1.0f, clusterCutParams(view, 1.0, 1));
    };
    EXPECT_EQ(threshold(), 0.0f);
    view.tanHalfFovY = 0.5;
    view.worldFromTree = glm::dmat4(0.0);
    EXPECT_GE(threshold(), 0.0f);
    EXPECT_TRUE(std::isfinite(threshold()));
    view.pixelBudget = kInfinity64;
    EXPECT_TRUE(std::isfinite(threshold()));
    view.cameraPosition.x = kNan64;
    EXPECT_EQ(threshold(), 0.0f);
}

TEST(InstanceErrorThreshold, IsNowhereCoarserThanTheCutByClusters) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        const auto groups = test::randomGroups(random, 4);
        const ClusterPage& root = groups.pages[0];
        ClusterView view = viewFrom(
            {random.unit() * 2000 - 1000, random.unit() * 2000 - 1000, random.unit() * 2000});
        view.pixelBudget = 20.0 * random.unit();
        const ClusterCutParams params = clusterCutParams(view, clusterReach(groups.pages), 0);
        // A hair less, for what is exactly at the budget.
        const float threshold =
            0.99999f * instanceErrorThreshold(root.lodBoundsCentre, root.lodBoundsRadius, params);
        for (const std::uint32_t i : uniformCut(groups.pages, threshold)) {
            const ClusterPage& page = groups.pages[i];
            EXPECT_LE(clusterProjectedError(page.lodError, page.lodBoundsCentre,
                                            page.lodBoundsRadius, params),
                      params.pixelBudget);
        }
    }
}

TEST(ProjectedError, IsTheErrorsHeightOnScreenAtTheSpheresSurface) {
    const ClusterCutParams params = clusterCutParams(viewFrom({0, 0, 11}), 3.0, 1);
    // Half the screen, 540 px, shows 0.5 units at a distance of 1.
    EXPECT_FLOAT_EQ(clusterProjectedError(0.25f, {0, 0, 0}, 1.0f, params),
                    0.25f * 540 / (10 * 0.5));
    EXPECT_EQ(clusterProjectedError(0.0f, {0, 0, 0}, 1.0f, params), 0.0f);
    EXPECT_EQ(clusterProjectedError(kInfinity, {0, 0, 0}, 1.0f, params), kInfinity);
    // Inside the sphere the near distance counts.
    ClusterView inside = viewFrom({0, 0, 0.5});
    inside.nearDistance = 0.125;
    EXPECT_FLOAT_EQ(clusterProjectedError(0.25f, {0, 0, 0}, 1.0f, clusterCutParams(inside, 3.0, 1)),
                    0.25f * 540 / (0.125f * 0.5f));
}

TEST(ProjectedError, GoesByTheSurfaceWhereTheSeedGoesByTheCentre) {
    // A child at the near end of its parent: by centres, the parent's error of 1.5 looks smaller
    // than the child's error of 1.
    ClusterPage child;
    child.lodError = 1.0f;
    child.lodBoundsCentre = {0, 0, 9};
    child.lodBoundsRadius = 1.0f;
    test::LiteralView literal;
    literal.camera = {0, 0, 12};
    EXPECT_LT(test::literalProjected(1.5f, {0, 0, 0}, literal),
              test::literalProjected(1.0f, child.lodBoundsCentre, literal));
    const ClusterCutParams params = clusterCutParams(viewFrom({0, 0, 12}), 10.0, 1);
    EXPECT_GT(clusterProjectedError(1.5f, {0, 0, 0}, 10.0f, params),
              clusterProjectedError(1.0f, child.lodBoundsCentre, 1.0f, params));
}

TEST(ProjectedError, OfOrthographicCamerasKnowsNoDistance) {
    ClusterView view = viewFrom({0, 0, 11});
    view.orthographicHalfHeight = 4.0;
    for (const double z : {0.0, 11.0, 1e6}) {
        view.cameraPosition.z = z;
        const ClusterCutParams params = clusterCutParams(view, 3.0, 1);
        EXPECT_FLOAT_EQ(clusterProjectedError(0.25f, {1, 2, 3}, 1.0f, params), 0.25f * 540 / 4);
    }
}

TEST(ProjectedError, TenThousandKilometresAwayNothingChanges) {
    ClusterView near = viewFrom({3, 4, 12});
    ClusterView far = near;
    const glm::dvec3 offset(1e7, -2e7, 3e7);
    far.cameraPosition += offset;
    far.worldFromTree[3] += glm::dvec4(offset, 0.0);
    const auto projected = [](const ClusterView& view) {
        return clusterProjectedError(1.0f, {0, 0, 0}, 1.0f, clusterCutParams(view, 1.0, 1));
    };
    EXPECT_EQ(projected(far), projected(near));
}

TEST(SelectCutPerCluster, DetailVariesWithinOneModel) {
    // Two places, one near and one far, each with a fine cluster and its coarse replacement.
    std::vector<ClusterPage> pages;
    for (const float x : {0.0f, 100.0f}) {
        ClusterPage fine;
        fine.centre = fine.lodBoundsCentre = fine.parentBoundsCentre = {x, 0, 0};
        fine.radius = fine.lodBoundsRadius = fine.parentBoundsRadius = 1.0f;
        fine.parentError = 0.1f;
        fine.indexCount = 300;
        ClusterPage coarse = fine;
        coarse.lodError = 0.1f;
        coarse.parentError = kInfinity;
        coarse.indexCount = 90;
        pages.push_back(fine);
        pages.push_back(coarse);
    }
    ClusterView view = viewFrom({0, 0, 3});
    view.pixelBudget = 2.0;
    EXPECT_THAT(cutOf(pages, view), ElementsAre(0, 3));
}

TEST(MaxAxisScale, IsTheLongestAxis) {
    glm::dmat4 m(1.0);
    m[0] = {0, 2, 0, 0};
    m[1] = {-5, 0, 0, 0};
    m[2] = {0, 0, 3, 0};
    m[3] = {70, 80, 90, 1};
    EXPECT_DOUBLE_EQ(maxAxisScale(m), 5.0);
    EXPECT_DOUBLE_EQ(maxAxisScale(glm::dmat4(2.0)), 2.0);
    EXPECT_EQ(maxAxisScale(glm::dmat4(0.0)), 0.0);
    m[1].x = kNan64;
    EXPECT_TRUE(std::isnan(maxAxisScale(m)));
}

TEST(MaxAxisScale, IsNeverLessThanTheMapStretches) {
    Random random(3);
    const auto any = [&] { return random.unit() * 2 - 1; };
    int longestAxisWasTooLittle = 0;
    for (int round = 0; round < 2000; ++round) {
        glm::dmat4 m(1.0);
        for (int i = 0; i < 3; ++i) m[i] = {any(), any(), any(), 0};
        const glm::dvec3 v(any(), any(), any());
        const double stretch = glm::length(glm::dmat3(m) * v) / glm::length(v);
        EXPECT_LE(stretch, maxAxisScale(m) * (1 + 1e-12));
        if (stretch > static_cast<double>(test::literalScale(glm::mat4(m))))
            ++longestAxisWasTooLittle;
    }
    EXPECT_GT(longestAxisWasTooLittle, 0);
}

}  // namespace
}  // namespace voxprite
