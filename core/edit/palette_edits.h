// Edits of a palette: functions from a palette to the one after, for a PaletteEdit, and one that
// repaints voxels. None renumbers a voxel unless that is what it is for (recolour).
//
// A palette is ordered by slots, as the panel shows it, and its colours are named by index;
// displayOrder leads from one to the other.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/edit/history.h"

namespace voxprite {

// Solid voxels a colour, over all models (shared ones once), by index; [0] is 0.
using ColourCounts = std::array<std::uint64_t, 256>;
[[nodiscard]] ColourCounts colourCounts(const Document& document);

// Where colours are written: the palette itself, or one of its variants.
using VariantIndex = std::optional<std::size_t>;

// --- colours

// A variant keeps only what differs from the palette.
[[nodiscard]] Palette withColour(Palette palette, VariantIndex variant, std::uint8_t index,
                                 Rgba8 colour);
[[nodiscard]] Palette withName(Palette palette, std::uint8_t index, std::string name);
// The two exchange colour, name and material, in all variants too; their voxels keep their indices
// and so exchange their looks.
[[nodiscard]] Palette withSwapped(Palette palette, std::uint8_t a, std::uint8_t b);
// Where a new colour can go without taking one away: a vacant place that no voxel uses, the first
// in display order; else one that no voxel, name, ramp or variant uses, the last.
[[nodiscard]] std::optional<std::uint8_t> freeIndex(const Palette& palette,
                                                    const ColourCounts& counts);
// `copy` becomes like `index` (ramp aside) and is shown after it.
[[nodiscard]] Palette withDuplicate(Palette palette, std::uint8_t index, std::uint8_t copy);
// The colours between the first and the last become steps of a straight line in OKLab.
[[nodiscard]] Palette withGradient(Palette palette, VariantIndex variant,
                                   std::span<const std::uint8_t> indices);
// What no voxel and no ramp uses becomes vacant.
[[nodiscard]] Palette withoutUnused(Palette palette, const ColourCounts& counts);

// --- order of display

// The colour in slot `from` moves to slot `to`, those between make room; slots 1 ... 255.
[[nodiscard]] Palette withSlotMoved(Palette palette, std::size_t from, std::size_t to);
enum class PaletteOrder : std::uint8_t {
    hue,        // greys first, dark to light, then round the circle from red
    lightness,  // light to dark
    use,        // what most voxels have first
    index
};
// Orders the slots that these colours stand in among themselves; vacant places come last.
[[nodiscard]] Palette withOrder(Palette palette, std::span<const std::uint8_t> indices,
                                PaletteOrder order, const ColourCounts& counts);

// --- ramps

// The colours become a ramp from dark to light (OKLab) and leave those that they stood in; a ramp
// left with fewer than two goes. Fewer than two colours change nothing.
[[nodiscard]] Palette withRamp(Palette palette, std::span<const std::uint8_t> indices);
[[nodiscard]] Palette withoutRamp(Palette palette, std::size_t ramp);
// The step `from` of a ramp becomes its step `to`; those between make room. What comes before a
// step is what its shadow may be.
[[nodiscard]] Palette withRampStepMoved(Palette palette, std::size_t ramp, std::size_t from,
                                        std::size_t to);
// Ramps for those of `indices` that stand in none: from dark to light, each colour goes on from the
// nearest that has about its hue (within 30 degrees; greys among themselves) and is darker.
[[nodiscard]] Palette withSuggestedRamps(Palette palette, std::span<const std::uint8_t> indices);

// --- variants

// A name made from `wanted` that no variant has.
[[nodiscard]] std::string freeVariantName(const Palette& palette, const std::string& wanted);
// A copy of `source`, or the palette's own colours.
[[nodiscard]] Palette withVariantAdded(Palette palette, VariantIndex source, std::string name);
[[nodiscard]] Palette withVariantRemoved(Palette palette, std::size_t variant);

// --- files

// As displayed, from slot 1 to the last that is not vacant.
[[nodiscard]] ColourList colourList(const Palette& palette, VariantIndex variant = {});
// The colours of slots 1, 2, ... become those of the list, with their names where it has some;
// slots beyond its end stay.
[[nodiscard]] Palette withColours(Palette palette, VariantIndex variant, const ColourList& colours);

// --- voxels

// Every voxel of colour `from` becomes `to`, in all models; they are found when it is carried out.
// Fails then beyond kMaxPatchVoxels (patches.h).
[[nodiscard]] Action recolour(const Document& document, std::uint8_t from, std::uint8_t to);

}  // namespace voxprite
