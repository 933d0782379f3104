#include "render/lit_rows.h"

#include <glad/gl.h>

#include <algorithm>

namespace voxprite {

namespace {

constexpr int kColumns = 256;
constexpr int kFewRows = 48;

}  // namespace

std::optional<int> LitRows::rowOf(std::uint64_t number, const LitPalette& lit) {
    if (const auto known = rows_.find(number); known != rows_.end()) return known->second;
    const int row = used_;
    const auto rows = static_cast<int>(lit.faces.size());
    if (row + rows > kMostRows) return std::nullopt;
    if (row + rows > capacity_) grow(row + rows);
    static_assert(sizeof(ShadedColours) == sizeof(std::uint32_t) * kColumns);
    glTextureSubImage2D(texture_.id(), 0, 0, row, kColumns, rows, GL_RED_INTEGER, GL_UNSIGNED_INT,
                        lit.faces.data());
    used_ += rows;
    rows_.emplace(number, row);
    return row;
}

void LitRows::grow(int rows) {
    const int before = capacity_;
    capacity_ = std::clamp(std::max(2 * before, rows), kFewRows, kMostRows);
    gl::Texture larger = gl::createTexture2d();
    glTextureStorage2D(larger.id(), 1, GL_R32UI, kColumns, capacity_);
    glTextureParameteri(larger.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(larger.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (before > 0) {
        glCopyImageSubData(texture_.id(), GL_TEXTURE_2D, 0, 0, 0, 0, larger.id(), GL_TEXTURE_2D, 0,
                           0, 0, 0, kColumns, before, 1);
    }
    texture_ = std::move(larger);
}

}  // namespace voxprite
