#include "core/io/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "tests/support/png_builder.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace voxprite {
namespace {

using test::handmadePng;
using test::putPngChunk;
using test::storedZlib;
using testing::HasSubstr;

Image noise(int width, int height, std::uint64_t seed) {
    test::Random random(seed);
    Image image(width, height);
    for (Rgba8& pixel : image.pixels) {
        for (int channel = 0; channel < 4; ++channel) {
            pixel[channel] = static_cast<std::uint8_t>(random.between(0, 255));
        }
    }
    return image;
}

TEST(Png, WhatIsWrittenReadsBackEqual) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {640, 2}, {1, 300}, {64, 64}}) {
        const Image image = noise(width, height, 3);
        const Result<Bytes> bytes = writePng(image);
        ASSERT_TRUE(bytes);
        const Result<Image> again = readPng(*bytes);
        ASSERT_TRUE(again) << again.error().describe();
        EXPECT_EQ(*again, image);
        EXPECT_EQ(*writePng(image), *bytes);
    }
}

TEST(Png, FilesReadBackEqual) {
    const test::TemporaryFolder folder;
    const Image image = noise(20, 10, 4);
    ASSERT_TRUE(writePngFile(folder / "a.png", image));
    EXPECT_EQ(readPngFile(folder / "a.png").value(), image);
    const Result<Image> missing = readPngFile(folder / "b.png");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().file, HasSubstr("b.png"));
}

TEST(Png, OtherPixelFormatsAreConverted) {
    // Grey of 8 bits; a palette with transparency, 2 bits a pixel; RGB of 16 bits.
    EXPECT_EQ(readPng(handmadePng(2, 1, 8, 0, {0, 10, 200})).value().at(1, 0),
              Rgba8(200, 200, 200, 255));
    const Image mapped = readPng(handmadePng(3, 1, 2, 3, {0, 0b00011000},
                                             {1, 2, 3, 4, 5, 6, 7, 8, 9}, {255, 128, 0}))
                             .value();
    EXPECT_EQ(mapped.at(0, 0), Rgba8(1, 2, 3, 255));
    EXPECT_EQ(mapped.at(1, 0), Rgba8(4, 5, 6, 128));
    EXPECT_EQ(mapped.at(2, 0), Rgba8(7, 8, 9, 0));
    EXPECT_EQ(
        readPng(handmadePng(1, 1, 16, 2, {0, 0x12, 0x34, 0xAB, 0xCD, 0xFF, 0xFF})).value().at(0, 0),
        Rgba8(0x12, 0xAB, 0xFF, 255));
}

// Found by the fuzzer.
TEST(Png, EmptyChunksOfPixelsAreNothing) {
    const Bytes plain = handmadePng(2, 1, 8, 0, {0, 10, 200});
    Bytes empty;
    putPngChunk(empty, "IDAT", {});
    constexpr std::string_view kName = "IDAT";
    const auto name = std::search(plain.begin(), plain.end(), kName.begin(), kName.end());
    const auto chunk = static_cast<std::size_t>(name - plain.begin()) - 4;
    Bytes padded(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(chunk));
    padded.insert(padded.end(), empty.begin(), empty.end());
    padded.insert(padded.end(), plain.begin() + static_cast<std::ptrdiff_t>(chunk), plain.end());
    const Result<Image> image = readPng(padded);
    ASSERT_TRUE(image) << image.error().describe();
    EXPECT_EQ(*image, readPng(plain).value());
}

TEST(Png, SizesAreCheckedBeforeMemoryIsTaken) {
    const auto reason = [](Bytes size) {
        Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
        size.insert(size.end(), {8, 6, 0, 0, 0});
        putPngChunk(png, "IHDR", size);
        putPngChunk(png, "IDAT", storedZlib({0, 0}));
        putPngChunk(png, "IEND", {});
        return readPng(png).error().message;
    };
    EXPECT_THAT(reason({0, 0, 0x40, 1, 0, 0, 0, 1}), HasSubstr("16385 x 1"));
    EXPECT_THAT(reason({0, 0, 0, 1, 0xFF, 0xFF, 0xFF, 0xFF}), HasSubstr("1 x 4294967295"));
    EXPECT_THAT(reason({0, 0, 0, 0, 0, 0, 0, 1}), HasSubstr("0 x 1"));
    EXPECT_THAT(reason({0, 0, 0x40, 0, 0, 0, 0x40, 0}), HasSubstr("end too early"));
    EXPECT_FALSE(writePng(Image{}));
    EXPECT_FALSE(writePng(Image(16385, 1)));
}

TEST(Png, MoreOrFewerPixelsThanThePictureHasAreRefused) {
    EXPECT_THAT(readPng(handmadePng(2, 2, 8, 0, {0, 1, 2, 0, 3})).error().message,
                HasSubstr("end too early"));
    EXPECT_THAT(readPng(handmadePng(2, 1, 8, 0, Bytes(60'000))).error().message,
                HasSubstr("damaged"));
    EXPECT_THAT(readPng(handmadePng(1, 1, 3, 0, {0, 0})).error().message,
                HasSubstr("unknown pixel format"));
}

TEST(Png, EveryTruncationAndFlippedByteIsRefused) {
    const Bytes whole = *writePng(noise(5, 4, 9));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_FALSE(readPng(cut)) << length;
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
        Bytes flipped = whole;
        flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ 0x10);
        EXPECT_FALSE(readPng(flipped)) << at;
    }
}

// Checksums made right again, so that the damage gets past them.
TEST(Png, DamagedPixelsNeverCrash) {
    test::Random random(11);
    for (int round = 0; round < 3000; ++round) {
        Bytes rows;
        for (int i = random.between(0, 40); i > 0; --i) {
            rows.push_back(static_cast<std::uint8_t>(random.between(0, 255)));
        }
        constexpr std::uint8_t kDepths[] = {1, 2, 4, 8, 16};
        constexpr std::uint8_t kTypes[] = {0, 2, 3, 4, 6};
        const Bytes png =
            handmadePng(static_cast<std::uint8_t>(random.between(1, 5)),
                        static_cast<std::uint8_t>(random.between(1, 5)),
                        kDepths[random.between(0, 4)], kTypes[random.between(0, 4)], rows,
                        Bytes(static_cast<std::size_t>(random.between(0, 3)) * 3));
        const Result<Image> image = readPng(png);
        if (image) {
            EXPECT_LE(image->pixels.size(), 25u);
        }
    }
}

}  // namespace
}  // namespace voxprite
