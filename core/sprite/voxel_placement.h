// An entity's place, as rays into its voxels need it.
#pragma once

#include <glm/matrix.hpp>

#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "core/trace/ray_packet.h"
#include "core/trace/raycast.h"

namespace voxprite {

[[nodiscard]] inline VoxelPlacement voxelPlacement(const PlacedEntity& placed) {
    return {placed.worldFromVoxelAxes, placed.anchor, placed.anchorMetres, placed.metresPerVoxel()};
}

// The rays through the middles of the camera's pixels, row by row from the top; not of an
// orthographic camera, which has no eye.
[[nodiscard]] inline EyePicture eyePicture(const VoxelPlacement& placement, const Camera& camera) {
    const glm::dmat3 voxelFromWorldAxes = glm::transpose(placement.worldFromVoxelAxes);
    const double perPx = camera.metresPerScreenPx(1.0);
    const glm::dvec3 first = camera.rayFromEye(glm::dvec2(0.5)).direction;
    return {voxelRay(placement, {camera.eyeMetres, first}).origin, voxelFromWorldAxes * first,
            voxelFromWorldAxes * (camera.right * perPx), voxelFromWorldAxes * (camera.up * -perPx)};
}

}  // namespace voxprite
