// Mirrored editing about one plane an axis, at a boundary between voxels or through their middle.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/edit/voxel_set.h"
#include "core/model/placement.h"

namespace voxprite {

// Model space. The plane of an axis is where its continuous coordinate is planeDoubled / 2: even
// numbers lie between two voxels (models of even size), odd ones within a voxel (odd size).
struct Symmetry {
    std::array<bool, 3> on{false, false, false};
    glm::ivec3 planeDoubled{0};
    bool operator==(const Symmetry&) const = default;

    [[nodiscard]] bool any() const { return on[0] || on[1] || on[2]; }
    // The planes through the middle of `bounds` (which has one for any size).
    [[nodiscard]] static glm::ivec3 planesThroughCentre(const IBox& bounds) {
        return bounds.min + bounds.max;
    }
};

// The mirrors that the switched-on axes make together: 1, 2, 4 or 8, the identity first. What is
// drawn at `v` is drawn at applyToVoxel(v) of each; directions turn with `rotation`.
[[nodiscard]] std::vector<Placement> imagesOf(const Symmetry& symmetry);

// Everything with all its images. Positions: the given ones first, then image by image; one that
// lies in a plane stands several times (patchVoxels does not mind).
[[nodiscard]] std::vector<glm::ivec3> mirrored(std::span<const glm::ivec3> positions,
                                               const Symmetry& symmetry);
[[nodiscard]] VoxelSet mirrored(const VoxelSet& set, const Symmetry& symmetry);

}  // namespace voxprite
