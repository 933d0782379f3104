// The pass is compiled once for each SIMD target that the compiler knows; the best one that the
// machine has is chosen when the program runs.
#include "core/sprite/sprite_outline.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sprite/sprite_outline.cpp"
#include <hwy/foreach_target.h>  // includes this file again for every target

#include <hwy/highway.h>

#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace voxprite::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Writes the outline's id and colour where a bit of the mask is set. `at`: the pixel of the lowest.
class OutlinePen {
  public:
    OutlinePen(SpriteBuffer& buffer, Rgba8 colour)
        : ids_(buffer.ids.data()), colours_(buffer.colours.data()), count_(buffer.ids.size()) {
        std::memcpy(&colour_, &colour, sizeof colour_);
        static_assert(sizeof colour_ == sizeof colour);
    }

    HWY_INLINE void draw(std::uint64_t mask, std::size_t at) const {
        const hn::CappedTag<std::uint32_t, 16> d;
        const std::size_t lanes = hn::Lanes(d);
        while (mask != 0) {
            // A vector from the first pixel on; it may reach past the row, not past the picture.
            const auto first = static_cast<std::size_t>(std::countr_zero(mask));
            const std::size_t pixel = at + first;
            if (pixel + lanes > count_) {
                ids_[pixel] = kIdOutline;
                std::memcpy(colours_ + pixel, &colour_, sizeof colour_);
                mask &= mask - 1;
                continue;
            }
            std::uint8_t bytes[8];
            const std::uint64_t bits = mask >> first;
            std::memcpy(bytes, &bits, sizeof bytes);
            const auto where = hn::LoadMaskBits(d, bytes);
            hn::BlendedStore(hn::Set(d, kIdOutline), where, d, ids_ + pixel);
            hn::BlendedStore(hn::Set(d, colour_), where, d,
                             reinterpret_cast<std::uint32_t*>(colours_ + pixel));
            mask &= first + lanes < 64 ? ~std::uint64_t{0} << (first + lanes) : 0;
        }
    }

  private:
    std::uint32_t* ids_;
    Rgba8* colours_;
    std::size_t count_;
    std::uint32_t colour_;
};

void drawWords(const PixelBits& opaque, Rgba8 colour, SpriteBuffer& buffer) {
    const int words = opaque.words();
    if (words == 0) return;
    const std::uint64_t lastWord = ~std::uint64_t{0} >> (64 * words - buffer.size.x);
    const OutlinePen pen(buffer, {colour.x, colour.y, colour.z, 255});
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
            pen.draw(outline, at);
        }
    }
}

}  // namespace
}  // namespace voxprite::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace voxprite {

HWY_EXPORT(drawWords);

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
    HWY_DYNAMIC_DISPATCH(drawWords)(opaque, colour, buffer);
}

}  // namespace voxprite
#endif
