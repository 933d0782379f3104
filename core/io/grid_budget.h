// Voxels of a file that is not trusted, put into grids within a limit: OpenVDB stores 8 x 8 x 8
// voxels even for one, so that a small file may ask for much memory.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <unordered_set>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

// What blocks may take whatever the file's length: 1 GiB. A fuzz target links a smaller figure
// (tests/fuzz/grid_allowance.cpp), or most of its time would go into filling grids.
extern const std::uint64_t kGridAllowanceBytes;

// For all grids of one file together: the allowance, and more where the file is large itself.
class GridBudget {
  public:
    explicit GridBudget(std::uint64_t fileBytes)
        : blocksLeft_((kGridAllowanceBytes + 32 * fileBytes) / kBytesPerBlock) {}

    // Is there room for so many more?
    [[nodiscard]] bool has(std::uint64_t blocks) const { return blocks <= blocksLeft_; }
    [[nodiscard]] bool takeOne() {
        if (blocksLeft_ == 0) return false;
        --blocksLeft_;
        return true;
    }
    [[nodiscard]] static std::string refusal() {
        return "the voxels would take more memory than a file of this length may ask for";
    }

  private:
    static constexpr std::uint64_t kBytesPerBlock = 640;
    std::uint64_t blocksLeft_;
};

class BudgetedGrid {
  public:
    // `budget` outlives this.
    explicit BudgetedGrid(GridBudget& budget) : budget_(&budget) {}

    // `v` within the range of voxels, `value` not 0. False when the budget is used up.
    [[nodiscard]] bool set(glm::ivec3 v, std::uint8_t value) {
        const glm::ivec3 block(v.x >> 3, v.y >> 3, v.z >> 3);
        if (block != lastBlock_ || !started_) {
            if (blocks_.insert(keyOf(block)).second && !budget_->takeOne()) return false;
            lastBlock_ = block;
            started_ = true;
        }
        grid_.set(v, value);
        return true;
    }
    // The same for a cube of an edge that is a power of two, aligned to it.
    [[nodiscard]] bool fill(const IBox& cube, std::uint8_t value) {
        const int edge = cube.size().x;
        // What is stored as one value costs the node above it: of 64 or 512 voxels an edge.
        const int shift = edge >= 64 ? 9 : 6;
        std::unordered_set<std::uint64_t>& nodes = edge >= 64 ? largeNodes_ : smallNodes_;
        const glm::ivec3 first = cube.min >> shift;
        const glm::ivec3 last = (cube.max - 1) >> shift;
        const auto across = static_cast<std::uint64_t>(last.x - first.x) + 1;
        if (!budget_->has(across * across * across)) return false;
        for (int x = first.x; x <= last.x; ++x) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int z = first.z; z <= last.z; ++z) {
                    const bool isNew = nodes.insert(keyOf({x, y, z})).second;
                    for (int k = 0; isNew && k < kBlocksOfNode; ++k) {
                        if (!budget_->takeOne()) return false;
                    }
                }
            }
        }
        if (edge < 8 && !set(cube.min, value)) return false;
        grid_.fill(cube, value);
        return true;
    }
    // Of a block that takes as much of the file as of memory.
    void setUnpaid(glm::ivec3 v, std::uint8_t value) { grid_.set(v, value); }
    [[nodiscard]] VoxelGrid release() { return std::move(grid_); }

  private:
    static constexpr int kBlocksOfNode = 16;
    // Blocks more than 2^21 apart may share a key, and then count once.
    static std::uint64_t keyOf(glm::ivec3 block) {
        const auto bits = [](int x) { return static_cast<std::uint64_t>(x) & 0x1F'FFFF; };
        return bits(block.x) << 42 | bits(block.y) << 21 | bits(block.z);
    }

    GridBudget* budget_;
    VoxelGrid grid_;
    std::unordered_set<std::uint64_t> blocks_;
    std::unordered_set<std::uint64_t> smallNodes_, largeNodes_;
    glm::ivec3 lastBlock_{0};
    bool started_ = false;
};

}  // namespace voxprite
