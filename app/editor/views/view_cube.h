// The cube in the corner of a view that shows how it is turned. A click on a face, an edge or a
// corner looks from there; dragging orbits.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "app/editor/views/orbit_camera.h"
#include "app/editor/window/theme.h"

namespace voxprite::editor {

// Half the edge of the drawn cube and the radius around its middle that takes the mouse; at content
// scale 1.
inline constexpr float kViewCubeHalfEdge = 24.0f, kViewCubeRadius = 46.0f;

// The part of the cube under a point, `fromMiddlePx` from its middle (y down): -1, 0 or 1 on each
// voxel axis, one of them not 0 for a face, two for an edge, three for a corner. Nothing beside it.
[[nodiscard]] std::optional<glm::ivec3> viewCubePartAt(const OrbitCamera& camera, double halfEdgePx,
                                                       glm::dvec2 fromMiddlePx);

void drawViewCube(const Theme& theme, ImDrawList& draw, ImVec2 middle, const OrbitCamera& camera,
                  const std::optional<glm::ivec3>& lit);

}  // namespace voxprite::editor
