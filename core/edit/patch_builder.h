// Makes patches from whole cubes of 8x8x8 voxels: of each cube that an edit touches, what shall be
// there. Compares it with what is there, applies the limits, and lists the changes in the order
// that recorded steps have, without sorting voxels. Private to core/edit.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/edit/cube_bits.h"
#include "core/edit/patches.h"

namespace voxprite {

using CubeBytes = std::array<std::uint8_t, kCubeVoxels>;  // in the order of VoxelBlock

// Of an edit that would change so many.
[[nodiscard]] Failure tooManyChanges(std::uint64_t voxels);

// The cube of 8 at `origin`.
[[nodiscard]] CubeBytes cubeBytes(const VoxelGrid& voxels, glm::ivec3 origin);

class PatchBuilder {
  public:
    // Document and limits must outlive the builder.
    PatchBuilder(const Document& document, int model, const EditLimits& limits);

    [[nodiscard]] const VoxelGrid& voxels() const { return voxels_; }
    [[nodiscard]] CubeBytes before(glm::ivec3 origin) const { return cubeBytes(voxels_, origin); }
    // Each cube at most once. Values outside the range of coordinates and the limits do not count.
    void set(glm::ivec3 origin, CubeBytes after);
    // Once. Fails when there are more changes than kMaxPatchVoxels.
    [[nodiscard]] Result<VoxelPatch> finish();

  private:
    struct Cube {
        glm::ivec3 origin{0};
        CubeBytes before;
        CubeBytes after;
    };
    void keepWithinLimits(Cube& cube) const;

    const VoxelGrid& voxels_;
    int model_;
    const EditLimits& limits_;
    std::vector<std::unique_ptr<Cube>> cubes_;
    std::uint64_t changes_ = 0;
};

// The minimum corners of the cubes of 8 that hold what is in the grids, ascending, none twice.
// Fails when there are too many to go through one by one.
[[nodiscard]] Result<std::vector<glm::ivec3>> cubesOf(const VoxelGrid& a);
[[nodiscard]] Result<std::vector<glm::ivec3>> cubesOf(const VoxelGrid& a, const VoxelGrid& b);

}  // namespace voxprite
