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

// How a picture is to be turned in its plane when it shows the model along `shown` where `seen`
// (both right, up and forward in voxel space) would be right: `plane` turned about its forward so
// that the points of the model's box, of `size` voxels, come to lie, by the sum of squares, as near
// to their true places as they can. So what is tall stays upright. Where the two views agree the
// plane is returned as it is.
[[nodiscard]] glm::dmat3 rolledToMatch(const glm::dmat3& plane, const glm::dmat3& seen,
                                       const glm::dmat3& shown, glm::ivec3 size);

// In radians, between unit vectors; precise for small angles too.
[[nodiscard]] double angleBetween(glm::dvec3 a, glm::dvec3 b);

}  // namespace voxprite
