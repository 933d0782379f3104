#include "core/model/palette.h"

namespace voxprite {

std::array<std::uint8_t, 256> Palette::identityOrder() {
    std::array<std::uint8_t, 256> order{};
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
        order[slot] = static_cast<std::uint8_t>(slot);
    }
    return order;
}

Palette Palette::standard() {
    Palette palette;
    std::size_t index = 1;
    // The 6x6x6 colour cube from white downward, blue fastest; black is left out.
    constexpr std::array<std::uint8_t, 6> kCube{0xFF, 0xCC, 0x99, 0x66, 0x33, 0x00};
    for (const std::uint8_t red : kCube) {
        for (const std::uint8_t green : kCube) {
            for (const std::uint8_t blue : kCube) {
                if (index < 216) palette.colours[index++] = Rgba8(red, green, blue, 0xFF);
            }
        }
    }
    // Then ramps of red, green, blue and grey, in the steps that the cube does not have.
    constexpr std::array<std::uint8_t, 10> kRamp{0xEE, 0xDD, 0xBB, 0xAA, 0x88,
                                                 0x77, 0x55, 0x44, 0x22, 0x11};
    for (const std::uint8_t red : kRamp) palette.colours[index++] = Rgba8(red, 0, 0, 0xFF);
    for (const std::uint8_t green : kRamp) palette.colours[index++] = Rgba8(0, green, 0, 0xFF);
    for (const std::uint8_t blue : kRamp) palette.colours[index++] = Rgba8(0, 0, blue, 0xFF);
    for (const std::uint8_t grey : kRamp) palette.colours[index++] = Rgba8(grey, grey, grey, 0xFF);
    return palette;
}

}  // namespace voxprite
