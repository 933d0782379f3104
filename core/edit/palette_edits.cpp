#include "core/edit/palette_edits.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/oklab.h"
#include "core/edit/make_action.h"
#include "core/edit/patch_builder.h"
#include "core/edit/regions.h"

namespace voxprite {

namespace {

std::size_t slotOf(const Palette& palette, std::uint8_t index) {
    const auto& order = palette.displayOrder;
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), index) - order.begin());
}

Rgba8 colourOf(const Palette& palette, VariantIndex variant, std::uint8_t index) {
    if (variant) {
        const auto& overrides = palette.variants[*variant].overrides;
        if (const auto own = overrides.find(index); own != overrides.end()) return own->second;
    }
    return palette.colours[index];
}

// A variant's override of `from` (or that there is none) becomes that of `to`.
void copyOverride(PaletteVariant& variant, std::uint8_t from, std::uint8_t to) {
    const auto own = variant.overrides.find(from);
    if (own == variant.overrides.end()) {
        variant.overrides.erase(to);
    } else {
        variant.overrides[to] = own->second;
    }
}

void setName(Palette& palette, std::uint8_t index, const std::string& name) {
    if (!name.empty()) palette.names[index] = name;
}

}  // namespace

ColourCounts colourCounts(const Document& document) {
    ColourCounts counts{};
    for (const Model& model : document.models) {
        model.voxels.forEachBlock([&](const VoxelBlock& block) {
            if (block.voxels == nullptr) {
                const auto edge = static_cast<std::uint64_t>(block.edgeVoxels);
                counts[block.uniformValue] += edge * edge * edge;
            } else {
                for (int k = 0; k < 512; ++k) ++counts[block.voxels[k]];
            }
        });
    }
    counts[0] = 0;
    return counts;
}

Palette withColour(Palette palette, VariantIndex variant, std::uint8_t index, Rgba8 colour) {
    if (index == 0) return palette;
    if (!variant) {
        palette.colours[index] = colour;
    } else if (palette.colours[index] == colour) {
        palette.variants[*variant].overrides.erase(index);
    } else {
        palette.variants[*variant].overrides[index] = colour;
    }
    return palette;
}

Palette withName(Palette palette, std::uint8_t index, std::string name) {
    if (index != 0) palette.names[index] = std::move(name);
    return palette;
}

Palette withSwapped(Palette palette, std::uint8_t a, std::uint8_t b) {
    if (a == 0 || b == 0) return palette;
    std::swap(palette.colours[a], palette.colours[b]);
    std::swap(palette.names[a], palette.names[b]);
    std::swap(palette.materials[a], palette.materials[b]);
    for (PaletteVariant& variant : palette.variants) {
        const PaletteVariant before = variant;
        const auto take = [&](std::uint8_t from, std::uint8_t to) {
            variant.overrides.erase(to);
            const auto own = before.overrides.find(from);
            if (own != before.overrides.end()) variant.overrides[to] = own->second;
        };
        take(a, b);
        take(b, a);
    }
    return palette;
}

std::optional<std::uint8_t> freeIndex(const Palette& palette, const ColourCounts& counts) {
    std::optional<std::uint8_t> unused;
    for (std::size_t slot = 1; slot < 256; ++slot) {
        const std::uint8_t index = palette.displayOrder[slot];
        if (counts[index] > 0 || palette.rampOf(index)) continue;
        if (palette.isVacant(index)) return index;
        const bool varies = std::any_of(
            palette.variants.begin(), palette.variants.end(),
            [&](const PaletteVariant& variant) { return variant.overrides.contains(index); });
        if (palette.names[index].empty() && !varies) unused = index;
    }
    return unused;
}

Palette withDuplicate(Palette palette, std::uint8_t index, std::uint8_t copy) {
    if (index == 0 || copy == 0 || index == copy) return palette;
    palette.colours[copy] = palette.colours[index];
    palette.names[copy] = palette.names[index];
    palette.materials[copy] = palette.materials[index];
    for (PaletteVariant& variant : palette.variants) copyOverride(variant, index, copy);
    const std::size_t from = slotOf(palette, copy);
    const std::size_t beside = slotOf(palette, index);
    return withSlotMoved(std::move(palette), from, beside + (from < beside ? 0 : 1));
}

Palette withGradient(Palette palette, VariantIndex variant, std::span<const std::uint8_t> indices) {
    if (indices.size() < 3) return palette;
    const OkLab first = okLabFrom(colourOf(palette, variant, indices.front()));
    const OkLab last = okLabFrom(colourOf(palette, variant, indices.back()));
    for (std::size_t i = 1; i + 1 < indices.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(indices.size() - 1);
        palette =
            withColour(std::move(palette), variant, indices[i], rgba8From(mix(first, last, share)));
    }
    return palette;
}

Palette withoutUnused(Palette palette, const ColourCounts& counts) {
    for (int i = 1; i < 256; ++i) {
        const auto index = static_cast<std::uint8_t>(i);
        if (counts[index] > 0 || palette.rampOf(index)) continue;
        palette.colours[index] = Rgba8(0);
        palette.names[index].clear();
        palette.materials[index].clear();
        for (PaletteVariant& variant : palette.variants) variant.overrides.erase(index);
    }
    return palette;
}

Palette withSlotMoved(Palette palette, std::size_t from, std::size_t to) {
    if (from == 0 || to == 0 || from > 255 || to > 255) return palette;
    const auto slot = [&](std::size_t at) {
        return palette.displayOrder.begin() + static_cast<std::ptrdiff_t>(at);
    };
    if (from < to) {
        std::rotate(slot(from), slot(from + 1), slot(to + 1));
    } else {
        std::rotate(slot(to), slot(from), slot(from + 1));
    }
    return palette;
}

Palette withOrder(Palette palette, std::span<const std::uint8_t> indices, PaletteOrder order,
                  const ColourCounts& counts) {
    constexpr double kGreyChroma = 0.02;
    struct Entry {
        std::uint8_t index;
        bool vacant;
        double key, then;  // ascending
    };
    std::vector<std::size_t> slots;
    std::vector<Entry> entries;
    for (const std::uint8_t index : indices) {
        if (index == 0) continue;
        slots.push_back(slotOf(palette, index));
        const OkLab lab = okLabFrom(palette.colours[index]);
        Entry entry{index, palette.isVacant(index), 0.0, 0.0};
        switch (order) {
            case PaletteOrder::hue:
                entry.key = chromaOf(lab) < kGreyChroma ? -1.0 : hueDegreesOf(lab);
                entry.then = lab.lightness;
                break;
            case PaletteOrder::lightness:
                entry.key = -lab.lightness;
                break;
            case PaletteOrder::use:
                entry.key = -static_cast<double>(counts[index]);
                break;
            case PaletteOrder::index:
                entry.key = index;
                break;
        }
        entries.push_back(entry);
    }
    std::sort(slots.begin(), slots.end());
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.vacant, a.key, a.then, a.index) <
               std::tie(b.vacant, b.key, b.then, b.index);
    });
    for (std::size_t i = 0; i < slots.size(); ++i) {
        palette.displayOrder[slots[i]] = entries[i].index;
    }
    return palette;
}

std::string freeVariantName(const Palette& palette, const std::string& wanted) {
    const std::string stem = wanted.empty() ? "Variant" : wanted;
    std::string name = stem;
    for (int number = 2; palette.variantNamed(name); ++number) {
        name = stem + " " + std::to_string(number);
    }
    return name;
}

Palette withVariantAdded(Palette palette, VariantIndex source, std::string name) {
    PaletteVariant variant;
    if (source) variant = palette.variants[*source];
    variant.name = std::move(name);
    palette.variants.push_back(std::move(variant));
    return palette;
}

Palette withVariantRemoved(Palette palette, std::size_t variant) {
    palette.variants.erase(palette.variants.begin() + static_cast<std::ptrdiff_t>(variant));
    return palette;
}

ColourList colourList(const Palette& palette, VariantIndex variant) {
    ColourList colours;
    for (std::size_t slot = 1; slot < 256; ++slot) {
        const std::uint8_t index = palette.displayOrder[slot];
        Rgba8 colour = colourOf(palette, variant, index);
        if (!palette.isVacant(index)) colour.w = 255;
        colours.push_back({colour, palette.names[index]});
    }
    while (!colours.empty() && colours.back().colour == Rgba8(0)) colours.pop_back();
    return colours;
}

Palette withColours(Palette palette, VariantIndex variant, const ColourList& colours) {
    for (std::size_t i = 0; i < colours.size() && i < 255; ++i) {
        const std::uint8_t index = palette.displayOrder[i + 1];
        palette = withColour(std::move(palette), variant, index, colours[i].colour);
        if (!variant) setName(palette, index, colours[i].name);
    }
    return palette;
}

Action recolour(const Document& document, std::uint8_t from, std::uint8_t to) {
    const std::uint64_t count = from == to || to == 0 ? 0 : colourCounts(document)[from];
    std::string label = "Recolour " + std::to_string(count) + (count == 1 ? " voxel" : " voxels");
    return makeActionLater(
        std::move(label), [=](const Document& now) -> Result<std::vector<VoxelPatch>> {
            std::vector<VoxelPatch> patches;
            if (count == 0) return patches;
            if (count > kMaxPatchVoxels) return tooManyChanges(count);
            for (std::size_t i = 0; i < now.models.size(); ++i) {
                const VoxelSet found = voxelsOfColour(now.models[i].voxels, from);
                if (found.empty()) continue;
                Result<VoxelPatch> patch =
                    patchSet(now, static_cast<int>(i), found, EditMode::paint, to);
                if (!patch) return Failure(patch.error());
                patches.push_back(std::move(*patch));
            }
            return patches;
        });
}

}  // namespace voxprite
