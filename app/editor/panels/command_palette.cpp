#include "app/editor/panels/command_palette.h"

#include <algorithm>

#include "app/editor/commands/fuzzy.h"
#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

constexpr float kWidth = 560.0f, kRow = 28.0f;
constexpr int kRows = 11;

std::string textOf(const Command& command) {
    return std::string(titleOf(command.menu)) + " " + command.name;
}

// The letters that matched in the accent colour.
void drawName(Ui& ui, ImVec2 at, std::string_view query, const Command& command, ImU32 colour) {
    const auto match = fuzzyMatch(query, command.name);
    const std::string_view name = command.name;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    std::size_t from = 0;
    const auto piece = [&](std::size_t to, ImU32 ink) {
        if (to <= from) return;
        const char* begin = name.data() + from;
        draw.AddText(at, ink, begin, name.data() + to);
        at.x += ImGui::CalcTextSize(begin, name.data() + to).x;
        from = to;
    };
    if (match) {
        for (const std::size_t place : match->places) {
            piece(place, colour);
            piece(place + 1, ui.theme.accent);
        }
    }
    piece(name.size(), colour);
}

}  // namespace

std::vector<const Command*> commandsMatching(std::string_view query) {
    std::vector<std::pair<int, const Command*>> found;
    for (const Command& command : commands()) {
        // By its menu a command is found, too, but its own name comes first.
        const auto byName = fuzzyMatch(query, command.name);
        const auto byAll = fuzzyMatch(query, textOf(command));
        if (byName) {
            found.emplace_back(byName->score + 100, &command);
        } else if (byAll) {
            found.emplace_back(byAll->score, &command);
        }
    }
    if (!query.empty()) {
        std::ranges::stable_sort(found, std::ranges::greater(),
                                 [](const auto& f) { return f.first; });
        // Beside what has the letters together, those that merely have them somewhere are noise.
        const int least = found.empty() ? 0 : found.front().first / 2;
        std::erase_if(found, [&](const auto& f) { return f.first < least; });
    }
    std::vector<const Command*> sorted;
    sorted.reserve(found.size());
    for (const auto& [score, command] : found) sorted.push_back(command);
    return sorted;
}

void CommandPalette::open() {
    open_ = true;
    query_ = {};
    chosen_ = 0;
}

void CommandPalette::draw(Ui& ui) {
    if (!open_) return;
    const Theme& theme = ui.theme;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (!ImGui::IsPopupOpen("##palette")) ImGui::OpenPopup("##palette");
    ImGui::SetNextWindowPos({std::round(display.x * 0.5f), theme.px(72)}, ImGuiCond_Always,
                            {0.5f, 0.0f});
    ImGui::SetNextWindowSize({std::min(theme.px(kWidth), display.x - theme.px(32)), 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(10, 10));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, theme.px(6, 6));
    // Modal, so that a click beside it is no edit; without the veil of a question.
    ImGui::PushStyleColor(ImGuiCol_ModalWindowDimBg, ImVec4(0, 0, 0, 0.2f));
    if (ImGui::BeginPopupModal(
            "##palette", nullptr,
            ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav)) {
        drawList(ui);
        const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                            !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
        if (pressedKey(ImGuiKey_Escape) || (beside && !ImGui::IsWindowAppearing())) open_ = false;
        if (!open_) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

void CommandPalette::drawList(Ui& ui) {
    const Theme& theme = ui.theme;
    const bool appearing = ImGui::IsWindowAppearing();
    if (appearing) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 8));
    ImGui::SetNextItemWidth(-1.0f);
    const bool typed = ImGui::InputTextWithHint("##query", "What do you want to do?", query_.data(),
                                                query_.size());
    if (typed) chosen_ = 0;
    ImGui::PopStyleVar();
    ui.probe.markItem("palette.query");

    const std::string_view query(query_.data());
    const std::vector<const Command*> found = commandsMatching(query);
    const int count = static_cast<int>(found.size());
    const auto repeats = [](ImGuiKey_ key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const int before = chosen_;
    if (repeats(ImGuiKey_DownArrow)) ++chosen_;
    if (repeats(ImGuiKey_UpArrow)) --chosen_;
    if (repeats(ImGuiKey_PageDown)) chosen_ += kRows;
    if (repeats(ImGuiKey_PageUp)) chosen_ -= kRows;
    chosen_ = std::clamp(chosen_, 0, std::max(0, count - 1));
    // The pointer chooses what is in sight; all else brings it there.
    const bool follows = appearing || typed || chosen_ != before;
    bool runs = pressedEnter();

    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("list", {0.0f, theme.px(kRow) * static_cast<float>(kRows)});
    for (int i = 0; i < count; ++i) {
        const Command& command = *found[static_cast<std::size_t>(i)];
        const bool enabled = isEnabled(command.id, ui.context);
        const ImVec2 min = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = theme.px(kRow);
        ImGui::PushID(command.tag);
        const bool clicked = ImGui::InvisibleButton("row", {width, height});
        ImGui::PopID();
        ui.probe.markItem(std::string("palette.") + command.tag);
        if (i == chosen_ && follows) ImGui::SetScrollHereY();
        // The pointer chooses only by moving, else it would hold the row under it.
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        if (ImGui::IsItemHovered() && (moved.x != 0.0f || moved.y != 0.0f)) chosen_ = i;
        if (!ImGui::IsRectVisible(min, {min.x + width, min.y + height})) continue;

        ImDrawList& draw = *ImGui::GetWindowDrawList();
        if (i == chosen_) {
            draw.AddRectFilled(min, {min.x + width, min.y + height}, theme.accentSoft, theme.px(5));
        }
        const ImU32 ink = enabled ? theme.text : theme.textFaint;
        const float y = min.y + std::floor((height - ImGui::GetFontSize()) * 0.5f);
        draw.AddText({min.x + theme.px(10), y}, ink, command.icon);
        drawName(ui, {min.x + theme.px(36), y}, query, command, ink);
        const std::string key = chordText(chordsOf(command, ui.settings.input.keys)[0]);
        const float keyWidth = ImGui::CalcTextSize(key.c_str()).x;
        draw.AddText({min.x + width - keyWidth - theme.px(12), y}, theme.textDim, key.c_str());
        const char* menu = titleOf(command.menu);
        const float menuX = min.x + width - theme.px(130) - ImGui::CalcTextSize(menu).x;
        draw.AddText({menuX, y}, theme.textFaint, menu);
        if (clicked) {
            chosen_ = i;
            runs = true;
        }
    }
    if (count == 0) nothingFoundText(theme);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    if (!runs || count == 0) return;
    const Command& command = *found[static_cast<std::size_t>(chosen_)];
    if (!isEnabled(command.id, ui.context)) return;
    ui.commands.ask(command.id);
    open_ = false;
}

}  // namespace voxprite::editor
