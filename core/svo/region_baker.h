// Bakes cubes of up to 64 voxels an edge out of a grid's own blocks, eight by eight by eight voxels
// at a time: their rows are shifted to where the cubes of the octree lie, cut into the payloads of
// 64 bricks, and those become nodes without a branch on what they hold.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/model/voxel_grid.h"
#include "core/svo/tree_builder.h"

namespace voxprite {

// A cube of the grid: an aligned one of 64 voxels with the blocks of eight in it, or, where
// `blocks` is empty, a larger or equal one that is all `uniformValue`.
struct VoxelRegion {
    glm::ivec3 origin{0};
    int edgeVoxels = 64;
    std::uint8_t uniformValue = 0;
    std::span<const VoxelBlock> blocks;
};

// Of one thread; its nodes go to `builder`.
class RegionBaker {
  public:
    static constexpr int kEdge = 64;

    // Entity space of tree (0,0,0) is bounds.min; nothing beyond bounds.max is baked.
    RegionBaker(const IBox& bounds, TreeBuilder& builder);

    // The word of the cube at `min` of tree space: of kEdge voxels, or the root's when the tree is
    // smaller. `sources` are all those that hold voxels in it; others do no harm.
    [[nodiscard]] std::uint32_t bake(glm::ivec3 min, std::span<const VoxelRegion> sources);

  private:
    static constexpr int kCells = kEdge / 8;
    static constexpr int kBlocks = kCells + 1;  // that touch a region which lies across them

    // Rows of eight voxels along z; (x, y) at rows + step * (64 * x + 8 * y). Uniform: step 0.
    struct Block {
        const std::uint8_t* rows;
        std::ptrdiff_t step;
    };

    void put(glm::ivec3 block, Block rows);
    void putUniform(const VoxelRegion& source, const IBox& box);
    [[nodiscard]] bool anyCell(unsigned first, unsigned count) const;
    // Cells [first, first + count), in the order of octants.
    [[nodiscard]] std::uint32_t cells(int depth, unsigned first, unsigned count);
    [[nodiscard]] std::uint32_t cell(unsigned index);
    // The value that all blocks around a cell have, or -1.
    [[nodiscard]] int valueAround(const Block* at) const;
    void gather(const Block* at);
    void clip(glm::ivec3 end);

    IBox bounds_;
    TreeBuilder& builder_;
    glm::ivec3 offset_;      // of a cell's corner in the block that holds it
    glm::ivec3 firstBlock_;  // entity space of blocks_[0]
    glm::ivec3 min_;         // tree space of the region
    std::array<Block, kBlocks * kBlocks * kBlocks> blocks_;  // [(x * kBlocks + y) * kBlocks + z]
    std::array<std::uint64_t, kCells> occupied_;             // a bit for each cell
    std::array<std::uint64_t, 64> rows_;                     // of a cell: [(x << 3) | y]
    std::array<std::uint64_t, 64> payloads_;                 // of a cell, in the order of octants
};

}  // namespace voxprite
