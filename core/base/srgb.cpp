#include "core/base/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/newton_root.h"

namespace voxprite {
namespace {

// To the power of 2.4 = 2 + 2/5.
double linearFrom(int byte) {
    const double value = byte / 255.0;
    if (value <= 0.04045) return value / 12.92;
    const double base = (value + 0.055) / 1.055;
    const double fifth = rootOf(base, 5);
    return base * base * fifth * fifth;
}

const std::array<double, 256>& linearTable() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (int byte = 0; byte < 256; ++byte) {
            values[static_cast<std::size_t>(byte)] = linearFrom(byte);
        }
        return values;
    }();
    return table;
}

}  // namespace

double linearFromSrgb(std::uint8_t byte) {
    return linearTable()[byte];
}

std::uint8_t srgbFromLinear(double linear) {
    const double value =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

}  // namespace voxprite
