// Which way a sprite is seen: the axes of its plane, and the same in voxel space, snapped.
#pragma once

#include <glm/mat3x3.hpp>

#include "core/sprite/sprite_view.h"

namespace voxprite {

// right, up and forward of the sprite plane in the world. Updates history->basis.
[[nodiscard]] glm::dmat3 planeAxes(const PlacedEntity& entity, const Camera& camera, ViewRule rule,
                                   glm::dvec3 centreFromEyeMetres, ViewHistory* history);

// The orbit angles (in degrees) whose orbitBasis, taken to voxel space, is `voxelAxes`.
[[nodiscard]] OrbitAngles orbitAnglesOf(const glm::dmat3& voxelAxes);

// The axes nearest to `voxelAxes` whose yaw, pitch and roll are multiples of the step. With a
// history an angle stays until it is past the middle between two steps by a tenth of a step.
[[nodiscard]] glm::dmat3 snapAxes(const glm::dmat3& voxelAxes, double stepDegrees,
                                  ViewHistory* history);

}  // namespace voxprite
