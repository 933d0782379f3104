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
    hash.add(glm::ivec2(key.frame, key.lit.outline.enabled ? 1 : 0));
    hash.add(glm::ivec2(key.lattice.positionBits, key.lattice.directionBits));
    hash.add(key.lattice.C);
    hash.add(key.lattice.D);
    hash.add(key.lattice.U);
    hash.add(key.lattice.V);
    hash.add(key.lattice.first);
    hash.add(key.lattice.size);
    for (const Rgba8 colour : key.lit.colours) hash.add(colour);
    hash.add(glm::ivec3(key.lit.light8[0], key.lit.light8[1], key.lit.light8[2]));
    hash.add(key.lit.outline.colour);
    return hash.value();
}

}  // namespace voxprite
