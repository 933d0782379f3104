#include "core/sprite/sprite_key.h"

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

std::size_t hashOf(const LitPalette& lit) {
    Hash hash;
    for (const Rgba8 colour : lit.colours) hash.add(colour);
    hash.add(glm::ivec3(lit.light8[0], lit.light8[1], lit.light8[2]));
    hash.add(lit.outline.colour);
    hash.add(lit.outline.enabled ? 1 : 0);
    return hash.value();
}

std::size_t LitPalettes::SeenHash::operator()(const Seen& seen) const {
    Hash hash;
    hash.add(reinterpret_cast<std::uintptr_t>(seen.palette));
    hash.add(glm::ivec3(seen.light8[0], seen.light8[1], seen.light8[2]));
    return hash.value();
}

void LitPalettes::beginFrame() {
    // What is forgotten is given a new number should it come again.
    constexpr std::size_t kMostKept = 4096;
    if (numbers_.size() > kMostKept) numbers_.clear();
    thisFrame_.clear();
}

LitPalettes::Numbered LitPalettes::of(const Palette& palette, std::array<std::uint8_t, 3> light8,
                                      const Outline& outline) {
    const auto [seen, isNew] = thisFrame_.try_emplace({&palette, light8});
    if (isNew) {
        const auto [entry, first] =
            numbers_.try_emplace(litPalette(palette, light8, outline), last_ + 1);
        if (first) ++last_;
        seen->second = {entry->second, &entry->first};
    }
    return seen->second;
}

}  // namespace voxprite
