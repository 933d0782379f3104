#include "app/plot/lettering.h"

#include <cmath>
#include <vector>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

// Laid out by app/fonts/embedded_fonts.S.in.
extern "C" {
extern const unsigned char voxprite_font_text[];
extern const unsigned char voxprite_font_bold[];
}

namespace voxprite::plot {

struct Lettering::Impl {
    stbtt_fontinfo font{};
};

namespace {

constexpr int kUnknown = 0xFFFD;

// The code points of a text; what is no UTF-8 becomes the sign for that.
std::vector<int> codesOf(std::string_view text) {
    std::vector<int> codes;
    for (std::size_t k = 0; k < text.size();) {
        const auto first = static_cast<unsigned char>(text[k++]);
        const int more = first < 0x80   ? 0
                         : first < 0xC0 ? -1
                         : first < 0xE0 ? 1
                         : first < 0xF0 ? 2
                                        : 3;
        int code = more <= 0 ? first : first & (0x3F >> more);
        bool valid = more >= 0;
        for (int n = 0; n < more; ++n) {
            valid =
                valid && k < text.size() && (static_cast<unsigned char>(text[k]) & 0xC0) == 0x80;
            if (!valid) break;
            code = code << 6 | (static_cast<unsigned char>(text[k++]) & 0x3F);
        }
        codes.push_back(valid ? code : kUnknown);
    }
    return codes;
}

// Calls glyph(code, pen) for each, and gives where the pen ends.
template <class Glyph>
float layOut(const stbtt_fontinfo& font, float scale, std::string_view text, Glyph glyph) {
    float pen = 0.0f;
    int before = 0;
    for (const int code : codesOf(text)) {
        if (before != 0)
            pen += scale * static_cast<float>(stbtt_GetCodepointKernAdvance(&font, before, code));
        before = code;
        glyph(code, pen);
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&font, code, &advance, &bearing);
        pen += scale * static_cast<float>(advance);
    }
    return pen;
}

}  // namespace

Lettering::Lettering(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Lettering::~Lettering() = default;
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;

Lettering Lettering::regular() {
    auto impl = std::make_unique<Impl>();
    stbtt_InitFont(&impl->font, voxprite_font_text, 0);
    return Lettering(std::move(impl));
}

Lettering Lettering::bold() {
    auto impl = std::make_unique<Impl>();
    stbtt_InitFont(&impl->font, voxprite_font_bold, 0);
    return Lettering(std::move(impl));
}

void Lettering::draw(Image& picture, int x, int baselineY, float heightPx, Rgba8 colour,
                     std::string_view text) const {
    const stbtt_fontinfo& font = impl_->font;
    const float scale = stbtt_ScaleForPixelHeight(&font, heightPx);
    layOut(font, scale, text, [&](int code, float from) {
        const float pen = static_cast<float>(x) + from;
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
    });
}

float Lettering::widthOf(float heightPx, std::string_view text) const {
    const float scale = stbtt_ScaleForPixelHeight(&impl_->font, heightPx);
    return layOut(impl_->font, scale, text, [](int, float) {});
}

}  // namespace voxprite::plot
