// The quads of clusters taken apart into the faces of single cells, and which faces there have to
// be, worked out from the voxels alone.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "core/lod/cluster_mesh.h"
#include "tests/support/voxels.h"

namespace voxprite::test {

// Cell x, y, z in cells of the level, and the face: the material shown.
using CellFaces = std::map<std::array<int, 4>, std::uint8_t>;

// Everything that one level draws, in tree space. Fails the test at hand where two quads cover the
// same face or a quad is no rectangle of whole cells in the order that ClusterVertex promises.
[[nodiscard]] CellFaces facesOf(const ClusterMesh& mesh, int level);

// The faces that a level has to draw for a model whose voxels are given in tree space: of the cells
// that hold anything, without those toward a solid cell of the same brick and those across a
// brick's border with nothing but solid voxels behind. The materials are 0.
[[nodiscard]] CellFaces requiredFaces(const VoxelMap& voxels, int level, int brickCells);

}  // namespace voxprite::test
