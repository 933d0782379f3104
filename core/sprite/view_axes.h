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

// The view step that a new game starts with in the editor, chosen from what `voxprite trade
// --temporal` measures (README). A profile's own default is 0: headless commands snap nothing.
inline constexpr double kUsualViewStepDegrees = 2.5;

// The axes near `voxelAxes` whose yaw, pitch and roll are multiples of the step; straight from
// above or below there is no roll. The step is the one nearest to `stepDegrees` that divides 45
// degrees, so that views along axes and diagonals are among the snapped ones, and the circle has no
// seam.
//
// With a history an angle stays until it is past the middle between two steps by a tenth of a step;
// yaw and roll by more toward the poles (a tenth of the way that the eye goes), at most by a step.
// So what is shown is always one of the snapped views, and which one depends on the history only
// within that band. An eye that trembles about the model by a twentieth of a step never changes the
// picture, up to 84 degrees of pitch; nearer to the pole the picture itself turns with the eye.
[[nodiscard]] glm::dmat3 snapAxes(const glm::dmat3& voxelAxes, double stepDegrees,
                                  ViewHistory* history);

}  // namespace voxprite
