#include "core/io/palette_files.h"

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/io/png.h"
#include "tests/support/temporary_folder.h"

namespace voxprite {
namespace {

NamedColour named(int red, int green, int blue, std::string name = {}) {
    return {Rgba8(red, green, blue, 255), std::move(name)};
}

Bytes pngOf(int width, int height, const std::vector<Rgba8>& pixels) {
    Image image(width, height);
    image.pixels = pixels;
    return *writePng(image);
}

template <class T>
std::string whyNot(const Result<T>& result) {
    return result ? "no error" : result.error().describe();
}

TEST(PaletteFiles, AGimpPaletteAsProgramsWriteIt) {
    const auto colours = readGimpPalette(
        "GIMP Palette\r\nName: Sunset\r\nColumns: 4\r\n# made by hand\r\n"
        "255   0  12\tWarm red\r\n\r\n  1   2   3\r\n0 0 0 Untitled\r\n9 8 7 two words ");
    ASSERT_TRUE(colours) << whyNot(colours);
    EXPECT_EQ(*colours, (ColourList{named(255, 0, 12, "Warm red"), named(1, 2, 3), named(0, 0, 0),
                                    named(9, 8, 7, "two words")}));
}

TEST(PaletteFiles, AGimpPaletteWithAlphaAsAsepriteWritesIt) {
    const auto colours =
        readGimpPalette("GIMP Palette\nChannels: RGBA\n#\n255 0 0 128 red wine\n1 2 3 255\n");
    ASSERT_TRUE(colours) << whyNot(colours);
    EXPECT_EQ(*colours, (ColourList{named(255, 0, 0, "red wine"), named(1, 2, 3)}));
    EXPECT_NE(whyNot(readGimpPalette("GIMP Palette\nChannels: RGBA\n1 2 3 red")).find("line 3"),
              std::string::npos);
}

TEST(PaletteFiles, AJascPaletteAsProgramsWriteIt) {
    const auto colours = readJascPalette("JASC-PAL\r\n0100\r\n3\r\n255 0 0\r\n1 2 3 255\r\n9 8 7");
    ASSERT_TRUE(colours) << whyNot(colours);
    EXPECT_EQ(*colours, (ColourList{named(255, 0, 0), named(1, 2, 3), named(9, 8, 7)}));
    // The usual 256: the last one has no place.
    std::string full = "JASC-PAL\n0100\n256\n";
    for (int i = 0; i < 256; ++i) full += std::to_string(i) + " 0 7\n";
    const auto all = readJascPalette(full);
    ASSERT_TRUE(all) << whyNot(all);
    ASSERT_EQ(all->size(), 255u);
    EXPECT_EQ(all->back(), named(254, 0, 7));
}

TEST(PaletteFiles, WhatIsWrittenIsReadBack) {
    const ColourList colours{named(1, 2, 3, "ink"), named(255, 254, 253), named(0, 0, 0, "black"),
                             named(1, 2, 3, "ink again")};
    EXPECT_EQ(*readGimpPalette(writeGimpPalette(colours, "a\nb")), colours);
    ColourList nameless = colours;
    for (NamedColour& each : nameless) each.name.clear();
    EXPECT_EQ(*readJascPalette(writeJascPalette(colours)), nameless);
    EXPECT_EQ(*readPalettePicture(*writePalettePicture(colours)), nameless);
    // Only a picture has places without a colour.
    ColourList gap = nameless;
    gap[1] = {};
    EXPECT_EQ(*readPalettePicture(*writePalettePicture(gap)), gap);
    gap.erase(gap.begin() + 1);
    ColourList withGap = nameless;
    withGap[1] = {};
    EXPECT_EQ(*readJascPalette(writeJascPalette(withGap)), gap);
    EXPECT_EQ(*readGimpPalette(writeGimpPalette(withGap, "x")), gap);
}

TEST(PaletteFiles, PicturesAreAPixelAColourOrLargeSwatches) {
    // MagicaVoxel's 256 x 1: the last pixel stands for no colour.
    std::vector<Rgba8> row;
    for (int i = 0; i < 256; ++i) row.emplace_back(i, 255 - i, 3, 255);
    const auto magica = readPalettePicture(pngOf(256, 1, row));
    ASSERT_TRUE(magica);
    ASSERT_EQ(magica->size(), 255u);
    EXPECT_EQ((*magica)[254], named(254, 1, 3));
    // The same colour twice keeps both places.
    const auto twice = readPalettePicture(
        pngOf(3, 1, {Rgba8(5, 5, 5, 255), Rgba8(5, 5, 5, 255), Rgba8(6, 6, 6, 128)}));
    EXPECT_EQ(*twice, (ColourList{named(5, 5, 5), named(5, 5, 5), named(6, 6, 6)}));
    // Four squares of 8 x 8, no more than 256 pixels; the last as dark as the first.
    std::vector<Rgba8> four;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 32; ++x) four.emplace_back(x / 8 % 3 * 100, 9, 9, 255);
    }
    EXPECT_EQ(*readPalettePicture(pngOf(32, 8, four)),
              (ColourList{named(0, 9, 9), named(100, 9, 9), named(200, 9, 9), named(0, 9, 9)}));
    // A row of pixels over another is no such squares.
    four[0].z = 10;
    EXPECT_EQ(readPalettePicture(pngOf(32, 8, four))->size(), 255u);
    // Swatches of 16 x 16.
    std::vector<Rgba8> swatches;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 48; ++x) {
            swatches.emplace_back(x / 16 * 100, 9, 9, x < 32 ? 255 : 0);
        }
    }
    EXPECT_EQ(*readPalettePicture(pngOf(48, 16, swatches)),
              (ColourList{named(0, 9, 9), named(100, 9, 9)}));
}

TEST(PaletteFiles, ErrorsNameTheLineOrTheReason) {
    const auto gimp = [](std::string_view text) { return whyNot(readGimpPalette(text)); };
    EXPECT_NE(gimp("").find("line 1"), std::string::npos);
    EXPECT_NE(gimp("Gimp palette\n").find("line 1"), std::string::npos);
    EXPECT_NE(gimp("GIMP Palette\n1 2 3\n1 2\n").find("line 3"), std::string::npos);
    EXPECT_NE(gimp("GIMP Palette\n1 2 256\n").find("line 2"), std::string::npos);
    EXPECT_NE(gimp("GIMP Palette\n1 -2 25\n").find("line 2"), std::string::npos);
    EXPECT_NE(gimp("GIMP Palette\n1 2 3x\n").find("line 2"), std::string::npos);
    EXPECT_NE(gimp("GIMP Palette\n# nothing\n").find("no colour"), std::string::npos);
    std::string many = "GIMP Palette\n";
    for (int i = 0; i < 256; ++i) many += "1 2 3\n";
    EXPECT_NE(gimp(many).find("line 257"), std::string::npos);

    const auto jasc = [](std::string_view text) { return whyNot(readJascPalette(text)); };
    EXPECT_NE(jasc("JASC-PAL\n0101\n1\n1 2 3\n").find("line 2"), std::string::npos);
    EXPECT_NE(jasc("JASC-PAL\n0100\nthree\n").find("line 3"), std::string::npos);
    EXPECT_NE(jasc("JASC-PAL\n0100\n2\n1 2 3\n").find("after 1 of 2"), std::string::npos);
    EXPECT_NE(jasc("JASC-PAL\n0100\n1\n1 2 3\n4 5 6\n").find("line 5"), std::string::npos);
    EXPECT_NE(jasc("JASC-PAL\n0100\n1\n1 2 3 4 5\n").find("line 4"), std::string::npos);
    EXPECT_NE(jasc("JASC-PAL\n0100\n0\n").find("no colour"), std::string::npos);
    EXPECT_NE(jasc("JASC-PAL").find("line 1"), std::string::npos);

    EXPECT_NE(whyNot(readPalettePicture(pngOf(2, 2, std::vector<Rgba8>(4)))).find("no opaque"),
              std::string::npos);
    std::vector<Rgba8> colourful;
    for (int i = 0; i < 300; ++i) colourful.emplace_back(i & 255, i >> 8, 0, 255);
    EXPECT_NE(whyNot(readPalettePicture(pngOf(300, 1, colourful))).find("255"), std::string::npos);
    Bytes cut = pngOf(3, 1, std::vector<Rgba8>(3, Rgba8(255)));
    cut.resize(cut.size() / 2);
    EXPECT_NE(whyNot(readPalettePicture(cut)).find("byte"), std::string::npos);
}

// Whatever the text, an answer or an error, and never more than fits.
TEST(PaletteFiles, NoCutOrChangedByteDoesHarm) {
    const ColourList colours{named(1, 2, 3, "ink"), named(255, 254, 253), named(10, 0, 77, "x")};
    for (const std::string& whole : {writeGimpPalette(colours, "n"), writeJascPalette(colours)}) {
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const char byte : {'\0', '\n', '9', '-', 'x', '\xFF'}) {
                std::string text = whole;
                text[at] = byte;
                for (const auto& read : {readGimpPalette(text), readJascPalette(text),
                                         readJascPalette(whole.substr(0, at))}) {
                    EXPECT_LE(read ? read->size() : 0u, 255u);
                }
            }
        }
    }
}

TEST(PaletteFiles, ByTheirEndings) {
    const test::TemporaryFolder folder;
    const ColourList colours{named(7, 6, 5), named(200, 100, 0)};
    for (const char* name : {"a.gpl", "a.pal", "a.PNG"}) {
        ASSERT_TRUE(saveColours(folder / name, colours));
        EXPECT_EQ(*loadColours(folder / name), colours) << name;
    }
    EXPECT_NE(whyNot(loadColours(folder / "a.txt")).find(".gpl"), std::string::npos);
    ASSERT_TRUE(writeFileAtomically(folder / "b.gpl", std::string("GIMP Palette\nblue\n")));
    const auto broken = loadColours(folder / "b.gpl");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().file, (folder / "b.gpl").string());
    EXPECT_EQ(broken.error().line, 2);
    EXPECT_FALSE(loadColours(folder / "none.pal"));
}

}  // namespace
}  // namespace voxprite
