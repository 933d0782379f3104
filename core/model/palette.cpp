#include "core/model/palette.h"

#include <algorithm>
#include <set>

namespace voxprite {

namespace {

Status validateRamps(const std::vector<PaletteRamp>& ramps) {
    std::array<bool, 256> taken{};
    taken[0] = true;
    for (std::size_t i = 0; i < ramps.size(); ++i) {
        const std::string field = "palette.ramps[" + std::to_string(i) + "]";
        if (ramps[i].indices.size() < 2) return fail(field + " has fewer than two colours");
        for (const std::uint8_t index : ramps[i].indices) {
            if (index == 0) return fail(field + " names index 0, which is empty");
            if (taken[index]) {
                return fail(field + " names index " + std::to_string(index) +
                            ", which stands in a ramp already");
            }
            taken[index] = true;
        }
    }
    return {};
}

Status validateVariants(const std::vector<PaletteVariant>& variants) {
    if (variants.size() > kMaxPaletteVariants) {
        return fail("palette.variants: there are " + std::to_string(variants.size()) +
                    "; at most " + std::to_string(kMaxPaletteVariants) + " are allowed");
    }
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const std::string field = "palette.variants[" + std::to_string(i) + "]";
        if (variants[i].name.empty()) return fail(field + " has no name");
        if (!names.insert(variants[i].name).second) {
            return fail(field + ": there is a variant \"" + variants[i].name + "\" already");
        }
        if (variants[i].overrides.contains(0)) {
            return fail(field + " gives index 0 a colour; it is empty");
        }
    }
    return {};
}

}  // namespace

std::optional<std::size_t> Palette::rampOf(std::uint8_t index) const {
    for (std::size_t i = 0; i < ramps.size(); ++i) {
        const auto& indices = ramps[i].indices;
        if (std::find(indices.begin(), indices.end(), index) != indices.end()) return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> Palette::variantNamed(std::string_view name) const {
    for (std::size_t i = 0; i < variants.size(); ++i) {
        if (variants[i].name == name) return i;
    }
    return std::nullopt;
}

Palette Palette::withVariant(std::size_t variant) const {
    Palette palette = *this;
    for (const auto& [index, colour] : variants[variant].overrides) {
        palette.colours[index] = colour;
    }
    return palette;
}

std::array<std::uint8_t, 256> Palette::identityOrder() {
    std::array<std::uint8_t, 256> order{};
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
        order[slot] = static_cast<std::uint8_t>(slot);
    }
    return order;
}

Palette Palette::standard() {
    Palette palette;
    std::size_t index = 1;
    // The 6x6x6 colour cube from white downward, blue fastest; black is left out.
    constexpr std::array<std::uint8_t, 6> kCube{0xFF, 0xCC, 0x99, 0x66, 0x33, 0x00};
    for (const std::uint8_t red : kCube) {
        for (const std::uint8_t green : kCube) {
            for (const std::uint8_t blue : kCube) {
                if (index < 216) palette.colours[index++] = Rgba8(red, green, blue, 0xFF);
            }
        }
    }
    // Then ramps of red, green, blue and grey, in the steps that the cube does not have.
    constexpr std::array<std::uint8_t, 10> kRamp{0xEE, 0xDD, 0xBB, 0xAA, 0x88,
                                                 0x77, 0x55, 0x44, 0x22, 0x11};
    for (const std::uint8_t red : kRamp) palette.colours[index++] = Rgba8(red, 0, 0, 0xFF);
    for (const std::uint8_t green : kRamp) palette.colours[index++] = Rgba8(0, green, 0, 0xFF);
    for (const std::uint8_t blue : kRamp) palette.colours[index++] = Rgba8(0, 0, blue, 0xFF);
    for (const std::uint8_t grey : kRamp) palette.colours[index++] = Rgba8(grey, grey, grey, 0xFF);
    return palette;
}

Status validate(const Palette& palette) {
    if (palette.colours[0] != Rgba8(0)) {
        return fail("palette.colours[0] must be transparent black: index 0 is empty");
    }
    std::array<bool, 256> shown{};
    for (const std::uint8_t index : palette.displayOrder) shown[index] = true;
    if (std::find(shown.begin(), shown.end(), false) != shown.end()) {
        return fail("palette.displayOrder is not a permutation of 0..255");
    }
    if (palette.displayOrder[0] != 0) return fail("palette.displayOrder[0] must be 0");
    if (Status s = validateRamps(palette.ramps); !s) return s;
    return validateVariants(palette.variants);
}

}  // namespace voxprite
