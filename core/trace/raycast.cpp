#include "core/trace/raycast.h"
#include "core/base/finite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace voxprite {
namespace {

static_assert(kRayDirectionBits * 2 + kRayEdgeBits + 2 <= 61, "keys stay below kNever");

// To the nearest integer, halves away from zero, so that mirrored rays give mirrored integers.
int rounded(double x) {
    return static_cast<int>(x < 0.0 ? x - 0.5 : x + 0.5);
}

// Steps of the lattice along a ray for each voxel that it advances on its largest axis.
double timePerVoxel(const QuantisedRay& ray) {
    return static_cast<double>(1 << ray.positionBits) / (1 << kRayDirectionBits);
}

int largestAxis(glm::dvec3 v) {
    int largest = 0;
    for (int a = 1; a < 3; ++a)
        if (std::abs(v[a]) > std::abs(v[largest])) largest = a;
    return largest;
}

// The key (see octree_walk.h) from which on all crossings lie behind `scaledT`, which counts along
// ray.scaled from where the line starts.
std::int64_t keyBehind(const QuantisedRay& ray, double scaledT) {
    double product = 4.0;
    for (int a = 0; a < 3; ++a)
        if (ray.direction[a] != 0) product *= std::abs(ray.direction[a]);
    // From inside, what holds the origin lies behind key kInsideAxis.
    const double key = std::max(scaledT * timePerVoxel(ray) * product, double{kInsideAxis} + 1.0);
    return key < static_cast<double>(kNever) ? static_cast<std::int64_t>(std::ceil(key)) : kNever;
}

LatticeHit castCounted(const OctreeView& octree, const QuantisedRay& ray, double greatestScaledT,
                       WalkCount& count) {
    const Course course(octree, ray.direction, ray.positionBits, ray.leafLevel);
    Line line(course, glm::i64vec3(ray.origin));
    line.leave = std::min(line.leave, keyBehind(ray, greatestScaledT - ray.enter));
    // From inside, every crossing up to the origin (time 0) has been made.
    return walk(course, line,
                ray.inside ? std::max(line.enter, std::int64_t{kInsideAxis}) : line.enter, count);
}

// Where, along q.scaled, the ray meets the plane of the face that the line walked came through.
// Where it grazes that plane and meets it beside the face, as near to that as the face goes.
double scaledTOfFace(const Ray& ray, const QuantisedRay& q, const RaycastHit& hit, int face,
                     int treeFromVoxel, double slack) {
    const int axis = hit.axis;
    const std::int64_t steps =
        (std::int64_t{face + treeFromVoxel} << q.positionBits) - q.origin[axis];
    const double walked =
        q.enter + static_cast<double>(steps) / (q.direction[axis] * timePerVoxel(q));
    double t = (face - ray.origin[axis]) / q.scaled[axis];
    if (std::abs(t - walked) > slack) {
        for (int b = 0; b < 3; ++b) {
            if (b == axis || q.scaled[b] == 0.0) continue;
            const double low = hit.voxel[b] - slack;
            const double high = hit.voxel[b] + (1 << q.leafLevel) + slack;
            const double first = (low - ray.origin[b]) / q.scaled[b];
            const double last = (high - ray.origin[b]) / q.scaled[b];
            t = std::clamp(t, std::min(first, last), std::max(first, last));
        }
    }
    return std::max(0.0, t);
}

}  // namespace

double raySlack(const OctreeView& octree) {
    return 1.25 * (1 << octree.maxDepth) / (1 << 20);
}

QuantisedRay quantiseRay(const OctreeView& octree, const Ray& ray, int maxDepth) {
    QuantisedRay result;
    result.leafLevel = std::clamp(octree.maxDepth - maxDepth, 0, octree.maxDepth);
    const IBox box = castableBox(octree, result.leafLevel);
    if (box.empty() || !finite(ray.origin) || !finite(ray.direction)) return result;
    const double largest = std::abs(ray.direction[largestAxis(ray.direction)]);
    if (largest == 0.0) return result;
    result.scaled = ray.direction / largest;

    // Where the ray enters the box, if it starts outside.
    result.inside = true;
    for (int a = 0; a < 3; ++a) {
        const bool below = ray.origin[a] < box.min[a];
        const bool above = ray.origin[a] >= box.max[a];
        if (!below && !above) continue;
        result.inside = false;
        if (below ? result.scaled[a] <= 0.0 : result.scaled[a] >= 0.0) return result;
        result.enter = std::max(
            result.enter, ((below ? box.min[a] : box.max[a]) - ray.origin[a]) / result.scaled[a]);
    }
    const glm::dvec3 start = ray.origin + result.scaled * result.enter;

    result.positionBits = kRayEdgeBits - octree.maxDepth;
    const double stepsPerVoxel = 1 << result.positionBits;
    for (int a = 0; a < 3; ++a) {
        // Rounding moves the line by far less than a voxel: it would miss as well.
        if (!(start[a] >= box.min[a] - 1.0 && start[a] <= box.max[a] + 1.0)) return result;
        result.origin[a] = rounded((start[a] + octree.treeFromVoxel[a]) * stepsPerVoxel);
        result.direction[a] = rounded(result.scaled[a] * (1 << kRayDirectionBits));
    }
    result.meetsBox = true;
    return result;
}

LatticeHit castQuantised(const OctreeView& octree, const QuantisedRay& ray) {
    if (!ray.meetsBox) return {};
    WalkCount count;
    count.mostIterations = RaycastOptions{}.mostIterations;
    return castCounted(octree, ray, RaycastOptions{}.greatestT, count);
}

RaycastHit raycast(const OctreeView& octree, const Ray& ray, const RaycastOptions& options,
                   RaycastCounters* counters) {
    const QuantisedRay quantised = quantiseRay(octree, ray, options.maxDepth);
    const double slack = raySlack(octree);
    WalkCount count;
    count.mostIterations = options.mostIterations;
    LatticeHit met;
    if (quantised.meetsBox) {
        // The walk's own t may be off by as much as a leaf where it grazes a face.
        const double later = (1 << quantised.leafLevel) + 2.0 * slack;
        met = castCounted(octree, quantised,
                          options.greatestT / glm::length(quantised.scaled) + later, count);
    }
    if (counters != nullptr) {
        ++counters->rays;
        counters->boxMisses += quantised.meetsBox ? 0 : 1;
        counters->iterations += count.iterations;
        counters->nodes += count.nodes;
        counters->guardReached += count.stopped ? 1 : 0;
    }
    RaycastHit hit = raycastHit(octree, ray, quantised, met);
    hit.hit = hit.hit && hit.t <= options.greatestT;
    return hit;
}

RaycastHit raycastHit(const OctreeView& octree, const Ray& ray, const QuantisedRay& quantised,
                      const LatticeHit& met) {
    if (met.material == 0) return {};
    RaycastHit hit;
    hit.hit = true;
    hit.voxel = met.voxel;
    hit.value = met.material;
    if (met.faceAxis == kInsideAxis) {
        hit.axis = static_cast<std::uint8_t>(largestAxis(ray.direction));
        hit.point = ray.origin;
    } else {
        hit.axis = met.faceAxis;
        const bool downward = quantised.direction[hit.axis] < 0;
        const int face = met.voxel[hit.axis] + (downward ? 1 << quantised.leafLevel : 0);
        const double scaledT = scaledTOfFace(ray, quantised, hit, face,
                                             octree.treeFromVoxel[hit.axis], raySlack(octree));
        hit.t = scaledT * glm::length(quantised.scaled);
        hit.point = ray.origin + quantised.scaled * scaledT;
        hit.point[hit.axis] = face;
    }
    hit.normal[hit.axis] = ray.direction[hit.axis] < 0.0 ? 1.0 : -1.0;
    return hit;
}

Ray voxelRay(const VoxelPlacement& placement, const Ray& worldRay) {
    // The axes are orthonormal: v * m is the product with the transpose, their inverse.
    const glm::dmat3& axes = placement.worldFromVoxelAxes;
    return {(worldRay.origin - placement.anchorMetres) * axes / placement.metresPerVoxel +
                placement.anchorVoxels,
            worldRay.direction * axes};
}

RaycastHit raycast(const OctreeView& octree, const VoxelPlacement& placement, const Ray& worldRay,
                   const RaycastOptions& options, RaycastCounters* counters) {
    RaycastOptions inVoxels = options;
    inVoxels.greatestT /= placement.metresPerVoxel;
    RaycastHit hit = raycast(octree, voxelRay(placement, worldRay), inVoxels, counters);
    if (!hit.hit) return hit;
    const glm::dmat3& axes = placement.worldFromVoxelAxes;
    hit.t *= placement.metresPerVoxel;
    hit.point = placement.anchorMetres +
                axes * (hit.point - placement.anchorVoxels) * placement.metresPerVoxel;
    hit.normal = axes * hit.normal;
    return hit;
}

}  // namespace voxprite
