// What light makes of a palette's colours.
//
// Light is a number from 0 to 255 (see faceLight). Shading::multiply makes of a channel
// (channel * light + 127) / 255, in integers. Shading::palette takes that multiplied colour as its
// aim and picks a colour of the palette instead, so that a sprite shows only the artist's colours:
//   - in a ramp, the colour whose lightness is nearest to the aim's, among those from the ramp's
//     dark end up to the colour itself (light never makes it lighter than it is); of two equally
//     near ones the lighter;
//   - without a ramp, the colour nearest to the aim, in all of the palette but vacant places; the
//     colour itself counts in any case, and of equally near ones the lowest index is taken.
// Nearness is that of OKLab (core/base/oklab.h). In full light, 255, every colour is itself. The
// choice depends on the palette alone and never on which colours the voxels use: drawing a voxel
// changes no other pixel.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/oklab.h"
#include "core/model/game_profile.h"
#include "core/model/palette.h"

namespace voxprite {

// The palette's 256 colours in one light, by index; alpha 255.
using ShadedColours = std::array<Rgba8, 256>;

// Remembers what it has worked out: there are at most 256 lights and two kinds of shading.
class PaletteShader {
  public:
    explicit PaletteShader(const Palette& palette);

    [[nodiscard]] const ShadedColours& inLight(std::uint8_t light8, Shading shading);
    // Are the colours, ramps and vacant places those that this one was made from? Names, materials
    // and variants shade nothing.
    [[nodiscard]] bool isOf(const Palette& palette) const;

  private:
    void prepareToPick();
    [[nodiscard]] Rgba8 picked(std::uint8_t index, Rgba8 aim) const;

    std::array<Rgba8, 256> colours_;
    std::vector<PaletteRamp> ramps_;
    std::bitset<256> vacant_;
    // Made when first needed: the colours, and for each index the part of its ramp that it may pick
    // from, dark to light; empty without a ramp.
    std::vector<OkLab> labs_;
    std::vector<std::vector<std::uint8_t>> choices_;
    std::array<std::array<std::unique_ptr<ShadedColours>, 256>, 2> inLight_;  // by shading
};

}  // namespace voxprite
