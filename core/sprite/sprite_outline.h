// The outline of a sprite, found on bits: 64 pixels in one word.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sprite/sprite_buffer.h"

namespace voxprite {

// A bit a pixel, in upright strips 64 pixels wide: a word for each row, rows from the top as in
// SpriteBuffer. Column c is bit c % 64 of strip c / 64; bits beyond the width are 0. (Packets side
// by side write into strips of their own: in rows they would share cache lines.)
class PixelBits {
  public:
    explicit PixelBits(glm::ivec2 size);

    [[nodiscard]] int strips() const { return strips_; }
    [[nodiscard]] std::uint64_t* strip(int strip) { return bits_.data() + at(strip); }
    [[nodiscard]] const std::uint64_t* strip(int strip) const { return bits_.data() + at(strip); }

  private:
    [[nodiscard]] std::size_t at(int strip) const {
        return static_cast<std::size_t>(strip) * static_cast<std::size_t>(rows_);
    }

    int strips_ = 0;
    int rows_ = 0;
    std::vector<std::uint64_t> bits_;
};

// Makes every pixel an outline that is not opaque and has an opaque neighbour to its left or right,
// above or below: the outline of a sprite that has none.
void dilateOutline(SpriteBuffer& buffer, Rgba8 colour);

// Only where that neighbour is of another packet (core/trace/picture_packets.h): castSprite() draws
// the rest while it has the packet at hand. `opaque` has a bit for each hit.
void drawOutlineAtSeams(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer);

}  // namespace voxprite
