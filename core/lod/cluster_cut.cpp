#include "core/lod/cluster_cut.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace voxprite {
namespace {

// Four times what single precision may be off in a distance, by the sizes that enter it. In units
// of 2^-24: 4 sqrt(3) + 1 for the transform (three products, three sums), 1 for the camera, 3 for
// the length, 2 for the radius, 3 for the matrix's own rounding, 16 for what validateClusters lets
// spheres stick out of their parents': less than 64.
constexpr double kNearByReach = 0x1p-16;
constexpr double kLeastNear = 1e-12;
constexpr double kFarthest = 1e15;
constexpr double kLeastScale = 1e-12;
constexpr double kMostScale = 1e12;
constexpr float kMostFinite = std::numeric_limits<float>::max();

bool isFinite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Of a threshold or a budget: a finite number, not below 0.
float sanitisedLimit(float limit) {
    return limit > 0.0f ? std::min(limit, kMostFinite) : 0.0f;
}

// Everything but the finest clusters is off by more than the budget of 0.
ClusterCutParams finestParams(std::uint32_t clusterCount) {
    ClusterCutParams params;
    params.worldFromTree[0][3] = 1.0f;
    params.clusterCount = clusterCount;
    return params;
}

// The distance in world units between the camera and the surface of a sphere.
float surfaceDistance(glm::vec3 centre, float radius, const ClusterCutParams& params) {
    const glm::mat4& m = params.worldFromTree;
    const glm::vec3 world = glm::vec3(m[0]) * centre.x + glm::vec3(m[1]) * centre.y +
                            glm::vec3(m[2]) * centre.z + glm::vec3(m[3]);
    const glm::vec3 offset = world - params.cameraPosition;
    const float distance =
        std::sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z);
    return std::max(distance - radius * params.worldScale, params.nearDistance());
}

// Nothing when the view makes no sense or lies beyond what single precision holds.
std::optional<ClusterCutParams> sensibleParams(const ClusterView& view, double reach) {
    const glm::dmat4& m = view.worldFromTree;
    // Relative to the camera, before anything is rounded.
    const glm::dvec3 origin = glm::dvec3(m[3]) - view.cameraPosition;
    const double stretch = maxAxisScale(m);
    const double extent = stretch * reach + glm::length(origin);
    if (!isFinite(origin) || !(stretch <= kMostScale) || !(extent <= kFarthest)) return {};
    const double height = view.viewportHeightPx;
    if (!(height > 0.0) || !std::isfinite(height)) return {};

    ClusterCutParams params;
    params.worldScale = static_cast<float>(std::max(stretch, kLeastScale));
    params.viewportHeight = static_cast<float>(std::clamp(height, 1e-6, 1e6));
    params.pixelBudget = sanitisedLimit(static_cast<float>(view.pixelBudget));
    double near = 0.0;
    if (view.orthographicHalfHeight > 0.0) {
        // All spheres in the eye: every distance is the near one, which stands for half the height.
        if (!std::isfinite(view.orthographicHalfHeight)) return {};
        params.worldFromTree = glm::mat4(0.0f);
        params.tanHalfFovY = 1.0f;
        near = view.orthographicHalfHeight;
    } else {
        const double tangent = view.tanHalfFovY;
        if (!(tangent > 0.0) || !std::isfinite(tangent)) return {};
        params.tanHalfFovY = static_cast<float>(std::clamp(tangent, 1e-6, 1e6));
        params.worldFromTree = glm::mat4(m);
        params.worldFromTree[3] = glm::vec4(glm::vec3(origin), 1.0f);
        near = std::isfinite(view.nearDistance) ? view.nearDistance : 0.0;
        near = std::max(near, kNearByReach * extent);
    }
    params.worldFromTree[0][3] = static_cast<float>(std::clamp(near, kLeastNear, kFarthest));
    return params;
}

}  // namespace

double maxAxisScale(const glm::dmat4& worldFromTree) {
    // The largest eigenvalue of the axes' products with each other, or more.
    double most = 0.0;
    for (int i = 0; i < 3; ++i) {
        double row = 0.0;
        for (int j = 0; j < 3; ++j) {
            row += std::abs(glm::dot(glm::dvec3(worldFromTree[i]), glm::dvec3(worldFromTree[j])));
        }
        // Not std::max: what is no number has to come through.
        if (!(row <= most)) most = row;
    }
    return std::sqrt(most);
}

double clusterReach(std::span<const ClusterPage> pages) {
    double reach = 0.0;
    for (const ClusterPage& page : pages) {
        reach =
            std::max({reach, glm::length(glm::dvec3(page.lodBoundsCentre)) + page.lodBoundsRadius,
                      glm::length(glm::dvec3(page.parentBoundsCentre)) + page.parentBoundsRadius});
    }
    return reach;
}

ClusterCutParams clusterCutParams(const ClusterView& view, double reach,
                                  std::uint32_t clusterCount) {
    ClusterCutParams params = sensibleParams(view, reach).value_or(finestParams(clusterCount));
    params.clusterCount = clusterCount;
    return params;
}

float clusterProjectedError(float error, glm::vec3 centre, float radius,
                            const ClusterCutParams& params) {
    return error * params.worldScale * (params.viewportHeight * 0.5f) /
           (surfaceDistance(centre, radius, params) * params.tanHalfFovY);
}

bool choosesCluster(const ClusterPage& page, const ClusterCutParams& params) {
    return clusterProjectedError(page.lodError, page.lodBoundsCentre, page.lodBoundsRadius,
                                 params) <= params.pixelBudget &&
           params.pixelBudget < clusterProjectedError(page.parentError, page.parentBoundsCentre,
                                                      page.parentBoundsRadius, params);
}

void selectCutPerCluster(std::span<const ClusterPage> pages, const ClusterCutParams& params,
                         std::vector<std::uint32_t>& out) {
    out.clear();
    for (std::uint32_t i = 0; i < pages.size(); ++i) {
        if (choosesCluster(pages[i], params)) out.push_back(i);
    }
}

void selectCut(std::span<const ClusterPage> pages, float threshold,
               std::vector<std::uint32_t>& out) {
    threshold = sanitisedLimit(threshold);
    out.clear();
    for (std::uint32_t i = 0; i < pages.size(); ++i) {
        if (pages[i].lodError <= threshold && threshold < pages[i].parentError) out.push_back(i);
    }
}

float instanceErrorThreshold(glm::vec3 centre, float radius, const ClusterCutParams& params) {
    return sanitisedLimit(params.pixelBudget * surfaceDistance(centre, radius, params) *
                          params.tanHalfFovY / (params.worldScale * params.viewportHeight * 0.5f));
}

}  // namespace voxprite
