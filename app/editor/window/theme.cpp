#include "app/editor/window/theme.h"

namespace voxprite::editor {
namespace {

constexpr ImU32 rgb(std::uint32_t hex) {
    return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, 255u);
}

ImVec4 vec(ImU32 colour) {
    return ImGui::ColorConvertU32ToFloat4(colour);
}

void setColours(Theme& theme) {
    const bool dark = theme.kind == ThemeKind::dark;
    theme.window = rgb(dark ? 0x141517 : 0xC9CBD0);
    theme.panel = rgb(dark ? 0x1E1F22 : 0xF2F2F4);
    theme.raised = rgb(dark ? 0x26282C : 0xFFFFFF);
    theme.field = rgb(dark ? 0x2C2E33 : 0xE2E3E7);
    theme.fieldHovered = rgb(dark ? 0x373A40 : 0xD6D8DD);
    theme.fieldActive = rgb(dark ? 0x42454C : 0xC9CCD2);
    theme.line = rgb(dark ? 0x303238 : 0xD9DADF);
    theme.text = rgb(dark ? 0xE4E5E8 : 0x1C1D20);
    theme.textDim = rgb(dark ? 0xA0A4AC : 0x5A5E66);
    theme.textFaint = rgb(dark ? 0x6B6F78 : 0x8E929A);
    theme.accent = rgb(dark ? 0xF0A23C : 0xC8700A);
    theme.accentSoft = withAlpha(theme.accent, 0.18f);
    theme.onAccent = rgb(dark ? 0x1B1408 : 0xFFFFFF);
    theme.danger = rgb(dark ? 0xE5645A : 0xC0392B);
}

void setImGuiColours(const Theme& theme, ImVec4* colours) {
    const ImVec4 none(0, 0, 0, 0);
    colours[ImGuiCol_Text] = vec(theme.text);
    colours[ImGuiCol_TextDisabled] = vec(theme.textFaint);
    colours[ImGuiCol_WindowBg] = vec(theme.panel);
    colours[ImGuiCol_ChildBg] = none;
    colours[ImGuiCol_PopupBg] = vec(theme.raised);
    colours[ImGuiCol_Border] = vec(theme.line);
    colours[ImGuiCol_BorderShadow] = none;
    colours[ImGuiCol_FrameBg] = vec(theme.field);
    colours[ImGuiCol_FrameBgHovered] = vec(theme.fieldHovered);
    colours[ImGuiCol_FrameBgActive] = vec(theme.fieldActive);
    colours[ImGuiCol_MenuBarBg] = vec(theme.panel);
    colours[ImGuiCol_ScrollbarBg] = none;
    colours[ImGuiCol_ScrollbarGrab] = vec(theme.fieldHovered);
    colours[ImGuiCol_ScrollbarGrabHovered] = vec(theme.fieldActive);
    colours[ImGuiCol_ScrollbarGrabActive] = vec(theme.textFaint);
    colours[ImGuiCol_CheckMark] = vec(theme.accent);
    colours[ImGuiCol_SliderGrab] = vec(theme.accent);
    colours[ImGuiCol_SliderGrabActive] = vec(theme.accent);
    colours[ImGuiCol_Button] = vec(theme.field);
    colours[ImGuiCol_ButtonHovered] = vec(theme.fieldHovered);
    colours[ImGuiCol_ButtonActive] = vec(theme.fieldActive);
    colours[ImGuiCol_Header] = vec(theme.accentSoft);
    colours[ImGuiCol_HeaderHovered] = vec(theme.fieldHovered);
    colours[ImGuiCol_HeaderActive] = vec(theme.fieldActive);
    colours[ImGuiCol_Separator] = vec(theme.line);
    colours[ImGuiCol_TextSelectedBg] = vec(withAlpha(theme.accent, 0.35f));
    colours[ImGuiCol_NavHighlight] = none;
    colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
}

}  // namespace

ImU32 withAlpha(ImU32 colour, float alpha) {
    const auto a = static_cast<ImU32>(std::lround(alpha * 255.0f));
    return (colour & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

Theme makeTheme(ThemeKind kind, float scale, Fonts fonts) {
    Theme theme;
    theme.kind = kind;
    theme.scale = scale;
    theme.fonts = fonts;
    setColours(theme);

    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.WindowPadding = theme.px(12, 12);
    style.FramePadding = theme.px(8, 4);
    style.ItemSpacing = theme.px(8, 6);
    style.ItemInnerSpacing = theme.px(6, 4);
    style.ScrollbarSize = theme.px(10);
    style.GrabMinSize = theme.px(10);
    style.WindowRounding = 0.0f;
    style.ChildRounding = theme.px(4);
    style.FrameRounding = theme.px(4);
    style.PopupRounding = theme.px(6);
    style.ScrollbarRounding = theme.px(5);
    style.GrabRounding = theme.px(4);
    style.WindowBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.FrameBorderSize = 0.0f;
    style.DisabledAlpha = 0.4f;
    style.WindowMinSize = theme.px(16, 16);
    setImGuiColours(theme, style.Colors);
    return theme;
}

}  // namespace voxprite::editor
