// The same numbers on every machine (the distributions of <random> are not): SplitMix64,
// Steele, Lea & Flood 2014.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace voxprite::test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9E37'79B9'7F4A'7C15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9u;
        z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBu;
        return z ^ (z >> 31);
    }
    // lowest ... highest, both included.
    int between(int lowest, int highest) {
        const auto count =
            static_cast<std::uint64_t>(static_cast<std::int64_t>(highest) - lowest + 1);
        return static_cast<int>(lowest + static_cast<std::int64_t>(next() % count));
    }
    // 0 <= x < 1.
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    bool chance(double probability) { return unit() < probability; }
    // Each component lowest ... highest, both included.
    glm::ivec3 voxel(int lowest, int highest) {
        const int x = between(lowest, highest);
        const int y = between(lowest, highest);
        return {x, y, between(lowest, highest)};
    }

  private:
    std::uint64_t state_;
};

}  // namespace voxprite::test
