// The tip of the brush, and the trail that it leaves.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/edit/voxel_set.h"

namespace voxprite {

enum class TipShape : std::uint8_t { cube, sphere, disc };

inline constexpr int kMaxTipEdge = 64;

struct BrushTip {
    TipShape shape = TipShape::cube;
    int edge = 1;  // voxels, 1 ... kMaxTipEdge; the diameter of spheres and discs
    int axis = 2;  // 0, 1 or 2: the axis that a disc of one layer stands across
    bool operator==(const BrushTip&) const = default;
};

// The box of a tip at voxel `v`. Odd edges are centred on it; even ones have it just below their
// centre, on every axis.
[[nodiscard]] IBox tipBox(const BrushTip& tip, glm::ivec3 v);
[[nodiscard]] std::vector<glm::ivec3> tipVoxels(const BrushTip& tip, glm::ivec3 v);

// The voxels from `a` to `b`, both included, each touching the next by at least a corner (Bresenham
// in three dimensions). The same voxels from `b` to `a`, in reverse.
[[nodiscard]] std::vector<glm::ivec3> voxelLine(glm::ivec3 a, glm::ivec3 b);

// What a tip has swept over. Every call returns only voxels that it has not covered before, none
// twice; a step to a neighbour costs as much as the tip's surface, not its volume.
class BrushTrail {
  public:
    explicit BrushTrail(const BrushTip& tip);

    // Puts the tip down at `v` without a line from where it was.
    std::vector<glm::ivec3> startAt(glm::ivec3 v);
    // Draws it along voxelLine() from where it was (or puts it down), leaving no gap.
    std::vector<glm::ivec3> lineTo(glm::ivec3 v);

    [[nodiscard]] const VoxelSet& covered() const { return covered_; }

  private:
    void cover(glm::ivec3 at, const std::vector<glm::ivec3>& offsets,
               std::vector<glm::ivec3>& fresh);
    [[nodiscard]] const std::vector<glm::ivec3>& frontOf(glm::ivec3 step);

    std::vector<glm::ivec3> offsets_;  // of the whole tip
    // Of the part that lies ahead when the tip goes one step, for each of 27 steps; made at need.
    std::array<std::vector<glm::ivec3>, 27> fronts_;
    VoxelSet covered_;
    std::optional<glm::ivec3> at_;
};

}  // namespace voxprite
