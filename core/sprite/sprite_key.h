// What a sprite is a function of, and nothing else: the key of every cache of sprite buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/sprite/sprite_buffer.h"
#include "core/trace/lattice.h"

namespace voxprite {

// sigma * scale in force is in the lattice's steps. Equal keys mean equal buffers, bit for bit.
struct SpriteKey {
    std::uint64_t modelRevision = 0;  // of the voxels; unique among the models of the cache
    int frame = 0;
    LatticeView lattice;
    LitPalette lit;
    bool operator==(const SpriteKey&) const = default;
};

[[nodiscard]] std::size_t hashOf(const SpriteKey& key);

}  // namespace voxprite

template <>
struct std::hash<voxprite::SpriteKey> {
    std::size_t operator()(const voxprite::SpriteKey& key) const { return voxprite::hashOf(key); }
};
