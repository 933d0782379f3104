// The cells about a mesh's surface, through OpenVDB (which stays in the .cpp).
//
// Space  cell (x, y, z) is the cube of edge 1 at that corner; its centre is at + 0.5.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/base/result.h"
#include "core/io/mesh_inside.h"
#include "core/io/triangle_mesh.h"

namespace voxprite {

// Which triangle is nearest to the centre of each cell that the surface comes near to: every cell
// whose centre is within 0.86 of it, and some that are a little farther away. Distances are
// OpenVDB's, in single precision; of equal ones the lowest index. The result does not depend on
// the number of threads. Reading from several threads at once is safe.
class SurfaceBand {
  public:
    // At least one triangle. Fails when there is not enough memory.
    [[nodiscard]] static Result<SurfaceBand> of(std::span<const MeshTriangle> triangles);
    ~SurfaceBand();
    SurfaceBand(SurfaceBand&&) noexcept;
    SurfaceBand& operator=(SurfaceBand&&) noexcept;

    // The triangles of the cube of 8 cells at `origin`, a multiple of 8, in the order of VoxelBlock
    // (core/model/voxel_grid.h), -1 where the surface is farther; null when it is for all of them.
    [[nodiscard]] const std::int32_t* blockAt(glm::ivec3 origin) const;

  private:
    struct Impl;
    explicit SurfaceBand(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// For surfaces that are not closed: the cells of [0, size) that a flood from outside does not
// reach, going round the surface, by the sign of OpenVDB's level set. Holes of more than about a
// cell let it in.
[[nodiscard]] Result<CellMask> floodedInside(std::span<const MeshTriangle> triangles,
                                             glm::ivec3 size);

}  // namespace voxprite
