#include "core/edit/regions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <unordered_map>

#include "core/base/check.h"
#include "core/edit/cube_bits.h"

namespace voxprite {

namespace {

struct CubeHash {
    std::size_t operator()(glm::ivec3 origin) const {
        const auto part = [](int x) { return static_cast<std::uint64_t>(x + kMaxCoordinate) >> 3; };
        std::uint64_t key = (part(origin.x) << 44) | (part(origin.y) << 22) | part(origin.z);
        key *= 0x9E37'79B9'7F4A'7C15u;
        return static_cast<std::size_t>(key ^ (key >> 29));
    }
};

// What may belong to a region, cube by cube.
using Eligible = std::function<CubeBits(glm::ivec3 origin)>;

// A fill that spreads cube by cube: within a cube the bits grow until nothing changes, then what
// touches a neighbouring cube is handed on to it.
class Flood {
  public:
    Flood(Eligible eligible, Neighbours neighbours, std::size_t maxBlocks)
        : eligible_(std::move(eligible)), neighbours_(neighbours), maxBlocks_(maxBlocks) {}

    [[nodiscard]] Result<VoxelSet> from(glm::ivec3 seed) {
        enter(cubeOf(seed), bitOf(seed));
        while (!open_.empty()) {
            const glm::ivec3 origin = open_.back();
            open_.pop_back();
            spreadWithin(cubes_.at(origin));
            handOn(origin, cubes_.at(origin).reached);
            if (cubes_.size() > maxBlocks_) {
                return fail("The region is too large: it spreads over more than " +
                            std::to_string(maxBlocks_) + " blocks of 8 voxels cubed");
            }
        }
        VoxelSet region;
        for (const auto& [origin, cube] : cubes_) insertBits(region, origin, cube.reached);
        return region;
    }

  private:
    struct Cube {
        CubeBits eligible{};
        CubeBits reached{};
        bool open = false;
    };

    // The cubes that nothing belongs to are remembered too: they are asked for many times.
    void enter(glm::ivec3 origin, const CubeBits& bits) {
        const auto [found, isNew] = cubes_.try_emplace(origin);
        Cube& cube = found->second;
        if (isNew) cube.eligible = eligible_(origin);
        const CubeBits fresh = bits & cube.eligible & ~cube.reached;
        if (!anyBit(fresh)) return;
        cube.reached = cube.reached | fresh;
        if (!cube.open) open_.push_back(origin);
        cube.open = true;
    }

    void spreadWithin(Cube& cube) const {
        cube.open = false;
        for (;;) {
            const CubeBits next = grown(cube.reached, neighbours_) & cube.eligible;
            if (next == cube.reached) return;
            cube.reached = next;
        }
    }

    // A copy of the bits: entering neighbours may move the table.
    void handOn(glm::ivec3 origin, const CubeBits reached) {
        for (int i = 0; i < 27; ++i) {
            const glm::ivec3 direction(i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1);
            const int axes = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
            if (axes == 0 || (neighbours_ == Neighbours::six && axes > 1)) continue;
            const CubeBits bits = crossing(reached, direction, neighbours_);
            const glm::ivec3 neighbour = origin + direction * kCubeEdge;
            if (anyBit(bits) && isInVoxelRange(neighbour)) enter(neighbour, bits);
        }
    }

    Eligible eligible_;
    Neighbours neighbours_;
    std::size_t maxBlocks_;
    std::unordered_map<glm::ivec3, Cube, CubeHash> cubes_;
    std::vector<glm::ivec3> open_;
};

// The voxels that `rule` counts as like the seed.
Eligible likeSeed(const VoxelGrid& voxels, std::uint8_t colour, const RegionRule& rule) {
    if (rule.sameColour) {
        return [&voxels, colour](glm::ivec3 origin) { return colourBits(voxels, origin, colour); };
    }
    return [&voxels](glm::ivec3 origin) { return solidBits(voxels, origin); };
}

int axisOf(glm::ivec3 normal) {
    return normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
}

}  // namespace

Result<VoxelSet> connectedRegion(const VoxelGrid& voxels, glm::ivec3 seed, const RegionRule& rule,
                                 std::size_t maxBlocks) {
    if (!isInVoxelRange(seed)) return VoxelSet();
    const std::uint8_t colour = voxels.get(seed);
    if (colour == 0) return VoxelSet();
    return Flood(likeSeed(voxels, colour, rule), rule.neighbours, maxBlocks).from(seed);
}

Result<VoxelSet> faceRegion(const VoxelGrid& voxels, glm::ivec3 seed, glm::ivec3 normal,
                            const RegionRule& rule, std::size_t maxBlocks) {
    VOXPRITE_CHECK(std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z) == 1);
    if (!isInVoxelRange(seed)) return VoxelSet();
    const std::uint8_t colour = voxels.get(seed);
    if (colour == 0) return VoxelSet();
    const int axis = axisOf(normal);
    const int layer = withinCube(seed)[axis];
    const int layerAbove = withinCube(seed + normal)[axis];
    const bool aboveInSameCube = layerAbove == layer + normal[axis];
    const Eligible like = likeSeed(voxels, colour, rule);
    const auto exposed = [&](glm::ivec3 origin) {
        CubeBits none{};
        if (origin[axis] != cubeOf(seed)[axis]) return none;
        const glm::ivec3 above = aboveInSameCube ? origin : origin + normal * kCubeEdge;
        const CubeBits covered = layerMoved(solidBits(voxels, above), axis, layerAbove, layer);
        return layerMoved(like(origin), axis, layer, layer) & ~covered;
    };
    return Flood(exposed, rule.neighbours, maxBlocks).from(seed);
}

Result<VoxelSet> planeRegion(const VoxelGrid& voxels, glm::ivec3 seed, int axis, const IBox& limits,
                             std::size_t maxBlocks) {
    IBox layer = limits.intersected({glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)});
    if (!layer.contains(seed)) return VoxelSet();
    layer.min[axis] = seed[axis];
    layer.max[axis] = seed[axis] + 1;
    const auto emptyInLayer = [&](glm::ivec3 origin) {
        return boxBits(layer, origin) & ~solidBits(voxels, origin);
    };
    return Flood(emptyInLayer, Neighbours::six, maxBlocks).from(seed);
}

std::vector<glm::ivec3> voxelsAlongRay(glm::dvec3 origin, glm::dvec3 direction, const IBox& box) {
    std::vector<glm::ivec3> cells;
    if (box.empty()) return cells;
    // The stretch of the ray inside the box.
    double enter = 0.0;
    double leave = INFINITY;
    int enteredThrough = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(origin[axis]) || !std::isfinite(direction[axis])) return cells;
        const double low = box.min[axis];
        const double high = box.max[axis];
        if (direction[axis] == 0.0) {
            if (origin[axis] < low || origin[axis] >= high) return cells;
            continue;
        }
        const double toLow = (low - origin[axis]) / direction[axis];
        const double toHigh = (high - origin[axis]) / direction[axis];
        if (std::min(toLow, toHigh) > enter) {
            enter = std::min(toLow, toHigh);
            enteredThrough = axis;
        }
        leave = std::min(leave, std::max(toLow, toHigh));
    }
    if (!(enter < leave) || !std::isfinite(leave)) return cells;

    glm::ivec3 cell{0};
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::floor(origin[axis] + enter * direction[axis]);
        // Rounding must not begin outside, nor in the second layer behind the face of entry.
        cell[axis] = static_cast<int>(std::clamp<double>(at, box.min[axis], box.max[axis] - 1));
        if (axis == enteredThrough) {
            cell[axis] = direction[axis] > 0 ? box.min[axis] : box.max[axis] - 1;
        }
    }
    while (box.contains(cell)) {
        cells.push_back(cell);
        int next = -1;
        double nearest = INFINITY;
        for (int axis = 0; axis < 3; ++axis) {
            if (direction[axis] == 0.0) continue;
            const double plane = direction[axis] > 0 ? cell[axis] + 1 : cell[axis];
            const double at = (plane - origin[axis]) / direction[axis];
            if (at < nearest) {
                nearest = at;
                next = axis;
            }
        }
        cell[next] += direction[next] > 0 ? 1 : -1;
    }
    return cells;
}

VoxelSet voxelsOfColour(const VoxelGrid& voxels, std::uint8_t colour) {
    VoxelSet set;
    if (colour == 0) return set;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels != nullptr) {
            insertBits(set, block.origin, colourBits(voxels, block.origin, colour));
        } else if (block.uniformValue == colour) {
            set.insert(IBox{block.origin, block.origin + block.edgeVoxels});
        }
    });
    return set;
}

}  // namespace voxprite
