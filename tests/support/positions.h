// Sets of voxel positions in the plainest form there is: what VoxelSets are compared with.
#pragma once

#include <glm/vec3.hpp>
#include <set>
#include <span>
#include <tuple>

#include "core/edit/voxel_set.h"

namespace voxprite::test {

using Positions = std::set<std::tuple<int, int, int>>;

inline std::tuple<int, int, int> key(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}
inline glm::ivec3 voxelOf(const std::tuple<int, int, int>& key) {
    return {std::get<0>(key), std::get<1>(key), std::get<2>(key)};
}

inline Positions positionsOf(const VoxelSet& set) {
    Positions positions;
    set.forEach([&](glm::ivec3 v) { positions.insert(key(v)); });
    return positions;
}
inline Positions positionsOf(std::span<const glm::ivec3> voxels) {
    Positions positions;
    for (const glm::ivec3 v : voxels) positions.insert(key(v));
    return positions;
}

// visit(v) for every voxel of the box.
template <class Visit>
void forEachVoxel(const IBox& box, const Visit& visit) {
    for (int x = box.min.x; x < box.max.x; ++x) {
        for (int y = box.min.y; y < box.max.y; ++y) {
            for (int z = box.min.z; z < box.max.z; ++z) visit(glm::ivec3(x, y, z));
        }
    }
}

}  // namespace voxprite::test
