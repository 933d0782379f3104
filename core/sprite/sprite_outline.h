// The outline of a sprite, found on bits: 64 pixels in one word.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sprite/sprite_buffer.h"

namespace voxprite {

// A bit a pixel, rows from the top as in SpriteBuffer. Column c is bit c % 64 of word c / 64 of its
// row; bits beyond the width are 0.
class PixelBits {
  public:
    PixelBits() = default;
    explicit PixelBits(glm::ivec2 size);

    [[nodiscard]] int words() const { return words_; }  // a row
    [[nodiscard]] std::uint64_t* row(int row) { return bits_.data() + at(row); }
    [[nodiscard]] const std::uint64_t* row(int row) const { return bits_.data() + at(row); }

  private:
    [[nodiscard]] std::size_t at(int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(words_);
    }

    int words_ = 0;
    std::vector<std::uint64_t> bits_;
};

[[nodiscard]] PixelBits opaquePixels(const SpriteBuffer& buffer);

// Makes every pixel an outline that is not opaque and has an opaque neighbour to its left or right,
// above or below. `opaque` is opaquePixels(buffer).
void drawOutline(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer);

// Only where that neighbour is of another packet (core/trace/picture_packets.h): for those who draw
// the rest while they have the packet at hand.
void drawOutlineAtSeams(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer);

}  // namespace voxprite
