#include "tests/core/lod/nested_groups.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

namespace voxprite::test {
namespace {

struct Group {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
    float error = 0.0f;
};

glm::dvec3 randomDirection(Random& random) {
    for (;;) {
        const glm::dvec3 v(random.unit() * 2 - 1, random.unit() * 2 - 1, random.unit() * 2 - 1);
        if (const double length = glm::length(v); length > 0.1 && length <= 1.0) return v / length;
    }
}

Group within(Random& random, const Group& parent) {
    Group child;
    const double share = random.chance(0.2) ? 0.01 : 0.3 + 0.7 * random.unit();
    child.radius = static_cast<float>(parent.radius * share);
    // Often touching the parent's sphere from within.
    const double room = static_cast<double>(parent.radius) - static_cast<double>(child.radius);
    const double apart = room * (random.chance(0.5) ? 1.0 : random.unit());
    child.centre = glm::vec3(glm::dvec3(parent.centre) + randomDirection(random) * apart);
    const double factor = random.chance(0.5) ? 2.0 : 2.0 + 1000.0 * random.unit() * random.unit();
    child.error = static_cast<float>(parent.error / factor);
    return child;
}

ClusterPage page(const Group& own, const Group* parents) {
    ClusterPage page;
    page.centre = page.lodBoundsCentre = own.centre;
    page.radius = page.lodBoundsRadius = own.radius;
    page.lodError = own.error;
    const Group& above = parents != nullptr ? *parents : own;
    page.parentBoundsCentre = above.centre;
    page.parentBoundsRadius = above.radius;
    page.parentError = parents != nullptr ? parents->error : std::numeric_limits<float>::infinity();
    page.indexCount = 3;
    return page;
}

class Grower {
  public:
    Grower(Random& random, NestedGroups& out) : random_(random), out_(out) {}

    // The clusters that `group` was made from, below those that stand for it (`above`, coarsest
    // last).
    void grow(const Group& group, int levels, const std::vector<std::uint32_t>& above) {
        for (int child = random_.between(1, 3); child > 0; --child) {
            Group own = within(random_, group);
            const bool finest = levels == 0 || own.error < 1e-5f || random_.chance(0.1);
            if (finest) own.error = 0.0f;
            std::vector<std::uint32_t> way{static_cast<std::uint32_t>(out_.pages.size())};
            out_.pages.push_back(page(own, &group));
            way.insert(way.end(), above.begin(), above.end());
            if (finest) {
                out_.regions.push_back(way);
            } else {
                grow(own, levels - 1, way);
            }
        }
    }

  private:
    Random& random_;
    NestedGroups& out_;
};

}  // namespace

NestedGroups randomGroups(Random& random, int levels) {
    NestedGroups groups;
    Group root;
    root.centre = glm::vec3(randomDirection(random) * (random.unit() * 200.0));
    root.radius = static_cast<float>(1.0 + 99.0 * random.unit());
    root.error = static_cast<float>(root.radius * (0.1 + random.unit()));
    groups.pages.push_back(page(root, nullptr));
    Grower(random, groups).grow(root, levels, {0});
    return groups;
}

std::vector<ClusterPage> threeLevels() {
    const auto cluster = [](float lodError, float parentError, std::uint32_t triangles) {
        ClusterPage page;
        page.radius = page.lodBoundsRadius = page.parentBoundsRadius = 1.0f;
        page.lodError = lodError;
        page.parentError = parentError;
        page.indexCount = 3 * triangles;
        return page;
    };
    const float infinite = std::numeric_limits<float>::infinity();
    return {cluster(0, 1, 10), cluster(0, 1, 10), cluster(0, 1, 10),      cluster(0, 1, 10),
            cluster(1, 2, 12), cluster(1, 2, 12), cluster(2, infinite, 8)};
}

Coverage coverage(const NestedGroups& groups, std::span<const std::uint32_t> cut) {
    const std::set<std::uint32_t> chosen(cut.begin(), cut.end());
    Coverage result;
    for (const std::vector<std::uint32_t>& region : groups.regions) {
        int count = 0;
        for (const std::uint32_t page : region) count += chosen.contains(page) ? 1 : 0;
        if (count == 0) ++result.holes;
        if (count > 1) ++result.overlaps;
    }
    return result;
}

}  // namespace voxprite::test
