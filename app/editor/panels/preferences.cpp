#include "app/editor/panels/preferences.h"

#include <algorithm>

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/input.h"

namespace voxprite::editor {
namespace {

constexpr float kPreferencesWidth = 640.0f, kPreferencesHeight = 600.0f;

constexpr std::array kThemes{Choice{"Dark", "Calm greys, for long evenings"},
                             Choice{"Light", "For bright rooms"}};
constexpr std::array kBackdrops{
    Choice{"Theme", "As the rest of the window"}, Choice{"Black", "Behind the voxels: black"},
    Choice{"Grey", "Behind the voxels: middle grey"}, Choice{"White", "Behind the voxels: white"},
    Choice{"Sky", "Behind the voxels: a sky"}};
constexpr std::array kOcclusions{
    Choice{"Off", "No shade between voxels"}, Choice{"Corners", "Shade where voxels meet"},
    Choice{"Rays", "Shade by short rays: it sees farther, and costs more"}};
constexpr std::array kDrawBys{
    Choice{"Automatic", "What takes less time on this machine, by the frames before"},
    Choice{"Rays", "The edit view casts a ray for each pixel"},
    Choice{"Clusters", "The edit view draws a mesh, as fine as its size on the screen asks for"}};
constexpr std::array kClusterBudgets{0.0, 1.0, 2.0, 4.0};
constexpr std::array kClusterBudgetChoices{
    Choice{"Exact", "The finest mesh: the pixels that rays show"},
    Choice{"1 px", "The mesh may be off by a pixel"}, Choice{"2 px", "Coarser, and faster"},
    Choice{"4 px", "Coarser still"}};
constexpr std::array kNavigations{
    Choice{"MagicaVoxel", "Right: orbit. Middle, or Space and left: pan. Wheel: zoom"},
    Choice{"Blender", "Middle: orbit, with Shift: pan, with Ctrl: zoom. Wheel: zoom"},
    Choice{"Goxel", "Middle: orbit. Right: pan. Wheel: zoom"},
    Choice{"Trackpad", "Two fingers: orbit, with Shift: pan, with Ctrl or a pinch: zoom"}};
constexpr std::array kContentScales{0.75f, 1.0f, 1.25f, 1.5f, 1.75f};
constexpr std::array kScaleChoices{
    Choice{"75 %", "Text and all else, on top of the display's own scale"}, Choice{"100 %", ""},
    Choice{"125 %", ""}, Choice{"150 %", ""}, Choice{"175 %", ""}};
constexpr std::array kMemories{256, 1024, 2048, 8192};
constexpr std::array kMemoryChoices{
    Choice{"256 MB", "Most that undo may hold; beyond it the oldest steps go"}, Choice{"1 GB", ""},
    Choice{"2 GB", ""}, Choice{"8 GB", ""}};

// A choice among values that are no enumeration: the nearest one is lit.
template <class Value, std::size_t count>
void valueRow(Ui& ui, const char* name, const char* label, Value& value,
              const std::array<Value, count>& values, std::span<const Choice> choices) {
    const auto nearest =
        std::ranges::min_element(values, {}, [&](Value v) { return std::abs(v - value); });
    int index = static_cast<int>(nearest - values.begin());
    if (choiceRow(ui, name, label, index, choices)) value = values[static_cast<std::size_t>(index)];
}

void note(Ui& ui, const char* text) {
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

bool isModifier(int key) {
    const auto name = keyName(key).value_or("");
    return name.starts_with("left_shift") || name.starts_with("right_shift") ||
           name.ends_with("_control") || name.ends_with("_alt");
}

}  // namespace

void Preferences::open(Page page) {
    open_ = true;
    page_ = page;
    search_ = {};
    listening_.reset();
}

void Preferences::draw(Ui& ui) {
    if (!open_) return;
    if (!beginDialog(ui, "##preferences", "Preferences", kPreferencesWidth, kPreferencesHeight))
        return;
    // The key being bound is no command of this dialog.
    const bool waited = listening_.has_value();
    listen(ui);
    drawTabs(ui);
    const ImVec2 button = ui.theme.px(108, 30);
    ImGui::BeginChild("page", {0.0f, -button.y - ui.theme.px(26)});
    if (page_ == Page::general) drawGeneral(ui);
    if (page_ == Page::keys) drawKeys(ui);
    ImGui::EndChild();
    placeButtons(ui, button, 1);
    const bool escaped = pressedKey(ImGuiKey_Escape) && !waited;
    if (primaryButton(ui, "Done", button) || escaped) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ui.probe.markItem("preferences.done");
    endDialog();
}

void Preferences::drawTabs(Ui& ui) {
    const float gap = ui.theme.px(8), square = ui.theme.px(30);
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) * 0.5f);
    const auto tab = [&](const char* label, Page page) {
        const bool on = page_ == page;
        if (on) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.accentSoft);
        if (on) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.accent);
        if (ImGui::Button(label, {width, square})) page_ = page;
        if (on) ImGui::PopStyleColor(2);
        ui.probe.markItem(std::string("preferences.") + label);
    };
    tab("General", Page::general);
    ImGui::SameLine(0.0f, gap);
    tab("Keys", Page::keys);
    ImGui::Dummy(ui.theme.px(0, 4));
}

void Preferences::drawGeneral(Ui& ui) {
    WindowSettings& window = ui.settings.window;
    InputSettings& input = ui.settings.input;
    static_cast<void>(enumRow(ui, "preferences.theme", "Theme", window.theme, kThemes));
    valueRow(ui, "preferences.scale", "Size of text", window.scale, kContentScales, kScaleChoices);
    static_cast<void>(
        enumRow(ui, "preferences.backdrop", "Background", ui.settings.view.backdrop, kBackdrops));
    ImGui::Dummy(ui.theme.px(0, 6));
    static_cast<void>(
        enumRow(ui, "preferences.navigation", "Mouse", input.navigation, kNavigations));
    note(ui, kNavigations[static_cast<std::size_t>(input.navigation)].hint);
    static_cast<void>(switchRow(ui, "preferences.invertWheel", "Invert wheel", input.invertWheel,
                                "Zoom in by rolling toward you"));
    ImGui::Dummy(ui.theme.px(0, 6));
    ViewSettings& view = ui.settings.view;
    const float middle = ui.theme.px(300);
    static_cast<void>(switchRow(ui, "preferences.edges", "Voxel edges", view.voxelEdges));
    ImGui::SameLine(middle);
    static_cast<void>(switchRow(ui, "preferences.grid", "Grid", view.editGround));
    static_cast<void>(switchRow(ui, "preferences.sunShadow", "Shadows", view.sunShadow));
    ImGui::SameLine(middle);
    static_cast<void>(switchRow(ui, "preferences.bounds", "Bounds", view.boundsBox));
    static_cast<void>(enumRow(ui, "preferences.occlusion", "Shade", view.occlusion, kOcclusions));
    static_cast<void>(enumRow(ui, "preferences.drawBy", "Draw by", view.drawBy, kDrawBys));
    if (view.drawBy != DrawBy::rays) {
        valueRow(ui, "preferences.clusterBudget", "Mesh detail", view.clusterBudgetPx,
                 kClusterBudgets, kClusterBudgetChoices);
    }
    ImGui::Dummy(ui.theme.px(0, 6));
    valueRow(ui, "preferences.history", "Undo memory", window.historyMegabytes, kMemories,
             kMemoryChoices);
}

void Preferences::drawKeys(Ui& ui) {
    const Theme& theme = ui.theme;
    Keymap& keymap = ui.settings.input.keys;
    const ImVec2 reset = theme.px(120, 30);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 6));
    ImGui::SetNextItemWidth(-reset.x - theme.px(8));
    ImGui::InputTextWithHint("##search", "Search commands and keys", search_.data(),
                             search_.size());
    ImGui::PopStyleVar();
    ui.probe.markItem("preferences.search");
    ImGui::SameLine();
    if (ImGui::Button("Reset all", reset)) keymap.clear();
    tooltip(ui, "Give every command its default keys");
    ImGui::Dummy(theme.px(0, 2));

    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, theme.px(6, 4));
    ImGui::BeginChild("keys");
    MenuId menu = MenuId::none;
    for (const Command* command : commandsWithKey(search_.data(), keymap)) {
        if (command->menu != menu) {
            menu = command->menu;
            ImGui::Dummy(theme.px(0, 2));
            ImGui::PushFont(theme.fonts.bold);
            ImGui::TextUnformatted(titleOf(menu));
            ImGui::PopFont();
        }
        drawKeyRow(ui, *command);
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void Preferences::drawKeyRow(Ui& ui, const Command& command) {
    const Theme& theme = ui.theme;
    Keymap& keymap = ui.settings.input.keys;
    ImGui::PushID(command.tag);
    const float chip = theme.px(120), square = theme.px(26), gap = theme.px(6);
    const float keysX = ImGui::GetContentRegionAvail().x - 2 * chip - 2 * gap - square;
    const float left = ImGui::GetCursorPosX();
    const std::string others = conflictText(command, keymap);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, others.empty() ? theme.textDim : theme.danger);
    ImGui::TextUnformatted(*command.icon != '\0' ? command.icon : " ");
    ImGui::SameLine(left + theme.px(28));
    ImGui::TextUnformatted(command.name);
    ImGui::PopStyleColor();
    if (!others.empty()) tooltip(ui, others.c_str());
    for (const std::size_t slot : {0u, 1u}) {
        ImGui::SameLine(left + keysX + static_cast<float>(slot) * (chip + gap));
        drawChord(ui, command, slot, chip);
        if (!others.empty()) tooltip(ui, others.c_str());
    }
    if (keymap.contains(std::string_view(command.tag))) {
        ImGui::SameLine(left + keysX + 2 * (chip + gap));
        if (iconButton(ui, "reset", icon::kReset, Lit::off, square, "Back to the default keys")) {
            keymap.erase(command.tag);
        }
    }
    ImGui::PopID();
}

void Preferences::drawChord(Ui& ui, const Command& command, std::size_t slot, float width) {
    const Theme& theme = ui.theme;
    const Keymap& keymap = ui.settings.input.keys;
    const Chord& chord = chordsOf(command, keymap)[slot];
    const bool waits = listening_ && listening_->command == command.id && listening_->slot == slot;
    const bool conflict = !conflictsOf(command, chord, keymap).empty();
    std::string text = waits ? "Press a key…" : chordText(chord);
    if (waits) ImGui::PushStyleColor(ImGuiCol_Button, theme.accentSoft);
    if (conflict) ImGui::PushStyleColor(ImGuiCol_Text, theme.danger);
    if (conflict && !waits) text = std::string(icon::kWarning) + " " + text;
    text += "##" + std::to_string(slot);
    if (ImGui::Button(text.c_str(), {width, theme.px(26)})) listening_ = {command.id, slot};
    if (conflict) ImGui::PopStyleColor();
    if (waits) ImGui::PopStyleColor();
    ui.probe.markItem(std::string("preferences.key.") + command.tag + (slot == 0 ? "" : ".2"));
    if (!conflict) tooltip(ui, "Click, then press the key. Esc keeps it, Backspace takes it away");
}

void Preferences::listen(Ui& ui) {
    if (!listening_) return;
    const ImGuiIO& io = ImGui::GetIO();
    for (int key = 1; key <= kLastKey; ++key) {
        if (!ImGui::IsKeyPressed(key, false) || !keyName(key) || isModifier(key)) continue;
        const Command& command = commandOf(listening_->command);
        std::array<Chord, 2> chords = chordsOf(command, ui.settings.input.keys);
        const std::string_view name = *keyName(key);
        const bool plain = !io.KeyCtrl && !io.KeyShift && !io.KeyAlt;
        if (!plain || name != "escape") {
            const bool removes = plain && name == "backspace";
            chords[listening_->slot] =
                removes ? Chord{} : Chord{key, io.KeyCtrl, io.KeyShift, io.KeyAlt};
            bindKeys(ui.settings.input.keys, command, chords);
        }
        listening_.reset();
        return;
    }
}

}  // namespace voxprite::editor
