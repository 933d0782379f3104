// Models and documents for tests, the same on every run and machine. All of them have their
// minimum corner at the origin unless they say otherwise.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <tuple>
#include <vector>

#include "core/model/document.h"

namespace voxprite::test {

// Each voxel of [0, size) is solid with probability `fillRate`, in one of the indices 1..colours.
[[nodiscard]] VoxelGrid randomVoxels(std::uint64_t seed, glm::ivec3 size, double fillRate,
                                     int colours);
// The surface of a ball of diameter n, one voxel thick, each octant in a colour of its own.
[[nodiscard]] VoxelGrid shellSphere(int n);
[[nodiscard]] VoxelGrid solidBox(glm::ivec3 size, std::uint8_t value = 1);
// A person of 16 x 8 x 32 voxels that looks along -Y, with a shield on its left arm (+X).
[[nodiscard]] VoxelGrid figure();
// Unlike each of its 47 mirrored or turned selves: an arm along each axis, of different length and
// colour, and a letter F on the face toward -Y.
[[nodiscard]] VoxelGrid asymmetric();

// One object at the origin that shows one model.
[[nodiscard]] Document documentOf(VoxelGrid voxels);
// One object that shows one model after the other, a frame each.
[[nodiscard]] Document animationOf(std::vector<VoxelGrid> frames);
// A document with something of everything: nested groups, mirrored and turned placements, one model
// shown several times, overlaps, hidden nodes, layers, keyed placements and models, loops, clips,
// names, materials, a palette of its own. Valid.
[[nodiscard]] Document busyDocument();

// The solid voxels by position: what other stores are compared with.
using VoxelMap = std::map<std::tuple<int, int, int>, std::uint8_t>;
[[nodiscard]] VoxelMap mapOf(const VoxelGrid& voxels);

}  // namespace voxprite::test
