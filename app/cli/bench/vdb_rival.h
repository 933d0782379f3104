// OpenVDB and NanoVDB, to measure the bake and the update against. Values are 16 bits wide, the
// narrowest integer that NanoVDB knows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "core/model/voxel_grid.h"

namespace voxprite::bench {

// The voxels in OpenVDB's usual tree (5-4-3), which is the only one that NanoVDB takes.
class VdbGrid {
  public:
    explicit VdbGrid(const VoxelGrid& voxels);
    ~VdbGrid();
    VdbGrid(const VdbGrid&) = delete;
    VdbGrid& operator=(const VdbGrid&) = delete;

    // Sets a voxel through an accessor that remembers where the last one was.
    void set(glm::ivec3 voxel, std::uint8_t material);
    // Converts all of it to NanoVDB, on all cores, without the statistics and the checksum that are
    // optional; the bytes that takes. Throws what NanoVDB throws.
    [[nodiscard]] std::size_t toNanoVdb() const;
    // Whether NanoVDB's grid holds these voxels.
    [[nodiscard]] bool nanoVdbHolds(const VoxelGrid& voxels) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite::bench
