// Bakes cubes of up to 64 voxels an edge out of a grid's own blocks, eight by eight by eight voxels
// at a time. What is solid is known from the blocks' bits alone: folded and put in the order of
// octants they are the masks of the nodes above the bricks. Bytes are looked at only where bricks
// are.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/model/voxel_grid.h"
#include "core/svo/tree_builder.h"

namespace voxprite {

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

    // As a VoxelBlock has them.
    struct Block {
        const std::uint8_t* voxels;
        const std::uint64_t* solid;
        int onlyValue;  // that all its voxels have, or -1
    };
    using Voxels = std::array<std::uint8_t, 512>;

    void put(glm::ivec3 block, const Block& voxels);
    void putUniform(const VoxelRegion& source, const IBox& box);
    [[nodiscard]] Block uniformBlock(std::uint8_t value);
    [[nodiscard]] bool anyCell(unsigned first, unsigned count) const;
    // Cells [first, first + count), in the order of octants.
    [[nodiscard]] std::uint32_t cells(int depth, unsigned first, unsigned count);
    [[nodiscard]] std::uint32_t cell(unsigned index);
    // The value that all blocks around a cell have, or -1.
    [[nodiscard]] int valueAround(const Block* at) const;
    // Into solid_ and rows_, shifted by the offset. False when nothing is solid.
    [[nodiscard]] bool gatherSolid(const Block* at, glm::ivec3 end);
    void gatherRows(const Block* at, glm::ivec3 end);

    IBox bounds_;
    TreeBuilder& builder_;
    glm::ivec3 offset_;      // of a cell's corner in the block that holds it
    glm::ivec3 firstBlock_;  // entity space of blocks_[0]
    glm::ivec3 min_;         // tree space of the region
    std::array<Block, kBlocks * kBlocks * kBlocks> blocks_;  // [(x * kBlocks + y) * kBlocks + z]
    std::array<std::uint64_t, kCells> occupied_;             // a bit for each cell
    std::array<std::uint64_t, 8> solid_;                     // of a cell, as of a block
    std::array<std::uint64_t, 64> rows_;                     // of a cell: [(x << 3) | y]
    std::array<std::uint64_t, 64> payloads_;                 // of a cell, in the order of octants
    std::vector<std::unique_ptr<Voxels>> uniforms_;          // blocks of one value each
};

}  // namespace voxprite
