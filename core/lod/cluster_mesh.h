// The surface of an octree as triangles at all levels of detail, cut into clusters: bricks of
// brickCells cubed cells, level by level. A cell of level L is a cube of 2^L voxels; it is solid
// when it holds any, of the material that core/svo/coarsen.h says. The brick of level L + 1 that
// covers eight of level L replaces them, up to the one that covers the root; the topmost level's
// cell is the root cube itself.
//
// Error  Every point of level L's surface is within sqrt(3) (2^L - 1) voxels of the model's: the
//        cell that it lies on holds a voxel, at worst the one in the opposite corner. What is
//        solid at a level is solid at all coarser ones. (Gaps narrower than a cell close, however
//        deep they are: seen from outside the model grows by no more than the error.)
// Mixes  Any choice of one cluster a region (cluster_cut.h) has no hole: a face is left out only
//        where the cell behind it is solid whatever level its region is shown at. Within a brick
//        that is a solid neighbour; across bricks the voxels behind the face must be solid all
//        over in the model itself. So a ray that comes from outside and enters what the chosen
//        bricks call solid meets a triangle exactly there.
//
// Space  tree space of the octree, whose corners are integers: voxel = tree - treeFromVoxel.
// Memory 56 bytes a quad (four vertices of 8, six indices of 4), 65 a cluster.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/lod/cluster_page.h"
#include "core/svo/octree.h"

namespace voxprite {

// The outward normals of faces: 0 +x, 1 +y, 2 +z, 3 -x, 4 -y, 5 -z.
inline constexpr int kFaces = 6;

// A corner of a quad. Four make one, never shared, in this order: with the face's axis a, u = a + 1
// and v = a + 2 (x after z), the corners are (u0,v0), (u1,v0), (u1,v1), (u0,v1). The low two bits
// of a vertex's number thus say which corner it is.
struct ClusterVertex {
    std::uint16_t x = 0, y = 0, z = 0;  // tree space
    std::uint8_t material = 0;          // 1 ... 255
    std::uint8_t face = 0;
    bool operator==(const ClusterVertex&) const = default;
};
static_assert(sizeof(ClusterVertex) == 8);

struct ClusterLevel {
    std::uint32_t firstPage = 0;
    std::uint32_t pageCount = 0;
    std::uint32_t quadCount = 0;
    float errorVoxels = 0.0f;
    bool operator==(const ClusterLevel&) const = default;
};

struct ClusterMesh {
    std::vector<ClusterVertex> vertices;
    std::vector<std::uint32_t> indices;    // six a quad, counter-clockwise seen from outside
    std::vector<ClusterPage> pages;        // finest level first
    std::vector<std::uint8_t> pageLevels;  // beside the pages
    std::vector<ClusterLevel> levels;      // finest first; empty for an empty model
    glm::ivec3 treeFromVoxel{0};           // the octree's
    // Around everything that any cut draws, in tree space: whole cells of the topmost level that
    // holds quads may reach beyond the model.
    IBox bounds;
    double reach = 0.0;  // clusterReach(pages)

    // Of the arrays, on the GPU as here.
    [[nodiscard]] std::uint64_t bytes() const;
};

struct ClusterBuildOptions {
    int brickCells = 16;  // the edge of a cluster in its level's cells: 4, 8, 16 or 32
    int threads = 0;      // as parallelFor; the result never depends on it
    // What the quads may take. A ball of 2,048 voxels fits the default; noise, of which most voxels
    // are seen, does from about 300 cubed on not.
    std::uint64_t mostBytes = std::uint64_t{512} << 20;
};

// Fails when the octree is 16 levels deep (its far corner has no 16-bit coordinate), when the
// options are out of range, or when the quads would take more memory than allowed or more indices
// than 32 bits can count; then before the memory is taken. An empty octree gives an empty mesh.
[[nodiscard]] Result<ClusterMesh> buildClusters(const OctreeView& octree,
                                                const ClusterBuildOptions& options = {});

}  // namespace voxprite
