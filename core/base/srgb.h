// The bytes of sRGB (IEC 61966-2-1) and the light that they stand for.
#pragma once

#include <cstdint>

namespace voxprite {

// 0 ... 1. Made of + - * / alone, so that every machine finds the same digits.
[[nodiscard]] double linearFromSrgb(std::uint8_t byte);
// The nearest byte; light outside 0 ... 1 is cut off. srgbFromLinear(linearFromSrgb(b)) == b.
[[nodiscard]] std::uint8_t srgbFromLinear(double linear);

}  // namespace voxprite
