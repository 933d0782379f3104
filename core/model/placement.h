// Where an object stands: one of the 48 signed permutations and an integer translation.
//
// A placement acts on continuous space, p' = R p + t, so the voxel cell [v, v+1) goes to a cell and
// a mirrored axis sends cell v to -v - 1 (+ t). Rotation is about the origin of model space.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/result.h"

namespace voxprite {

// Row r of the matrix has the single entry sign[r] (+1 or -1) in column axis[r].
struct SignedPermutation {
    std::array<std::uint8_t, 3> axis{0, 1, 2};
    std::array<std::int8_t, 3> sign{1, 1, 1};

    bool operator==(const SignedPermutation&) const = default;

    [[nodiscard]] glm::ivec3 apply(glm::ivec3 v) const {
        return {sign[0] * v[axis[0]], sign[1] * v[axis[1]], sign[2] * v[axis[2]]};
    }
    [[nodiscard]] SignedPermutation inverse() const;
    [[nodiscard]] int determinant() const;  // -1 for mirrors
    // The rotation byte of a .vox file (_r): bits 0-1 and 2-3 the columns of rows 0 and 1, bits 4-6
    // set where a row is negative. Fails unless the columns are two different ones of 0..2.
    [[nodiscard]] static Result<SignedPermutation> fromVoxByte(int byte);
    [[nodiscard]] int toVoxByte() const;
};
// (a * b).apply(v) == a.apply(b.apply(v))
[[nodiscard]] SignedPermutation operator*(const SignedPermutation& a, const SignedPermutation& b);

// Maps model space into the space of the parent (or of the entity).
struct Placement {
    SignedPermutation rotation;
    glm::ivec3 translation{0};

    bool operator==(const Placement&) const = default;

    // The cell that voxel cell v lands in.
    [[nodiscard]] glm::ivec3 applyToVoxel(glm::ivec3 v) const;
    [[nodiscard]] IBox applyToBox(const IBox& box) const;
    [[nodiscard]] Placement inverse() const;
};
// (a * b).applyToVoxel(v) == a.applyToVoxel(b.applyToVoxel(v))
[[nodiscard]] Placement operator*(const Placement& a, const Placement& b);

}  // namespace voxprite
