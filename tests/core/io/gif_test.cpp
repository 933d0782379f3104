#include "core/io/gif.h"

#include <gif_lib.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/must.h"

namespace voxprite {
namespace {

using test::must;
using testing::HasSubstr;

// What giflib's reader makes of it, frame by frame.
struct Read {
    std::vector<Image> frames;
    std::vector<int> hundredths;
};

Read readBack(const Bytes& bytes) {
    struct Source {
        const Bytes& bytes;
        std::size_t at = 0;
    } source{bytes};
    const auto take = [](GifFileType* file, GifByteType* data, int length) {
        auto& from = *static_cast<Source*>(file->UserData);
        const auto count =
            std::min<std::size_t>(static_cast<std::size_t>(length), from.bytes.size() - from.at);
        std::memcpy(data, from.bytes.data() + from.at, count);
        from.at += count;
        return static_cast<int>(count);
    };
    Read read;
    int error = 0;
    GifFileType* gif = DGifOpen(&source, take, &error);
    if (gif == nullptr || DGifSlurp(gif) != GIF_OK) throw std::runtime_error("no GIF");
    for (int k = 0; k < gif->ImageCount; ++k) {
        const SavedImage& saved = gif->SavedImages[k];
        GraphicsControlBlock control{};
        EXPECT_EQ(DGifSavedExtensionToGCB(gif, k, &control), GIF_OK);
        Image image(saved.ImageDesc.Width, saved.ImageDesc.Height);
        for (std::size_t p = 0; p < image.pixels.size(); ++p) {
            const int index = saved.RasterBits[p];
            if (index == control.TransparentColor) continue;
            const GifColorType c = gif->SColorMap->Colors[index];
            image.pixels[p] = Rgba8(c.Red, c.Green, c.Blue, 255);
        }
        read.frames.push_back(image);
        read.hundredths.push_back(control.DelayTime);
    }
    EXPECT_EQ(DGifCloseFile(gif, &error), GIF_OK);
    return read;
}

AnimationFrame ramp(int colours, int milliseconds) {
    Image image(20, 20);
    for (int k = 0; k < colours; ++k) {
        image.pixels[static_cast<std::size_t>(k)] = Rgba8(k % 256, k / 2, 255 - k % 256, 255);
    }
    return {image, milliseconds};
}

TEST(Gif, UpTo255ColoursAreExact) {
    for (const int colours : {0, 1, 2, 3, 7, 8, 255}) {
        const std::vector<AnimationFrame> frames{ramp(colours, 80), ramp(colours / 2, 1000)};
        const GifImage gif = must(writeGif(frames));
        EXPECT_FALSE(gif.loss) << colours;
        const Read read = readBack(gif.bytes);
        ASSERT_EQ(read.frames.size(), 2u);
        EXPECT_EQ(read.frames[0], frames[0].image) << colours;
        EXPECT_EQ(read.frames[1], frames[1].image) << colours;
        EXPECT_EQ(read.hundredths, (std::vector<int>{8, 100}));
        EXPECT_EQ(must(writeGif(frames)).bytes, gif.bytes);
    }
}

TEST(Gif, PlaysForEver) {
    const GifImage gif = must(writeGif(std::vector{ramp(3, 10)}));
    const std::string text(gif.bytes.begin(), gif.bytes.end());
    EXPECT_TRUE(text.starts_with("GIF89a"));
    EXPECT_NE(text.find(std::string("NETSCAPE2.0\x03\x01\x00\x00\x00", 16)), std::string::npos);
    EXPECT_EQ(readBack(gif.bytes).hundredths, std::vector<int>{2});
}

// Six frames a second: none is a whole number of hundredths, but they last a second.
TEST(Gif, TimesAddUp) {
    const GifImage gif = must(writeGif(std::vector(6, ramp(3, 167))));
    EXPECT_EQ(readBack(gif.bytes).hundredths, (std::vector<int>{17, 16, 17, 17, 17, 16}));
}

TEST(Gif, WhatIsLostIsSaid) {
    const GifImage many = must(writeGif(std::vector{ramp(400, 80)}));
    EXPECT_THAT(many.loss.value(), HasSubstr("400 colours are reduced"));
    EXPECT_EQ(readBack(many.bytes).frames.size(), 1u);
    AnimationFrame glass = ramp(1, 80);
    glass.image.pixels[5] = Rgba8(9, 9, 9, 127);
    glass.image.pixels[6] = Rgba8(9, 9, 9, 128);
    const GifImage translucent = must(writeGif(std::vector{glass}));
    EXPECT_THAT(translucent.loss.value(), HasSubstr("all or nothing"));
    const Image back = readBack(translucent.bytes).frames[0];
    EXPECT_EQ(back.pixels[5], Rgba8(0));
    EXPECT_EQ(back.pixels[6], Rgba8(9, 9, 9, 255));
}

TEST(Gif, FramesMustBeThereAndAlike) {
    EXPECT_FALSE(writeGif({}));
    EXPECT_FALSE(writeGif(std::vector{AnimationFrame{Image(), 80}}));
    EXPECT_FALSE(writeGif(std::vector{ramp(1, 80), AnimationFrame{Image(3, 3), 80}}));
}

}  // namespace
}  // namespace voxprite
