// Cubes of 8x8x8 voxels as 512 bits, one bit a voxel: what fills and shapes compute with. Private
// to core/edit.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "core/edit/regions.h"
#include "core/edit/voxel_set.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

inline constexpr int kCubeEdge = 8;
inline constexpr int kCubeVoxels = 512;

// The minimum corner of the cube that holds `v`, and `v` within it.
[[nodiscard]] inline glm::ivec3 cubeOf(glm::ivec3 v) {
    return v & ~(kCubeEdge - 1);
}
[[nodiscard]] inline glm::ivec3 withinCube(glm::ivec3 v) {
    return v & (kCubeEdge - 1);
}
// The order of VoxelBlock.
[[nodiscard]] inline int indexInCube(glm::ivec3 v) {
    const glm::ivec3 w = withinCube(v);
    return (w.x << 6) | (w.y << 3) | w.z;
}

// The bit (y << 3 | z) of word x.
using CubeBits = std::array<std::uint64_t, 8>;

[[nodiscard]] inline bool anyBit(const CubeBits& bits) {
    std::uint64_t any = 0;
    for (const std::uint64_t word : bits) any |= word;
    return any != 0;
}
[[nodiscard]] inline bool allBits(const CubeBits& bits) {
    std::uint64_t all = ~std::uint64_t{0};
    for (const std::uint64_t word : bits) all &= word;
    return all == ~std::uint64_t{0};
}
[[nodiscard]] CubeBits operator&(CubeBits a, const CubeBits& b);
[[nodiscard]] CubeBits operator|(CubeBits a, const CubeBits& b);
[[nodiscard]] CubeBits operator~(CubeBits a);
[[nodiscard]] CubeBits bitOf(glm::ivec3 v);

// The solid voxels of the cube at `origin`, or those of one colour.
[[nodiscard]] CubeBits solidBits(const VoxelGrid& voxels, glm::ivec3 origin);
[[nodiscard]] CubeBits colourBits(const VoxelGrid& voxels, glm::ivec3 origin, std::uint8_t colour);
[[nodiscard]] CubeBits boxBits(const IBox& box, glm::ivec3 origin);
// 1 for every set bit, in the order of VoxelBlock.
[[nodiscard]] std::array<std::uint8_t, kCubeVoxels> bytesOf(const CubeBits& bits);
void insertBits(VoxelSet& set, glm::ivec3 origin, const CubeBits& bits);

// The bits and their neighbours, within the cube.
[[nodiscard]] CubeBits grown(const CubeBits& bits, Neighbours neighbours);
// The voxels of the neighbouring cube in `direction` (each component -1, 0 or 1) that touch them.
[[nodiscard]] CubeBits crossing(const CubeBits& bits, glm::ivec3 direction, Neighbours neighbours);
// The layer `from` of an axis, and nothing else, carried to the layer `to`.
[[nodiscard]] CubeBits layerMoved(const CubeBits& bits, int axis, int from, int to);

}  // namespace voxprite
