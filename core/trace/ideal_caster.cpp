#include "core/trace/ideal_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voxprite {
namespace {

using Real = long double;
using Axes = std::array<Real, 3>;

constexpr Real kNever = std::numeric_limits<Real>::infinity();

}  // namespace

LatticeHit castIdeal(const OctreeView& octree, const OrthoView& view, glm::ivec2 pixel) {
    const Real pxVoxels = Real{1} / view.sigmaInForce;
    const Real offset = sampleOffsetPx(view.sigmaInForce);
    Axes origin;
    Axes direction;
    Real enter = -kNever;
    Real leave = kNever;
    for (int a = 0; a < 3; ++a) {
        origin[a] = octree.size[a] / 2 + (pixel.x + offset) * pxVoxels * view.right[a] +
                    (pixel.y + offset) * pxVoxels * view.up[a];
        direction[a] = view.forward[a];
        if (direction[a] == 0) {
            if (origin[a] < 0 || origin[a] >= octree.size[a]) return {};
            continue;
        }
        const Real atMin = -origin[a] / direction[a];
        const Real atMax = (octree.size[a] - origin[a]) / direction[a];
        enter = std::max(enter, std::min(atMin, atMax));
        leave = std::min(leave, std::max(atMin, atMax));
    }
    if (!(enter < leave)) return {};

    // The cell just inside the box, and when each axis crosses its next face.
    glm::ivec3 cell{0};
    Axes next;
    Axes last;
    const auto faceTime = [&](int a) {
        if (direction[a] == 0) return kNever;
        return (cell[a] + (direction[a] > 0 ? 1 : 0) - origin[a]) / direction[a];
    };
    int axis = 0;
    for (int a = 0; a < 3; ++a) {
        const Real at = origin[a] + enter * direction[a];
        const Real below = direction[a] < 0 ? std::ceil(at) - 1 : std::floor(at);
        cell[a] = std::clamp(static_cast<int>(below), 0, octree.size[a] - 1);
        next[a] = faceTime(a);
        const Real entryFace = direction[a] < 0 ? octree.size[a] : 0;
        last[a] = direction[a] == 0 ? -kNever : (entryFace - origin[a]) / direction[a];
        if (last[a] >= last[axis]) axis = a;
    }
    for (;;) {
        if (const std::uint8_t material = materialAt(octree, cell); material != 0)
            return {material, static_cast<std::uint8_t>(axis), cell};
        axis = 0;
        if (next[1] < next[axis]) axis = 1;
        if (next[2] < next[axis]) axis = 2;
        cell[axis] += direction[axis] > 0 ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= octree.size[axis]) return {};
        next[axis] = faceTime(axis);
    }
}

}  // namespace voxprite
