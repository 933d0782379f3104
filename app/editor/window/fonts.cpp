#include <ft2build.h>
#include <imgui_freetype.h>
#include FT_FREETYPE_H

#include "app/editor/window/theme.h"

// Laid out by embedded_fonts.S.in.
extern "C" {
extern const unsigned char voxprite_font_text[], voxprite_font_text_end[];
extern const unsigned char voxprite_font_bold[], voxprite_font_bold_end[];
extern const unsigned char voxprite_font_icons[], voxprite_font_icons_end[];
}

namespace voxprite::editor {
namespace {

// Latin, Greek, Cyrillic, punctuation, arrows and the mathematical signs that labels use. ImGui
// keeps the pointer until the atlas is built.
const ImWchar kTextRanges[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF,
                               0x2000, 0x206F, 0x20A0, 0x20CF, 0x2100, 0x214F,
                               0x2190, 0x21FF, 0x2200, 0x22FF, 0};
// Those of icons.h alone: the font has 1,800, and each would be drawn in four sizes.
const ImWchar kIconRanges[] = {
#include "icon_ranges.inc"
    0};

ImFont* add(const unsigned char* begin, const unsigned char* end, float sizePx,
            const ImWchar* ranges, ImFontConfig config) {
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    // The atlas only reads the data; its interface is older than const.
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(
        const_cast<unsigned char*>(begin), static_cast<int>(end - begin), sizePx, &config, ranges);
}

// The rasteriser rounds every advance up, which spaces text too wide: set them to the nearest.
void correctAdvances(ImFont& font, const unsigned char* begin, const unsigned char* end) {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    if (FT_Init_FreeType(&library) != 0) return;
    if (FT_New_Memory_Face(library, begin, end - begin, 0, &face) == 0) {
        FT_Size_RequestRec size{};
        size.type = FT_SIZE_REQUEST_TYPE_REAL_DIM;
        size.height = static_cast<FT_Long>(font.FontSize * 64.0f);
        FT_Request_Size(face, &size);
        for (ImFontGlyph& glyph : font.Glyphs) {
            const FT_UInt index = FT_Get_Char_Index(face, glyph.Codepoint);
            if (index == 0 || FT_Load_Glyph(face, index, FT_LOAD_NO_HINTING) != 0) continue;
            const auto advance = static_cast<float>(face->glyph->linearHoriAdvance) / 65536.0f;
            glyph.AdvanceX = std::round(advance);
        }
        font.BuildLookupTable();
        FT_Done_Face(face);
    }
    FT_Done_FreeType(library);
}

void mergeIcons(float sizePx) {
    ImFontConfig config;
    config.MergeMode = true;
    config.GlyphMinAdvanceX = sizePx;
    config.GlyphOffset.y = std::round(sizePx * 0.06f);
    add(voxprite_font_icons, voxprite_font_icons_end, sizePx, kIconRanges, config);
}

}  // namespace

Fonts buildFonts(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;

    Fonts fonts;
    const float textPx = std::round(16.0f * scale);
    fonts.text = add(voxprite_font_text, voxprite_font_text_end, textPx, kTextRanges, {});
    mergeIcons(textPx);
    const float smallPx = std::round(14.0f * scale);
    fonts.small = add(voxprite_font_text, voxprite_font_text_end, smallPx, kTextRanges, {});
    mergeIcons(smallPx);
    fonts.bold = add(voxprite_font_bold, voxprite_font_bold_end, textPx, kTextRanges, {});
    mergeIcons(textPx);
    fonts.icons = add(voxprite_font_icons, voxprite_font_icons_end, std::round(22.0f * scale),
                      kIconRanges, {});
    atlas.Build();
    correctAdvances(*fonts.text, voxprite_font_text, voxprite_font_text_end);
    correctAdvances(*fonts.small, voxprite_font_text, voxprite_font_text_end);
    correctAdvances(*fonts.bold, voxprite_font_bold, voxprite_font_bold_end);
    return fonts;
}

}  // namespace voxprite::editor
