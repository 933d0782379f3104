// What a sprite is a function of, and nothing else: the key of every cache of sprite buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <unordered_map>

#include "core/sprite/sprite_buffer.h"
#include "core/trace/lattice.h"

namespace voxprite {

// sigma * scale in force is in the lattice's steps. Equal keys mean equal buffers, bit for bit.
struct SpriteKey {
    std::uint64_t modelRevision = 0;  // of the voxels; unique among the models of the cache
    int frame = 0;
    LatticeView lattice;
    std::uint64_t litPalette = 0;  // its number among LitPalettes, which knows the light's rays too
    bool operator==(const SpriteKey&) const = default;
};

[[nodiscard]] std::size_t hashOf(const SpriteKey& key);

}  // namespace voxprite

template <>
struct std::hash<voxprite::SpriteKey> {
    std::size_t operator()(const voxprite::SpriteKey& key) const { return voxprite::hashOf(key); }
};

namespace voxprite {

// Gives lit palettes numbers, so that a crowd compares and hashes a number instead of thousands
// of colours: the same palette in the same light has the same number, and no number ever stands for
// two. Palettes and their lit tables are each bounded by twice what one frame asks for and kSpare
// more: what the last frame did not use may be forgotten and, should it come again, is worked out
// and numbered anew.
class LitPalettes {
  public:
    static constexpr std::size_t kSpare = 1024;

    struct Numbered {
        std::uint64_t number = 0;
        const LitPalette* lit = nullptr;  // until the next beginFrame
    };
    // Until the next call the palettes that are passed below change neither place nor content.
    void beginFrame();
    [[nodiscard]] Numbered of(const Palette& palette, const FaceLights& lights,
                              const Outline& outline, Shading shading = Shading::multiply);
    // Equal for palettes that are shaded alike (PaletteShader::isOf), and never given to another.
    [[nodiscard]] std::uint64_t contentOf(const Palette& palette);
    // Palettes and lit tables that are remembered.
    [[nodiscard]] std::size_t kept() const { return kept_ + sources_.size(); }

  private:
    struct Look {
        FaceLights lights;
        Outline outline;
        Shading shading;
        bool operator==(const Look&) const = default;
    };
    struct LookHash {
        std::size_t operator()(const Look& look) const;
    };
    struct Lit {
        std::uint64_t number = 0;
        std::uint64_t usedInFrame = 0;
        LitPalette palette;
    };
    struct Source {
        PaletteShader shader;
        std::uint64_t content;
        std::uint64_t usedInFrame;
        std::unordered_map<Look, Lit, LookHash> lit;
    };
    [[nodiscard]] Source& sourceOf(const Palette& palette);
    void forgetUnused();

    std::list<Source> sources_;  // a list: their places in memory stay
    std::unordered_map<const Palette*, Source*> thisFrame_;
    std::uint64_t frame_ = 1;
    std::size_t used_ = 0;  // lit palettes, in this frame
    std::size_t kept_ = 0;
    std::uint64_t lastNumber_ = 0;
    std::uint64_t lastContent_ = 0;
};

}  // namespace voxprite
