// The octrees of a scene side by side in one texture, so that one draw casts them all. They are
// copied there from their own textures, on the GPU, when they are new or have changed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/gpu_octree.h"

namespace voxprite {

// Where shaders find an octree: offsets in texels of `texture`.
struct OctreePlace {
    std::uint32_t texture = 0;
    std::uint32_t nodeOffset = 0;
    std::uint32_t payloadOffset = 0;
};

class OctreeArena {
  public:
    // Rows of the texture, 16 KiB each: 64 MiB at most.
    explicit OctreeArena(int mostRows = 4096) : mostRows_(mostRows) {}

    // Makes room for the octrees of a frame, each given once. One alone, and what finds no room any
    // more, is read from its own texture.
    void arrange(std::span<const GpuOctree* const> octrees);
    // Of an octree that was arranged, until it changes or the next call of arrange.
    [[nodiscard]] OctreePlace placeOf(const GpuOctree& octree) const;
    [[nodiscard]] std::uint64_t bytes() const;

  private:
    struct Resident {
        std::uint64_t revision;
        int firstRow;
        int rows;
        bool wanted;  // by this frame
    };
    bool add(const GpuOctree& octree);
    [[nodiscard]] bool grow(int rows);

    int mostRows_;
    int rows_ = 0;
    gl::Texture texture_;
    std::vector<Resident> residents_;                // by row
    std::vector<std::pair<std::uint64_t, int>> at_;  // revision and first row, by revision
};

}  // namespace voxprite
