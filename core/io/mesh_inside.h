// Which cells lie inside a mesh: by the surface's crossings of the lines through the cells'
// centres, along each axis. Unlike a flood from outside this sees cavities and gaps of one cell.
//
// Space  cell (x, y, z) is the cube of edge 1 at that corner; its centre is at + 0.5.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/io/triangle_mesh.h"

namespace voxprite {

// A bit a cell of [0, size).
class CellMask {
  public:
    explicit CellMask(glm::ivec3 size);
    [[nodiscard]] glm::ivec3 size() const { return size_; }
    // False outside of the size.
    [[nodiscard]] bool at(glm::ivec3 cell) const {
        if (cell.x < 0 || cell.y < 0 || cell.z < 0 || cell.x >= size_.x || cell.y >= size_.y ||
            cell.z >= size_.z) {
            return false;
        }
        const std::size_t bit = indexOf(cell);
        return (words_[bit >> 6] >> (bit & 63) & 1) != 0;
    }
    void set(glm::ivec3 cell) {
        const std::size_t bit = indexOf(cell);
        words_[bit >> 6] |= std::uint64_t{1} << (bit & 63);
    }
    [[nodiscard]] std::uint64_t count() const;

  private:
    [[nodiscard]] std::size_t indexOf(glm::ivec3 cell) const {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(size_.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(cell.x);
    }
    glm::ivec3 size_;
    std::vector<std::uint64_t> words_;
};

struct InsideCells {
    // Whether the surface is closed as far as the lines see it: all of them leave as often as they
    // enter, and the axes agree on how much lies inside. (Holes smaller than a cell, edges that
    // meet without sharing corners and walls that pass through each other do no harm.) Parts
    // thinner than a cell may hold no centre.
    bool closed = false;
    CellMask cells;  // all false unless closed
};

// Inside is where the surface winds around; where its sides are not told apart (some triangles
// turned outside in), what an odd number of crossings leads to. Any size whose cells fit memory
// as bits. Time grows with the crossings: the triangles' areas in cells.
[[nodiscard]] InsideCells insideOf(std::span<const MeshTriangle> triangles, glm::ivec3 size);

}  // namespace voxprite
