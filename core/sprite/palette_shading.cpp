#include "core/sprite/palette_shading.h"

#include <cmath>

namespace voxprite {

namespace {

Rgba8 multiplied(Rgba8 colour, unsigned light8) {
    const auto lit = [light8](unsigned channel) {
        return static_cast<std::uint8_t>((channel * light8 + 127u) / 255u);
    };
    return {lit(colour.x), lit(colour.y), lit(colour.z), 255};
}

std::bitset<256> vacantPlaces(const Palette& palette) {
    std::bitset<256> vacant;
    for (std::size_t i = 0; i < 256; ++i) {
        vacant[i] = palette.isVacant(static_cast<std::uint8_t>(i));
    }
    return vacant;
}

}  // namespace

PaletteShader::PaletteShader(const Palette& palette)
    : colours_(palette.colours), ramps_(palette.ramps), vacant_(vacantPlaces(palette)) {}

bool PaletteShader::isOf(const Palette& palette) const {
    return palette.colours == colours_ && palette.ramps == ramps_ &&
           vacantPlaces(palette) == vacant_;
}

void PaletteShader::prepareToPick() {
    if (!labs_.empty()) return;
    for (const Rgba8 colour : colours_) labs_.push_back(okLabFrom(colour));
    choices_.resize(256);
    for (const PaletteRamp& ramp : ramps_) {
        for (auto end = ramp.indices.begin(); end != ramp.indices.end(); ++end) {
            choices_[*end].assign(ramp.indices.begin(), end + 1);
        }
    }
}

Rgba8 PaletteShader::picked(std::uint8_t index, Rgba8 aim) const {
    const OkLab wanted = okLabFrom(aim);
    std::uint8_t best = index;
    if (const auto& ramp = choices_[index]; !ramp.empty()) {
        // From the light end, so that an equally near darker one does not win.
        for (auto choice = ramp.rbegin(); choice != ramp.rend(); ++choice) {
            if (std::abs(labs_[*choice].lightness - wanted.lightness) <
                std::abs(labs_[best].lightness - wanted.lightness)) {
                best = *choice;
            }
        }
    } else {
        double nearest = -1.0;
        for (std::size_t i = 1; i < 256; ++i) {
            if (vacant_[i] && i != index) continue;
            const double distance = squaredDistance(labs_[i], wanted);
            if (nearest >= 0.0 && distance >= nearest) continue;
            nearest = distance;
            best = static_cast<std::uint8_t>(i);
        }
    }
    const Rgba8 colour = colours_[best];
    return {colour.x, colour.y, colour.z, 255};
}

const ShadedColours& PaletteShader::inLight(std::uint8_t light8, Shading shading) {
    std::unique_ptr<ShadedColours>& shaded = inLight_[static_cast<std::size_t>(shading)][light8];
    if (shaded) return *shaded;
    shaded = std::make_unique<ShadedColours>();
    if (shading == Shading::palette) prepareToPick();
    for (std::size_t i = 0; i < 256; ++i) {
        Rgba8& colour = (*shaded)[i];
        colour = multiplied(colours_[i], light8);
        if (shading == Shading::palette && i != 0) {
            colour = picked(static_cast<std::uint8_t>(i), colour);
        }
    }
    return *shaded;
}

}  // namespace voxprite
