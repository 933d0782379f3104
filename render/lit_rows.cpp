#include "render/lit_rows.h"

#include <glad/gl.h>

#include <algorithm>

namespace voxprite {

namespace {

constexpr int kColumns = 256;
constexpr int kRowsEach = 3;
constexpr int kFewPalettes = 16;

}  // namespace

std::optional<int> LitRows::rowOf(std::uint64_t number, const LitPalette& lit) {
    if (const auto known = rows_.find(number); known != rows_.end()) return known->second;
    const int used = static_cast<int>(rows_.size());
    if (used == kMostPalettes) return std::nullopt;
    if (used == capacity_) grow();
    const int row = kRowsEach * used;
    for (int axis = 0; axis < kRowsEach; ++axis) {
        const ShadedColours& face = lit.faces[static_cast<std::size_t>(axis)];
        glTextureSubImage2D(texture_.id(), 0, 0, row + axis, kColumns, 1, GL_RED_INTEGER,
                            GL_UNSIGNED_INT, face.data());
    }
    rows_.emplace(number, row);
    return row;
}

void LitRows::grow() {
    const int before = capacity_;
    capacity_ = std::clamp(2 * before, kFewPalettes, kMostPalettes);
    gl::Texture larger = gl::createTexture2d();
    glTextureStorage2D(larger.id(), 1, GL_R32UI, kColumns, kRowsEach * capacity_);
    glTextureParameteri(larger.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(larger.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (before > 0) {
        glCopyImageSubData(texture_.id(), GL_TEXTURE_2D, 0, 0, 0, 0, larger.id(), GL_TEXTURE_2D, 0,
                           0, 0, 0, kColumns, kRowsEach * before, 1);
    }
    texture_ = std::move(larger);
}

}  // namespace voxprite
