#include "core/io/slices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/io/png_text.h"
#include "core/model/entity_voxels.h"
#include "tests/support/must.h"
#include "tests/support/png_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::handmadePng;
using test::must;
using testing::Contains;
using testing::HasSubstr;

using ColourMap = std::map<std::tuple<int, int, int>, std::array<int, 4>>;

ColourMap coloursOf(const Document& document) {
    ColourMap map;
    flatten(document, 0).forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        const Rgba8 c = document.palette.colours[value];
        map[{v.x, v.y, v.z}] = {c.x, c.y, c.z, c.w};
    });
    return map;
}

constexpr std::array<int, 4> kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 128};

// Two wide and four high: red above left; green right of it, below it a row of nothing; then blue
// below right. As squares: two layers, the lower one at the top.
Bytes twoLayers() {
    return handmadePng(2, 4, 8, 6, {0, 255, 0, 0, 255, 0, 255, 0,   255,  //
                                    0, 0,   0, 0, 0,   9, 9,   9,   0,    //
                                    0, 0,   0, 0, 0,   0, 0,   0,   0,    //
                                    0, 0,   0, 0, 0,   0, 0,   255, 128});
}

void write(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

TEST(Slices, AStripIsSquaresOneBelowTheOther) {
    const SlicesImport import = must(readStrip(twoLayers()));
    EXPECT_EQ(coloursOf(import.document),
              (ColourMap{{{0, 1, 0}, kRed}, {{1, 1, 0}, kGreen}, {{1, 0, 1}, kBlue}}));
    EXPECT_THAT(import.warnings, Contains(HasSubstr("taken as 2 of 2 x 2")));
    // Indices in the order of reading.
    EXPECT_EQ(import.document.palette.colours[1], Rgba8(255, 0, 0, 255));
    EXPECT_EQ(import.document.palette.colours[3], Rgba8(0, 0, 255, 128));
}

TEST(Slices, TheRowsOfALayerCanBeTold) {
    EXPECT_EQ(coloursOf(must(readStrip(twoLayers(), {.layerRows = 1})).document),
              (ColourMap{{{0, 0, 0}, kRed}, {{1, 0, 0}, kGreen}, {{1, 0, 3}, kBlue}}));
    EXPECT_EQ(must(readStrip(twoLayers(), {.layerRows = 4})).document.models[0].canvas.size(),
              glm::ivec3(2, 4, 1));
    EXPECT_THAT(readStrip(twoLayers(), {.layerRows = 3}).error().message,
                HasSubstr("4 rows cannot be divided into layers of 3"));
    const SlicesImport odd = must(readStrip(handmadePng(2, 1, 8, 2, {0, 1, 2, 3, 4, 5, 6})));
    EXPECT_THAT(odd.warnings, Contains(HasSubstr("taken as 1 of 2 x 1")));
    EXPECT_EQ(odd.document.models[0].voxels.solidCount(), 2u);
}

TEST(Slices, OurOwnTextWins) {
    const Bytes told = withPngText(twoLayers(), "voxprite layers", "4 at -3 5 7");
    const SlicesImport import = must(readStrip(told, {.layerRows = 2}));
    EXPECT_TRUE(import.warnings.empty());
    EXPECT_EQ(coloursOf(import.document),
              (ColourMap{{{-3, 5, 7}, kRed}, {{-2, 5, 7}, kGreen}, {{-2, 5, 10}, kBlue}}));
    for (const char* wrong : {"3 at 0 0 0", "0 at 0 0 0", "-1 at 0 0 0"}) {
        EXPECT_FALSE(readStrip(withPngText(twoLayers(), "voxprite layers", wrong))) << wrong;
    }
    for (const char* odd : {"2", "2 at 0 0", "2 at 0 0 99999999", "2 at 0 0 0 0", ""}) {
        const auto read = readStrip(withPngText(twoLayers(), "voxprite layers", odd));
        ASSERT_TRUE(read) << odd;
        EXPECT_EQ(read->warnings.size(), 1u) << odd;
    }
}

TEST(Slices, IndexedPicturesAreReadAsWell) {
    const Bytes png = handmadePng(2, 1, 8, 3, {0, 1, 0}, {9, 9, 9, 10, 20, 30}, {0});
    EXPECT_EQ(coloursOf(must(readStrip(png)).document),
              (ColourMap{{{0, 0, 0}, {10, 20, 30, 255}}}));
}

TEST(Slices, AStackIsAFileALayer) {
    const test::TemporaryFolder folder;
    const auto pixel = [](std::uint8_t red) {
        return handmadePng(1, 1, 8, 6, {0, red, 0, 0, 255});
    };
    const ColourMap expected{
        {{0, 0, 0}, {8, 0, 0, 255}}, {{0, 0, 1}, {9, 0, 0, 255}}, {{0, 0, 2}, {10, 0, 0, 255}}};
    // Numbers count, and not how the names sort.
    write(folder / "hut8.png", pixel(8));
    write(folder / "hut9.png", pixel(9));
    write(folder / "hut10.PNG", pixel(10));
    for (const char* any : {"hut8.png", "hut9.png"}) {
        EXPECT_EQ(coloursOf(must(readSlices(folder / any)).document), expected) << any;
    }
    EXPECT_EQ(coloursOf(must(loadDocument(folder.path())).document), expected);
    EXPECT_EQ(must(loadDocument(folder.path())).format, Format::png);

    write(folder / "other_000.png", pixel(1));
    EXPECT_EQ(must(readSlices(folder / "other_000.png")).document.models[0].voxels.solidCount(),
              1u);
    EXPECT_THAT(readSlices(folder.path()).error().message, HasSubstr("several names"));
    write(folder / "other_002.png", pixel(1));
    EXPECT_THAT(readSlices(folder / "other_000.png").error().describe(),
                HasSubstr("other_002.png: the layer before it is missing, number 1"));
    write(folder / "other_001.png", handmadePng(2, 1, 8, 0, {0, 1, 2}));
    EXPECT_THAT(readSlices(folder / "other_000.png").error().describe(),
                HasSubstr("other_001.png: has another size"));
    write(folder / "picture.png", pixel(1));
    EXPECT_THAT(readSlices(folder.path()).error().message, HasSubstr("no numbered layer"));
}

TEST(Slices, PicturesBesideAStackAreNoMatterOfIt) {
    const test::TemporaryFolder folder;
    const auto box = [](int height) { return test::documentOf(test::solidBox({1, 1, height})); };
    ASSERT_TRUE(saveDocument(folder / "hut_000.png", box(4), GameProfile{}));
    for (const char* icon : {"icon1.png", "icon01.png"}) {
        write(folder / icon, handmadePng(1, 1, 8, 0, {1}));
    }
    EXPECT_EQ(must(readSlices(folder / "hut_000.png")).document.models[0].voxels.solidCount(), 4u);
    EXPECT_THAT(saveDocument(folder / "hut_000.png", box(3), GameProfile{}).error().describe(),
                HasSubstr("of another stack"));
    // The same number twice counts where it is part of the stack.
    write(folder / "hut_0001.png", handmadePng(1, 1, 8, 0, {1}));
    EXPECT_THAT(readSlices(folder / "hut_000.png").error().describe(),
                HasSubstr("has the same number as hut_0"));
    EXPECT_THAT(saveDocument(folder / "hut_000.png", box(4), GameProfile{}).error().describe(),
                HasSubstr("has the same number as hut_0"));
}

TEST(Slices, AStackThatLacksItsTopIsTold) {
    const test::TemporaryFolder folder;
    for (const SlicePicture& picture :
         must(writeSlices(test::documentOf(test::figure()), "a_000.png"))) {
        write(folder / picture.name, picture.png);
    }
    EXPECT_TRUE(must(readSlices(folder.path())).warnings.empty());
    std::filesystem::path last;
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
        last = std::max(last, file.path());
    }
    std::filesystem::remove(last);
    EXPECT_THAT(must(readSlices(folder.path())).warnings,
                testing::ElementsAre(testing::HasSubstr("were written as")));
}

TEST(Slices, AnEmptyFolderIsNoModel) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(loadDocument(folder.path()).error().describe(), HasSubstr("no .png"));
    EXPECT_FALSE(loadDocument(folder / "none.png"));
    EXPECT_FALSE(loadDocument(folder / "none_000.png"));
}

// What the pictures look like, told apart from the reader.
TEST(Slices, AreWrittenFromAboveTheLowestFirst) {
    Document document = Document::withEmptyModel();
    document.models[0].voxels.set({4, 5, 6}, 1);
    document.models[0].voxels.set({5, 6, 7}, 2);
    document.palette.colours[1] = Rgba8(1, 2, 3, 255);
    document.palette.colours[2] = Rgba8(4, 5, 6, 77);
    const auto strip = must(writeSlices(document, "a.png"));
    ASSERT_EQ(strip.size(), 1u);
    const Image image = must(readPng(strip[0].png));
    ASSERT_EQ(image.width, 2);
    ASSERT_EQ(image.height, 4);
    Image expected(2, 4);
    expected.at(0, 1) = Rgba8(1, 2, 3, 255);
    expected.at(1, 2) = Rgba8(4, 5, 6, 77);
    EXPECT_EQ(image, expected);
    EXPECT_EQ(pngText(strip[0].png, "voxprite layers"), "2 at 4 5 6");

    const auto stack = must(writeSlices(document, "a_099.png"));
    ASSERT_EQ(stack.size(), 2u);
    EXPECT_EQ(stack[0].name, "a_100.png");
    EXPECT_EQ(stack[1].name, "a_099.png");
    EXPECT_EQ(must(readPng(stack[1].png)).at(0, 1), Rgba8(1, 2, 3, 255));
    EXPECT_EQ(must(readPng(stack[0].png)).at(1, 0), Rgba8(4, 5, 6, 77));
}

TEST(Slices, RoundTripsAreExactEitherWay) {
    const test::TemporaryFolder folder;
    Document document = test::busyDocument();
    for (const char* name : {"a.png", "a_000.png", "b2.png"}) {
        const std::filesystem::path path = folder / name;
        ASSERT_TRUE(saveDocument(path, document, GameProfile{})) << name;
        const LoadedDocument once = must(loadDocument(path));
        EXPECT_TRUE(once.warnings.empty()) << name;
        EXPECT_EQ(coloursOf(once.document), coloursOf(document)) << name;
        ASSERT_TRUE(saveDocument(path, once.document, GameProfile{}));
        EXPECT_EQ(must(loadDocument(path)).document, once.document) << name;
    }
}

TEST(Slices, NoVoxelVanishesBecauseItsColourIsTransparent) {
    Document document = test::documentOf(test::solidBox({1, 1, 1}, 5));
    document.palette.colours[5] = Rgba8(1, 2, 3, 0);
    EXPECT_THAT(lossesOf(document, Format::png), Contains(HasSubstr("1 colour becomes opaque")));
    const auto pictures = must(writeSlices(document, "a.png"));
    EXPECT_EQ(must(readPng(pictures[0].png)).at(0, 0), Rgba8(1, 2, 3, 255));
}

TEST(Slices, AStackIsNotWrittenInFrontOfAnother) {
    const test::TemporaryFolder folder;
    const auto box = [](int height) { return test::documentOf(test::solidBox({1, 1, height})); };
    ASSERT_TRUE(saveDocument(folder / "a_000.png", box(4), GameProfile{}));
    EXPECT_TRUE(saveDocument(folder / "a_000.png", box(4), GameProfile{}));
    const Status smaller = saveDocument(folder / "a_000.png", box(3), GameProfile{});
    ASSERT_FALSE(smaller);
    EXPECT_THAT(smaller.error().describe(), HasSubstr("a_003.png: is of another stack"));
    EXPECT_EQ(must(loadDocument(folder / "a_000.png")).document.models[0].voxels.solidCount(), 4u);
}

TEST(Slices, WhatIsTooLargeForAPictureIsRefusedWithAWayOut) {
    Document document = Document::withEmptyModel();
    document.models[0].voxels.fill({{0, 0, 0}, {1, 200, 200}}, 1);
    EXPECT_THAT(writeSlices(document, "a.png").error().message, HasSubstr("hut_000.png"));
    EXPECT_EQ(must(writeSlices(document, "a_000.png")).size(), 200u);
}

TEST(SlicesDamage, EveryCutAndEveryFlippedByteEndsInAnErrorOrADocument) {
    const Bytes whole = withPngText(twoLayers(), "voxprite layers", "2 at 1 2 3");
    ASSERT_TRUE(readStrip(whole));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_FALSE(readStrip(ByteView(whole).first(length))) << length;
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const int mask : {0x01, 0x02, 0x10, 0x40, 0x80, 0xFF}) {
            Bytes flipped = whole;
            flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ mask);
            const auto read = readStrip(flipped);
            EXPECT_TRUE(!read || validate(read->document)) << at;
        }
    }
}

// Past the checksums: texts and pixels that were made so.
TEST(SlicesDamage, EveryTextEndsInAnErrorOrADocument) {
    const std::string text = "2 at 1 2 3";
    for (std::size_t at = 0; at < text.size(); ++at) {
        for (int byte = 1; byte < 256; ++byte) {
            std::string changed = text;
            changed[at] = static_cast<char>(byte);
            const auto read = readStrip(withPngText(twoLayers(), "voxprite layers", changed));
            EXPECT_TRUE(!read || validate(read->document)) << changed;
        }
    }
}

}  // namespace
}  // namespace voxprite
