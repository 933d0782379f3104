// Row 17: does every region of a surface get exactly one cluster?
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/subjects.h"
#include "core/lod/cluster_cut.h"

namespace voxprite::conformance {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// Seed 003: the error on screen by the distance to the sphere's centre.
float literalProjected(float error, glm::vec3 centre, const ClusterView& view) {
    const glm::mat4 world(view.worldFromTree);
    const glm::vec3 at(world * glm::vec4(centre, 1.0f));
    const float distance = glm::length(at - glm::vec3(view.cameraPosition));
    const auto tangent = static_cast<float>(view.tanHalfFovY);
    float scale = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        scale = std::fmax(scale, glm::length(glm::vec3(world[axis])));
    if (distance <= 1e-6f || tangent <= 1e-6f) return kInfinity;
    return error * scale * (static_cast<float>(view.viewportHeightPx) * 0.5f) /
           (distance * tangent);
}

bool literalChooses(const ClusterPage& page, const ClusterView& view) {
    const auto budget = static_cast<float>(view.pixelBudget);
    return literalProjected(page.lodError, page.lodBoundsCentre, view) <= budget &&
           budget < literalProjected(page.parentError, page.parentBoundsCentre, view);
}

glm::dvec3 anyDirection(Sequence& random) {
    // In braces, which are evaluated in order: the same on every machine.
    const glm::dvec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    return glm::normalize(v + 1e-6);
}

// One region: a cluster, what replaces it, and what replaces that, the last a root.
std::vector<ClusterPage> nestedRegion(Sequence& random) {
    std::vector<ClusterPage> region(3);
    glm::dvec3 centre(0.0);
    double radius = 8.0;
    double error = 1.0;
    for (std::size_t i = region.size(); i-- > 0;) {
        ClusterPage& page = region[i];
        page.lodBoundsCentre = glm::vec3(centre);
        page.lodBoundsRadius = static_cast<float>(radius);
        page.lodError = i == 0 ? 0.0f : static_cast<float>(error);
        const bool root = i + 1 == region.size();
        const ClusterPage& above = root ? page : region[i + 1];
        page.parentBoundsCentre = above.lodBoundsCentre;
        page.parentBoundsRadius = above.lodBoundsRadius;
        page.parentError = root ? kInfinity : above.lodError;
        const double within = radius * random.between(0.1, 0.7);
        centre += anyDirection(random) * ((radius - within) * random.between(0.0, 0.999));
        radius = within;
        error /= random.between(2.0, 4.0);
    }
    return region;
}

// Clusters of the region that are chosen, by the seed's rule and by ours.
struct Chosen {
    int literal = 0;
    int ours = 0;
};

Chosen choose(const std::vector<ClusterPage>& region, const ClusterView& view) {
    const ClusterCutParams params = clusterCutParams(view, clusterReach(region), 0);
    Chosen chosen;
    for (const ClusterPage& page : region) {
        chosen.literal += literalChooses(page, view) ? 1 : 0;
        chosen.ours += choosesCluster(page, params) ? 1 : 0;
    }
    return chosen;
}

ClusterView goodView() {
    ClusterView view;
    view.cameraPosition = {3.0, 5.0, 40.0};
    view.tanHalfFovY = 0.5;
    view.viewportHeightPx = 1080.0;
    return view;
}

// Inputs that a renderer may meet in a bad frame, each beside values that are good.
std::vector<ClusterView> badViews(const std::vector<ClusterPage>& region) {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<std::function<void(ClusterView&)>> changes{
        [&](ClusterView& v) { v.cameraPosition = glm::dvec3(region[0].lodBoundsCentre); },
        [&](ClusterView& v) { v.cameraPosition.x = kNoNumber; },
        [&](ClusterView& v) { v.cameraPosition.x = infinity; },
        [&](ClusterView& v) { v.tanHalfFovY = 0.0; },
        [&](ClusterView& v) { v.tanHalfFovY = kNoNumber; },
        [&](ClusterView& v) { v.viewportHeightPx = 0.0; },
        [&](ClusterView& v) { v.viewportHeightPx = kNoNumber; },
        [&](ClusterView& v) { v.pixelBudget = kNoNumber; },
        [&](ClusterView& v) { v.pixelBudget = infinity; },
        [&](ClusterView& v) { v.pixelBudget = -1.0; },
        [&](ClusterView& v) { v.worldFromTree = glm::dmat4(0.0); },
        [&](ClusterView& v) { v.worldFromTree[0][0] = kNoNumber; },
    };
    std::vector<ClusterView> views;
    for (const auto& change : changes) {
        views.push_back(goodView());
        change(views.back());
    }
    return views;
}

}  // namespace

void compareClusters(Comparisons& all) {
    Sequence random(17);
    double literalHoles = 0;
    double ourHoles = 0;
    const std::vector<ClusterPage> region = nestedRegion(random);
    const std::vector<ClusterView> views = badViews(region);
    for (const ClusterView& view : views) {
        const Chosen chosen = choose(region, view);
        literalHoles += chosen.literal != 1 ? 1 : 0;
        ourHoles += chosen.ours != 1 ? 1 : 0;
    }
    all.push_back({17, "cluster_holes", "bad inputs that leave a region without a cluster",
                   literalHoles, ourHoles, 0, "kinds",
                   "of " + std::to_string(views.size()) +
                       ": no number, infinite, zero or negative, the eye in a sphere's centre"});

    constexpr int kGroups = 2000;
    int literalTwice = 0;
    int ourTwice = 0;
    for (int i = 0; i < kGroups; ++i) {
        const std::vector<ClusterPage> groups = nestedRegion(random);
        ClusterView view = goodView();
        const ClusterPage& finest = groups.front();
        view.cameraPosition =
            glm::dvec3(finest.lodBoundsCentre) +
            anyDirection(random) * (finest.lodBoundsRadius * random.between(1.1, 3.0));
        bool literal = false;
        bool ours = false;
        for (double budget = 1.0; budget < 1000.0; budget *= 1.01) {
            view.pixelBudget = budget;
            const Chosen chosen = choose(groups, view);
            literal = literal || chosen.literal != 1;
            ours = ours || chosen.ours != 1;
        }
        literalTwice += literal ? 1 : 0;
        ourTwice += ours ? 1 : 0;
    }
    const auto percent = [](int count) { return 100.0 * count / kGroups; };
    all.push_back(
        {17, "cluster_overlaps", "random groups that some budget shows twice",
         percent(literalTwice), percent(ourTwice), 0, "%",
         "2,000 clusters in spheres in each other, seen from 1.1 to 3 radii of the finest"});
}

}  // namespace voxprite::conformance
