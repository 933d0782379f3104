// Which clusters stand for a model: exactly one for every region of its surface, whatever the
// camera, provided that the pages keep what validate_clusters.h asks of them.
//
// A cluster is chosen when  projected(lodError) <= budget < projected(parentError), with
//
//   projected(e) = e * worldScale * (viewportHeight / 2) / (distance * tanHalfFovY)   screen pixels
//   distance     = max(|centre - camera| - radius * worldScale, near)                 world units
//
// the centre and radius being those of the sphere that the error's group shares. Distance is that
// of the sphere's surface: spheres that hold each other then have errors in the same order, from
// every eye, which distances of centres do not.
//
// Why rounding opens no hole. Going up one level doubles the error at least. A computed distance is
// off by at most d = 2^-18 * (reach of the spheres + distance of their origin), in world units,
// and `near` is never below 4 d. So a parent's computed distance is at most (1 + 1/2) times its
// child's, its computed error never below its child's, and the intervals of a way to the root
// still tile [0, infinity). Other orders of evaluation, other roundings of a division or a square
// root change nothing about that: processor and GPU each choose one cluster for every region, the
// same ones wherever no error lies within 1e-5 of the budget, relatively.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/lod/cluster_page.h"

namespace voxprite {

// How an instance is seen, as it comes: any value at all is allowed.
struct ClusterView {
    glm::dmat4 worldFromTree{1.0};   // affine
    glm::dvec3 cameraPosition{0.0};  // world
    double tanHalfFovY = 1.0;
    // Above 0: the camera is orthographic and shows so much above its middle, in world units; then
    // nothing depends on the distance.
    double orthographicHalfHeight = 0.0;
    double viewportHeightPx = 1.0;
    double pixelBudget = 1.0;    // screen pixels that the surface may be off
    double nearDistance = 1e-3;  // world units: nearer surfaces are taken to be so far away
};

// The parameters for pages whose spheres lie within `reach` of the tree's origin (clusterReach).
// World positions become relative to the camera in double precision (so cameraPosition is 0), and
// whatever the view says, the values are in their ranges:
// - A position, matrix, angle or height that is no number, infinite or impossible, a field of view
//   without opening included, asks for the finest clusters; so does an instance that lies further
//   away or is larger than 1e15 units.
// - A budget that is no number or negative is 0 (the finest clusters); infinite, it is the largest
//   finite one (the roots). A near distance that is neither is raised to the arithmetic's own.
[[nodiscard]] ClusterCutParams clusterCutParams(const ClusterView& view, double reach,
                                                std::uint32_t clusterCount);
// How far the spheres of the pages reach from the tree's origin.
[[nodiscard]] double clusterReach(std::span<const ClusterPage> pages);

// How many screen pixels an error may be, seen near the sphere. 0 for no error, infinite for an
// infinite one.
[[nodiscard]] float clusterProjectedError(float error, glm::vec3 centre, float radius,
                                          const ClusterCutParams& params);
// The rule itself, for one page.
[[nodiscard]] bool choosesCluster(const ClusterPage& page, const ClusterCutParams& params);
// The pages that are chosen, by number, in ascending order. `out` is cleared first and keeps its
// memory. Detail varies within the model: near clusters stay fine while far ones coarsen.
void selectCutPerCluster(std::span<const ClusterPage> pages, const ClusterCutParams& params,
                         std::vector<std::uint32_t>& out);

// One detail for the whole instance: the pages with lodError <= threshold < parentError. Thresholds
// below 0 or not a number count as 0, infinite ones as the largest finite one.
void selectCut(std::span<const ClusterPage> pages, float threshold,
               std::vector<std::uint32_t>& out);
// The error in voxels that covers the budget where the sphere around the instance is nearest:
// selectCut with it is nowhere coarser than selectCutPerCluster.
[[nodiscard]] float instanceErrorThreshold(glm::vec3 centre, float radius,
                                           const ClusterCutParams& params);

// The most that an affine map stretches: the longest of its axes while they are perpendicular,
// an upper bound (by Gershgorin's circles) when it shears.
[[nodiscard]] double maxAxisScale(const glm::dmat4& worldFromTree);

}  // namespace voxprite
