// Where snapshots lie on the GPU: the layers of two texture arrays, colours and reversed depths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <tuple>

#include "render/frame.h"
#include "render/gl/handles.h"

namespace voxprite {

class SnapshotLayers {
  public:
    // Of an octree's and a palette's content, in a light (toward it, in voxel space), from a view.
    struct Key {
        std::uint64_t octree = 0;
        std::uint64_t palette = 0;
        glm::dvec3 towardLight{0.0};
        int view = 0;
        friend bool operator<(const Key& a, const Key& b) {
            const auto order = [](const Key& k) {
                return std::tuple(k.octree, k.palette, k.view, k.towardLight.x, k.towardLight.y,
                                  k.towardLight.z);
            };
            return order(a) < order(b);
        }
    };

    // Forgets all.
    void reset(int sizePx, std::uint64_t mostBytes);
    // The layer of a snapshot that is held.
    [[nodiscard]] std::optional<int> find(const Key& key);
    // A layer for a snapshot that is not held: a new one, or that of the one asked for longest ago
    // before the last call of endBatch. Nothing when all belong to this batch.
    [[nodiscard]] std::optional<int> add(const Key& key);
    void endBatch() { batchBegan_ = uses_; }
    // The frame, of this size, becomes the layer's picture.
    void copyFrom(const Frame& frame, int layer);

    [[nodiscard]] std::uint32_t colours() const { return colours_.id(); }
    [[nodiscard]] std::uint32_t depths() const { return depths_.id(); }
    [[nodiscard]] int held() const { return static_cast<int>(entries_.size()); }
    [[nodiscard]] std::uint64_t bytes() const { return bytesPerLayer() * capacity_; }

  private:
    struct Entry {
        int layer = 0;
        std::uint64_t lastUse = 0;
    };
    [[nodiscard]] std::uint64_t bytesPerLayer() const;
    bool grow();

    int sizePx_ = 0;
    int mostLayers_ = 0;
    int capacity_ = 0;
    gl::Texture colours_, depths_;
    std::map<Key, Entry> entries_;
    std::uint64_t uses_ = 0;
    std::uint64_t batchBegan_ = 0;
};

}  // namespace voxprite
