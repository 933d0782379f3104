#include "core/sprite/lattice_memo.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace voxprite {

bool LatticeMemo::Key::operator==(const Key& other) const {
    return view.right == other.view.right && view.up == other.view.up &&
           view.forward == other.view.forward && view.sigmaInForce == other.view.sigmaInForce &&
           modelSize == other.modelSize;
}

std::size_t LatticeMemo::KeyHash::operator()(const Key& key) const {
    std::uint64_t state = 0;
    const auto add = [&](double value) {
        // + 0.0 makes one of the two zeros, which are equal.
        state = (state ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x9E37'79B9'7F4A'7C15u;
        state ^= state >> 29;
    };
    for (const glm::dvec3 v : {key.view.right, key.view.forward, glm::dvec3(key.modelSize)}) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    add(key.view.sigmaInForce);
    return static_cast<std::size_t>(state);
}

void LatticeMemo::remember(Shard& shard, const Key& key, const LatticeView& lattice) {
    if (shard.recent.size() >= kMostRecent) {
        shard.older = std::move(shard.recent);
        shard.recent.clear();
    }
    shard.recent.emplace(key, lattice);
}

Result<LatticeView> LatticeMemo::quantise(const OrthoView& view, glm::ivec3 modelSize) {
    const Key key{view, modelSize};
    // The map goes by the low bits.
    Shard& shard = shards_[(KeyHash{}(key) >> 48) % kShards];
    {
        const std::lock_guard lock(shard.mutex);
        if (const auto found = shard.recent.find(key); found != shard.recent.end()) {
            return found->second;
        }
        if (const auto found = shard.older.find(key); found != shard.older.end()) {
            const LatticeView lattice = found->second;
            shard.older.erase(found);
            remember(shard, key, lattice);
            return lattice;
        }
    }
    Result<LatticeView> lattice = quantiseView(view, modelSize);
    if (!lattice) return lattice;
    const std::lock_guard lock(shard.mutex);
    remember(shard, key, *lattice);
    return lattice;
}

std::size_t LatticeMemo::kept() const {
    std::size_t sum = 0;
    for (const Shard& shard : shards_) {
        const std::lock_guard lock(shard.mutex);
        sum += shard.recent.size() + shard.older.size();
    }
    return sum;
}

}  // namespace voxprite
