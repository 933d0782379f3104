#include "core/io/nearest_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace voxprite {
namespace {

constexpr std::uint32_t kLeaf = 4;

double squaredDistanceTo(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& point) {
    const glm::dvec3 outside = glm::max(glm::max(low - point, point - high), glm::dvec3(0.0));
    return glm::dot(outside, outside);
}

glm::dvec3 middle(const MeshTriangle& triangle) {
    const auto& c = triangle.corners;
    return (c[0].position + c[1].position + c[2].position) / 3.0;
}

// Of the corners, by the region of the plane that the point lies over.
glm::dvec3 nearestWeights(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                          const glm::dvec3& point) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = point - a;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
    const glm::dvec3 bp = point - b;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 - d3 > 0.0) {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }
    const glm::dvec3 cp = point - c;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 - d6 > 0.0) {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6 && (d4 - d3) + (d5 - d6) > 0.0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }
    const double sum = va + vb + vc;
    if (!(sum > 0.0)) return {1.0, 0.0, 0.0};  // no area: a corner will do
    const double v = vb / sum, w = vc / sum;
    return {std::max(0.0, 1.0 - v - w), v, w};
}

}  // namespace

SurfacePoint nearestOnTriangle(const MeshTriangle& triangle, std::uint32_t index,
                               const glm::dvec3& point) {
    const glm::dvec3& a = triangle.corners[0].position;
    const glm::dvec3& b = triangle.corners[1].position;
    const glm::dvec3& c = triangle.corners[2].position;
    SurfacePoint nearest;
    nearest.triangle = index;
    nearest.weights = nearestWeights(a, b, c, point);
    nearest.position = nearest.weights.x * a + nearest.weights.y * b + nearest.weights.z * c;
    const glm::dvec3 apart = point - nearest.position;
    nearest.squaredDistance = glm::dot(apart, apart);
    return nearest;
}

bool isBehind(const MeshTriangle& triangle, const SurfacePoint& nearest, const glm::dvec3& point) {
    const auto& corners = triangle.corners;
    const glm::dvec3 normal = glm::cross(corners[1].position - corners[0].position,
                                         corners[2].position - corners[0].position);
    return glm::dot(point - nearest.position, normal) < 0.0;
}

NearestTriangle::NearestTriangle(std::span<const MeshTriangle> triangles)
    : triangles_(triangles), order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(triangles.size());
    build(0, static_cast<std::uint32_t>(triangles.size()));
}

// Halved at the median of the middles along the longest edge, so that the depth is logarithmic.
std::uint32_t NearestTriangle::build(std::uint32_t first, std::uint32_t last) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Node node{glm::dvec3(kFar), glm::dvec3(-kFar), first, last - first};
    glm::dvec3 low(kFar), high(-kFar);
    for (std::uint32_t k = first; k < last; ++k) {
        for (const MeshCorner& corner : triangles_[order_[k]].corners) {
            node.low = glm::min(node.low, corner.position);
            node.high = glm::max(node.high, corner.position);
        }
        low = glm::min(low, middle(triangles_[order_[k]]));
        high = glm::max(high, middle(triangles_[order_[k]]));
    }
    nodes_.push_back(node);
    if (node.count <= kLeaf) return at;
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = first + node.count / 2;
    const auto begin = order_.begin();
    std::nth_element(begin + first, begin + half, begin + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double x = middle(triangles_[a])[axis];
                         const double y = middle(triangles_[b])[axis];
                         return x < y || (x == y && a < b);
                     });
    build(first, half);
    const std::uint32_t upper = build(half, last);
    nodes_[at].first = upper;
    nodes_[at].count = 0;
    return at;
}

SurfacePoint NearestTriangle::nearest(const glm::dvec3& point, std::uint32_t hint) const {
    SurfacePoint best = nearestOnTriangle(triangles_[hint], hint, point);
    std::array<std::uint32_t, 64> waiting{};  // the tree is some 22 deep at most
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t at = waiting[--count];
        const Node& node = nodes_[at];
        // With room for rounding, so that the hint cannot decide between triangles.
        const double least = squaredDistanceTo(node.low, node.high, point);
        if (least > best.squaredDistance * (1.0 + 1e-9)) continue;
        if (node.count == 0) {
            const Node& lower = nodes_[at + 1];
            const Node& upper = nodes_[node.first];
            const bool lowerFirst = squaredDistanceTo(lower.low, lower.high, point) <=
                                    squaredDistanceTo(upper.low, upper.high, point);
            waiting[count++] = lowerFirst ? node.first : at + 1;
            waiting[count++] = lowerFirst ? at + 1 : node.first;
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            const SurfacePoint found = nearestOnTriangle(triangles_[order_[k]], order_[k], point);
            if (found.squaredDistance < best.squaredDistance ||
                (found.squaredDistance == best.squaredDistance && found.triangle < best.triangle)) {
                best = found;
            }
        }
    }
    return best;
}

SurfacePoint NearestTriangle::nearestFromBehind(const glm::dvec3& point,
                                                const SurfacePoint& nearest, double slack) const {
    const double reach = std::sqrt(nearest.squaredDistance) + slack;
    SurfacePoint best = nearest;
    bool found = isBehind(triangles_[nearest.triangle], nearest, point);
    std::array<std::uint32_t, 64> waiting{};
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t at = waiting[--count];
        const Node& node = nodes_[at];
        if (squaredDistanceTo(node.low, node.high, point) > reach * reach) continue;
        if (node.count == 0) {
            waiting[count++] = node.first;
            waiting[count++] = at + 1;
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            if (found && order_[k] >= best.triangle) continue;
            const MeshTriangle& triangle = triangles_[order_[k]];
            const SurfacePoint other = nearestOnTriangle(triangle, order_[k], point);
            if (other.squaredDistance > reach * reach || !isBehind(triangle, other, point)) {
                continue;
            }
            best = other;
            found = true;
        }
    }
    return best;
}

}  // namespace voxprite
