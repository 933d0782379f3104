// The quads of one brick of cells: what a cluster draws.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/lod/cluster_mesh.h"
#include "core/svo/octree.h"

namespace voxprite {

// One level of detail: its cells, and the model that they were made from.
struct BrickLevel {
    OctreeView finest;  // the model itself, in its tree space
    OctreeView
        cells;  // cell (0,0,0) of its tree space is `firstCell` of the finest one's, in cells
    glm::ivec3 firstCell{0};
    int level = 0;  // a cell is a cube of 2^level voxels
    int brickCells = 16;
};

// Greedy rectangles of one material (core/lod/greedy_rectangles.h) over the faces of the brick's
// cells. Faces without are those between solid cells of the brick and, across its border, those
// with voxels of the model all over behind them.
// `brick` counts bricks from the tree's origin. One object serves many bricks, on one thread.
class BrickMesher {
  public:
    explicit BrickMesher(const BrickLevel& level);

    // Four vertices a quad, as ClusterVertex says.
    [[nodiscard]] std::vector<ClusterVertex> quads(glm::ivec3 brick);

  private:
    void slice(int face, int k, glm::ivec3 brick, std::vector<ClusterVertex>& out);
    // Where faces of the outermost slice are to be drawn because something behind them is empty.
    void openBorder(int face, glm::ivec3 brick);
    void emit(int face, glm::ivec3 min, glm::ivec3 max, std::uint8_t material, glm::ivec3 brick,
              std::vector<ClusterVertex>& out) const;

    BrickLevel level_;
    std::vector<std::uint8_t> cells_;  // of the brick at hand, x fastest
    std::vector<std::uint8_t> open_;   // of its border: 1 where a face would be seen, u fastest
    std::vector<std::uint8_t> faces_;  // of one slice: the material where a face is to be drawn
};

}  // namespace voxprite
