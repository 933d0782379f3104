#include "core/sprite/sprite_outline.h"

#include <bit>

namespace voxprite {
namespace {

std::uint64_t wordOf(const std::uint64_t* row, int word, int words) {
    return row != nullptr && word >= 0 && word < words ? row[word] : 0;
}

}  // namespace

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
    for (int row = 0; row < buffer.size.y; ++row) {
        const std::uint64_t* const here = opaque.row(row);
        const std::uint64_t* const above = row > 0 ? opaque.row(row - 1) : nullptr;
        const std::uint64_t* const below = row + 1 < buffer.size.y ? opaque.row(row + 1) : nullptr;
        const std::size_t start =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.size.x);
        for (int word = 0; word < words; ++word) {
            const std::uint64_t middle = here[word];
            const std::uint64_t fromLeft = middle << 1 | wordOf(here, word - 1, words) >> 63;
            const std::uint64_t fromRight = middle >> 1 | wordOf(here, word + 1, words) << 63;
            std::uint64_t outline =
                (fromLeft | fromRight | wordOf(above, word, words) | wordOf(below, word, words)) &
                ~middle;
            if (word + 1 == words) outline &= lastWord;
            for (; outline != 0; outline &= outline - 1) {
                const std::size_t at = start + static_cast<std::size_t>(64 * word) +
                                       static_cast<std::size_t>(std::countr_zero(outline));
                buffer.ids[at] = kIdOutline;
                buffer.colours[at] = solid;
            }
        }
    }
}

}  // namespace voxprite
