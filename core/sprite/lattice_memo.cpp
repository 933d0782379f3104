#include "core/sprite/lattice_memo.h"

#include <bit>
#include <cstdint>

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

Result<LatticeView> LatticeMemo::quantise(const OrthoView& view, glm::ivec3 modelSize) {
    constexpr std::size_t kMostKept = std::size_t{1} << 17;
    const Key key{view, modelSize};
    if (const auto found = lattices_.find(key); found != lattices_.end()) return found->second;
    Result<LatticeView> lattice = quantiseView(view, modelSize);
    if (!lattice) return lattice;
    if (lattices_.size() >= kMostKept) lattices_.clear();
    lattices_.emplace(key, *lattice);
    return lattice;
}

}  // namespace voxprite
