// Whole rectangles of a lattice's rays at once, exactly as the scalar caster casts them one by one.
//
// Parallel rays meet the nodes of an octree in one order, whatever their pixel: where all rays run
// upward on every axis (after mirroring, see octree_walk.h), what lies in a node's lower half on an
// axis is never met after what lies in the upper half, so octants 0, 1, ... 7 come front to back,
// depth first. A packet of up to 64 x 64 rays therefore goes down the octree once, together
// (Meagher 1982, front-to-back octree display): one bit a ray tells which still look for their
// hit, a subtree that no such ray can meet is left out, and the first voxel drawn over a pixel is
// its hit. No ray ever steps through empty space, and what is hidden costs one test at the largest
// node that is hidden whole.
//
// Why this is exact. Two things decide, both in integers:
//
// - Which rays meet a voxel. A line is in the cell with lower faces l and upper faces u = l + 1 at
//   some time, by the order of crossings that core/trace/lattice.h defines, if and only if for all
//   axes a, b its crossing of l[a] comes before that of u[b]. With O the ray's start, all mirrored
//   so that D >= 0, and times multiplied by D[a] D[b], the two conditions on a pair a < b say
//
//     2^P (l[a] D[b] - u[b] D[a])  <=  G[ab]  <  2^P (u[a] D[b] - l[b] D[a]),
//     G[ab] = O[a] D[b] - O[b] D[a],
//
//   where "<=" on one side is the rule for ties: the lower axis goes first. Three such tests are a
//   hexagon in the sprite plane, half open just so that each pixel belongs to one of two
//   neighbours. The lower face crossed last, which is the hit's face, follows from the signs of
//   G[ab] - 2^P (l[a] D[b] - l[b] D[a]): not negative means that b's is crossed after a's. An axis
//   with D[a] = 0 needs no case of its own once the lowest bit of O[a] is set; a pair of such axes
//   decides nothing and is let through. (Whether it lies in such an axis's slab is decided in the
//   pairs with the third.) G depends on the ray alone and is worked out once; a voxel's part is
//   linear in its corner.
// - Which rays are asked. The pixels that a node can cover lie in a rectangle found with
//   fixed-point arithmetic, rounded outward (pixelBounds in lattice.h does the same for the whole
//   model). It may be too large, never too small, so it chooses what is tested and not what is hit.
//
// The tests run modulo 2^32. That is enough because a pixel in a voxel's rectangle lies near the
// voxel: the tables bound how far G can be off. For a lattice so skewed that this is too far, the
// scalar caster stands in.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "core/trace/lattice_caster.h"

namespace voxprite {

struct PacketTables;  // core/trace/packet_tables.h

// What the rays of one packet hit. Reused from packet to packet, it allocates nothing.
class PacketHits {
  public:
    static constexpr int kEdge = 64;  // pixels: a packet's largest width and height

    // Column and row from the packet's first pixel. What LatticeCaster::cast gives for it.
    [[nodiscard]] LatticeHit at(int column, int row) const {
        const std::uint32_t entry = entries[index(column, row)];
        if (entry == 0) return {};
        LatticeHit hit = voxels[entry >> 2];
        hit.faceAxis = entry & 3;
        return hit;
    }

    // onHit(column, row) for every pixel that was hit in so many rows.
    template <class OnHit>
    void forEachHit(int rowCount, const OnHit& onHit) const {
        for (int row = 0; row < rowCount; ++row)
            for (std::uint64_t bits = rows[static_cast<std::size_t>(row)]; bits != 0;
                 bits &= bits - 1)
                onHit(std::countr_zero(bits), row);
    }

    // Nothing is hit in so many rows.
    void clear(int rowCount) {
        rows.fill(0);
        std::fill_n(entries.begin(), index(0, rowCount), 0u);
        voxels.assign(1, LatticeHit{});
    }

    // What one ray hit, if anything.
    void add(int column, int row, const LatticeHit& hit) {
        if (hit.material == 0) return;
        rows[static_cast<std::size_t>(row)] |= std::uint64_t{1} << column;
        entries[index(column, row)] = static_cast<std::uint32_t>(voxels.size()) << 2 | hit.faceAxis;
        voxels.push_back(hit);
    }

    static constexpr std::size_t index(int column, int row) {
        return static_cast<std::size_t>(row) * kEdge + static_cast<std::size_t>(column);
    }
    // Vectors read and write past the end of the last row.
    static constexpr std::size_t kPadding = 64;
    static constexpr std::size_t kEntries = std::size_t{kEdge} * kEdge + kPadding;

    // A bit a pixel that was hit: column c of a row is bit c.
    std::array<std::uint64_t, kEdge> rows;
    // 0: nothing was hit. Else 4 * (the voxel's place in `voxels`) + the face's axis.
    alignas(64) std::array<std::uint32_t, kEntries> entries;
    // voxels[0] stands for none. Each is there once, with no axis.
    std::vector<LatticeHit> voxels;
    // Of the rays themselves: the caster's scratch (G of packet_caster.h by pair of axes).
    alignas(64) std::array<std::array<std::int32_t, kEntries>, 3> starts;
};

class PacketCaster {
  public:
    // `lattice` as quantiseView or validateLattice leave it. Must not outlive the octree's arrays.
    PacketCaster(const OctreeView& octree, const LatticeView& lattice);
    ~PacketCaster();
    PacketCaster(const PacketCaster&) = delete;
    PacketCaster& operator=(const PacketCaster&) = delete;

    // Casts the pixels [first, first + size), at most kEdge on either axis. One caster may serve
    // many threads, each with hits of its own.
    void cast(glm::ivec2 first, glm::ivec2 size, PacketHits& hits) const;

    // False where the scalar caster stands in.
    [[nodiscard]] bool fast() const;

  private:
    LatticeCaster scalar_;
    std::unique_ptr<const PacketTables> tables_;
};

// A whole picture by packets: for every pixel of [first, first + size) whose ray hits, what
// LatticeCaster::cast gives for it. `onHit` is called on several threads, once a pixel.
// threads <= 0: all cores.
using OnLatticeHit = std::function<void(glm::ivec2 pixel, const LatticeHit& hit)>;
void castLattice(const OctreeView& octree, const LatticeView& lattice, glm::ivec2 first,
                 glm::ivec2 size, int threads, const OnLatticeHit& onHit);

}  // namespace voxprite
