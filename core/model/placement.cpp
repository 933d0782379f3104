#include "core/model/placement.h"

namespace voxprite {

SignedPermutation SignedPermutation::inverse() const {
    SignedPermutation inverse;
    for (std::uint8_t row = 0; row < 3; ++row) {
        inverse.axis[axis[row]] = row;
        inverse.sign[axis[row]] = sign[row];
    }
    return inverse;
}

int SignedPermutation::determinant() const {
    // The three cyclic orders are even, the three others odd.
    const bool even = axis[1] == (axis[0] + 1) % 3;
    const int signs = sign[0] * sign[1] * sign[2];
    return even ? signs : -signs;
}

Result<SignedPermutation> SignedPermutation::fromVoxByte(int byte) {
    const int first = byte & 3;
    const int second = (byte >> 2) & 3;
    if (byte < 0 || byte > 127 || first == 3 || second == 3 || first == second) {
        return fail("rotation " + std::to_string(byte) + " is none of the 48 signed permutations");
    }
    SignedPermutation rotation;
    rotation.axis = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
                     static_cast<std::uint8_t>(3 - first - second)};
    for (std::size_t row = 0; row < 3; ++row) {
        rotation.sign[row] = ((byte >> (4 + row)) & 1) != 0 ? -1 : 1;
    }
    return rotation;
}

int SignedPermutation::toVoxByte() const {
    int byte = axis[0] | (axis[1] << 2);
    for (std::size_t row = 0; row < 3; ++row) {
        if (sign[row] < 0) byte |= 1 << (4 + row);
    }
    return byte;
}

SignedPermutation operator*(const SignedPermutation& a, const SignedPermutation& b) {
    SignedPermutation product;
    for (std::size_t row = 0; row < 3; ++row) {
        product.axis[row] = b.axis[a.axis[row]];
        product.sign[row] = static_cast<std::int8_t>(a.sign[row] * b.sign[a.axis[row]]);
    }
    return product;
}

glm::ivec3 Placement::applyToVoxel(glm::ivec3 v) const {
    // The cell's corner that becomes the lowest is its upper one on a mirrored axis.
    const glm::ivec3 mirrored(rotation.sign[0] < 0, rotation.sign[1] < 0, rotation.sign[2] < 0);
    return rotation.apply(v) - mirrored + translation;
}

IBox Placement::applyToBox(const IBox& box) const {
    if (box.empty()) return {};
    const glm::ivec3 a = rotation.apply(box.min) + translation;
    const glm::ivec3 b = rotation.apply(box.max) + translation;
    return {glm::min(a, b), glm::max(a, b)};
}

Placement Placement::inverse() const {
    const SignedPermutation back = rotation.inverse();
    return {back, -back.apply(translation)};
}

Placement operator*(const Placement& a, const Placement& b) {
    return {a.rotation * b.rotation, a.rotation.apply(b.translation) + a.translation};
}

}  // namespace voxprite
