#include "samples/sheet/lettering.h"

#include <cmath>
#include <vector>

#include "core/base/file.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

namespace voxprite::sheet {

struct Lettering::Impl {
    Bytes file;  // the font reads from it
    stbtt_fontinfo font{};
};

Lettering::Lettering(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Lettering::~Lettering() = default;
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;

Result<Lettering> Lettering::fromFile(const std::filesystem::path& path) {
    Result<Bytes> bytes = readFile(path);
    if (!bytes) return Failure(bytes.error());
    auto impl = std::make_unique<Impl>();
    impl->file = std::move(*bytes);
    if (stbtt_InitFont(&impl->font, impl->file.data(), 0) == 0) {
        return failInFile(path.string(), "no font");
    }
    return Lettering(std::move(impl));
}

void Lettering::draw(Image& picture, int x, int baselineY, float heightPx, Rgba8 colour,
                     std::string_view text) const {
    const stbtt_fontinfo& font = impl_->font;
    const float scale = stbtt_ScaleForPixelHeight(&font, heightPx);
    float pen = static_cast<float>(x);
    int before = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        int code = static_cast<unsigned char>(text[k]);
        // Two bytes: C2 or C3, then six bits.
        if ((code == 0xC2 || code == 0xC3) && k + 1 < text.size()) {
            code = (code & 3) << 6 | (static_cast<unsigned char>(text[++k]) & 0x3F);
        }
        if (before != 0) {
            pen += scale * static_cast<float>(stbtt_GetCodepointKernAdvance(&font, before, code));
        }
        before = code;
        const float left = std::floor(pen);
        int width = 0, height = 0, offsetX = 0, offsetY = 0;
        unsigned char* const glyph = stbtt_GetCodepointBitmapSubpixel(
            &font, scale, scale, pen - left, 0.0f, code, &width, &height, &offsetX, &offsetY);
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const int px = static_cast<int>(left) + offsetX + column;
                const int py = baselineY + offsetY + row;
                if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
                const int cover = glyph[row * width + column];
                Rgba8& pixel = picture.at(px, py);
                const auto mixed = [cover](int below, int above) {
                    return static_cast<std::uint8_t>((below * (255 - cover) + above * cover + 127) /
                                                     255);
                };
                pixel = {mixed(pixel.x, colour.x), mixed(pixel.y, colour.y),
                         mixed(pixel.z, colour.z), 255};
            }
        }
        stbtt_FreeBitmap(glyph, nullptr);
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&font, code, &advance, &bearing);
        pen += scale * static_cast<float>(advance);
    }
}

}  // namespace voxprite::sheet
