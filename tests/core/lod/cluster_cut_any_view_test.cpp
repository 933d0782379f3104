// The cut against everything a view may be made of, with the seed's own words as the rival.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <string>

#include "core/lod/cluster_cut.h"
#include "core/lod/validate_clusters.h"
#include "tests/core/lod/literal_cut.h"
#include "tests/core/lod/nested_groups.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::Random;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kNan64 = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity64 = std::numeric_limits<double>::infinity();

std::vector<std::uint32_t> cutOf(std::span<const ClusterPage> pages, const ClusterView& view) {
    std::vector<std::uint32_t> out;
    selectCutPerCluster(
        pages,
        clusterCutParams(view, clusterReach(pages), static_cast<std::uint32_t>(pages.size())), out);
    return out;
}

ClusterView viewFrom(glm::dvec3 camera) {
    ClusterView view;
    view.cameraPosition = camera;
    view.tanHalfFovY = 0.5;
    view.viewportHeightPx = 1080.0;
    return view;
}

// Named views that break the seed's rule on any clusters at all.
std::map<std::string, ClusterView> impossibleViews() {
    const ClusterView good = viewFrom({0, 0, 5});
    std::map<std::string, ClusterView> views;
    const auto add = [&](const char* name, auto&& change) {
        ClusterView view = good;
        change(view);
        views[name] = view;
    };
    add("camera in the sphere's centre", [](auto& v) { v.cameraPosition = {0, 0, 0}; });
    add("camera is no number", [](auto& v) { v.cameraPosition.y = kNan64; });
    add("camera infinitely far", [](auto& v) { v.cameraPosition.y = kInfinity64; });
    add("no field of view", [](auto& v) { v.tanHalfFovY = 0.0; });
    add("a negative field of view", [](auto& v) { v.tanHalfFovY = -1.0; });
    add("field of view is no number", [](auto& v) { v.tanHalfFovY = kNan64; });
    add("an infinite budget", [](auto& v) { v.pixelBudget = kInfinity64; });
    add("a negative budget", [](auto& v) { v.pixelBudget = -1.0; });
    add("budget is no number", [](auto& v) { v.pixelBudget = kNan64; });
    add("a matrix of zeros", [](auto& v) { v.worldFromTree = glm::dmat4(0.0); });
    add("the matrix is no number", [](auto& v) { v.worldFromTree[1][1] = kNan64; });
    add("an infinite matrix", [](auto& v) { v.worldFromTree[1][1] = kInfinity64; });
    add("a viewport without height", [](auto& v) { v.viewportHeightPx = 0.0; });
    add("a viewport height that is no number", [](auto& v) { v.viewportHeightPx = kNan64; });
    return views;
}

test::LiteralView literalOf(const ClusterView& view) {
    return {glm::mat4(view.worldFromTree), glm::vec3(view.cameraPosition),
            static_cast<float>(view.tanHalfFovY), static_cast<float>(view.viewportHeightPx),
            static_cast<float>(view.pixelBudget)};
}

TEST(SelectCutPerCluster, NoInputLeavesAHole) {
    test::NestedGroups groups;
    groups.pages = test::threeLevels();
    for (std::uint32_t finest = 0; finest < 4; ++finest)
        groups.regions.push_back({finest, 4 + finest / 2, 6});
    int literalHoles = 0;
    for (const auto& [name, view] : impossibleViews()) {
        const test::Coverage ours = coverage(groups, cutOf(groups.pages, view));
        EXPECT_EQ(ours.holes, 0) << name;
        EXPECT_EQ(ours.overlaps, 0) << name;
        if (coverage(groups, literalCut(groups.pages, literalOf(view))).holes == 4) ++literalHoles;
    }
    EXPECT_GE(literalHoles, 8);
}

// Whatever a view may be made of.
ClusterView adversarialView(Random& random, const test::NestedGroups& groups) {
    const auto any = [&](std::initializer_list<double> values) {
        return values.begin()[random.between(0, static_cast<int>(values.size()) - 1)];
    };
    const auto signedUnit = [&] { return random.unit() * 2 - 1; };
    ClusterView view;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) view.worldFromTree[i][j] = i == j ? 1.0 : 0.0;
    }
    const int shape = random.between(0, 3);
    if (shape > 0) {  // any linear map, sheared and mirrored, or far too large or small
        const double size = shape == 1 ? 1.0 : std::exp2(signedUnit() * (shape == 2 ? 8 : 60));
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) view.worldFromTree[i][j] = size * signedUnit();
        }
    }
    const double away = any({0.0, 1.0, 1e3, 1e6, 1e9, 1e13, 1e17});
    view.worldFromTree[3] = {away * signedUnit(), away * signedUnit(), away * signedUnit(), 1.0};
    // Somewhere about a random cluster: in its centre, on its surface, a little or far away.
    const ClusterPage& page = groups.pages[random.next() % groups.pages.size()];
    const glm::dvec3 direction(signedUnit(), signedUnit(), signedUnit());
    const double reach = any({0.0, 1e-6, 0.5, 1.0, 1.0, 1.0 + 1e-6, 1.001, 2.0, 30.0, 1e5, 1e30});
    const glm::dvec3 point = glm::dvec3(page.lodBoundsCentre) +
                             glm::normalize(direction + 1e-9) * (reach * page.lodBoundsRadius);
    view.cameraPosition = glm::dvec3(view.worldFromTree * glm::dvec4(point, 1.0));
    view.tanHalfFovY =
        any({0.5, 0.5, 1.0, 1e-3, 1e-9, 1e-300, 1e9, 0.0, -1.0, kNan64, kInfinity64});
    view.viewportHeightPx = any({1080, 1080, 100, 1, 1e-9, 1e12, 0.0, -5.0, kNan64, kInfinity64});
    view.nearDistance = any({1e-3, 1.0, 0.0, -1.0, 1e30, kNan64, kInfinity64});
    if (random.chance(0.1)) view.orthographicHalfHeight = any({1.0, 1e-20, 1e20, kInfinity64});
    if (random.chance(0.05)) view.cameraPosition.x = any({kNan64, kInfinity64, 1e300});
    if (random.chance(0.05)) view.worldFromTree[2][1] = any({kNan64, kInfinity64, 1e300, 1e-300});
    // Often right at an error of the cut.
    view.pixelBudget = any({1.0, 0.3, 10.0, 0.0, 1e-30, 1e30, -1.0, kNan64, kInfinity64});
    if (random.chance(0.6)) {
        const ClusterPage& limit = groups.pages[random.next() % groups.pages.size()];
        const ClusterCutParams params = clusterCutParams(view, clusterReach(groups.pages), 0);
        const float at = clusterProjectedError(limit.lodError, limit.lodBoundsCentre,
                                               limit.lodBoundsRadius, params);
        const int side = random.between(-1, 1);
        view.pixelBudget =
            static_cast<double>(side == 0 ? at : std::nextafter(at, side > 0 ? kInfinity : 0.0f));
    }
    return view;
}

// The rule as another machine may compute it: products and sums fused, square roots and divisions
// off by some units in the last place.
bool choosesElsewhere(const ClusterPage& page, const ClusterCutParams& params, Random& random) {
    const auto off = [&](float value) {
        if (value == 0.0f || std::isinf(value)) return value;  // exact everywhere
        for (int ulps = random.between(0, 3); ulps > 0; --ulps)
            value = std::nextafter(value, random.chance(0.5) ? kInfinity : 0.0f);
        return value;
    };
    const auto projected = [&](float error, glm::vec3 centre, float radius) {
        const glm::mat4& m = params.worldFromTree;
        glm::vec3 world(m[3]);
        for (int axis = 2; axis >= 0; --axis) {
            for (int i = 0; i < 3; ++i) world[i] = std::fma(m[axis][i], centre[axis], world[i]);
        }
        const glm::vec3 d = world - params.cameraPosition;
        const float length = off(std::sqrt(std::fma(d.x, d.x, std::fma(d.y, d.y, d.z * d.z))));
        const float distance =
            std::fmax(std::fma(-radius, params.worldScale, length), params.nearDistance());
        return off(error * (params.worldScale * params.viewportHeight * 0.5f) /
                   (distance * params.tanHalfFovY));
    };
    // A group's error is computed alike for all its clusters: from the same numbers, by the same
    // instructions.
    const auto seedOf = [](glm::vec3 c, float e) {
        return std::bit_cast<std::uint32_t>(c.x) ^ std::bit_cast<std::uint32_t>(c.y) * 3u ^
               std::bit_cast<std::uint32_t>(e) * 5u;
    };
    random = Random(seedOf(page.lodBoundsCentre, page.lodError));
    const float own = projected(page.lodError, page.lodBoundsCentre, page.lodBoundsRadius);
    random = Random(seedOf(page.parentBoundsCentre, page.parentError));
    const float parents =
        projected(page.parentError, page.parentBoundsCentre, page.parentBoundsRadius);
    return own <= params.pixelBudget && params.pixelBudget < parents;
}

TEST(SelectCutPerCluster, ExactlyOneClusterARegionWhateverTheView) {
    Random random(17);
    std::int64_t regions = 0;
    std::int64_t levelsUsed[2] = {0, 0};  // the finest; coarser ones
    for (int round = 0; round < 60; ++round) {
        const auto groups = test::randomGroups(random, 5);
        const Status valid = validateClusters(groups.pages, 3);
        ASSERT_TRUE(valid) << valid.error().message;
        for (int views = 0; views < 100; ++views) {
            const ClusterView view = adversarialView(random, groups);
            const ClusterCutParams params = clusterCutParams(
                view, clusterReach(groups.pages), static_cast<std::uint32_t>(groups.pages.size()));
            std::vector<std::uint32_t> cut;
            selectCutPerCluster(groups.pages, params, cut);
            const test::Coverage ours = coverage(groups, cut);
            ASSERT_EQ(ours.holes, 0) << "round " << round << " view " << views;
            ASSERT_EQ(ours.overlaps, 0) << "round " << round << " view " << views;
            for (const std::uint32_t i : cut) ++levelsUsed[groups.pages[i].lodError > 0 ? 1 : 0];

            std::vector<std::uint32_t> elsewhere;
            Random rounding(0);
            for (std::uint32_t i = 0; i < groups.pages.size(); ++i) {
                if (choosesElsewhere(groups.pages[i], params, rounding)) elsewhere.push_back(i);
            }
            const test::Coverage theirs = coverage(groups, elsewhere);
            ASSERT_EQ(theirs.holes, 0) << "round " << round << " view " << views;
            ASSERT_EQ(theirs.overlaps, 0) << "round " << round << " view " << views;
            regions += static_cast<std::int64_t>(groups.regions.size());
        }
    }
    EXPECT_GT(regions, 100'000);
    EXPECT_GT(levelsUsed[0], 1000);
    EXPECT_GT(levelsUsed[1], 1000);
}

// Good views, so that nothing is wrong but the seed's measure of distance.
TEST(SelectCutPerCluster, DistancesOfCentresShowRegionsTwiceFromGoodViews) {
    Random random(23);
    int doubled = 0;
    for (int round = 0; round < 1000; ++round) {
        const auto groups = test::randomGroups(random, 4);
        const auto anyPage = [&]() -> const ClusterPage& {
            return groups.pages[random.next() % groups.pages.size()];
        };
        // Outside some cluster's sphere, with a budget that some error just exceeds.
        const ClusterPage& near = anyPage();
        const glm::dvec3 direction(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
        ClusterView view =
            viewFrom(glm::dvec3(near.lodBoundsCentre) +
                     glm::normalize(direction) * (near.lodBoundsRadius * (1.01 + random.unit())));
        const ClusterPage& limit = anyPage();
        view.pixelBudget = 0.999 * static_cast<double>(test::literalProjected(
                                       limit.lodError, limit.lodBoundsCentre, literalOf(view)));
        const test::Coverage ours = coverage(groups, cutOf(groups.pages, view));
        EXPECT_EQ(ours.holes + ours.overlaps, 0);
        if (coverage(groups, literalCut(groups.pages, literalOf(view))).overlaps > 0) ++doubled;
    }
    EXPECT_GT(doubled, 20);
}

TEST(SelectCutPerCluster, MoreToleranceNeverTakesFinerClusters) {
    Random random(29);
    for (int round = 0; round < 50; ++round) {
        const auto groups = test::randomGroups(random, 5);
        ClusterView view = viewFrom(
            {random.unit() * 400 - 200, random.unit() * 400 - 200, random.unit() * 400 - 200});
        std::size_t before = groups.pages.size() + 1;
        for (double budget = 0.001; budget < 1e9; budget *= 3) {
            view.pixelBudget = budget;
            const std::size_t clusters = cutOf(groups.pages, view).size();
            EXPECT_LE(clusters, before);
            before = clusters;
        }
        // Beyond the errors of all, also for an eye within a cluster.
        EXPECT_EQ(before, 1u);
    }
}

}  // namespace
}  // namespace voxprite
