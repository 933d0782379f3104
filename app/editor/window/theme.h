// How the editor looks: one accent colour on calm neutrals, an 8-pixel rhythm, two weights of one
// typeface. All lengths are given at content scale 1 and pass through px().
#pragma once

#include <imgui.h>

#include <cmath>
#include <cstdint>

namespace voxprite::editor {

enum class ThemeKind : std::uint8_t { dark, light };

struct Fonts {
    ImFont* text = nullptr;   // lines of 16 px, icons merged in
    ImFont* small = nullptr;  // 14 px
    ImFont* bold = nullptr;   // 16 px, for headings
    ImFont* icons = nullptr;  // 20 px, for the tool column
};

struct Theme {
    ThemeKind kind = ThemeKind::dark;
    float scale = 1.0f;
    Fonts fonts;
    ImU32 window = 0;  // behind everything, shows between panels
    ImU32 panel = 0;
    ImU32 raised = 0;
    ImU32 field = 0;
    ImU32 fieldHovered = 0;
    ImU32 fieldActive = 0;
    ImU32 line = 0;
    ImU32 text = 0;
    ImU32 textDim = 0;
    ImU32 textFaint = 0;
    ImU32 accent = 0;
    ImU32 accentSoft = 0;  // the accent as a background
    ImU32 onAccent = 0;    // text on the accent
    ImU32 danger = 0;

    // Whole device pixels, so that edges stay crisp at any scale.
    [[nodiscard]] float px(float length) const { return std::round(length * scale); }
    [[nodiscard]] ImVec2 px(float x, float y) const { return {px(x), px(y)}; }
};

// Builds the font atlas of the current ImGui context for `scale`.
[[nodiscard]] Fonts buildFonts(float scale);
// Colours and spacing, also set as the style of the current ImGui context.
[[nodiscard]] Theme makeTheme(ThemeKind kind, float scale, Fonts fonts);

[[nodiscard]] ImU32 withAlpha(ImU32 colour, float alpha);

}  // namespace voxprite::editor
