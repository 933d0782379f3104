#include "core/sprite/sprite_key.h"

#include <algorithm>

namespace voxprite {

namespace {

// FNV-1a over 64-bit words, with a shift so that high bits reach the low ones.
class Hash {
  public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x0000'0100'0000'01B3u;
        state_ ^= state_ >> 32;
    }
    void add(glm::ivec2 v) {
        add(std::uint64_t{static_cast<std::uint32_t>(v.x)} << 32 | static_cast<std::uint32_t>(v.y));
    }
    void add(glm::ivec3 v) {
        add(glm::ivec2(v.x, v.y));
        add(static_cast<std::uint32_t>(v.z));
    }
    void add(Rgba8 c) {
        add(std::uint64_t{c.x} | std::uint64_t{c.y} << 8 | std::uint64_t{c.z} << 16 |
            std::uint64_t{c.w} << 24);
    }
    void add(const std::array<std::uint8_t, 3>& bytes) {
        add(Rgba8(bytes[0], bytes[1], bytes[2], 0));
    }
    [[nodiscard]] std::size_t value() const { return static_cast<std::size_t>(state_); }

  private:
    std::uint64_t state_ = 0xCBF2'9CE4'8422'2325u;
};

}  // namespace

std::size_t hashOf(const SpriteKey& key) {
    Hash hash;
    hash.add(key.modelRevision);
    hash.add(static_cast<std::uint32_t>(key.frame));
    hash.add(key.litPalette);
    hash.add(glm::ivec2(key.lattice.positionBits, key.lattice.directionBits));
    hash.add(key.lattice.C);
    hash.add(key.lattice.D);
    hash.add(key.lattice.U);
    hash.add(key.lattice.V);
    hash.add(key.lattice.first);
    hash.add(key.lattice.size);
    return hash.value();
}

std::size_t LitPalettes::LookHash::operator()(const Look& look) const {
    Hash hash;
    hash.add(look.lights.open);
    hash.add(look.lights.shadowed);
    hash.add(std::uint64_t{look.lights.occlusion});
    hash.add(look.lights.rays.towardLight);
    hash.add(look.outline.colour);
    hash.add(static_cast<std::uint64_t>(look.shading) << 1 | (look.outline.enabled ? 1 : 0));
    return hash.value();
}

void LitPalettes::beginFrame() {
    if (kept_ > 2 * used_ + kSpare || sources_.size() > 2 * thisFrame_.size() + kSpare) {
        forgetUnused();
    }
    thisFrame_.clear();
    used_ = 0;
    ++frame_;
}

void LitPalettes::forgetUnused() {
    std::erase_if(sources_, [&](const Source& source) { return source.usedInFrame != frame_; });
    kept_ = 0;
    for (Source& source : sources_) {
        std::erase_if(source.lit,
                      [&](const auto& entry) { return entry.second.usedInFrame != frame_; });
        kept_ += source.lit.size();
    }
}

LitPalettes::Source& LitPalettes::sourceOf(const Palette& palette) {
    Source*& known = thisFrame_[&palette];
    if (known != nullptr) return *known;
    const auto same = std::find_if(sources_.begin(), sources_.end(), [&](const Source& source) {
        return source.shader.isOf(palette);
    });
    known =
        same != sources_.end()
            ? &*same
            : &sources_.emplace_back(Source{PaletteShader(palette), ++lastContent_, frame_, {}});
    known->usedInFrame = frame_;
    return *known;
}

std::uint64_t LitPalettes::contentOf(const Palette& palette) {
    return sourceOf(palette).content;
}

LitPalettes::Numbered LitPalettes::of(const Palette& palette, const FaceLights& lights,
                                      const Outline& outline, Shading shading) {
    Source& source = sourceOf(palette);
    Lit& lit = source.lit[{lights, outline, shading}];
    if (lit.number == 0) {
        lit.number = ++lastNumber_;
        lit.palette = litPalette(source.shader, lights, outline, shading);
        ++kept_;
    }
    if (lit.usedInFrame != frame_) ++used_;
    lit.usedInFrame = frame_;
    return {lit.number, &lit.palette};
}

}  // namespace voxprite
