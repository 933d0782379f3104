// Texts that are none: each error with its exact place; damaged texts, and texts made to cost much,
// end in an error or a document.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/csm_reader.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using testing::HasSubstr;

ByteView bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void expectRefused(const std::string& text, int line, int column, const std::string& reason) {
    const Result<Octree> octree = octreeFromCsm(bytesOf(text));
    ASSERT_FALSE(octree) << text;
    const Error& error = octree.error();
    EXPECT_EQ(std::pair(error.line.value_or(0), error.column.value_or(0)), std::pair(line, column))
        << text << ": " << error.describe();
    EXPECT_THAT(error.message, HasSubstr(reason)) << text;
}

TEST(CsmErrors, StatementsBeginWithTheirMark) {
    expectRefused("5", 1, 1, "expected '>' or '|', found '5'");
    expectRefused(">a 1\n  b 2", 2, 3, "found 'b'");
    expectRefused(">a 12x", 1, 6, "found 'x'");
    expectRefused(">a = 5", 1, 4, "expected a cube, found '='");
    expectRefused("# fine\r\n>a 1 \x80", 2, 6, "the byte 0x80");
    expectRefused(std::string(">a 1\0", 5), 1, 5, "the byte 0x00");
    expectRefused("\xEF\xBB\xBF]", 1, 1, "found ']'");
}

TEST(CsmErrors, CubesAreMissing) {
    expectRefused(">", 1, 2, "expected a cube, but the text ends");
    expectRefused(">a", 1, 3, "the text ends");
    expectRefused(">a \n", 2, 1, "the text ends");
    expectRefused(">a # 5", 1, 7, "the text ends");
    expectRefused(">i 5", 1, 2, "expected a cube, found 'i'");
    expectRefused(">A 5", 1, 2, "found 'A'");
    expectRefused(">a > b 1", 1, 4, "found '>'");
    expectRefused(">a |", 1, 4, "found '|'");
    expectRefused(">a /x", 1, 6, "the text ends");
    expectRefused(">a b 5", 1, 4, "found 'b'");
}

TEST(CsmErrors, BracketsHoldEight) {
    expectRefused("> [1 2 3 4 5 6 7]", 1, 17, "the one of line 1, column 3 has 7");
    expectRefused(">\n[]", 2, 2, "the one of line 2, column 1 has 0");
    expectRefused("> [1 2 3 4 5 6 7 8 9]", 1, 20, "expected ']', found '9'");
    expectRefused("> [1 2 3 4 5 6 7 8", 1, 19, "expected ']', but the text ends");
    expectRefused("> [1 2 3\n", 2, 1, "expected a cube, but the text ends");
    expectRefused("> [1 2 3 4 [1 2] 6 7 8]", 1, 16, "the one of line 1, column 12 has 2");
    expectRefused("> 5]", 1, 4, "found ']'");
}

TEST(CsmErrors, ValuesAreBytes) {
    expectRefused(">a 256", 1, 4, "above 255");
    expectRefused(">a\n [1 2 3 300 5 6 7 8]", 2, 9, "above 255");
    expectRefused("> 99999999999999999999999999999999", 1, 3, "above 255");
    expectRefused("> 4294967296", 1, 3, "above 255");  // 0 in 32 bits
    expectRefused(">a -1", 1, 4, "negative");
    expectRefused(">a +1", 1, 4, "found '+'");
    EXPECT_TRUE(octreeFromCsm(bytesOf(">a 255 >b 0000000000000000000000000255")));
}

TEST(CsmErrors, NoDeeperThanSixteenLevels) {
    expectRefused(">" + std::string(17, 'a') + " 1", 1, 18, "deeper than 16 levels");
    expectRefused("> <" + std::string(17, 'a'), 1, 20, "deeper than 16 levels");
    expectRefused(">" + std::string(16, 'a') + " [1 2 3 4 5 6 7 8]", 1, 19, "deeper than 16");
    expectRefused("> " + std::string(17, '['), 1, 19, "deeper than 16");
    expectRefused(">aaa [1 2 3 4 5 6 7 8]\n| >" + std::string(16, 'b') + " <aaa", 2, 21,
                  "deeper than 16");
    expectRefused(">aaaaaaaa 1 > [1 2 3 4 5 6 7 8]\n| >" + std::string(15, 'b') + " [<aaaaaaaa <",
                  2, 31, "deeper than 16");
    EXPECT_TRUE(octreeFromCsm(bytesOf(">aaa 1 | >" + std::string(16, 'b') + " <aaa")));
}

TEST(CsmErrors, ReferencesNeedAnEpochThatAssignedThem) {
    expectRefused("> <", 1, 3, "no epoch before");
    expectRefused("| > <a", 1, 5, "no epoch before");
    expectRefused(">a 1 >b <a", 1, 9, "no epoch before");
    expectRefused(">a 1 | >b <", 1, 11, "assigned nothing at the root");
    expectRefused(">ab 1 | > <a", 1, 11, "assigned nothing at path a");
    expectRefused(">a [1 2 3 4 5 6 7 8]\n|\n> [1 2 <ab 4 5 6 7 8]", 3, 8, "nothing at path ab");
    // Two epochs back is too far.
    expectRefused(">a 1 | >b 2 | >c <a", 1, 18, "assigned nothing at path a");
}

TEST(CsmErrors, AxesAreNamedOnce) {
    expectRefused("> / 5", 1, 3, "expected axes (x, y, z) after '/'");
    expectRefused("> ^", 1, 3, "expected axes (x, y, z) after '^'");
    expectRefused("> /xx 5", 1, 5, "the axis x again");
    expectRefused("> ^xyzy 5", 1, 7, "the axis y again");
    expectRefused("> /xw 5", 1, 5, "found 'w'");
}

// --- texts made to cost much ---------------------------------------------------------------------

TEST(CsmDamage, ADepthBombIsRefusedAtItsSeventeenthBracket) {
    expectRefused("> " + std::string(1'000'000, '['), 1, 19, "deeper than 16");
    expectRefused("> " + std::string(1'000'000, '<'), 1, 3, "no epoch before");
}

TEST(CsmDamage, ReferencesCannotUnfoldWithoutEnd) {
    std::string text = "> [1 2 3 4 5 6 7 8]\n";
    for (int epoch = 0; epoch < 15; ++epoch) text += "| > [< < < < < < < <]\n";
    // 8^7 + ... + 1 cubes are allowed, 8^8 are not.
    expectRefused(text, 9, 5, "unfolds into more than 8388608 cubes");
}

TEST(CsmDamage, AMillionTurnsCostNoMoreThanTheirText) {
    std::string turns;
    for (int i = 0; i < 300'000; ++i) turns += i % 3 == 0 ? "/x" : i % 3 == 1 ? "^yz" : "^x";
    const Result<Octree> turned = octreeFromCsm(bytesOf("> " + turns + "[1 2 3 4 5 6 7 8]"));
    ASSERT_TRUE(turned);
    EXPECT_EQ(solidCount(turned->view()), 8u);
    // And over epochs, of a cube with much in it.
    std::string text = "> [1 2 3 4 5 6 7 8] | > [< < < < < < < <] | > [< < < < < < < <]";
    for (int i = 0; i < 20'000; ++i) text += "\n| > /xy ^xyz <";
    EXPECT_TRUE(octreeFromCsm(bytesOf(text)));
}

TEST(CsmDamage, WhatTheGridCannotHoldIsRefused) {
    const std::string deepest = ">" + std::string(16, 'a') + " 1\n";
    EXPECT_TRUE(readCsm(bytesOf(deepest + ">bbb 2\n")));  // 2^39 voxels
    const Result<Document> solid = readCsm(bytesOf(deepest + ">b 2\n"));
    ASSERT_FALSE(solid);
    EXPECT_THAT(solid.error().message, HasSubstr("2^40"));
    // Two million blocks with one voxel in a corner of each.
    std::string text = "> [1 0 0 0 0 0 0 0]\n";
    for (int epoch = 0; epoch < 7; ++epoch) text += "| > [< < < < < < < <]\n";
    const Result<Document> fine = readCsm(bytesOf(text + ">aaaaaaaaaa 1\n"));
    ASSERT_FALSE(fine);
    EXPECT_THAT(fine.error().message, HasSubstr("a gigabyte"));
}

// --- damage --------------------------------------------------------------------------------------

// Something of everything, in lines and with comments.
const std::string kEverything = R"(# a figure
>a [1 2 3 4 5 6 7 8] # eight
>ab 200
>hgf [0 0 [9 9 9 9 9 9 9 9] 0 0 0 0 255]
|
> [<a <ab /x <a ^xy <a
   /zy <hgf ^xyz <hgf ^y <a 7]
| # the last one
>b < >cc /x ^zy [< 1 2 3 4 5 6 <]
>ccd 0
)";

void expectErrorOrDocument(const std::string& text) {
    const Result<Document> document = readCsm(bytesOf(text));
    if (document) {
        EXPECT_TRUE(validate(*document)) << text;
        return;
    }
    const Error& error = document.error();
    EXPECT_FALSE(error.message.empty()) << text;
    if (!error.line) return;  // the model as a whole is too large
    ASSERT_TRUE(error.column) << text;
    // The place is in the text, or just behind its end.
    std::size_t lineStart = 0;
    for (int line = 1; line < *error.line; ++line) {
        lineStart = text.find('\n', lineStart);
        ASSERT_NE(lineStart, std::string::npos) << text;
        ++lineStart;
    }
    const std::size_t lineEnd = std::min(text.find('\n', lineStart), text.size());
    EXPECT_GE(*error.column, 1);
    EXPECT_LE(static_cast<std::size_t>(*error.column), lineEnd - lineStart + 1) << text;
}

TEST(CsmDamage, TheWholeTextIsRead) {
    const Result<Octree> octree = octreeFromCsm(bytesOf(kEverything));
    ASSERT_TRUE(octree) << octree.error().describe();
    EXPECT_GT(solidCount(octree->view()), 100u);
}

TEST(CsmDamage, EveryTruncation) {
    for (std::size_t length = 0; length < kEverything.size(); ++length) {
        expectErrorOrDocument(kEverything.substr(0, length));
    }
}

TEST(CsmDamage, EveryByteFlipped) {
    for (std::size_t at = 0; at < kEverything.size(); ++at) {
        for (const int mask : {0x01, 0x04, 0x20, 0x80, 0xFF}) {
            std::string flipped = kEverything;
            flipped[at] = static_cast<char>(flipped[at] ^ mask);
            expectErrorOrDocument(flipped);
        }
    }
}

TEST(CsmDamage, TokensInRandomPlaces) {
    test::Random random(6);
    static const char* const kTokens[] = {"[", "]", "<",  ">", "|", "/x", "^xy", "^",  "0",
                                          "7", "#", "\n", "a", "h", "-",  "999", "<a", " "};
    for (int round = 0; round < 3000; ++round) {
        std::string text = kEverything;
        for (int change = random.between(1, 6); change > 0; --change) {
            const auto at =
                static_cast<std::size_t>(random.between(0, static_cast<int>(text.size()) - 1));
            const auto length = static_cast<std::size_t>(random.between(0, 3));
            text.replace(at, length, kTokens[random.between(0, 17)]);
        }
        expectErrorOrDocument(text);
    }
}

TEST(CsmDamage, TokensInRandomOrder) {
    test::Random random(7);
    static const char* const kTokens[] = {
        ">",  "> ", ">a ", ">bc ", "[1 2 3 4 5 6 7 8]", "[", "]", "<", "<a ", "|", "/xz", "^yz",
        "5 ", "0 ", "# ",  "\n"};
    int documents = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string text;
        for (int tokens = random.between(1, 9); tokens > 0; --tokens) {
            text += kTokens[random.between(0, 15)];
        }
        documents += octreeFromCsm(bytesOf(text)) ? 1 : 0;
        if (round % 10 == 0) expectErrorOrDocument(text);
    }
    EXPECT_GT(documents, 200);
}

}  // namespace
}  // namespace voxprite
