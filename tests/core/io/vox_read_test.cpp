// The reader on small files: models, colours, names and materials.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "tests/support/vox_builder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::put32;
using test::putText;
using test::VoxBuilder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Document read(const VoxBuilder& builder, int version = 200) {
    const Result<VoxImport> import = readVox(builder.bytes(version));
    EXPECT_TRUE(import) << import.error().describe();
    return import ? import->document : Document{};
}

std::vector<std::string> warningsOf(const VoxBuilder& builder) {
    const Result<VoxImport> import = readVox(builder.bytes());
    EXPECT_TRUE(import) << import.error().describe();
    return import ? import->warnings : std::vector<std::string>{"not read"};
}

// The error must name this byte.
void expectRefused(const Bytes& bytes, std::uint64_t offset, const std::string& reason) {
    const Result<VoxImport> import = readVox(bytes);
    ASSERT_FALSE(import);
    EXPECT_EQ(import.error().offset, offset) << import.error().describe();
    EXPECT_THAT(import.error().message, HasSubstr(reason));
}

VoxBuilder tinyModel() {
    VoxBuilder builder;
    builder.model({3, 4, 5}, {{0, 0, 0, 1}, {2, 3, 4, 255}});
    return builder;
}

Bytes grey(std::size_t entries) {
    Bytes colours;
    for (std::size_t i = 0; i < entries; ++i) {
        const auto level = static_cast<std::uint8_t>(i);
        colours.insert(colours.end(), {level, level, level, 255});
    }
    return colours;
}

TEST(VoxRead, VoxelsAreCountedFromThePivot) {
    for (const int version : {150, 200}) {
        const Document document = read(tinyModel(), version);
        ASSERT_EQ(document.models.size(), 1u);
        EXPECT_EQ(document.models[0].canvas, (IBox{{-1, -2, -2}, {2, 2, 3}}));
        EXPECT_EQ(test::mapOf(document.models[0].voxels),
                  (test::VoxelMap{{{-1, -2, -2}, 1}, {{1, 1, 2}, 255}}));
    }
}

TEST(VoxRead, AModelWithoutSceneGraphStandsOnTheGround) {
    VoxBuilder builder;
    builder.chunk("PACK", {2, 0, 0, 0})
        .model({3, 4, 5}, {{0, 0, 0, 1}})
        .model({2, 2, 2}, {{1, 1, 0, 2}});
    const Document document = read(builder);
    // Several models are the frames of one object.
    ASSERT_EQ(document.nodes.size(), 2u);
    ASSERT_EQ(frameCount(document), 2);
    EXPECT_EQ(test::mapOf(flatten(document, 0)), (test::VoxelMap{{{-1, -2, 0}, 1}}));
    EXPECT_EQ(test::mapOf(flatten(document, 1)), (test::VoxelMap{{{0, 0, 0}, 2}}));
    EXPECT_EQ(readVox(*writeVox(document))->document, document);
}

TEST(VoxRead, ALaterVoxelWinsAndColourZeroIsLeftOut) {
    VoxBuilder builder;
    builder.model({1, 1, 2}, {{0, 0, 0, 3}, {0, 0, 0, 4}, {0, 0, 1, 0}});
    const Document document = read(builder);
    EXPECT_EQ(test::mapOf(document.models[0].voxels), (test::VoxelMap{{{0, 0, -1}, 4}}));
    EXPECT_THAT(warningsOf(builder), ElementsAre(HasSubstr("1 voxels have colour 0")));
}

TEST(VoxRead, EmptyModelsAreKept) {
    VoxBuilder builder;
    builder.model({8, 8, 8}, {}).model({0, 0, 0}, {}).model({1, 1, 1}, {{0, 0, 0, 1}});
    const Document document = read(builder);
    ASSERT_EQ(document.models.size(), 3u);
    EXPECT_TRUE(document.models[0].voxels.empty());
    EXPECT_EQ(document.models[0].canvas, (IBox{{-4, -4, -4}, {4, 4, 4}}));
    EXPECT_EQ(document.models[1].canvas, (IBox{{0, 0, 0}, {1, 1, 1}}));
    EXPECT_EQ(document.models[2].voxels.solidCount(), 1u);
}

TEST(VoxRead, SizesBeyondTheOfficialOnesAreReadUpToALimit) {
    VoxBuilder large;
    large.model({300, 1, 1}, {{255, 0, 0, 1}});
    EXPECT_EQ(test::mapOf(read(large).models[0].voxels), (test::VoxelMap{{{105, 0, 0}, 1}}));
    EXPECT_THAT(warningsOf(large), ElementsAre(HasSubstr("larger than MagicaVoxel's 256")));
    VoxBuilder tooLarge;
    tooLarge.model({1, 1, 2049}, {});
    expectRefused(tooLarge.bytes(), 32, "at most 2048");
    VoxBuilder negative;
    negative.model({1, -1, 1}, {});
    expectRefused(negative.bytes(), 32, "1 x -1 x 1");
}

// There are such files, which programs that do not look open as well.
TEST(VoxRead, VoxelsOutsideTheirModelAreLeftOutAndTold) {
    VoxBuilder builder;
    builder.model({2, 2, 2}, {{0, 0, 0, 1}, {0, 2, 0, 1}, {255, 0, 0, 2}, {1, 1, 1, 3}});
    EXPECT_EQ(read(builder).models[0].voxels.solidCount(), 2u);
    EXPECT_THAT(warningsOf(builder), ElementsAre(HasSubstr("model 0: 2 voxels lie outside")));
}

TEST(VoxRead, SizeAndVoxelsBelongTogether) {
    VoxBuilder voxelsFirst;
    voxelsFirst.chunk("XYZI", {0, 0, 0, 0});
    expectRefused(voxelsFirst.bytes(), 32, "no SIZE");
    const Bytes size{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    VoxBuilder twice;
    twice.chunk("SIZE", size).chunk("SIZE", size);
    expectRefused(twice.bytes(), 32, "no XYZI");
    VoxBuilder alone;
    alone.chunk("SIZE", size);
    expectRefused(alone.bytes(), 32, "no XYZI");
}

TEST(VoxRead, RgbaEntryIIsColourIPlusOne) {
    VoxBuilder builder = tinyModel();
    builder.chunk("RGBA", grey(256));
    const Palette palette = read(builder).palette;
    EXPECT_EQ(palette.colours[0], Rgba8(0));
    for (int i = 1; i < 256; ++i) {
        EXPECT_EQ(palette.colours[static_cast<std::size_t>(i)], Rgba8(i - 1, i - 1, i - 1, 255));
    }
}

TEST(VoxRead, AShortPaletteFillsTheColoursThatItHas) {
    VoxBuilder all = tinyModel();
    all.chunk("RGBA", grey(255));  // 1020 bytes
    EXPECT_EQ(read(all).palette.colours[255], Rgba8(254, 254, 254, 255));
    EXPECT_THAT(warningsOf(all), IsEmpty());
    VoxBuilder few = tinyModel();
    few.chunk("RGBA", grey(3));
    const Palette palette = read(few).palette;
    EXPECT_EQ(palette.colours[3], Rgba8(2, 2, 2, 255));
    EXPECT_EQ(palette.colours[4], Palette::standard().colours[4]);
}

TEST(VoxRead, NoPaletteMeansTheDefaultOne) {
    EXPECT_EQ(read(tinyModel()).palette, Palette::standard());
}

// Entry k of IMAP is the colour shown in slot k + 1; indices stay as they are.
TEST(VoxRead, ImapOrdersTheDisplayOnly) {
    Bytes map;
    for (int k = 0; k < 255; ++k) map.push_back(static_cast<std::uint8_t>(255 - k));
    map.push_back(0);
    VoxBuilder builder = tinyModel();
    builder.chunk("RGBA", grey(256)).chunk("IMAP", map);
    const Document document = read(builder);
    VoxBuilder plain = tinyModel();
    plain.chunk("RGBA", grey(256));
    EXPECT_EQ(document.palette.colours, read(plain).palette.colours);
    EXPECT_EQ(document.models, read(plain).models);
    EXPECT_EQ(document.palette.displayOrder[0], 0);
    EXPECT_EQ(document.palette.displayOrder[1], 255);
    EXPECT_EQ(document.palette.displayOrder[255], 1);
}

TEST(VoxRead, TheEmptyColourMayStandAnywhereInTheDisplayOrder) {
    Bytes map;
    for (int k = 0; k < 256; ++k) map.push_back(static_cast<std::uint8_t>(k));
    VoxBuilder builder = tinyModel();
    builder.chunk("IMAP", map);
    EXPECT_EQ(read(builder).palette.displayOrder, Palette::identityOrder());
    EXPECT_TRUE(warningsOf(builder).empty());
}

TEST(VoxRead, ADisplayOrderThatIsNoPermutationIsLeftOut) {
    VoxBuilder builder = tinyModel();
    builder.chunk("IMAP", Bytes(256, 9));
    EXPECT_EQ(read(builder).palette.displayOrder, Palette::identityOrder());
    EXPECT_THAT(warningsOf(builder), ElementsAre(HasSubstr("no permutation")));
}

Bytes notes(const std::vector<std::string>& names) {
    Bytes content;
    put32(content, static_cast<std::int64_t>(names.size()));
    for (const std::string& name : names) putText(content, name);
    return content;
}

// 32 names for rows of eight, the last row first, as files of Teardown's use of them show.
TEST(VoxRead, NotesNameTheRowsOfThePalette) {
    std::vector<std::string> rows(32);
    rows[31] = "glass";
    rows[9] = "hard masonry";
    rows[0] = "reserved";
    VoxBuilder builder = tinyModel();
    builder.chunk("NOTE", notes(rows));
    const Palette palette = read(builder).palette;
    for (std::size_t i = 0; i < 256; ++i) {
        const bool glass = i >= 1 && i <= 8;
        const bool masonry = i >= 177 && i <= 184;
        const bool reserved = i >= 249;
        EXPECT_EQ(palette.names[i], glass      ? "glass"
                                    : masonry  ? "hard masonry"
                                    : reserved ? "reserved"
                                               : "")
            << i;
    }
}

TEST(VoxRead, NotesNameRowsAsTheyAreDisplayed) {
    Bytes map;
    for (int k = 0; k < 256; ++k) map.push_back(static_cast<std::uint8_t>(k + 1));
    std::swap(map[0], map[100]);  // slot 1 shows 101, slot 101 shows 1
    std::vector<std::string> rows(32);
    rows[31] = "first";
    VoxBuilder builder = tinyModel();
    builder.chunk("NOTE", notes(rows)).chunk("IMAP", map);
    const Palette palette = read(builder).palette;
    EXPECT_EQ(palette.names[101], "first");
    EXPECT_EQ(palette.names[2], "first");
    EXPECT_EQ(palette.names[1], "");
}

TEST(VoxRead, MaterialsOfBothKinds) {
    const auto material = [](int id, const Properties& properties) {
        Bytes content;
        put32(content, id);
        test::putProperties(content, properties);
        return content;
    };
    Bytes old;
    put32(old, 5);           // colour
    put32(old, 2);           // glass
    put32(old, 0x3F000000);  // weight 0.5
    put32(old, 0b10001010);  // roughness, index of refraction, total power
    put32(old, 0x3E800000);  // 0.25
    put32(old, 0x3F800000);  // 1
    VoxBuilder builder = tinyModel();
    builder.chunk("MATL", material(9, {{"_type", "_emit"}, {"_own", "kept"}}))
        .chunk("MATL", material(256, {{"_type", "_metal"}}))
        .chunk("MATL", material(300, {}))
        .chunk("MATT", old);
    const Palette palette = read(builder).palette;
    EXPECT_EQ(palette.materials[9], (Properties{{"_type", "_emit"}, {"_own", "kept"}}));
    EXPECT_EQ(palette.materials[0], (Properties{{"_type", "_metal"}}));
    EXPECT_EQ(palette.materials[5], (Properties{{"_type", "_glass"},
                                                {"_weight", "0.5"},
                                                {"_rough", "0.25"},
                                                {"_ior", "1"},
                                                {"_total_power", "1"}}));
    EXPECT_THAT(warningsOf(builder), ElementsAre(HasSubstr("material 300")));
}

TEST(VoxRead, CamerasAndRenderSettingsAreKept) {
    Bytes camera;
    put32(camera, 4);
    test::putProperties(camera, {{"_mode", "pers"}});
    Bytes setting;
    test::putProperties(setting, {{"_type", "_fog"}});
    VoxBuilder builder = tinyModel();
    builder.chunk("rCAM", camera).chunk("rOBJ", setting);
    const Document document = read(builder);
    EXPECT_THAT(document.cameras, ElementsAre(KeptRecord{4, {{"_mode", "pers"}}}));
    EXPECT_THAT(document.renderSettings, ElementsAre(KeptRecord{0, {{"_type", "_fog"}}}));
}

TEST(VoxRead, UnknownChunksAreSkippedWithTheirChildren) {
    VoxBuilder builder;
    builder.chunk("META", {1, 2, 3}, {9, 9, 9, 9, 9})
        .model({1, 1, 1}, {{0, 0, 0, 1}})
        .chunk("what", {})
        .chunk("what", {});
    EXPECT_EQ(read(builder).models[0].voxels.solidCount(), 1u);
    EXPECT_THAT(warningsOf(builder), ElementsAre(HasSubstr("chunk META"), HasSubstr("chunk what")));
}

TEST(VoxRead, TextThatIsNotUtf8IsTakenAsLatin1) {
    VoxBuilder builder = test::oneObject({1, 1, 1}, {});
    builder.layer(0, {{"_name", "caf\xE9"}}).layer(1, {{"_name", "caf\xC3\xA9"}});
    const Document document = read(builder);
    EXPECT_EQ(document.layers[0].name, "caf\xC3\xA9");
    EXPECT_EQ(document.layers[1].name, "caf\xC3\xA9");
}

TEST(VoxRead, OtherFilesAreRefusedWithTheReason) {
    expectRefused({}, 0, "empty");
    expectRefused({'D', 'O', 'O', 'M', 1, 2, 3, 4}, 0, "does not begin with");
    Bytes slab6;
    put32(slab6, 2);
    put32(slab6, 3);
    put32(slab6, 4);
    slab6.resize(slab6.size() + 24 + 768);
    expectRefused(slab6, 0, "Slab6");
    expectRefused(tinyModel().bytes(201), 4, "version 201");
    expectRefused(tinyModel().bytes(-1), 4, "version -1");
    VoxBuilder teardown;
    teardown.chunk("SIZE", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}).chunk("TDCZ", {1, 2, 3});
    expectRefused(teardown.bytes(), 44, "Teardown");
}

TEST(VoxRead, LengthsThatLieAreRefusedWhereTheyStand) {
    Bytes bytes = tinyModel().bytes();
    bytes[24] = 13;  // SIZE: one byte more than it has, from XYZI
    expectRefused(bytes, 45, "claims");
    bytes[24] = 12;
    bytes[27] = 0xFF;  // a negative length
    expectRefused(bytes, 20, "chunk SIZE claims");
    bytes[27] = 0;
    bytes[24] = 11;
    bytes[28] = 1;  // too short for three sizes
    expectRefused(bytes, 40, "ends inside a model's size");
    Bytes main = tinyModel().bytes();
    main[16] = static_cast<std::uint8_t>(main[16] + 1);
    expectRefused(main, 8, "chunk MAIN claims");
    Bytes counted = tinyModel().bytes();
    counted[56] = 3;  // three voxels in a chunk of two
    expectRefused(counted, 56, "XYZI claims 3 entries");
    counted[59] = 0x80;
    expectRefused(counted, 56, "XYZI claims -2147483645 entries");
}

TEST(VoxRead, WhatFollowsTheLastChunkIsNoHarm) {
    Bytes bytes = tinyModel().bytes();
    bytes.push_back(0);
    const Result<VoxImport> import = readVox(bytes);
    ASSERT_TRUE(import);
    EXPECT_THAT(import->warnings, ElementsAre("1 bytes follow after the last chunk"));
}

// Writers that leave MAIN's length at 0, or do not bring it up to date.
TEST(VoxRead, ChunksAfterTheEndOfMainAreRead) {
    const Bytes whole = tinyModel().bytes();
    const Document document = read(tinyModel());
    for (const int length : {0, 24}) {  // before SIZE, before XYZI
        Bytes bytes = whole;
        bytes[16] = static_cast<std::uint8_t>(length);
        const Result<VoxImport> import = readVox(bytes);
        ASSERT_TRUE(import) << import.error().describe();
        EXPECT_EQ(import->document, document);
        EXPECT_THAT(import->warnings, ElementsAre(HasSubstr("chunks go on after them")));
    }
}

TEST(VoxRead, AnEdgeOfNoVoxelsHasRoomForOne) {
    const Document document = read(VoxBuilder().model({0, 2, 2}, {{0, 1, 0, 5}}));
    EXPECT_EQ(document.models[0].canvas.size(), glm::ivec3(1, 2, 2));
    EXPECT_EQ(document.models[0].voxels.solidCount(), 1u);
}

// Single voxels take whole blocks of the grid: many models of a few are refused before they fill
// the memory.
TEST(VoxRead, ScatteredVoxelsAreBounded) {
    VoxBuilder builder;
    for (int i = 0; i < 20'000; ++i) builder.model({1, 1, 1}, {{0, 0, 0, 1}});
    const Result<VoxImport> import = readVox(builder.bytes());
    ASSERT_FALSE(import);
    EXPECT_THAT(import.error().message, HasSubstr("so scattered"));
    EXPECT_TRUE(import.error().offset);
}

TEST(VoxRead, WarningsAreBounded) {
    VoxBuilder builder;
    for (int i = 0; i < 1000; ++i) builder.model({1, 1, 1}, {{0, 0, 0, 0}});
    const std::vector<std::string> warnings = warningsOf(builder);
    EXPECT_LT(warnings.size(), 100u);
    EXPECT_EQ(warnings.back(), "there is more of this kind");
}

}  // namespace
}  // namespace voxprite
