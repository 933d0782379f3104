// The cells about a mesh's surface and inside of it.
//
// Space  cell (x, y, z) is the cube of edge 1 at that corner; its centre is at + 0.5.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/base/result.h"
#include "core/io/mesh_inside.h"
#include "core/io/triangle_mesh.h"
#include "core/volume/volume_library.h"

namespace voxprite {

// Which triangle is nearest to each cell that the surface comes near to. At least one triangle.
// Both fail when there is not enough memory.
[[nodiscard]] Result<std::unique_ptr<NearestTriangles>> surfaceBand(
    std::span<const MeshTriangle> triangles);

// For surfaces that are not closed: the cells of [0, size) that a flood from outside does not
// reach.
[[nodiscard]] Result<CellMask> floodedInside(std::span<const MeshTriangle> triangles,
                                             glm::ivec3 size);

}  // namespace voxprite
