#include "core/io/qb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/support/must.h"
#include "tests/support/qb_builder.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
using test::QbBuilder;
using test::rgba;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint32_t kRed = rgba(255, 0, 0);
constexpr std::uint32_t kGreen = rgba(0, 255, 0);
constexpr std::uint32_t kBlue = rgba(0, 0, 255);

using ColourMap = std::map<std::tuple<int, int, int>, std::uint32_t>;

// What is seen, by position and colour.
ColourMap coloursOf(const Document& document) {
    ColourMap map;
    flatten(document, 0).forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        const Rgba8 c = document.palette.colours[value];
        map[{v.x, v.y, v.z}] = rgba(c.x, c.y, c.z, c.w);
    });
    return map;
}

// The file's x, y, z run right, up and away: ours are right, away, up.
TEST(Qb, CellsLieAsQubicleHasThem) {
    // Two wide, one high, three deep; slice after slice.
    const QbBuilder builder =
        QbBuilder().matrix("a", {2, 1, 3}, {10, 20, 30}, {kRed, 0, 0, kGreen, 0, kBlue});
    const Document document = must(readQb(builder.bytes())).document;
    EXPECT_EQ(coloursOf(document),
              (ColourMap{{{10, 30, 20}, kRed}, {{11, 31, 20}, kGreen}, {{11, 32, 20}, kBlue}}));
    ASSERT_EQ(document.nodes.size(), 2u);
    EXPECT_EQ(document.nodes[1].name, "a");
    EXPECT_EQ(document.models[0].canvas.max - document.models[0].canvas.min, glm::ivec3(2, 3, 1));
}

TEST(Qb, RightHandedFilesHaveZTowardTheViewer) {
    const QbBuilder builder =
        QbBuilder({.rightHanded = 1}).matrix("a", {1, 2, 2}, {1, 2, 3}, {kRed, 0, 0, kGreen});
    // Cells z = 3 and z = 4 are -4 and -5.
    EXPECT_EQ(coloursOf(must(readQb(builder.bytes())).document),
              (ColourMap{{{1, -4, 2}, kRed}, {{1, -5, 3}, kGreen}}));
}

TEST(Qb, BlueMayComeFirst) {
    const QbBuilder builder =
        QbBuilder({.blueFirst = 1}).matrix("", {1, 1, 1}, {0, 0, 0}, {rgba(1, 2, 3)});
    EXPECT_EQ(coloursOf(must(readQb(builder.bytes())).document),
              (ColourMap{{{0, 0, 0}, rgba(3, 2, 1)}}));
}

TEST(Qb, RunsFillSlicesInRowsAndMayEndEarly) {
    const QbBuilder builder =
        QbBuilder({.runs = 1})
            .matrix("", {3, 2, 3}, {0, 0, 0},
                    {2, 4, kRed, kGreen, 6,  // a row and a cell of red, then one green
                     6,                      // nothing
                     2, 5, 0, kBlue, 6});
    EXPECT_EQ(coloursOf(must(readQb(builder.bytes())).document), (ColourMap{{{0, 0, 0}, kRed},
                                                                            {{1, 0, 0}, kRed},
                                                                            {{2, 0, 0}, kRed},
                                                                            {{0, 0, 1}, kRed},
                                                                            {{1, 0, 1}, kGreen},
                                                                            {{2, 2, 1}, kBlue}}));
}

TEST(Qb, WithAMaskAnyFaceMakesAVoxel) {
    const QbBuilder builder = QbBuilder({.mask = 1})
                                  .matrix("", {3, 1, 1}, {0, 0, 0},
                                          {rgba(9, 9, 9, 2), rgba(9, 9, 9, 0), rgba(9, 9, 9, 126)});
    EXPECT_EQ(coloursOf(must(readQb(builder.bytes())).document),
              (ColourMap{{{0, 0, 0}, rgba(9, 9, 9)}, {{2, 0, 0}, rgba(9, 9, 9)}}));
}

TEST(Qb, MatricesAreObjectsAndLaterOnesWin) {
    const QbBuilder builder = QbBuilder()
                                  .matrix("first", {1, 1, 1}, {5, 0, -2}, {kRed})
                                  .matrix("m\xFCsli", {2, 1, 1}, {5, 0, -2}, {kGreen, kBlue});
    const QbImport import = must(readQb(builder.bytes()));
    EXPECT_TRUE(import.warnings.empty());
    ASSERT_EQ(import.document.nodes.size(), 3u);
    EXPECT_EQ(import.document.nodes[2].name, "müsli");
    EXPECT_EQ(coloursOf(import.document), (ColourMap{{{5, -2, 0}, kGreen}, {{6, -2, 0}, kBlue}}));
}

TEST(Qb, MoreColoursThanAPaletteAreReducedAndThatIsSaid) {
    std::vector<std::uint32_t> colours;
    for (std::uint32_t k = 0; k < 400; ++k) colours.push_back(rgba(k % 256, k / 2, 7 * k % 256));
    const QbImport import =
        must(readQb(QbBuilder().matrix("", {400, 1, 1}, {0, 0, 0}, colours).bytes()));
    ASSERT_EQ(import.warnings.size(), 1u);
    EXPECT_THAT(import.warnings[0], HasSubstr("400 colours are reduced to"));
    EXPECT_EQ(import.document.models[0].voxels.solidCount(), 400u);
}

TEST(Qb, MatricesAtTheRangesEdgeAreReadAndWritten) {
    using Size = std::array<std::uint32_t, 3>;
    using Position = std::array<std::int32_t, 3>;
    const int edge = kMaxCoordinate;
    for (const auto& [size, position] :
         {std::pair(Size{3, 1, 1}, Position{-edge, 0, 0}),
          std::pair(Size{1, 3, 1}, Position{0, edge - 3, 0}),
          // Far out along one axis, long along another.
          std::pair(Size{1, 4000, 1}, Position{edge - 1, -2000, 0})}) {
        const std::vector<std::uint32_t> cells(std::size_t{size[0]} * size[1], kRed);
        const QbBuilder builder = QbBuilder().matrix("", size, position, cells);
        const Document document = must(readQb(builder.bytes())).document;
        const glm::ivec3 corner(position[0], position[2], position[1]);
        EXPECT_EQ(flatten(document, 0).bounds(),
                  (IBox{corner, corner + glm::ivec3(size[0], size[2], size[1])}));
        EXPECT_EQ(coloursOf(must(readQb(must(writeQb(document)))).document), coloursOf(document));
    }
}

// Goxel announces its empty layers and leaves them out; VoxelShop writes them without a size, at
// the lowest place that there is of nothing.
TEST(Qb, EmptyLayersOfOtherProgramsAreRead) {
    const std::int32_t nowhere = std::numeric_limits<std::int32_t>::max();
    const QbBuilder builder = QbBuilder()
                                  .matrix("none", {0, 0, 0}, {nowhere, nowhere, nowhere}, {})
                                  .matrix("one", {1, 1, 1}, {4, 5, 6}, {kRed});
    const QbImport import = must(readQb(builder.bytes(4)));
    EXPECT_THAT(import.warnings,
                ElementsAre(HasSubstr("announces 4 matrices and ends after 2"),
                            HasSubstr("without size are read as empty objects: 1")));
    ASSERT_EQ(import.document.nodes.size(), 3u);
    EXPECT_EQ(import.document.nodes[1].name, "none");
    EXPECT_EQ(coloursOf(import.document), (ColourMap{{{4, 6, 5}, kRed}}));
}

TEST(Qb, WhatIsWrongIsSaidWithItsPlace) {
    const auto errorOf = [](const Bytes& bytes) { return readQb(bytes).error().describe(); };
    EXPECT_THAT(errorOf({}), HasSubstr("byte 0: the file ends inside the version"));
    EXPECT_THAT(errorOf(QbBuilder({.version = 0x0102}).bytes()), HasSubstr("version 2.1"));
    EXPECT_THAT(errorOf(QbBuilder({.blueFirst = 2}).bytes()),
                HasSubstr("byte 4: the colour format is 2"));
    EXPECT_THAT(errorOf(QbBuilder({.mask = 9}).bytes()), HasSubstr("byte 16"));
    EXPECT_THAT(errorOf(QbBuilder().matrix("m", {1, 1, 1}, {0, 1 << 25, 0}, {kRed}).bytes()),
                HasSubstr("outside the range"));
    EXPECT_THAT(errorOf(QbBuilder({.runs = 1})
                            .matrix("m", {2, 2, 1}, {0, 0, 0}, {kRed, 2, 4, kRed, 6})
                            .bytes()),
                HasSubstr("byte 54: the voxels go beyond slice 0 of 2 x 2 cells"));
    Bytes cut = QbBuilder().matrix("m", {1, 1, 1}, {0, 0, 0}, {kRed}).bytes(2);
    cut.push_back(3);
    EXPECT_THAT(errorOf(cut), HasSubstr("the file ends inside the name of a matrix"));
    EXPECT_THAT(errorOf(QbBuilder().bytes(1)), HasSubstr("the file ends inside the name"));
    const QbImport none = must(readQb(QbBuilder().bytes()));
    EXPECT_EQ(none.warnings.size(), 1u);
    EXPECT_EQ(none.document.models.size(), 1u);
}

TEST(Qb, FewBytesCannotAskForMuchMemory) {
    // One run over a plane of 2^31 cells.
    const Bytes bytes = QbBuilder({.runs = 1})
                            .matrix("m", {1 << 16, 1 << 15, 1}, {0, 0, 0}, {2, 1u << 31, kRed, 6})
                            .bytes();
    EXPECT_THAT(readQb(bytes).error().describe(), HasSubstr("memory"));
    // Sizes alone cost nothing.
    const Bytes wide =
        QbBuilder({.runs = 1})
            .matrix("m", {1 << 23, 1 << 23, 1}, {0, 0, 0}, {2, 0xFFFF'FFFFu, 0, kRed, 6})
            .bytes();
    EXPECT_EQ(must(readQb(wide)).document.models[0].voxels.solidCount(), 1u);
}

// Byte by byte what the format's description asks for.
TEST(Qb, WritesWhatTheFormatSays) {
    Document document = Document::withEmptyModel();
    document.nodes[1].name = "wall";
    for (int x = 0; x < 5; ++x) document.models[0].voxels.set({x, 0, 0}, 1);
    document.models[0].voxels.set({0, 1, 2}, 2);
    document.palette.colours[1] = Rgba8(1, 2, 3, 255);
    document.palette.colours[2] = Rgba8(4, 5, 6, 255);
    document.nodes[1].placements[0].placement.translation = {100, -7, 3};
    const Bytes expected = QbBuilder({.runs = 1})
                               .matrix("wall", {5, 3, 2}, {100, 3, -7},
                                       {2, 5, rgba(1, 2, 3), 6, 2, 10, 0, rgba(4, 5, 6), 6})
                               .bytes();
    EXPECT_EQ(must(writeQb(document)), expected);
}

TEST(Qb, ObjectsAreWrittenAsTheyStand) {
    const Document busy = test::busyDocument();
    const Document read = must(readQb(must(writeQb(busy)))).document;
    ColourMap expected = coloursOf(busy);
    for (auto& [place, colour] : expected) colour |= 0xFF00'0000u;
    EXPECT_EQ(coloursOf(read), expected);
    std::vector<std::string> names, readNames;
    for (const Instance& i : instancesOf(busy, 0)) {
        names.push_back(busy.nodes[static_cast<std::size_t>(i.node)].name);
    }
    for (const Instance& i : instancesOf(read, 0)) {
        readNames.push_back(read.nodes[static_cast<std::size_t>(i.node)].name);
    }
    EXPECT_EQ(readNames, names);
    // What was read is written as it was.
    EXPECT_EQ(must(writeQb(read)), must(writeQb(busy)));
}

TEST(Qb, LongNamesAreCutBetweenCharactersAndThatIsSaid) {
    Document document = test::documentOf(test::solidBox({1, 1, 1}));
    document.nodes[1].name = std::string(254, 'a') + "ü";
    EXPECT_THAT(lossesOf(document, Format::qb), testing::Contains(HasSubstr("1 cut off")));
    EXPECT_EQ(must(readQb(must(writeQb(document)))).document.nodes[1].name, std::string(254, 'a'));
}

// Every kind of file in one, for the tests of damage: with and without runs.
Bytes wholeFile(std::uint32_t runs) {
    std::vector<std::uint32_t> first{kRed, 0, kGreen, 0, 0, 0, kBlue, kBlue};
    if (runs == 1) first = {2, 3, kRed, 6, 2, 2, 0, kGreen, 6};
    std::vector<std::uint32_t> second{kRed};
    if (runs == 1) second.push_back(6);
    return QbBuilder({.runs = runs})
        .matrix("hut", {2, 2, 2}, {-1, 2, 3}, first)
        .matrix("", {1, 1, 1}, {0, 0, 0}, second)
        .bytes();
}

void expectErrorOrDocument(const Bytes& bytes) {
    const Result<QbImport> import = readQb(bytes);
    if (!import) {
        EXPECT_FALSE(import.error().message.empty());
        if (import.error().offset) {
            EXPECT_LE(*import.error().offset, bytes.size());
        }
        return;
    }
    const Status valid = validate(import->document);
    EXPECT_TRUE(valid) << valid.error().describe();
}

TEST(QbDamage, EveryTruncationIsRefusedOrTold) {
    for (const std::uint32_t runs : {0u, 1u}) {
        const Bytes whole = wholeFile(runs);
        ASSERT_TRUE(readQb(whole));
        int told = 0;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
            const Result<QbImport> import = readQb(cut);
            if (import) {
                EXPECT_THAT(import->warnings,
                            ElementsAre(HasSubstr("2 matrices and ends after 1")));
                ++told;
            } else {
                EXPECT_LE(import.error().offset.value(), length);
            }
        }
        EXPECT_EQ(told, 1);  // between the two
    }
}

TEST(QbDamage, EveryFlippedByteEndsInAnErrorOrADocument) {
    for (const std::uint32_t runs : {0u, 1u}) {
        const Bytes whole = wholeFile(runs);
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const int mask : {0x01, 0x02, 0x10, 0x40, 0x80, 0xFF}) {
                Bytes flipped = whole;
                flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ mask);
                expectErrorOrDocument(flipped);
            }
        }
    }
}

TEST(QbDamage, RandomNumbersInRandomPlacesEndInAnErrorOrADocument) {
    test::Random random(7);
    constexpr std::uint32_t kOdd[] = {
        0, 1, 2, 3, 6, 64, 0xFFFF, 0x7FFF'FFFFu, 0x8000'0000u, 0xFFFF'FFFFu};
    for (int round = 0; round < 3000; ++round) {
        Bytes changed = wholeFile(static_cast<std::uint32_t>(round % 2));
        for (int change = random.between(1, 3); change > 0; --change) {
            const auto at =
                static_cast<std::size_t>(random.between(20, static_cast<int>(changed.size()) - 4));
            const std::uint32_t number = kOdd[random.between(0, 9)];
            for (std::size_t k = 0; k < 4; ++k) {
                changed[at + k] = static_cast<std::uint8_t>(number >> 8 * k);
            }
        }
        expectErrorOrDocument(changed);
    }
}

}  // namespace
}  // namespace voxprite
