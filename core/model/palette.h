// 256 colours shared by all models of a document. Index 0 is empty and stays transparent black.
//
// Voxels hold indices. Nothing here ever renumbers them: what an artist reorders is displayOrder,
// and what a variant changes are the colours that indices stand for.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

// Material properties as their file names them ("_type" -> "_glass", "_rough" -> "0.1", ...).
// voxprite keeps them for the game; the sprite does not use them.
using Properties = std::map<std::string, std::string>;

// Colours that light leads through, from the darkest to the lightest: what Shading::palette picks
// from (core/sprite/palette_shading.h). An index stands in at most one ramp of a palette.
struct PaletteRamp {
    std::string name;
    std::vector<std::uint8_t> indices;  // 1 ... 255, at least two, none twice
    bool operator==(const PaletteRamp&) const = default;
};

// The same model in other colours (a team, a season): the indices that differ, and nothing else, so
// that what the variants share is edited once.
struct PaletteVariant {
    std::string name;                         // not empty; unique in its palette
    std::map<std::uint8_t, Rgba8> overrides;  // by index, 1 ... 255
    bool operator==(const PaletteVariant&) const = default;
};

inline constexpr std::size_t kMaxPaletteVariants = 64;

struct Palette {
    std::array<Rgba8, 256> colours{};
    std::array<std::string, 256> names;
    std::array<Properties, 256> materials;
    // displayOrder[slot] is the palette index shown in that slot of the palette panel; slot 0 holds
    // index 0. A permutation of 0..255: it orders the display and never the voxels' indices.
    std::array<std::uint8_t, 256> displayOrder = identityOrder();
    std::vector<PaletteRamp> ramps;
    std::vector<PaletteVariant> variants;

    bool operator==(const Palette&) const = default;

    // A place without a colour: transparent black, and no name. A voxel may still use it.
    [[nodiscard]] bool isVacant(std::uint8_t index) const {
        return colours[index] == Rgba8(0) && names[index].empty();
    }
    // The ramp that an index stands in, as an index into `ramps`.
    [[nodiscard]] std::optional<std::size_t> rampOf(std::uint8_t index) const;
    [[nodiscard]] std::optional<std::size_t> variantNamed(std::string_view name) const;
    // The colours of a variant in place of its own; all else as it is.
    [[nodiscard]] Palette withVariant(std::size_t variant) const;

    [[nodiscard]] static std::array<std::uint8_t, 256> identityOrder();
    // The palette a .vox file without RGBA chunk means (MagicaVoxel's default 255 colours).
    [[nodiscard]] static Palette standard();
};

// Colours by themselves, as palette files hold them (core/io/palette_files.h).
struct NamedColour {
    Rgba8 colour{0};  // transparent black: a place without a colour
    std::string name;
    bool operator==(const NamedColour&) const = default;
};
using ColourList = std::vector<NamedColour>;  // the first is that of slot 1; at most 255

// What the members of a Palette promise, with a message that names the field.
[[nodiscard]] Status validate(const Palette& palette);

}  // namespace voxprite
