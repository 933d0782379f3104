#include "core/sprite/sprite_outline.h"

#include <bit>

#include "core/trace/packet_caster.h"

namespace voxprite {
namespace {

class OutlinePen {
  public:
    OutlinePen(Rgba8 colour, SpriteBuffer& buffer)
        : colour_(glm::u8vec3(colour), 255), buffer_(buffer) {}

    void pixel(std::size_t at) {
        buffer_.ids[at] = kIdOutline;
        buffer_.colours[at] = colour_;
    }
    void pixel(int row, int column) {
        pixel(static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer_.size.x) +
              static_cast<std::size_t>(column));
    }
    // Of a word of 64 pixels, the first of which is `at`.
    void pixels(std::size_t at, std::uint64_t bits) {
        for (; bits != 0; bits &= bits - 1)
            pixel(at + static_cast<std::size_t>(std::countr_zero(bits)));
    }

  private:
    Rgba8 colour_;
    SpriteBuffer& buffer_;
};

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
    OutlinePen pen(colour, buffer);
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
            pen.pixels(at, outline);
        }
    }
}

void drawOutlineAtSeams(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer) {
    constexpr int kEdge = PacketHits::kEdge;
    static_assert(kEdge == 64);  // so that packets meet where words do
    const int words = opaque.words();
    OutlinePen pen(colour, buffer);
    for (int row = 0; row < buffer.size.y; ++row) {
        const std::uint64_t* const bits = opaque.row(row);
        for (int word = 1; word < words; ++word) {
            const bool before = bits[word - 1] >> 63 != 0;
            const bool after = (bits[word] & 1) != 0;
            if (before != after) pen.pixel(row, before ? kEdge * word : kEdge * word - 1);
        }
    }
    // Packets begin at the bottom.
    for (int below = buffer.size.y - kEdge; below > 0; below -= kEdge) {
        const int above = below - 1;
        for (int word = 0; word < words; ++word) {
            const std::uint64_t high = opaque.row(above)[word];
            const std::uint64_t low = opaque.row(below)[word];
            const auto first = static_cast<std::size_t>(kEdge * word);
            const auto width = static_cast<std::size_t>(buffer.size.x);
            pen.pixels(static_cast<std::size_t>(above) * width + first, low & ~high);
            pen.pixels(static_cast<std::size_t>(below) * width + first, high & ~low);
        }
    }
}

}  // namespace voxprite
