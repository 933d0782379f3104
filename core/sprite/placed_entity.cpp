#include "core/sprite/placed_entity.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/finite.h"
#include "core/model/entity_voxels.h"
#include "core/model/range_check.h"
#include "core/sprite/camera.h"
#include "core/svo/octree.h"

namespace voxprite {

namespace {

// Columns are where the voxel axes point in the world; the inverse of voxelFromWorld.
constexpr glm::dmat3 kWorldFromVoxel{1, 0, 0, 0, 0, -1, 0, 1, 0};

}  // namespace

glm::dvec3 PlacedEntity::worldFromVoxel(glm::dvec3 voxel) const {
    return anchorMetres + worldFromVoxelAxes * ((voxel - anchor) * metresPerVoxel());
}

glm::dvec3 PlacedEntity::centreMetres() const {
    return worldFromVoxel(centreVoxels());
}

double PlacedEntity::radiusMetres() const {
    return glm::length(halfVoxels()) * metresPerVoxel();
}

glm::dmat3 entityRotation(const Entity& entity) {
    const SinCos yaw = sinCosDegrees(entity.yawDegrees);
    const SinCos pitch = sinCosDegrees(entity.pitchDegrees);
    const SinCos roll = sinCosDegrees(entity.rollDegrees);
    const glm::dmat3 aboutX{1, 0, 0, 0, pitch.cos, pitch.sin, 0, -pitch.sin, pitch.cos};
    const glm::dmat3 aboutY{roll.cos, 0, -roll.sin, 0, 1, 0, roll.sin, 0, roll.cos};
    const glm::dmat3 aboutZ{yaw.cos, yaw.sin, 0, -yaw.sin, yaw.cos, 0, 0, 0, 1};
    return aboutZ * aboutX * aboutY;
}

PlacedEntity placeEntity(const Entity& entity, const IBox& bounds, const GameProfile& profile) {
    PlacedEntity placed;
    placed.modelSize = bounds.empty() ? glm::ivec3(0) : bounds.size();
    placed.anchor = anchorVoxels(entity, bounds) - glm::dvec3(bounds.min);
    placed.worldFromVoxelAxes = kWorldFromVoxel * entityRotation(entity);
    placed.scale = entity.scale;
    placed.anchorMetres = entity.positionMetres;
    placed.voxelSizeMetres = profile.voxelSizeMetres;
    return placed;
}

Status validate(const PlacedEntity& entity) {
    if (!finite(entity.anchor)) return fail("entity: the anchor is not finite");
    if (!finite(entity.centreFromMiddle)) return fail("entity: the centre is not finite");
    if (!finite(entity.anchorMetres)) return fail("entity: the position is not finite");
    if (auto ok = checkVoxelSize("entity: the voxel size", entity.voxelSizeMetres); !ok) return ok;
    if (auto ok = checkRange("entity: the scale", entity.scale, 1e-3, 1e3); !ok) return ok;
    for (int axis = 0; axis < 3; ++axis)
        if (auto ok = checkRange("entity: the model's size", entity.modelSize[axis], 0,
                                 1 << kMaxOctreeDepth);
            !ok)
            return ok;
    const glm::dmat3& axes = entity.worldFromVoxelAxes;
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(product[column][row] - (column == row ? 1.0 : 0.0)) < 1e-6))
                return fail(
                    "entity: its axes are not a rotation; only a uniform scale is possible");
    if (glm::determinant(axes) < 0.0) return fail("entity: its axes are mirrored");
    return {};
}

double groundClearanceMetres(const GameProfile& profile) {
    return profile.groundClearancePx * profile.voxelSizeMetres / profile.sigma;
}

glm::dvec3 proxyHalfMetres(const PlacedEntity& entity, double sigmaInForce) {
    return entity.halfVoxels() * entity.metresPerVoxel() + entity.voxelSizeMetres / sigmaInForce;
}

std::array<glm::dvec3, 8> proxyCorners(const PlacedEntity& entity, double sigmaInForce) {
    const glm::dvec3 centre = entity.centreMetres();
    const glm::dvec3 half = proxyHalfMetres(entity, sigmaInForce);
    std::array<glm::dvec3, 8> corners;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::dvec3 side = glm::dvec3(octantCorner(octant)) * 2.0 - 1.0;
        corners[octant] = centre + entity.worldFromVoxelAxes * (half * side);
    }
    return corners;
}

}  // namespace voxprite
