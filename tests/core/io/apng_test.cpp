#include "core/io/apng.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/io/png.h"
#include "tests/support/must.h"

namespace voxprite::test {
namespace {

struct PngChunk {
    std::string type;
    Bytes content;
};

std::uint32_t number(const Bytes& bytes, std::size_t at, int count = 4) {
    std::uint32_t value = 0;
    for (int k = 0; k < count; ++k) value = value << 8 | bytes.at(at + static_cast<std::size_t>(k));
    return value;
}

// The polynomial, bit by bit.
std::uint32_t crcOf(const Bytes& bytes, std::size_t from, std::size_t to) {
    std::uint32_t crc = 0xFFFF'FFFFu;
    for (std::size_t k = from; k < to; ++k) {
        crc ^= bytes[k];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB8'8320u : 0u);
    }
    return ~crc;
}

std::vector<PngChunk> chunksOf(const Bytes& file) {
    std::vector<PngChunk> chunks;
    for (std::size_t at = 8; at < file.size();) {
        const std::size_t length = number(file, at);
        EXPECT_EQ(number(file, at + 8 + length), crcOf(file, at + 4, at + 8 + length));
        chunks.push_back({std::string(file.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                                      file.begin() + static_cast<std::ptrdiff_t>(at) + 8),
                          Bytes(file.begin() + static_cast<std::ptrdiff_t>(at) + 8,
                                file.begin() + static_cast<std::ptrdiff_t>(at + 8 + length))});
        at += length + 12;
    }
    return chunks;
}

std::vector<AnimationFrame> threeFrames() {
    std::vector<AnimationFrame> frames;
    for (int k = 0; k < 3; ++k) {
        Image image(5, 4, Rgba8(10 * k, 200, 30, 255));
        image.at(k, 1) = Rgba8(0);
        frames.push_back({image, 40 + k});
    }
    return frames;
}

TEST(Apng, ViewersThatKnowNoAnimationSeeTheFirstFrame) {
    const std::vector<AnimationFrame> frames = threeFrames();
    EXPECT_EQ(must(readPng(must(writeApng(frames)))), frames[0].image);
}

TEST(Apng, HoldsEveryFrameInOrder) {
    const std::vector<AnimationFrame> frames = threeFrames();
    const Bytes file = must(writeApng(frames));
    const std::vector<PngChunk> chunks = chunksOf(file);
    std::string types;
    for (const PngChunk& chunk : chunks) types += chunk.type + " ";
    EXPECT_EQ(types, "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
    EXPECT_EQ(number(chunks[1].content, 0), 3u);
    EXPECT_EQ(number(chunks[1].content, 4), 0u);  // for ever
    std::uint32_t sequence = 0;
    std::size_t frame = 0;
    for (const PngChunk& chunk : chunks) {
        if (chunk.type == "fcTL") {
            ASSERT_EQ(chunk.content.size(), 26u);
            EXPECT_EQ(number(chunk.content, 0), sequence++);
            EXPECT_EQ(number(chunk.content, 4), 5u);
            EXPECT_EQ(number(chunk.content, 8), 4u);
            EXPECT_EQ(number(chunk.content, 20, 2), 40 + frame);
            EXPECT_EQ(number(chunk.content, 22, 2), 1000u);
            ++frame;
        }
        if (chunk.type != "fdAT") continue;
        EXPECT_EQ(number(chunk.content, 0), sequence++);
        // The same pixels as a PNG of that frame alone has.
        const std::vector<PngChunk> alone = chunksOf(must(writePng(frames[frame - 1].image)));
        EXPECT_EQ(Bytes(chunk.content.begin() + 4, chunk.content.end()), alone[1].content);
    }
    EXPECT_EQ(sequence, 5u);
}

TEST(Apng, LongFramesHaveACoarserUnit) {
    const auto duration = [](int milliseconds) {
        std::vector<AnimationFrame> frames = threeFrames();
        frames[0].milliseconds = milliseconds;
        const PngChunk control = chunksOf(must(writeApng(frames)))[2];
        return std::pair(number(control.content, 20, 2), number(control.content, 22, 2));
    };
    EXPECT_EQ(duration(65'535), std::pair(65'535u, 1000u));
    EXPECT_EQ(duration(65'540), std::pair(6'554u, 100u));
    EXPECT_EQ(duration(1'000'000), std::pair(10'000u, 10u));
    EXPECT_EQ(duration(2'000'000'000), std::pair(65'535u, 1u));
}

TEST(Apng, RefusesWhatItCannotHold) {
    EXPECT_FALSE(writeApng({}));
    std::vector<AnimationFrame> frames = threeFrames();
    frames[1].image = Image(5, 5, Rgba8(1, 2, 3, 4));
    const auto sizes = writeApng(frames);
    ASSERT_FALSE(sizes);
    EXPECT_EQ(sizes.error().message, "frame 1 has another size than the first");
    frames = threeFrames();
    frames[2].milliseconds = 0;
    EXPECT_FALSE(writeApng(frames));
}

}  // namespace
}  // namespace voxprite::test
