#include "core/sprite/sprite_outline.h"

#include <bit>

namespace voxprite {
PixelBits::PixelBits(glm::ivec2 size)
    : words_((size.x + 63) / 64),
      bits_(static_cast<std::size_t>(words_) * static_cast<std::size_t>(size.y)) {}

PixelBits opaquePixels(const SpriteBuffer& buffer) {
    PixelBits opaque(buffer.size);
    std::size_t at = 0;
    for (int row = 0; row < buffer.size.y; ++row) {
        std::uint64_t* const bits = opaque.row(row);
        for (int column = 0; column < buffer.size.x; ++column, ++at)
            bits[column / 64] |= std::uint64_t{buffer.ids[at] >= kIdFirstVoxel} << (column % 64);
    }
    return opaque;
}

void drawOutline(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer) {
    const int words = opaque.words();
    if (words == 0) return;
    const std::uint64_t lastWord = ~std::uint64_t{0} >> (64 * words - buffer.size.x);
    const Rgba8 solid{colour.x, colour.y, colour.z, 255};
    const std::vector<std::uint64_t> none(static_cast<std::size_t>(words));
    for (int row = 0; row < buffer.size.y; ++row) {
        const std::uint64_t* const here = opaque.row(row);
        const std::uint64_t* const above = row > 0 ? opaque.row(row - 1) : none.data();
        const std::uint64_t* const below =
            row + 1 < buffer.size.y ? opaque.row(row + 1) : none.data();
        std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.size.x);
        std::uint64_t left = 0;
        for (int word = 0; word < words; ++word, at += 64) {
            const std::uint64_t middle = here[word];
            const bool last = word + 1 == words;
            const std::uint64_t right = last ? 0 : here[word + 1];
            std::uint64_t outline =
                (middle << 1 | left >> 63 | middle >> 1 | right << 63 | above[word] | below[word]) &
                ~middle;
            if (last) outline &= lastWord;
            left = middle;
            for (; outline != 0; outline &= outline - 1) {
                const std::size_t pixel = at + static_cast<std::size_t>(std::countr_zero(outline));
                buffer.ids[pixel] = kIdOutline;
                buffer.colours[pixel] = solid;
            }
        }
    }
}

}  // namespace voxprite
