// An entity as it stands in the world.
#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite {

// `modelSize` and `anchor` in voxels from the minimum corner of the entity's bounds.
struct PlacedEntity {
    glm::ivec3 modelSize{0};
    glm::dvec3 anchor{0.0};
    glm::dmat3 worldFromVoxelAxes{1.0};  // rotation and axis swizzle; orthonormal, no scale
    double scale = 1.0;
    glm::dvec3 anchorMetres{0.0};  // where the anchor stands
    double voxelSizeMetres = 0.1;
    // From the middle of the model's box to its centre, in voxels: zero but for a stand-in whose
    // box is rounded out to whole cells (core/sprite/coarse_entity.h). Plane, depth and proxy
    // belong to the centre.
    glm::dvec3 centreFromMiddle{0.0};

    [[nodiscard]] double metresPerVoxel() const { return voxelSizeMetres * scale; }
    [[nodiscard]] glm::dvec3 worldFromVoxel(glm::dvec3 voxel) const;
    [[nodiscard]] glm::dvec3 centreVoxels() const {
        return glm::dvec3(modelSize) * 0.5 + centreFromMiddle;
    }
    // Half of the smallest box around the centre that holds the model's.
    [[nodiscard]] glm::dvec3 halfVoxels() const {
        return glm::dvec3(modelSize) * 0.5 + glm::abs(centreFromMiddle);
    }
    [[nodiscard]] glm::dvec3 centreMetres() const;
    [[nodiscard]] double radiusMetres() const;  // of the sphere round the centre and the box
};

[[nodiscard]] PlacedEntity placeEntity(const Entity& entity, const IBox& bounds,
                                       const GameProfile& profile);
// Finite and in range; the axes a pure rotation (a scale of its own an axis, or a mirror, is an
// error that says so).
[[nodiscard]] Status validate(const PlacedEntity& entity);

// The rotation of Entity (yaw, pitch, roll) in voxel space, exact at multiples of 90.
[[nodiscard]] glm::dmat3 entityRotation(const Entity& entity);

// How far above the ground an entity that stands on it floats: the profile's clearance. For whoever
// puts the entity on a ground to add to its height; placeEntity does not.
[[nodiscard]] double groundClearanceMetres(const GameProfile& profile);

// The proxy box: the model's bounds plus a margin of one virtual pixel all round (the artist's
// handle and cull volume). Eight corners in world metres, octant order.
[[nodiscard]] std::array<glm::dvec3, 8> proxyCorners(const PlacedEntity& entity,
                                                     double sigmaInForce);
// Half of its edges along the voxel axes, in metres; it lies around the model's centre.
[[nodiscard]] glm::dvec3 proxyHalfMetres(const PlacedEntity& entity, double sigmaInForce);

}  // namespace voxprite
