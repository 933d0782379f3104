// The files of a sheet, and options as they are typed.
#include "core/sheet/sheet_files.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/io/png.h"
#include "core/sheet/sheet_json.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using Numbers = std::vector<double>;
using Frames = std::vector<int>;
using test::must;

TEST(SheetFiles, ArePicturesATurntableAndTheText) {
    const Document document = test::documentOf(test::figure());
    SheetOptions options;
    options.directions = 3;
    options.depths = true;
    const GameProfile profile;
    const Sheet sheet = must(makeSheet(document, profile, options));
    const auto files = must(sheetFiles(sheet, document, profile, options, "out/hut.png",
                                       Turntable{"out/turn.png", 90, 2}));
    ASSERT_EQ(files.size(), 4u);
    EXPECT_EQ(files[0].path, "out/hut.png");
    EXPECT_EQ(must(readPng(files[0].bytes)), sheet.pictures[0].image);
    EXPECT_EQ(files[1].path, "out/hut.depths.png");
    EXPECT_EQ(must(readPng(files[1].bytes)), sheet.pictures[1].image);
    EXPECT_EQ(files[2].path, "out/turn.png");
    // A viewer that knows no animation shows the first view.
    EXPECT_EQ(must(readPng(files[2].bytes)), cellsOf(sheet, sheet.pictures[0], 2)[0]);
    EXPECT_EQ(files[3].path, "out/hut.json");
    EXPECT_EQ(std::string(files[3].bytes.begin(), files[3].bytes.end()),
              sheetJson(sheet, document, profile, options, "hut.png"));
}

TEST(SheetFiles, SayWhatCannotBeWritten) {
    const std::vector<SheetFile> files{{"/nowhere/at/all.png", {1, 2, 3}}};
    const Status written = writeSheetFiles(files);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().describe().find("/nowhere/at/all.png"), std::string::npos);
}

TEST(SheetFiles, NoneIsWrittenWhereOneCannotBe) {
    const test::TemporaryFolder folder;
    const std::vector<SheetFile> files{
        {.path = folder / "hut.png", .bytes = {1, 2, 3}, .asked = true},
        {.path = folder / "missing" / "turn.gif", .bytes = {4, 5}, .asked = true},
        {.path = folder / "hut.json", .bytes = {6}}};
    const Status written = writeSheetFiles(files);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().describe().find("turn.gif"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// None is written over another.
TEST(SheetFiles, HavePathsOfTheirOwn) {
    Document document = test::documentOf(test::figure());
    SheetOptions options;
    options.directions = 1;
    options.normals = true;
    const GameProfile profile;
    const auto errorOf = [&](const std::optional<Turntable>& turntable) -> std::string {
        const Sheet sheet = must(makeSheet(document, profile, options));
        const auto files = sheetFiles(sheet, document, profile, options, "out/hut.png", turntable);
        return files ? "" : files.error().message;
    };
    EXPECT_EQ(errorOf(Turntable{"hut.png"}), "");
    for (const char* path :
         {"out/hut.png", "out/./hut.png", "out/hut.normals.png", "out/hut.json"}) {
        EXPECT_THAT(errorOf(Turntable{path}), testing::HasSubstr("two files of the sheet")) << path;
    }
    document.palette.variants = {{"a/b", {}}, {"a_b", {}}};
    EXPECT_THAT(errorOf({}), testing::HasSubstr("hut.variant-a_b.png"));
}

TEST(SheetFiles, AWholeMinuteAFrameIsNoReasonToFail) {
    Document document = test::documentOf(test::figure());
    document.clips = {Clip{"slow", 0, 0, 0.001, true}};
    SheetOptions options;
    options.directions = 1;
    const GameProfile profile;
    const Sheet sheet = must(makeSheet(document, profile, options));
    for (const char* turntable : {"turn.png", "turn.gif"}) {
        EXPECT_TRUE(sheetFiles(sheet, document, profile, options, "hut.png", Turntable{turntable}));
    }
}

TEST(SheetFiles, SocketsOfOneNameAreNumbered) {
    Document document = test::documentOf(test::figure());
    document.sockets = {Socket{"hand", {{0, {1.0, 0.0, 0.0}}}},
                        Socket{"hand", {{0, {2.0, 0.0, 0.0}}}},
                        Socket{"hand 2", {{0, {3.0, 0.0, 0.0}}}}};
    SheetOptions options;
    options.directions = 1;
    const GameProfile profile;
    const Sheet sheet = must(makeSheet(document, profile, options));
    const auto json =
        nlohmann::json::parse(sheetJson(sheet, document, profile, options, "hut.png"));
    const auto& sockets = json["frames"][0]["voxprite"]["sockets"];
    const auto& placed = sheet.sprites[0].sockets;
    ASSERT_EQ(sockets.size(), 3u);
    EXPECT_EQ(sockets["hand"]["px"][0], placed[0].px.x);
    EXPECT_EQ(sockets["hand 3"]["px"][0], placed[1].px.x);
    EXPECT_EQ(sockets["hand 2"]["px"][0], placed[2].px.x);
}

TEST(SheetFiles, WhatTheyWouldReplaceIsKnownBeforeTheyAreMade) {
    const test::TemporaryFolder folder;
    Document document = test::documentOf(test::figure());
    document.palette.variants.push_back({"night", {}});
    SheetOptions options;
    options.directions = 2;
    options.normals = options.depths = options.indices = true;
    const std::filesystem::path output = folder / "hut.png";
    const Turntable turntable{folder / "turn.gif"};
    const GameProfile profile;
    const auto replaced = [&] {
        return replacedBySheet(document.palette, options, output, turntable);
    };
    EXPECT_TRUE(replaced().empty());
    const Sheet sheet = must(makeSheet(document, profile, options));
    const auto files = must(sheetFiles(sheet, document, profile, options, output, turntable));
    ASSERT_TRUE(writeSheetFiles(files));
    std::vector<std::filesystem::path> written;
    for (const SheetFile& file : files) written.push_back(file.path);
    EXPECT_THAT(replaced(), testing::UnorderedElementsAreArray(written));
    EXPECT_EQ(replaced().back(), output);
    std::filesystem::remove(folder / "hut.depths.png");
    EXPECT_EQ(replaced().size(), files.size() - 1);
}

TEST(SheetFiles, LieBesideEachOtherWhateverVariantsAreCalled) {
    EXPECT_EQ(pictureName("out/hut.png", "normals"), "out/hut.normals.png");
    EXPECT_EQ(pictureName("out/hut.png", "variant-../../night"), "out/hut.variant-.._.._night.png");
}

TEST(SheetFiles, TheTextSaysWhichPicturesAreItsOwn) {
    const Document document = test::documentOf(test::figure());
    SheetOptions options;
    options.directions = 1;
    options.normals = true;
    const Sheet sheet = must(makeSheet(document, {}, options));
    const std::string text = sheetJson(sheet, document, {}, options, "hut.png");
    EXPECT_TRUE(sheetJsonNames(text, "hut.png", "hut.png"));
    EXPECT_TRUE(sheetJsonNames(text, "hut.png", "hut.normals.png"));
    EXPECT_FALSE(sheetJsonNames(text, "hut.png", "hut.depths.png"));
    EXPECT_FALSE(sheetJsonNames(text, "other.png", "hut.normals.png"));
    // What another program wrote for a picture of this name, or no such text at all.
    for (const char* other :
         {R"({"meta": {"app": "https://www.aseprite.org/", "image": "hut.png"}})",
          R"({"meta": {"app": "voxprite", "image": 7}})", R"({"meta": 1})", "[]", "{", ""}) {
        EXPECT_FALSE(sheetJsonNames(other, "hut.png", "hut.png")) << other;
    }
}

TEST(SheetLists, NumbersAreReadAsTyped) {
    EXPECT_EQ(numbersFromList("30"), Numbers{30.0});
    EXPECT_EQ(numbersFromList(" 30, -45.5,60 "), (Numbers{30.0, -45.5, 60.0}));
    for (const char* wrong : {"", "30,", ",", "thirty", "30;60", "1e999", "nan", "30 60"}) {
        EXPECT_FALSE(numbersFromList(wrong)) << wrong;
    }
}

TEST(SheetLists, FramesAreNumbersAndRanges) {
    EXPECT_EQ(framesFromList("0,2,5-9"), (Frames{0, 2, 5, 6, 7, 8, 9}));
    EXPECT_EQ(framesFromList("3 - 4, 1"), (Frames{3, 4, 1}));
    for (const char* wrong : {"", "4-2", "1-2-3", "-1", "0,", "all", "0-99999999", "2.5"}) {
        EXPECT_FALSE(framesFromList(wrong)) << wrong;
    }
}

}  // namespace
}  // namespace voxprite
