// Lit palettes as a texture of words of RGBA8: column = material, and as many rows as a palette has
// kinds of faces.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/sprite/sprite_buffer.h"
#include "render/gl/handles.h"

namespace voxprite {

class LitRows {
  public:
    // The first row of the palette of this number (see LitPalettes), uploaded when it is new.
    // Nothing when all rows are taken: forgetAll makes room, once what was given has been drawn.
    [[nodiscard]] std::optional<int> rowOf(std::uint64_t number, const LitPalette& lit);
    void forgetAll() {
        rows_.clear();
        used_ = 0;
    }
    [[nodiscard]] std::uint32_t texture() const { return texture_.id(); }

    static constexpr int kMostRows = 3 * 2048;  // 6 MiB

  private:
    void grow(int rows);

    gl::Texture texture_;
    int capacity_ = 0;  // rows
    int used_ = 0;
    std::unordered_map<std::uint64_t, int> rows_;
};

}  // namespace voxprite
