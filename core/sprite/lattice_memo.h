// Views that were quantised before. Quantising takes some twenty microseconds, for the search of
// the nearest direction; the entities of a crowd often show the same view.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <unordered_map>

#include "core/trace/lattice.h"

namespace voxprite {

// Any number of threads may ask at once.
class LatticeMemo {
  public:
    // However long a camera moves, no more views than this are kept: those asked for last.
    static constexpr std::size_t kMostKept = std::size_t{1} << 17;

    // The same as quantiseView, which depends on nothing else.
    [[nodiscard]] Result<LatticeView> quantise(const OrthoView& view, glm::ivec3 modelSize);
    [[nodiscard]] std::size_t kept() const;

  private:
    struct Key {
        OrthoView view;
        glm::ivec3 modelSize{0};
        bool operator==(const Key& other) const;
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };
    using Views = std::unordered_map<Key, LatticeView, KeyHash>;
    // A part of all views, so that threads seldom wait for each other. When `recent` is full it
    // takes the place of `older`, and what was in there is forgotten.
    struct Shard {
        mutable std::mutex mutex;
        Views recent, older;
    };
    static constexpr std::size_t kShards = 16;
    static constexpr std::size_t kMostRecent = kMostKept / (2 * kShards);

    static void remember(Shard& shard, const Key& key, const LatticeView& lattice);

    std::array<Shard, kShards> shards_;
};

}  // namespace voxprite
