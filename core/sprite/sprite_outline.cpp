#include "core/sprite/sprite_outline.h"

#include <bit>

#include "core/trace/packet_caster.h"

namespace voxprite {
namespace {

class OutlinePen {
  public:
    OutlinePen(Rgba8 colour, SpriteBuffer& buffer)
        : colour_(glm::u8vec3(colour), 255), buffer_(buffer) {}

    void pixel(int row, int column) {
        const std::size_t at =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer_.size.x) +
            static_cast<std::size_t>(column);
        buffer_.ids[at] = kIdOutline;
        buffer_.colours[at] = colour_;
    }
    void pixels(int row, int first, std::uint64_t bits) {
        for (; bits != 0; bits &= bits - 1) pixel(row, first + std::countr_zero(bits));
    }

  private:
    Rgba8 colour_;
    SpriteBuffer& buffer_;
};

PixelBits opaquePixels(const SpriteBuffer& buffer) {
    PixelBits opaque(buffer.size);
    std::size_t at = 0;
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column, ++at)
            opaque.strip(column / 64)[row] |= std::uint64_t{buffer.ids[at] >= kIdFirstVoxel}
                                              << (column % 64);
    return opaque;
}

}  // namespace

PixelBits::PixelBits(glm::ivec2 size)
    : strips_((size.x + 63) / 64),
      rows_(size.y),
      bits_(static_cast<std::size_t>(strips_) * static_cast<std::size_t>(size.y)) {}

void dilateOutline(SpriteBuffer& buffer, Rgba8 colour) {
    const PixelBits opaque = opaquePixels(buffer);
    OutlinePen pen(colour, buffer);
    const int rows = buffer.size.y;
    const std::vector<std::uint64_t> none(static_cast<std::size_t>(rows));
    for (int strip = 0; strip < opaque.strips(); ++strip) {
        const int first = 64 * strip;
        const bool last = strip + 1 == opaque.strips();
        const std::uint64_t within = ~std::uint64_t{0} >> (last ? first + 64 - buffer.size.x : 0);
        const std::uint64_t* const here = opaque.strip(strip);
        const std::uint64_t* const left = strip > 0 ? opaque.strip(strip - 1) : none.data();
        const std::uint64_t* const right = last ? none.data() : opaque.strip(strip + 1);
        for (int row = 0; row < rows; ++row) {
            const std::uint64_t middle = here[row];
            const std::uint64_t above = row > 0 ? here[row - 1] : 0;
            const std::uint64_t below = row + 1 < rows ? here[row + 1] : 0;
            const std::uint64_t beside =
                middle << 1 | left[row] >> 63 | middle >> 1 | right[row] << 63;
            pen.pixels(row, first, (beside | above | below) & ~middle & within);
        }
    }
}

void drawOutlineAtSeams(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer) {
    constexpr int kEdge = PacketHits::kEdge;
    static_assert(kEdge == 64);  // so that packets meet where strips do
    OutlinePen pen(colour, buffer);
    for (int strip = 0; strip < opaque.strips(); ++strip) {
        const int first = kEdge * strip;
        const std::uint64_t* const here = opaque.strip(strip);
        if (strip > 0) {
            const std::uint64_t* const left = opaque.strip(strip - 1);
            for (int row = 0; row < buffer.size.y; ++row) {
                const bool before = left[row] >> 63 != 0;
                const bool after = (here[row] & 1) != 0;
                if (before != after) pen.pixel(row, before ? first : first - 1);
            }
        }
        // Packets begin at the bottom.
        for (int below = buffer.size.y - kEdge; below > 0; below -= kEdge) {
            const int above = below - 1;
            pen.pixels(above, first, here[below] & ~here[above]);
            pen.pixels(below, first, here[above] & ~here[below]);
        }
    }
}

}  // namespace voxprite
