// One cluster of a model's surface as the GPU reads it, and what a cut through the clusters is
// chosen by: the records of seed 003, 64 and 96 bytes in std430 layout, little endian.
//
// A cluster is a piece of the surface at one level of detail. It stands for its region while its
// own error is small enough on screen and that of the coarser cluster which replaces it is not:
// [lodError, parentError) along every way from the finest clusters to a root tile [0, infinity).
// Errors are projected against spheres that all clusters of a group share, so that they change
// over together (Karis, Stubbe & Wihlidal 2021, "Nanite").
//
// Space  spheres and errors in the octree's tree space: 1 is a voxel.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/base/bytes.h"

namespace voxprite {

static_assert(std::endian::native == std::endian::little, "pages are uploaded as they lie");

//  byte   0        12      16               28               32                  44
//         centre   radius  lodBoundsCentre  lodBoundsRadius  parentBoundsCentre  parentBoundsRadius
//        48        52           56          60
//         lodError parentError  firstIndex  indexCount
struct ClusterPage {
    glm::vec3 centre{0.0f};  // of a sphere around the cluster's own triangles, for culling
    float radius = 0.0f;
    glm::vec3 lodBoundsCentre{0.0f};  // what lodError is projected against
    float lodBoundsRadius = 0.0f;
    glm::vec3 parentBoundsCentre{0.0f};  // what parentError is projected against
    float parentBoundsRadius = 0.0f;
    float lodError = 0.0f;  // how far the cluster may be from the finest surface; 0 at the finest
    float parentError = 0.0f;      // of what replaces it; infinite makes it a root
    std::uint32_t firstIndex = 0;  // into ClusterMesh::indices
    std::uint32_t indexCount = 0;  // three a triangle
    bool operator==(const ClusterPage&) const = default;
};

inline constexpr std::size_t kClusterPageBytes = 64;
static_assert(sizeof(ClusterPage) == kClusterPageBytes);
static_assert(offsetof(ClusterPage, centre) == 0);
static_assert(offsetof(ClusterPage, radius) == 12);
static_assert(offsetof(ClusterPage, lodBoundsCentre) == 16);
static_assert(offsetof(ClusterPage, lodBoundsRadius) == 28);
static_assert(offsetof(ClusterPage, parentBoundsCentre) == 32);
static_assert(offsetof(ClusterPage, parentBoundsRadius) == 44);
static_assert(offsetof(ClusterPage, lodError) == 48);
static_assert(offsetof(ClusterPage, parentError) == 52);
static_assert(offsetof(ClusterPage, firstIndex) == 56);
static_assert(offsetof(ClusterPage, indexCount) == 60);

// How one instance is seen. Make it with clusterCutParams() (cluster_cut.h): the rule that chooses
// counts on its values being within the ranges below.
//
// The matrix is affine, its bottom row would be constant (0, 0, 0, 1): the first of these four,
// byte 12, holds the nearest distance that errors are projected from. Read positions by the upper
// three rows.
struct ClusterCutParams {
    glm::mat4 worldFromTree{1.0f};   // columns; [0][3] is nearDistance()
    glm::vec3 cameraPosition{0.0f};  // world
    float tanHalfFovY = 1.0f;        // 1e-6 ... 1e6
    float viewportHeight = 2.0f;     // screen pixels, up to 1e6
    float pixelBudget = 0.0f;        // 0 ... the largest finite
    float worldScale = 1.0f;         // at least the most that worldFromTree stretches; up to 1e12
    std::uint32_t clusterCount = 0;
    bool operator==(const ClusterCutParams&) const = default;

    [[nodiscard]] float nearDistance() const { return worldFromTree[0][3]; }
};

inline constexpr std::size_t kClusterCutParamsBytes = 96;
static_assert(sizeof(ClusterCutParams) == kClusterCutParamsBytes);
static_assert(offsetof(ClusterCutParams, cameraPosition) == 64);
static_assert(offsetof(ClusterCutParams, tanHalfFovY) == 76);
static_assert(offsetof(ClusterCutParams, viewportHeight) == 80);
static_assert(offsetof(ClusterCutParams, pixelBudget) == 84);
static_assert(offsetof(ClusterCutParams, worldScale) == 88);
static_assert(offsetof(ClusterCutParams, clusterCount) == 92);

// Field by field, for files and for machines of another byte order.
void writeClusterPage(const ClusterPage& page, ByteWriter& out);
void writeClusterCutParams(const ClusterCutParams& params, ByteWriter& out);

}  // namespace voxprite
