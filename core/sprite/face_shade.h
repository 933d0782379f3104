// What stands around a face of a voxel, and between it and the light: one answer for each face as a
// whole, so that a sprite stays pixel art, and exact, so that every processor gives the same.
//
// Shadow. The ray from the face's middle toward the light, whose direction is rounded to integers
// (shadowDirection): on the lattice of half voxels, by the walk of core/trace/octree_walk.h, from
// the cell in front of the face. A face that looks away from the light is in its own shade already
// and casts none.
//
// Occlusion. Sixteen rays from the face's middle, no longer than kOcclusionReach voxels. The
// middles of a grid of 4 x 4, laid onto the disc below the hemisphere with equal areas kept
// (Shirley & Chiu 1997), and lifted onto it: directions by the cosine, so that all count alike. As
// whole numbers along the face's two axes and its normal, with all signs and the first two
// exchanged:
//
//     (2, 2, 11)  14 degrees off the normal      (11, 3, 10), (4, 4, 5)  49 degrees off
//
// A ray is blocked by a solid cell whose inside it enters within reach; where it meets an edge it
// goes through between the two beside it. Rays that begin alike share their cells: see
// occlusionSteps. The number of blocked rays makes the level, (blocked - 1) / 4: the four that one
// step of stairs takes do not count, for else every slope and every ball would be darker than a
// wall. A step on two sides or the foot of a wall is level 1, a corner of walls 3.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/svo/octree.h"
#include "core/trace/octree_walk.h"

namespace voxprite {

inline constexpr int kOcclusionRays = 16;
inline constexpr int kOcclusionReach = 4;
inline constexpr int kOcclusionLevels = 4;

[[nodiscard]] int occlusionLevel(int blockedRays);

// Toward the light, rounded: the largest component is +-kShadowDirection. (0,0,0) of a vector that
// has no length or is not finite.
inline constexpr int kShadowDirection = 1 << 13;
[[nodiscard]] glm::ivec3 shadowDirection(glm::dvec3 towardLight);

// Which rays a sprite's faces cast.
struct FaceRays {
    bool occlusion = false;
    glm::ivec3 towardLight{0};  // voxel space; (0,0,0): no shadows
    bool operator==(const FaceRays&) const = default;
    [[nodiscard]] bool shadows() const { return towardLight != glm::ivec3(0); }
    [[nodiscard]] bool any() const { return occlusion || shadows(); }
};

// What they found.
struct FaceShade {
    int occlusion = 0;  // level, 0 ... kOcclusionLevels - 1
    bool shadowed = false;
    bool operator==(const FaceShade&) const = default;
};

// One of the two faces of a voxel across an axis.
struct VoxelFace {
    glm::ivec3 voxel{0};
    int axis = 0;
    int side = 0;  // it looks along the axis (1) or against it (-1); 0: no face
    bool operator==(const VoxelFace&) const = default;
};

// The face that a ray of that direction came through.
[[nodiscard]] inline VoxelFace seenFace(const LatticeHit& hit, glm::ivec3 direction) {
    return {hit.voxel, hit.faceAxis, direction[hit.faceAxis] < 0 ? 1 : -1};
}

// A cell on the way of some of the rays, from the cell in front of the face: along the axes
// (axis + 1) % 3 and (axis + 2) % 3, and outward. Where it is solid it blocks `rays` of them and
// the steps up to `next` are left out, for those rays are done; else the next step follows.
struct OcclusionStep {
    glm::ivec3 offset{0};
    int rays = 0;
    int next = 0;
};
[[nodiscard]] std::span<const OcclusionStep> occlusionSteps();

// Asks one octree; one instance may serve many threads, and must not outlive the octree's arrays.
class FaceShader {
  public:
    FaceShader(const OctreeView& octree, const FaceRays& rays);

    [[nodiscard]] FaceShade shadeOf(const VoxelFace& face) const;
    // 0 ... kOcclusionRays
    [[nodiscard]] int blockedRays(const VoxelFace& face) const;
    [[nodiscard]] bool inShadow(const VoxelFace& face) const;

  private:
    OctreeView octree_;
    FaceRays rays_;
    Course towardLight_;
};

}  // namespace voxprite
