// One ray through an octree: what it meets first, where, and through which face.
//
// Exact from integers on. The root cube's edge is cut into 2^21 steps, whatever its depth (the
// normalised cube space [0,1]^3 of the octree ray cast's specification, in fixed point), and
// quantiseRay turns a ray of doubles into a start of whole steps, where the ray comes into the
// box, and a direction of 19 bits an axis. The octree is walked by core/trace/octree_walk: integers
// alone decide which cell is next, so there is no epsilon in the walk, nothing accumulates, and no
// ray slips between two cells. The shaders' walk (shaders/shared/exact_walk.glsl) finds the same
// voxel and face for the same integers.
//
// What quantising costs: inside the box the line walked strays from the ray, at equal t and on each
// axis, by at most raySlack() = 1.25 * 2^(maxDepth - 20) voxels (a thousandth of a voxel in a root
// of 512 cubed), and by what doubles lose on the way from the origin, |origin| * 2^-51. Only a ray
// that passes an edge nearer than that may be seen to pass on its other side.
//
// Cells are half open and ties go to the lowest axis, as core/trace/lattice.h has them: so rays
// along faces, through edges and through corners have one answer. A ray along a face lies in the
// cell above it.
//
// A maximum depth cuts the tree: a node at that depth that holds anything is one solid cube, also
// where it reaches beyond the model's box. Its value is that of its first solid voxel in octant
// order, depth first. Depth 0 is the root cube itself.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/svo/octree.h"
#include "core/trace/octree_walk.h"

namespace voxprite {

// `direction` of any length but zero. Rays with a component that is no finite number hit nothing.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 1.0, 0.0};
};

struct RaycastOptions {
    // Levels below the octree's root; from octree.maxDepth on there is no limit. Negative: 0. (A
    // live octree's root may lie higher than that of the model baked.)
    int maxDepth = kMaxOctreeDepth;
    double greatestT = std::numeric_limits<double>::infinity();  // hits beyond do not count
    // The guard. A line crosses at most 3 * 2^maxDepth planes of the grid, so with the default,
    // one more than that, it is never reached. A smaller one makes what lies deeper a miss.
    std::uint64_t mostIterations = std::uint64_t{3} << kMaxOctreeDepth | 1u;
};

// What casting cost, added up over calls.
struct RaycastCounters {
    std::uint64_t rays = 0;
    std::uint64_t boxMisses = 0;     // rays that did not come into the box: the tree was not read
    std::uint64_t iterations = 0;    // nodes passed or hit, one after the other
    std::uint64_t nodes = 0;         // words of the tree read
    std::uint64_t guardReached = 0;  // rays given up
};

struct RaycastHit {
    bool hit = false;  // if not, nothing else has a meaning
    // Along the normalised direction from the origin, to where the ray itself meets the plane of
    // the face hit; 0 when it starts inside what it hits. (Should it miss that face, by at most
    // raySlack(), t ends where the face does.)
    double t = 0.0;
    // On that plane, within raySlack() of the face; the origin when the ray starts inside.
    glm::dvec3 point{0.0};
    // Unit, outward: through a voxel's minimum face it points down the axis. Inside: against the
    // largest component of the direction.
    glm::dvec3 normal{0.0};
    glm::ivec3 voxel{0};  // the minimum corner of a node at the depth limit
    std::uint8_t value = 0;
    std::uint8_t axis = 0;  // of the normal
};

// In voxel space: origin, t and point in voxels from the model's minimum corner. The box is tested
// first. What lies behind the origin does not count; a ray that starts on a voxel's face and runs
// into it hits it at 0.
[[nodiscard]] RaycastHit raycast(const OctreeView& octree, const Ray& ray,
                                 const RaycastOptions& options = {},
                                 RaycastCounters* counters = nullptr);

// Where an octree stands in a world: world = anchorMetres + axes * (voxel - anchor) * metres a
// voxel. The axes are orthonormal (core/sprite/placed_entity.h makes them).
struct VoxelPlacement {
    glm::dmat3 worldFromVoxelAxes{1.0};
    glm::dvec3 anchorVoxels{0.0};  // from the model's minimum corner
    glm::dvec3 anchorMetres{0.0};  // where that point stands
    double metresPerVoxel = 1.0;
};

[[nodiscard]] Ray voxelRay(const VoxelPlacement& placement, const Ray& worldRay);

// In the world: origin, t, point and options.greatestT in metres, the normal along world axes.
[[nodiscard]] RaycastHit raycast(const OctreeView& octree, const VoxelPlacement& placement,
                                 const Ray& worldRay, const RaycastOptions& options = {},
                                 RaycastCounters* counters = nullptr);

// The integers that a ray becomes: all that the walk, here and in shaders, depends on. In tree
// space: steps from the root's minimum corner.
struct QuantisedRay {
    bool meetsBox = false;  // if not, nothing else has a meaning: nothing is hit
    // The ray starts in the box (or on its minimum faces): only what lies from there on counts.
    bool inside = false;
    int positionBits = 0;  // steps a voxel = 2^positionBits: 21 - octree.maxDepth
    int leafLevel = 0;
    glm::ivec3 origin{0};
    glm::ivec3 direction{0};
    // Of the direction scaled to a largest component of 1: where the line starts along it.
    double enter = 0.0;
    glm::dvec3 scaled{0.0};
};

inline constexpr int kRayEdgeBits = 21;       // lattice steps of the root's edge
inline constexpr int kRayDirectionBits = 19;  // the largest component of D is 2^19

[[nodiscard]] QuantisedRay quantiseRay(const OctreeView& octree, const Ray& ray, int maxDepth);

// Voxels, on every axis; see above.
[[nodiscard]] double raySlack(const OctreeView& octree);

// What the walk of those integers meets: exactly this is promised of the shaders, too. faceAxis is
// kInsideAxis when the ray starts inside what it hits.
inline constexpr std::uint8_t kInsideAxis = 3;
[[nodiscard]] LatticeHit castQuantised(const OctreeView& octree, const QuantisedRay& ray);

// What raycast makes of it: `quantised` is quantiseRay's for this ray and `met` castQuantised's for
// that. For whoever casts many rays at once (core/trace/ray_packet.h).
[[nodiscard]] RaycastHit raycastHit(const OctreeView& octree, const Ray& ray,
                                    const QuantisedRay& quantised, const LatticeHit& met);

}  // namespace voxprite
