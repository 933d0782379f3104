// The sprite specification (seed 001) read by the letter, one small function for each reading that
// core/ decides otherwise. Only `voxprite trade --conformance` calls them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "core/svo/octree.h"
#include "core/trace/lattice_caster.h"

namespace voxprite::conformance {

// Section 5.1, steps 1 to 4: the offset from the anchor's place on the screen, in voxels, for a
// `cameraDistance` in metres. `screenPx` from the top left corner. Steps 3 and 4 know neither the
// entity's scale nor orthographic cameras.
[[nodiscard]] glm::dvec2 literalAnchorOffset(const Camera& camera, glm::dvec3 anchorMetres,
                                             double cameraDistance, double voxelSizeMetres,
                                             glm::dvec2 screenPx);
// Section 5.2: "the distance from the camera to the anchor point".
[[nodiscard]] double euclideanDistance(const Camera& camera, glm::dvec3 pointMetres);
// Section 10: anchor_to_center of a model on a bottom-centre anchor.
[[nodiscard]] glm::dvec3 literalAnchorToCentre(glm::ivec3 modelSize);
// Section 6.1: the camera's axes swizzled, whatever way the proxy box is turned. Columns right, up
// and forward in voxel space.
[[nodiscard]] glm::dmat3 literalVoxelAxes(const Camera& camera);
// Section 5.1, step 5: sample (i, j) at round(), that is at whole virtual pixels from the centre;
// `offsetPx` more along both axes. In voxels from the minimum corner.
[[nodiscard]] std::array<long double, 3> centredSample(const OrthoView& view, glm::ivec3 modelSize,
                                                       glm::ivec2 pixel, double offsetPx = 0.0);
// Section 9: model, view and projection as fp32 matrices over world coordinates. Screen position
// of a world point.
[[nodiscard]] glm::dvec2 projectThroughFp32World(const Camera& camera, glm::dvec3 objectMetres,
                                                 glm::dvec3 pointFromObject);
// Section 9: z / w * 0.5 + 0.5 in a 24-bit depth buffer.
[[nodiscard]] std::uint32_t depth24(double nearMetres, double farMetres, double depthMetres);
// Seed 004's octants, x in the highest bit.
[[nodiscard]] std::uint8_t materialInProseOrder(const OctreeView& octree, glm::ivec3 tree);

// Cell by cell in long double along an infinite line. Coordinates are in units of which a voxel has
// `unitsPerVoxel`: with integers (a lattice ray) every comparison is exact, since quotients of
// numbers below 2^31 that differ do so within the 64 bits of a long double.
[[nodiscard]] LatticeHit castCells(const OctreeView& octree,
                                   const std::array<long double, 3>& origin,
                                   const std::array<long double, 3>& direction,
                                   long double unitsPerVoxel = 1.0L);

}  // namespace voxprite::conformance
