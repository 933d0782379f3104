// The voxels that a killed editor attaches, one an edit: how many there are says how far it came.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace voxprite::test {

[[nodiscard]] inline glm::ivec3 crashVoxel(std::uint64_t k) {
    const auto i = static_cast<int>(k);
    return {i % 32, i / 32 % 32, i / 1024};
}
[[nodiscard]] inline std::uint8_t crashColour(std::uint64_t k) {
    return static_cast<std::uint8_t>(1 + k % 255);
}

}  // namespace voxprite::test
