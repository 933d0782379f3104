// A sparse set of voxel positions: what shapes, fills and selections are made of. It lies on a
// VoxelGrid, so that a solid box of 512 cubed costs one entry and not 134 million positions.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "core/base/box.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

// Plain value, model space. Positions beyond kMaxCoordinate are never members: inserting one does
// nothing.
class VoxelSet {
  public:
    VoxelSet() = default;
    explicit VoxelSet(std::span<const glm::ivec3> positions);
    explicit VoxelSet(const IBox& box) { insert(box); }

    [[nodiscard]] bool contains(glm::ivec3 v) const { return members_.get(v) != 0; }
    [[nodiscard]] bool empty() const { return members_.empty(); }
    [[nodiscard]] std::uint64_t count() const { return members_.solidCount(); }
    [[nodiscard]] IBox bounds() const { return members_.bounds(); }
    // In a fixed order that depends on the members alone.
    void forEach(const std::function<void(glm::ivec3 v)>& visit) const;
    // Every member has the value 1.
    [[nodiscard]] const VoxelGrid& grid() const { return members_; }

    void insert(glm::ivec3 v);
    // Costs an entry for every 512 voxels cubed, and the rim.
    void insert(const IBox& box);
    void erase(glm::ivec3 v);
    // Of the cube of 8 at `origin`, a multiple of 8: those voxels whose byte is not 0, in the order
    // of VoxelBlock.
    void insertBlock(glm::ivec3 origin, const std::uint8_t* voxels);

    // Cost: the blocks of the operands.
    void unite(const VoxelSet& other);
    void subtract(const VoxelSet& other);
    void intersect(const VoxelSet& other);

    bool operator==(const VoxelSet&) const = default;

  private:
    VoxelGrid members_;
};

}  // namespace voxprite
