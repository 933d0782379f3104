#include "core/model/palette.h"

#include <gtest/gtest.h>

#include <set>

namespace voxprite {
namespace {

// As ABGR words, the way the format's documentation prints them.
std::uint32_t wordOf(Rgba8 c) {
    return static_cast<std::uint32_t>(c.x) | static_cast<std::uint32_t>(c.y) << 8 |
           static_cast<std::uint32_t>(c.z) << 16 | static_cast<std::uint32_t>(c.w) << 24;
}

TEST(Palette, TheStandardOneIsMagicaVoxels) {
    const Palette palette = Palette::standard();
    const auto word = [&](std::size_t index) { return wordOf(palette.colours[index]); };
    EXPECT_EQ(word(0), 0u);
    EXPECT_EQ(word(1), 0xFFFF'FFFFu);
    EXPECT_EQ(word(2), 0xFFCC'FFFFu);
    EXPECT_EQ(word(6), 0xFF00'FFFFu);
    EXPECT_EQ(word(7), 0xFFFF'CCFFu);
    EXPECT_EQ(word(36), 0xFF00'00FFu);
    EXPECT_EQ(word(37), 0xFFFF'FFCCu);
    EXPECT_EQ(word(215), 0xFF33'0000u);
    EXPECT_EQ(word(216), 0xFF00'00EEu);
    EXPECT_EQ(word(225), 0xFF00'0011u);
    EXPECT_EQ(word(226), 0xFF00'EE00u);
    EXPECT_EQ(word(236), 0xFFEE'0000u);
    EXPECT_EQ(word(246), 0xFFEE'EEEEu);
    EXPECT_EQ(word(255), 0xFF11'1111u);
}

TEST(Palette, TheStandardColoursAreAllDifferentAndOpaque) {
    const Palette palette = Palette::standard();
    std::set<std::uint32_t> words;
    for (std::size_t i = 1; i < 256; ++i) {
        EXPECT_EQ(palette.colours[i].w, 255);
        words.insert(wordOf(palette.colours[i]));
    }
    EXPECT_EQ(words.size(), 255u);
    for (std::size_t slot = 0; slot < 256; ++slot) EXPECT_EQ(palette.displayOrder[slot], slot);
}

}  // namespace
}  // namespace voxprite
