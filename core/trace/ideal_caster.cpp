#include "core/trace/ideal_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voxprite {
namespace {

using Real = long double;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

}  // namespace

LatticeHit castIdeal(const OctreeView& octree, const OrthoView& view, glm::ivec2 pixel) {
    const Real pxVoxels = Real{1} / view.sigmaInForce;
    const Real offset = sampleOffsetPx(view.sigmaInForce);
    std::array<Real, 3> origin;
    std::array<Real, 3> direction;
    // The ray enters the box through the last of its three near faces.
    Real enter = -kInfinity;
    Real leave = kInfinity;
    int axis = 0;
    for (int a = 0; a < 3; ++a) {
        origin[a] =
            octree.size[a] / 2 +
            ((pixel.x + offset) * view.right[a] + (pixel.y + offset) * view.up[a]) * pxVoxels;
        direction[a] = view.forward[a];
        if (direction[a] == 0) {
            if (origin[a] < 0 || origin[a] >= octree.size[a]) return {};
            continue;
        }
        const Real low = -origin[a] / direction[a];
        const Real high = (octree.size[a] - origin[a]) / direction[a];
        if (std::min(low, high) >= enter) {
            enter = std::min(low, high);
            axis = a;
        }
        leave = std::min(leave, std::max(low, high));
    }
    if (!(enter < leave)) return {};

    glm::ivec3 cell{0};
    std::array<Real, 3> next;  // when each axis crosses the face ahead of the cell
    const auto crossAhead = [&](int a) {
        if (direction[a] == 0) return kInfinity;
        return (cell[a] + (direction[a] > 0 ? 1 : 0) - origin[a]) / direction[a];
    };
    for (int a = 0; a < 3; ++a) {
        const Real at = direction[a] == 0 ? origin[a] : origin[a] + enter * direction[a];
        const Real behind = direction[a] < 0 ? std::ceil(at) - 1 : std::floor(at);
        cell[a] = std::clamp(static_cast<int>(behind), 0, octree.size[a] - 1);
        next[a] = crossAhead(a);
    }
    for (;;) {
        if (const std::uint8_t material = materialAt(octree, cell); material != 0)
            return {material, static_cast<std::uint8_t>(axis), cell};
        axis = 0;
        if (next[1] < next[axis]) axis = 1;
        if (next[2] < next[axis]) axis = 2;
        cell[axis] += direction[axis] > 0 ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= octree.size[axis]) return {};
        next[axis] = crossAhead(axis);
    }
}

}  // namespace voxprite
