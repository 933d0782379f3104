// Ramps made by hand and by suggestion.
#include <algorithm>
#include <cmath>

#include "core/base/oklab.h"
#include "core/edit/palette_edits.h"

namespace voxprite {

namespace {

constexpr double kGreyChroma = 0.02;
constexpr double kHueDegrees = 30.0;
// A step of less light than this is no step, one of more leaps over colours that should be there.
constexpr double kLeastStep = 0.015;
constexpr double kMostStep = 0.35;

struct Shade {
    std::uint8_t index = 0;
    OkLab colour;
};

// Dark to light, vacant places and index 0 left out.
std::vector<Shade> shadesOf(const Palette& palette, std::span<const std::uint8_t> indices) {
    std::vector<Shade> shades;
    std::array<bool, 256> taken{};
    taken[0] = true;
    for (const std::uint8_t index : indices) {
        if (taken[index] || palette.isVacant(index)) continue;
        taken[index] = true;
        shades.push_back({index, okLabFrom(palette.colours[index])});
    }
    std::sort(shades.begin(), shades.end(), [](const Shade& a, const Shade& b) {
        return std::pair(a.colour.lightness, a.index) < std::pair(b.colour.lightness, b.index);
    });
    return shades;
}

// Could `light` be the next step of a ramp that ends in `dark`?
bool follows(const OkLab& dark, const OkLab& light) {
    const double step = light.lightness - dark.lightness;
    if (step < kLeastStep || step > kMostStep) return false;
    const bool darkIsGrey = chromaOf(dark) < kGreyChroma,
               lightIsGrey = chromaOf(light) < kGreyChroma;
    if (darkIsGrey || lightIsGrey) return darkIsGrey && lightIsGrey;
    const double apart = std::abs(hueDegreesOf(dark) - hueDegreesOf(light));
    return std::min(apart, 360.0 - apart) <= kHueDegrees;
}

}  // namespace

Palette withRamp(Palette palette, std::span<const std::uint8_t> indices) {
    PaletteRamp made;
    for (const Shade& shade : shadesOf(palette, indices)) made.indices.push_back(shade.index);
    if (made.indices.size() < 2) return palette;
    for (PaletteRamp& ramp : palette.ramps) {
        std::erase_if(ramp.indices, [&](std::uint8_t index) {
            return std::find(made.indices.begin(), made.indices.end(), index) != made.indices.end();
        });
    }
    std::erase_if(palette.ramps, [](const PaletteRamp& ramp) { return ramp.indices.size() < 2; });
    palette.ramps.push_back(std::move(made));
    return palette;
}

Palette withRampStepMoved(Palette palette, std::size_t ramp, std::size_t from, std::size_t to) {
    if (ramp >= palette.ramps.size()) return palette;
    std::vector<std::uint8_t>& steps = palette.ramps[ramp].indices;
    if (from >= steps.size() || to >= steps.size()) return palette;
    const std::uint8_t step = steps[from];
    steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(from));
    steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(to), step);
    return palette;
}

Palette withoutRamp(Palette palette, std::size_t ramp) {
    palette.ramps.erase(palette.ramps.begin() + static_cast<std::ptrdiff_t>(ramp));
    return palette;
}

Palette withSuggestedRamps(Palette palette, std::span<const std::uint8_t> indices) {
    std::vector<std::vector<Shade>> chains;
    for (const Shade& shade : shadesOf(palette, indices)) {
        if (palette.rampOf(shade.index)) continue;
        std::vector<Shade>* best = nullptr;
        double nearest = 0.0;
        for (std::vector<Shade>& chain : chains) {
            if (!follows(chain.back().colour, shade.colour)) continue;
            const double distance = squaredDistance(chain.back().colour, shade.colour);
            if (best != nullptr && distance >= nearest) continue;
            best = &chain;
            nearest = distance;
        }
        if (best != nullptr) {
            best->push_back(shade);
        } else {
            chains.push_back({shade});
        }
    }
    for (const std::vector<Shade>& chain : chains) {
        if (chain.size() < 2) continue;
        PaletteRamp ramp;
        for (const Shade& shade : chain) ramp.indices.push_back(shade.index);
        palette.ramps.push_back(std::move(ramp));
    }
    return palette;
}

}  // namespace voxprite
