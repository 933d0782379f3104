// Views that were quantised before. Quantising takes some twenty microseconds, for the search of
// the nearest direction; the entities of a crowd often show the same view.
#pragma once

#include <unordered_map>

#include "core/trace/lattice.h"

namespace voxprite {

class LatticeMemo {
  public:
    // The same as quantiseView, which depends on nothing else.
    [[nodiscard]] Result<LatticeView> quantise(const OrthoView& view, glm::ivec3 modelSize);

  private:
    struct Key {
        OrthoView view;
        glm::ivec3 modelSize{0};
        bool operator==(const Key& other) const;
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };
    std::unordered_map<Key, LatticeView, KeyHash> lattices_;
};

}  // namespace voxprite
