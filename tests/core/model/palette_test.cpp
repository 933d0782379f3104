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

TEST(Palette, AVariantChangesItsColoursAndNothingElse) {
    Palette palette = Palette::standard();
    palette.names[9] = "coat";
    palette.variants = {{"Red", {{9, Rgba8(200, 0, 0, 255)}}}, {"Plain", {}}};
    const Palette red = palette.withVariant(0);
    EXPECT_EQ(red.colours[9], Rgba8(200, 0, 0, 255));
    Palette back = red;
    back.colours[9] = palette.colours[9];
    EXPECT_EQ(back, palette);
    EXPECT_EQ(palette.withVariant(1), palette);
    EXPECT_EQ(palette.variantNamed("Plain"), 1u);
    EXPECT_FALSE(palette.variantNamed("plain"));
}

TEST(Palette, RampsAndVariantsAreChecked) {
    const auto message = [](auto change) {
        Palette palette = Palette::standard();
        change(palette);
        const Status status = validate(palette);
        return status ? std::string() : status.error().message;
    };
    EXPECT_EQ(message([](Palette& p) { p.ramps = {{"", {1, 2}}, {"b", {3, 4, 5}}}; }), "");
    EXPECT_EQ(message([](Palette& p) {
                  p.ramps = {{"", {1}}};
              }),
              "palette.ramps[0] has fewer than two colours");
    EXPECT_EQ(message([](Palette& p) {
                  p.ramps = {{"", {1, 0}}};
              }),
              "palette.ramps[0] names index 0, which is empty");
    EXPECT_EQ(message([](Palette& p) {
                  p.ramps = {{"", {1, 2}}, {"", {3, 2}}};
              }),
              "palette.ramps[1] names index 2, which stands in a ramp already");
    EXPECT_EQ(message([](Palette& p) {
                  p.variants = {{"", {}}};
              }),
              "palette.variants[0] has no name");
    EXPECT_EQ(message([](Palette& p) {
                  p.variants = {{"a", {}}, {"a", {}}};
              }),
              "palette.variants[1]: there is a variant \"a\" already");
    EXPECT_EQ(message([](Palette& p) {
                  p.variants = {{"a", {{0, Rgba8(1)}}}};
              }),
              "palette.variants[0] gives index 0 a colour; it is empty");
    EXPECT_NE(message([](Palette& p) {
                  for (int i = 0; i < 65; ++i) p.variants.push_back({std::to_string(i), {}});
              }).find("at most 64"),
              std::string::npos);
}

}  // namespace
}  // namespace voxprite
