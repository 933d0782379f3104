// The editable store of one model's voxels: a sparse OpenVDB tree of 8-bit palette indices.
//
// Space: integer model space, Z up, right-handed; coordinates may be negative or far apart, within
// +-kMaxCoordinate. Value 0 is empty, 1..255 a palette index. OpenVDB itself stays in the .cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>

#include "core/base/box.h"

namespace voxprite {

inline constexpr int kMaxCoordinate = 1 << 24;
[[nodiscard]] inline bool isInVoxelRange(glm::ivec3 v) {
    const auto inRange = [](int x) { return x >= -kMaxCoordinate && x <= kMaxCoordinate; };
    return inRange(v.x) && inRange(v.y) && inRange(v.z);
}
[[nodiscard]] inline IBox voxelRange() {
    return IBox::around(glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate));
}

// A cube of voxels handed out by forEachBlock or blockAt, aligned to its edge, a power of eight.
// When `voxels` is null every voxel in the cube is `uniformValue` (never 0); else edgeVoxels is 8
// and the value at origin + (x, y, z) is voxels[(x << 6) | (y << 3) | z]. `voxels` points into the
// grid itself and stays valid until the grid next changes; so does `solid`, eight words that say
// which of these voxels are not 0: bit (y << 3) | z of word x.
struct VoxelBlock {
    glm::ivec3 origin{0};
    int edgeVoxels = 8;
    std::uint8_t uniformValue = 0;
    const std::uint8_t* voxels = nullptr;
    const std::uint64_t* solid = nullptr;  // null where `voxels` is

    [[nodiscard]] IBox box() const { return {origin, origin + edgeVoxels}; }
};

// A cube handed out by forEachRegion, aligned to its edge: one of 64 voxels with blocks of eight in
// it, or, when `blocks` is null, one of 64 or 512 voxels that are all `uniformValue` (never 0).
// Valid until the grid next changes.
struct VoxelRegion {
    glm::ivec3 origin{0};
    int edgeVoxels = 64;
    std::uint8_t uniformValue = 0;
    int blockCount = 0;            // of 512; a few may turn out to hold nothing
    const void* blocks = nullptr;  // the grid's own
};

// Reading from several threads at once is safe; writing is not. A grid that was moved from may only
// be assigned to or destroyed.
class VoxelGrid {
  public:
    VoxelGrid();
    ~VoxelGrid();
    VoxelGrid(const VoxelGrid& other);  // deep
    VoxelGrid& operator=(const VoxelGrid& other);
    VoxelGrid(VoxelGrid&&) noexcept;
    VoxelGrid& operator=(VoxelGrid&&) noexcept;

    [[nodiscard]] std::uint8_t get(glm::ivec3 v) const;
    // Coordinates beyond kMaxCoordinate are a bug of the caller (checked in debug builds).
    void set(glm::ivec3 v, std::uint8_t value);
    // Sparse: whole blocks inside the box cost one entry.
    void fill(const IBox& box, std::uint8_t value);
    // Replaces the cube of 8 at `origin`, a multiple of 8, by 512 values in VoxelBlock's order.
    void setBlock(glm::ivec3 origin, const std::uint8_t* voxels);
    void clear();

    [[nodiscard]] std::uint64_t solidCount() const;  // O(blocks)
    // Cubes of 8, aligned as blocks are, with something solid in them. O(blocks).
    [[nodiscard]] std::uint64_t cubeCount() const;
    [[nodiscard]] bool empty() const;
    [[nodiscard]] std::size_t bytes() const;  // memory held, about
    // The tight box around the solid voxels; an empty box when there are none. O(blocks).
    [[nodiscard]] IBox bounds() const;

    // The block that holds `v`, as it is stored; here uniformValue may be 0.
    [[nodiscard]] VoxelBlock blockAt(glm::ivec3 v) const;
    // Every block that holds solid voxels, in a fixed order that depends on the voxels alone.
    void forEachBlock(const std::function<void(const VoxelBlock&)>& visit) const;
    // The same in larger cubes, for whoever wants only a part of the blocks, or another order.
    void forEachRegion(const std::function<void(const VoxelRegion&)>& visit) const;
    // The blocks of eight in `region`, which is not uniform, that touch `box` and hold something.
    static void forEachBlockIn(const VoxelRegion& region, const IBox& box,
                               const std::function<void(const VoxelBlock&)>& visit);
    // Every solid voxel, in the order of blocks.
    void forEachSolid(const std::function<void(glm::ivec3 v, std::uint8_t value)>& visit) const;

    // The same voxels (how they are stored does not count).
    bool operator==(const VoxelGrid& other) const;

    // Repeated reads of nearby voxels, several times faster than get(). One thread each; must not
    // outlive the grid, nor a change to it.
    class Reader {
      public:
        explicit Reader(const VoxelGrid& grid);
        ~Reader();
        Reader(const Reader&) = delete;
        Reader& operator=(const Reader&) = delete;
        [[nodiscard]] std::uint8_t get(glm::ivec3 v) const;

      private:
        struct Impl;
        std::unique_ptr<Impl> impl_;
    };

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite
