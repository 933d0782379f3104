#include "core/io/slice_text.h"

#include <array>
#include <charconv>
#include <string_view>

#include "core/io/png_text.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

std::string textOf(const SliceText& text) {
    return std::to_string(text.layers) + " at " + std::to_string(text.corner.x) + " " +
           std::to_string(text.corner.y) + " " + std::to_string(text.corner.z);
}

std::optional<SliceText> sliceTextIn(ByteView png) {
    const std::optional<std::string> text = pngText(png, kSliceTextKey);
    if (!text) return std::nullopt;
    std::array<int, 4> numbers{};
    constexpr std::array<std::string_view, 4> kBetween{"", " at ", " ", " "};
    const char* at = text->data();
    const char* const end = at + text->size();
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::string_view rest(at, static_cast<std::size_t>(end - at));
        if (!rest.starts_with(kBetween[k])) return std::nullopt;
        const auto [next, error] = std::from_chars(at + kBetween[k].size(), end, numbers[k]);
        if (error != std::errc()) return std::nullopt;
        at = next;
    }
    if (at != end) return std::nullopt;
    const SliceText told{numbers[0], {numbers[1], numbers[2], numbers[3]}};
    return isInVoxelRange(told.corner) ? std::optional(told) : std::nullopt;
}

}  // namespace voxprite
