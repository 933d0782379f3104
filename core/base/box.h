// Integer boxes of voxels, half open: a voxel v is inside when min <= v < max on every axis.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace voxprite {

struct IBox {
    glm::ivec3 min{0};
    glm::ivec3 max{0};

    [[nodiscard]] bool empty() const { return min.x >= max.x || min.y >= max.y || min.z >= max.z; }
    // Edge lengths in voxels; only meaningful when not empty.
    [[nodiscard]] glm::ivec3 size() const { return max - min; }
    [[nodiscard]] bool contains(glm::ivec3 v) const {
        return v.x >= min.x && v.y >= min.y && v.z >= min.z && v.x < max.x && v.y < max.y &&
               v.z < max.z;
    }
    // The smallest box around both; an empty box adds nothing.
    [[nodiscard]] IBox united(const IBox& other) const {
        if (empty()) return other;
        if (other.empty()) return *this;
        return {glm::min(min, other.min), glm::max(max, other.max)};
    }
    [[nodiscard]] IBox intersected(const IBox& other) const {
        const IBox both{glm::max(min, other.min), glm::min(max, other.max)};
        return both.empty() ? IBox{} : both;
    }
    // The box around the voxels a and b, both included.
    [[nodiscard]] static IBox around(glm::ivec3 a, glm::ivec3 b) {
        return {glm::min(a, b), glm::max(a, b) + 1};
    }
    bool operator==(const IBox&) const = default;
};

}  // namespace voxprite
