#include "core/lod/validate_clusters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

namespace voxprite {
namespace {

constexpr double kMost = 1e6;
constexpr double kLeastError = 1e-6;
// How far a sphere may stick out of its parents' group's, of what both reach from the origin:
// their centres and radii are rounded, too.
constexpr double kSphereRounding = 0x1p-20;

Failure failAtPage(std::size_t page, const std::string& what) {
    return failAtByte(page * kClusterPageBytes, "cluster " + std::to_string(page) + " " + what);
}

// What a group of clusters shares: the bits of its error and its sphere.
using GroupKey = std::array<std::uint32_t, 5>;

GroupKey keyOf(float error, glm::vec3 centre, float radius) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return {bits(error), bits(centre.x), bits(centre.y), bits(centre.z), bits(radius)};
}

bool isSphere(glm::vec3 centre, float radius) {
    return radius >= 0.0f && glm::length(glm::dvec3(centre)) + radius <= kMost;
}

Status checkPage(const ClusterPage& page, std::size_t number, std::size_t indexCount) {
    if (!isSphere(page.centre, page.radius) ||
        !isSphere(page.lodBoundsCentre, page.lodBoundsRadius) ||
        !isSphere(page.parentBoundsCentre, page.parentBoundsRadius)) {
        return failAtPage(number, "has a sphere that is none or lies beyond 1,000,000 voxels");
    }
    const bool finest = page.lodError == 0.0f;
    const bool root = std::isinf(page.parentError);
    if (!finest && !(page.lodError >= kLeastError && page.lodError <= kMost))
        return failAtPage(number, "has an error out of range");
    if (!(page.parentError >= kLeastError) || (!root && page.parentError > kMost))
        return failAtPage(number, "has a parent error out of range");
    if (page.parentError < 2.0f * page.lodError)
        return failAtPage(number, "has a parent error less than twice its own");
    const glm::dvec3 parentCentre(page.parentBoundsCentre);
    const double apart = glm::length(glm::dvec3(page.lodBoundsCentre) - parentCentre);
    const double slack = kSphereRounding * (glm::length(parentCentre) + page.parentBoundsRadius);
    if (!(apart + page.lodBoundsRadius <= page.parentBoundsRadius + slack))
        return failAtPage(number, "sticks out of its parents' sphere");
    if (page.indexCount % 3 != 0) return failAtPage(number, "has a broken triangle");
    if (std::size_t{page.firstIndex} + page.indexCount > indexCount)
        return failAtPage(number, "has indices beyond the end");
    return {};
}

}  // namespace

Status validateClusters(std::span<const ClusterPage> pages, std::size_t indexCount) {
    std::vector<GroupKey> replaced;  // by these errors and spheres, pages are replaced
    std::vector<GroupKey> own;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const ClusterPage& page = pages[i];
        if (auto ok = checkPage(page, i, indexCount); !ok) return ok;
        replaced.push_back(
            keyOf(page.parentError, page.parentBoundsCentre, page.parentBoundsRadius));
        own.push_back(keyOf(page.lodError, page.lodBoundsCentre, page.lodBoundsRadius));
    }
    std::ranges::sort(replaced);
    std::ranges::sort(own);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const ClusterPage& page = pages[i];
        const GroupKey parents =
            keyOf(page.parentError, page.parentBoundsCentre, page.parentBoundsRadius);
        if (!std::isinf(page.parentError) && !std::ranges::binary_search(own, parents))
            return failAtPage(i, "is replaced by clusters that are not there");
        const GroupKey self = keyOf(page.lodError, page.lodBoundsCentre, page.lodBoundsRadius);
        if (page.lodError != 0.0f && !std::ranges::binary_search(replaced, self))
            return failAtPage(i, "replaces clusters that are not there");
    }
    return {};
}

}  // namespace voxprite
