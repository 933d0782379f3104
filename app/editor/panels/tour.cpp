#include "app/editor/panels/tour.h"

#include <algorithm>
#include <array>

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

struct Card {
    const char* title;
    const char* text;
    ImVec2 at;  // its middle
};

constexpr float kCardWidth = 250.0f;

ImVec2 inside(const Area& area, float x, float y) {
    return {area.min.x + area.size.x * x, area.min.y + area.size.y * y};
}

// Inside the window, whatever its size.
void drawCard(Ui& ui, const Card& card) {
    const Theme& theme = ui.theme;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImFont* bold = theme.fonts.bold;
    ImFont* small = theme.fonts.small;
    const float pad = theme.px(14), width = theme.px(kCardWidth), wrap = width - 2 * pad;
    const ImVec2 text = small->CalcTextSizeA(small->FontSize, FLT_MAX, wrap, card.text);
    const float height = bold->FontSize + theme.px(6) + text.y + 2 * pad;
    const float edge = theme.px(8);
    const ImVec2 min(
        std::round(std::clamp(card.at.x - width * 0.5f, edge, display.x - width - edge)),
        std::round(std::clamp(card.at.y - height * 0.5f, edge, display.y - height - edge)));
    const ImVec2 max(min.x + width, min.y + height);
    draw.AddRectFilled(min, max, theme.raised, theme.px(8));
    draw.AddRectFilled(min, {min.x + theme.px(3), max.y}, theme.accent, theme.px(8),
                       ImDrawFlags_RoundCornersLeft);
    draw.AddText(bold, bold->FontSize, {min.x + pad, min.y + pad}, theme.text, card.title);
    draw.AddText(small, small->FontSize, {min.x + pad, min.y + pad + bold->FontSize + theme.px(6)},
                 theme.textDim, card.text, nullptr, wrap);
}

}  // namespace

void Tour::draw(Ui& ui, const Layout& layout) {
    if (!open_) return;
    const Theme& theme = ui.theme;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (!ImGui::IsPopupOpen("##tour")) ImGui::OpenPopup("##tour");
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(display);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_PopupBorderSize, 0.0f);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_ModalWindowDimBg, ImVec4(0.03f, 0.03f, 0.04f, 0.62f));
    const bool shows = ImGui::BeginPopupModal(
        "##tour", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    if (shows) {
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const std::array shown{&layout.tools,  &layout.options,   &layout.edit,
                               &layout.sprite, &layout.inspector, &layout.dock};
        for (const Area* area : shown) {
            if (!area->shown()) continue;
            draw.AddRect({area->min.x + 1, area->min.y + 1}, {area->max().x - 1, area->max().y - 1},
                         withAlpha(theme.accent, 0.55f), theme.px(4), 0, theme.px(1.5f));
        }
        const std::string palette =
            "Everything has a name and a key: " +
            chordText(chordsOf(commandOf(CommandId::commandPalette), ui.settings.input.keys)[0]) +
            " finds it.";
        const std::array cards{
            Card{"Tools",
                 "Attach, erase or paint, with a brush or whole shapes; select; set the anchor. "
                 "Hold Shift to swap attach and erase, Alt to pick a colour.",
                 inside(layout.tools, 0.5f, 0.62f)},
            Card{"Edit view",
                 "Your voxels. Draw with the left button, turn with the right, zoom with the "
                 "wheel. The cube in the corner looks from its sides.",
                 inside(layout.edit, 0.5f, 0.26f)},
            Card{"Sprite view",
                 "The very sprite that the game will show, pixel for pixel, while you draw.",
                 inside(layout.sprite, 0.5f, 0.26f)},
            Card{"The game's numbers",
                 "Sigma, the virtual pixels a voxel, and VoxelSize are shared by the whole game; "
                 "below them the anchor and the proxy box of this model.",
                 inside(layout.inspector, 0.45f, 0.32f)},
            Card{"Palette, objects, history, scene",
                 "Colours with their ramps and variants, the parts of the model, every step to go "
                 "back to, and a crowd to look at.",
                 inside(layout.dock, 0.45f, 0.45f)},
            Card{"Find anything", palette.c_str(), inside(layout.divider, 0.5f, 0.78f)}};
        for (const Card& card : cards) drawCard(ui, card);

        const ImVec2 button = theme.px(160, 36);
        ImGui::SetCursorPos(
            {std::round((layout.edit.min.x + layout.sprite.max().x - button.x) * 0.5f),
             std::round(inside(layout.divider, 0.5f, 0.88f).y)});
        const bool closes = primaryButton(ui, "Start", button);
        ui.probe.markItem("tour.start");
        if (closes || pressedKey(ImGuiKey_Escape) || pressedEnter()) {
            open_ = false;
            ui.settings.window.tourSeen = true;
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(3);
}

}  // namespace voxprite::editor
