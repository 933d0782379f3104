// What a sprite is a function of, and nothing else: the key of every cache of sprite buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "core/sprite/sprite_buffer.h"
#include "core/trace/lattice.h"

namespace voxprite {

// sigma * scale in force is in the lattice's steps. Equal keys mean equal buffers, bit for bit.
struct SpriteKey {
    std::uint64_t modelRevision = 0;  // of the voxels; unique among the models of the cache
    int frame = 0;
    LatticeView lattice;
    std::uint64_t litPalette = 0;  // its number among LitPalettes
    bool operator==(const SpriteKey&) const = default;
};

[[nodiscard]] std::size_t hashOf(const SpriteKey& key);
[[nodiscard]] std::size_t hashOf(const LitPalette& lit);

}  // namespace voxprite

template <>
struct std::hash<voxprite::LitPalette> {
    std::size_t operator()(const voxprite::LitPalette& lit) const { return voxprite::hashOf(lit); }
};

template <>
struct std::hash<voxprite::SpriteKey> {
    std::size_t operator()(const voxprite::SpriteKey& key) const { return voxprite::hashOf(key); }
};

namespace voxprite {

// Gives lit palettes numbers, so that a crowd compares and hashes a number instead of 256 colours:
// equal palettes have equal numbers, and no number ever stands for two palettes.
class LitPalettes {
  public:
    struct Numbered {
        std::uint64_t number = 0;
        const LitPalette* lit = nullptr;  // until the next beginFrame
    };
    // Until the next call neither the palettes nor the outline that are passed to `of` change.
    void beginFrame();
    [[nodiscard]] Numbered of(const Palette& palette, std::array<std::uint8_t, 3> light8,
                              const Outline& outline);

  private:
    struct Seen {
        const Palette* palette;
        std::array<std::uint8_t, 3> light8;
        bool operator==(const Seen&) const = default;
    };
    struct SeenHash {
        std::size_t operator()(const Seen& seen) const;
    };
    std::unordered_map<LitPalette, std::uint64_t> numbers_;
    std::unordered_map<Seen, Numbered, SeenHash> thisFrame_;
    std::uint64_t last_ = 0;
};

}  // namespace voxprite
