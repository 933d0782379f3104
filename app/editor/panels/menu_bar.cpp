#include <algorithm>
#include <cmath>

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

// Before every entry, so that names stand in one column whether they have an icon or not.
constexpr const char* kIconSpace = "        ";

void item(Ui& ui, const Command& command) {
    const std::string label = kIconSpace + std::string(command.name);
    const std::string keys = chordText(chordsOf(command, ui.settings.input.keys)[0]);
    if (ImGui::MenuItem(label.c_str(), keys.c_str(), isOn(command.id, ui.context),
                        isEnabled(command.id, ui.context))) {
        ui.commands.ask(command.id);
    }
    ui.probe.markItem(std::string("menu.") + command.tag);
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const float y = std::round((min.y + max.y - ImGui::GetFontSize()) * 0.5f);
    ImGui::GetWindowDrawList()->AddText({min.x + ui.theme.px(8), y},
                                        ImGui::GetColorU32(ImGuiCol_Text), command.icon);
}

std::optional<std::filesystem::path> recentFiles(Ui& ui) {
    std::optional<std::filesystem::path> chosen;
    const auto& recent = ui.settings.window.recent;
    if (!ImGui::BeginMenu((kIconSpace + std::string("Open recent")).c_str(), !recent.empty()))
        return chosen;
    for (const std::filesystem::path& file : recent) {
        ImGui::PushID(file.c_str());
        if (textSelectable(file.filename().string(), false)) chosen = file;
        tooltip(ui, file.c_str());
        ImGui::PopID();
    }
    ImGui::EndMenu();
    return chosen;
}

// The entries of a menu; a recent file, if one was chosen there.
std::optional<std::filesystem::path> menuOf(Ui& ui, MenuId menu) {
    std::optional<std::filesystem::path> chosen;
    std::string_view group;
    bool unfolded = true;  // the group
    const auto endGroup = [&] {
        if (!group.empty() && unfolded) ImGui::EndMenu();
        group = {};
        unfolded = true;
    };
    for (const Command& command : commands()) {
        if (command.menu != menu) continue;
        if (command.group != group) {
            endGroup();
            if (command.separator) ImGui::Separator();
            group = command.group;
            if (!group.empty()) {
                unfolded = ImGui::BeginMenu((kIconSpace + std::string(group)).c_str());
                if (!unfolded) ui.probe.markItem("menu." + std::string(group));
            }
        } else if (command.separator && unfolded) {
            ImGui::Separator();
        }
        if (unfolded) item(ui, command);
        if (command.id != CommandId::open) continue;
        if (auto file = recentFiles(ui)) chosen = file;
    }
    endGroup();
    if (pressedKey(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    return chosen;
}

// The document's name in the middle; a dot while it is not saved.
void documentName(Ui& ui) {
    const std::string name = ui.session.title() + (ui.session.unsaved() ? "  •" : "");
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    const float middle = std::round((ImGui::GetWindowWidth() - width) * 0.5f);
    ImGui::SameLine(std::max(middle, ImGui::GetCursorPosX() + ui.theme.px(16)), 0.0f);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopStyleColor();
    ui.probe.markItem("menu.document");
    if (ui.session.path()) tooltip(ui, ui.session.path()->c_str());
}

}  // namespace

std::optional<std::filesystem::path> drawMenuBar(Ui& ui) {
    struct Entry {
        MenuId id;
        const char* title;
    };
    constexpr Entry kMenus[] = {
        {MenuId::file, "File"},       {MenuId::edit, "Edit"},           {MenuId::select, "Select"},
        {MenuId::object, "Object"},   {MenuId::animation, "Animation"}, {MenuId::tool, "Tools"},
        {MenuId::palette, "Palette"}, {MenuId::view, "View"},           {MenuId::help, "Help"}};
    std::optional<std::filesystem::path> chosen;
    if (!ImGui::BeginMenuBar()) return chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(8, 8));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.theme.px(10, 7));
    for (const Entry& menu : kMenus) {
        const bool open = ImGui::BeginMenu(menu.title);
        if (!open) ui.probe.markItem(std::string("menu.") + menu.title);
        if (!open) continue;
        if (auto file = menuOf(ui, menu.id)) chosen = file;
        ImGui::EndMenu();
    }
    ImGui::PopStyleVar(2);
    documentName(ui);
    ImGui::EndMenuBar();
    return chosen;
}

}  // namespace voxprite::editor
