// Lines of text in a picture, from a font file, by stb_truetype.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite::sheet {

class Lettering {
  public:
    [[nodiscard]] static Result<Lettering> fromFile(const std::filesystem::path& path);
    ~Lettering();
    Lettering(Lettering&&) noexcept;
    Lettering& operator=(Lettering&&) noexcept;

    // Latin-1 in UTF-8, its baseline at y, over what the picture holds; cut off at its edges.
    // `heightPx` is from the lowest descender to the highest ascender.
    void draw(Image& picture, int x, int baselineY, float heightPx, Rgba8 colour,
              std::string_view text) const;

  private:
    struct Impl;
    explicit Lettering(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite::sheet
