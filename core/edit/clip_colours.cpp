#include "core/edit/clip_colours.h"

#include <limits>
#include <numeric>
#include <optional>

#include "core/base/oklab.h"
#include "core/edit/palette_edits.h"
#include "core/edit/patch_builder.h"

namespace voxprite {

namespace {

constexpr std::array<std::uint8_t, 256> everyIndex() {
    std::array<std::uint8_t, 256> indices{};
    std::iota(indices.begin(), indices.end(), std::uint8_t{0});
    return indices;
}

std::array<bool, 256> coloursOf(const VoxelGrid& voxels) {
    std::array<bool, 256> used{};
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            used[block.uniformValue] = true;
        } else {
            for (int i = 0; i < kCubeVoxels; ++i) used[block.voxels[i]] = true;
        }
    });
    used[0] = false;
    return used;
}

std::optional<std::uint8_t> sameColour(const Palette& palette, const Palette& source,
                                       std::uint8_t index) {
    const Rgba8 colour = source.colours[index];
    if (palette.colours[index] == colour) return index;
    std::optional<std::uint8_t> found;
    for (unsigned i = 255; i > 0; --i) {
        if (palette.colours[i] != colour) continue;
        const bool named = palette.names[i] == source.names[index];
        const bool better = !found || named || palette.names[*found] != source.names[index];
        if (better) found = static_cast<std::uint8_t>(i);
    }
    return found;
}

std::uint8_t nearestColour(const Palette& palette, Rgba8 colour) {
    const OkLab wanted = okLabFrom(colour);
    std::uint8_t nearest = 1;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned i = 1; i < 256; ++i) {
        const auto index = static_cast<std::uint8_t>(i);
        if (palette.isVacant(index)) continue;
        const double distance = squaredDistance(okLabFrom(palette.colours[i]), wanted);
        if (distance < least) {
            least = distance;
            nearest = index;
        }
    }
    return nearest;
}

}  // namespace

bool ColourMatch::isIdentity() const {
    return added == 0 && indexOf == everyIndex();
}

ColourMatch matchColours(const VoxelGrid& voxels, const Palette& source, const Document& document) {
    ColourMatch match{everyIndex(), document.palette};
    ColourCounts counts = colourCounts(document);
    const std::array<bool, 256> used = coloursOf(voxels);
    for (unsigned i = 1; i < 256; ++i) {
        if (!used[i]) continue;
        const auto index = static_cast<std::uint8_t>(i);
        if (const auto same = sameColour(match.palette, source, index)) {
            match.indexOf[i] = *same;
            ++counts[*same];  // no place for another colour
        } else if (const auto free = freeIndex(match.palette, counts)) {
            match.indexOf[i] = *free;
            match.palette.colours[*free] = source.colours[i];
            match.palette.names[*free] = source.names[i];
            match.palette.materials[*free] = source.materials[i];
            for (PaletteVariant& variant : match.palette.variants) variant.overrides.erase(*free);
            ++counts[*free];
            ++match.added;
        } else {
            match.indexOf[i] = nearestColour(match.palette, source.colours[i]);
            ++match.approximated;
        }
    }
    return match;
}

VoxelGrid recoloured(const VoxelGrid& voxels, const std::array<std::uint8_t, 256>& indexOf) {
    VoxelGrid result;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            result.fill({block.origin, block.origin + block.edgeVoxels},
                        indexOf[block.uniformValue]);
            return;
        }
        CubeBytes values;
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = indexOf[block.voxels[i]];
        result.setBlock(block.origin, values.data());
    });
    return result;
}

}  // namespace voxprite
