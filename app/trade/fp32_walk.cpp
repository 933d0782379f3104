#include "app/trade/fp32_walk.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace voxprite::trade {

LatticeHit castFp32Walk(const OctreeView& octree, const std::array<float, 3>& origin,
                        const std::array<float, 3>& direction) {
    constexpr float kEpsilon = 1e-4f;
    constexpr int kMaxSteps = 1000;
    const glm::vec3 o(origin[0], origin[1], origin[2]);
    const glm::vec3 d(direction[0], direction[1], direction[2]);
    const glm::vec3 size(octree.size);
    const glm::vec3 inverse = 1.0f / d;
    const glm::vec3 a = -o * inverse;
    const glm::vec3 b = (size - o) * inverse;
    const glm::vec3 lower = glm::min(a, b);
    const glm::vec3 upper = glm::max(a, b);
    float t = std::max({lower.x, lower.y, lower.z});
    const float leave = std::min({upper.x, upper.y, upper.z});
    int axis = lower.x >= lower.y && lower.x >= lower.z ? 0 : lower.y >= lower.z ? 1 : 2;
    for (int step = 0; step < kMaxSteps && t < leave; ++step) {
        const glm::vec3 at = glm::floor(o + d * (t + kEpsilon));
        const bool inside =
            at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size.x && at.y < size.y && at.z < size.z;
        if (!inside) return {};
        const glm::ivec3 cell(at);
        std::uint32_t word = octree.nodes[0];
        int bit = octree.maxDepth;
        while (node::isInternal(word)) {
            const unsigned octant = octantOf(cell, --bit);
            word = node::hasChild(word, octant) ? octree.nodes[node::childIndex(word, octant)] : 0;
        }
        std::uint8_t material = static_cast<std::uint8_t>(word);
        if (node::isBrick(word)) {
            material =
                payloadMaterial(octree.payloads[node::payloadIndex(word)], octantOf(cell, --bit));
        }
        if (material != 0) return {material, static_cast<std::uint8_t>(axis), cell};
        const float edge = static_cast<float>(1 << bit);
        const glm::vec3 corner = glm::floor(at / edge) * edge;
        // Without a special case for components that are 0: their face is the lower one, the
        // crossing is minus infinity or not a number.
        const glm::vec3 ahead = corner + glm::vec3(glm::greaterThan(d, glm::vec3(0.0f))) * edge;
        const glm::vec3 crossing = (ahead - o) * inverse;
        axis = crossing.x <= crossing.y && crossing.x <= crossing.z ? 0
               : crossing.y <= crossing.z                           ? 1
                                                                    : 2;
        t = crossing[axis];
    }
    return {};
}

}  // namespace voxprite::trade
