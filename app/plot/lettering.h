// Lines of text in a picture, by stb_truetype, in the typeface that the program carries.
#pragma once

#include <memory>
#include <string_view>

#include "core/base/image.h"

namespace voxprite::plot {

class Lettering {
  public:
    [[nodiscard]] static Lettering regular();
    [[nodiscard]] static Lettering bold();
    ~Lettering();
    Lettering(Lettering&&) noexcept;
    Lettering& operator=(Lettering&&) noexcept;

    // UTF-8, its baseline at y, over what the picture holds; cut off at its edges. `heightPx` is
    // from the lowest descender to the highest ascender.
    void draw(Image& picture, int x, int baselineY, float heightPx, Rgba8 colour,
              std::string_view text) const;
    [[nodiscard]] float widthOf(float heightPx, std::string_view text) const;

  private:
    struct Impl;
    explicit Lettering(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite::plot
