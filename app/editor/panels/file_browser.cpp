#include "app/editor/panels/file_browser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"
#include "core/io/svo_set.h"

namespace voxprite::editor {
namespace {

namespace fs = std::filesystem;

constexpr int kMostNotes = 4;

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string sizeText(std::uintmax_t bytes) {
    std::array<char, 32> buffer{};
    const double kib = static_cast<double>(bytes) / 1024.0;
    std::snprintf(buffer.data(), buffer.size(), kib < 1024.0 ? "%.0f KiB" : "%.1f MiB",
                  kib < 1024.0 ? std::max(1.0, kib) : kib / 1024.0);
    return buffer.data();
}

}  // namespace

std::string questionAbout(const std::vector<fs::path>& replaced) {
    constexpr std::size_t kNamed = 3;
    const auto nameOf = [](const fs::path& path) { return path.filename().string(); };
    if (replaced.size() == 1) {
        const std::size_t entities = entitiesAt(replaced[0]);
        const std::string held =
            entities > 1 ? " and holds " + std::to_string(entities) + " models, all of which go"
                         : "";
        return nameOf(replaced[0]) + " exists" + held + ". Press again to replace it";
    }
    if (replaced.size() > kNamed) {
        return nameOf(replaced.back()) + " and " + std::to_string(replaced.size() - 1) +
               " files beside it exist. Press again to replace them";
    }
    std::string names = nameOf(replaced.front());
    for (std::size_t i = 1; i < replaced.size(); ++i) {
        names += (i + 1 == replaced.size() ? " and " : ", ") + nameOf(replaced[i]);
    }
    return names + " exist. Press again to replace them";
}

void FileBrowser::open(Request request) {
    request_ = std::move(request);
    open_ = true;
    name_ = request_.name;
    way_ = 0;
    lossesFor_.reset();
    losses_.clear();
    std::error_code ignored;
    fs::path start = request_.folder;
    if (!fs::is_directory(start, ignored)) start = fs::current_path(ignored);
    enter(fs::absolute(start, ignored));
}

void FileBrowser::enter(const fs::path& folder) {
    folder_ = folder.lexically_normal();
    // What ends in a slash would be the folder above itself.
    if (!folder_.has_filename() && folder_.has_relative_path()) folder_ = folder_.parent_path();
    problem_.clear();
    overwrite_.clear();
    entries_.clear();
    std::error_code failed;
    for (fs::directory_iterator at(folder_, failed), end; !failed && at != end;
         at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (name.empty() || name[0] == '.') continue;
        std::error_code ignored;
        if (at->is_directory(ignored)) {
            entries_.push_back({name, true});
        } else if (std::ranges::find(request_.extensions, lower(at->path().extension().string())) !=
                   request_.extensions.end()) {
            const std::uintmax_t bytes = at->file_size(ignored);
            entries_.push_back({name, false, ignored ? 0 : bytes});
        }
    }
    if (failed) problem_ = failed.message();
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
        if (a.folder != b.folder) return a.folder;
        return lower(a.name) < lower(b.name);
    });
}

void FileBrowser::drawPath(Ui& ui) {
    const Theme& theme = ui.theme;
    const float square = theme.px(26);
    if (iconButton(ui, "browser.up", icon::kUp, Lit::off, square, "The folder above")) {
        enter(folder_.parent_path());
    }
    ImGui::SameLine(0.0f, theme.px(4));
    if (iconButton(ui, "browser.home", icon::kHome, Lit::off, square, "Home")) {
        if (const char* home = std::getenv("HOME")) enter(home);
    }
    ImGui::SameLine(0.0f, theme.px(8));
    // The last parts of the path that fit, each a way back.
    std::vector<fs::path> parts;
    for (fs::path at = folder_; parts.size() < 4; at = at.parent_path()) {
        parts.push_back(at);
        if (at == at.parent_path()) break;
    }
    ImGui::AlignTextToFramePadding();
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        const std::string name = part->filename().empty() ? "/" : part->filename().string();
        ImGui::PushID(part->c_str());
        const bool last = part + 1 == parts.rend();
        ImGui::PushStyleColor(ImGuiCol_Text, last ? theme.text : theme.textDim);
        ImGui::PushStyleColor(ImGuiCol_Button, 0);
        const bool pressed = textButton(name);
        ImGui::PopStyleColor(2);
        ImGui::PopID();
        if (pressed && !last) {
            enter(*part);
            return;
        }
        if (last) break;
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::TextDisabled("%s", icon::kRight);
        ImGui::SameLine(0.0f, 0.0f);
    }
}

void FileBrowser::drawList(Ui& ui, float height, bool& accepted) {
    const Theme& theme = ui.theme;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme.panel);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(6, 6));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, theme.px(2)});
    ImGui::BeginChild("files", {0, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
    std::optional<fs::path> into;
    for (const Entry& entry : entries_) {
        ImGui::PushID(entry.name.c_str());
        const std::string label =
            std::string("  ") + (entry.folder ? icon::kFolder : icon::kFile) + "   " + entry.name;
        ImGui::PushStyleColor(ImGuiCol_Text, entry.folder ? theme.textDim : theme.text);
        ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
        const bool pressed = textSelectable(
            label, !entry.folder && entry.name == name_, {0, theme.px(26)},
            ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
        ui.probe.markItem("browser.entry." + entry.name);
        if (!entry.folder) {
            const std::string size = sizeText(entry.bytes);
            const ImVec2 max = ImGui::GetItemRectMax(), min = ImGui::GetItemRectMin();
            const ImVec2 text = ImGui::CalcTextSize(size.c_str());
            ImGui::GetWindowDrawList()->AddText(
                {max.x - text.x - theme.px(8), std::round((min.y + max.y - text.y) * 0.5f)},
                theme.textFaint, size.c_str());
        }
        if (pressed) {
            const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
            if (entry.folder) {
                into = folder_ / entry.name;
            } else {
                name_ = entry.name;
                problem_.clear();
                overwrite_.clear();
                accepted = accepted || twice;
            }
        }
        ImGui::PopID();
    }
    if (entries_.empty()) ImGui::TextDisabled("  Nothing here");
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    if (into) enter(*into);
}

std::string FileBrowser::endingFor(const fs::path& path) const {
    const std::string extension = lower(path.extension().string());
    const bool known =
        std::ranges::find(request_.extensions, extension) != request_.extensions.end();
    return known || request_.extensions.empty() ? extension : request_.extensions.front();
}

std::optional<fs::path> FileBrowser::accept() {
    if (name_.empty()) {
        problem_ = request_.saving ? "The file needs a name" : "Choose a file";
        return std::nullopt;
    }
    fs::path path = folder_ / name_;
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        name_.clear();
        enter(path);
        return std::nullopt;
    }
    if (!request_.saving) {
        if (fs::exists(path, ignored)) return path;
        problem_ = "There is no such file";
        return std::nullopt;
    }
    if (lower(path.extension().string()) != endingFor(path)) path += request_.extensions.front();
    const std::vector<fs::path> replaced = replacedBy(path);
    if (!replaced.empty() && overwrite_ != path.string()) {
        overwrite_ = path.string();
        problem_ = questionAbout(replaced);
        return std::nullopt;
    }
    return path;
}

std::vector<fs::path> FileBrowser::replacedBy(const fs::path& path) const {
    if (request_.replaced) return request_.replaced(path);
    std::error_code ignored;
    if (fs::exists(path, ignored)) return {path};
    return {};
}

void FileBrowser::findLosses() {
    const std::string extension = endingFor(name_);
    if (!request_.losses || lossesFor_ == extension) return;
    losses_ = request_.losses("model" + extension);
    lossesFor_ = extension;
}

int FileBrowser::noteLines() const {
    if (!problem_.empty()) {
        const float wrap = ImGui::GetContentRegionAvail().x;
        const float height = ImGui::CalcTextSize(problem_.c_str(), nullptr, false, wrap).y;
        return static_cast<int>(std::round(height / ImGui::GetTextLineHeight()));
    }
    return std::clamp(static_cast<int>(losses_.size()), 1, kMostNotes);
}

void FileBrowser::drawNote(Ui& ui) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
    if (!problem_.empty() || losses_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.danger);
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextUnformatted(problem_.c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
    } else {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
        const int lines = noteLines();
        const int all = static_cast<int>(losses_.size());
        for (int k = 0; k < lines; ++k) {
            const bool last = k + 1 == lines && all > lines;
            const std::string text =
                last ? "and " + std::to_string(all - k) + " more things are left out"
                     : losses_[static_cast<std::size_t>(k)];
            ImGui::TextUnformatted((std::string(icon::kWarning) + "  " + text).c_str());
        }
        ImGui::PopStyleColor();
    }
    ImGui::PopStyleVar();
    ImGui::EndGroup();
    ui.probe.mark("browser.note", corner, ImGui::GetItemRectMax());
    if (!problem_.empty() || losses_.empty() || !ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    for (const std::string& loss : losses_) ImGui::TextUnformatted(loss.c_str());
    ImGui::EndTooltip();
}

void FileBrowser::drawFormats(Ui& ui, float width) {
    const std::string chosen = endingFor(name_);
    const auto labelOf = [&](const std::string& ending) {
        return request_.formatName(ending) + "  " + ending;
    };
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##format", labelOf(chosen).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const std::string& ending : request_.extensions) {
            if (ImGui::Selectable(labelOf(ending).c_str(), ending == chosen)) {
                // The ending that the name has gives way, if it is one of a format.
                fs::path name(name_);
                const std::string now = lower(name.extension().string());
                if (std::ranges::find(request_.extensions, now) != request_.extensions.end()) {
                    name.replace_extension();
                }
                name_ = name.string() + ending;
                problem_.clear();
                overwrite_.clear();
            }
            ui.probe.markItem("browser.format" + ending);
        }
        ImGui::EndCombo();
    }
    ui.probe.markItem("browser.formats");
}

void FileBrowser::drawWays(Ui& ui, float width) {
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##way", request_.ways[way_].c_str())) {
        for (std::size_t way = 0; way < request_.ways.size(); ++way) {
            if (ImGui::Selectable(request_.ways[way].c_str(), way == way_)) {
                way_ = way;
                lossesFor_.reset();
            }
            ui.probe.markItem("browser.way." + std::to_string(way));
        }
        ImGui::EndCombo();
    }
    ui.probe.markItem("browser.ways");
}

void FileBrowser::drawFooter(Ui& ui, bool& accepted) {
    const Theme& theme = ui.theme;
    const ImVec2 button(theme.px(96), theme.px(30));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 7));
    const bool choosesWay = request_.ways.size() > 1;
    const float formats = choosesFormat() || choosesWay ? theme.px(208) : 0.0f;
    const float beside =
        2 * (button.x + theme.px(8)) + (formats > 0.0f ? formats + theme.px(8) : 0.0f);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - beside);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint(
            "##name", "File name", &name_,
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
        accepted = true;
    }
    if (ImGui::IsItemEdited()) problem_.clear();
    ui.probe.markItem("browser.name");
    if (formats > 0.0f) {
        ImGui::SameLine(0.0f, theme.px(8));
        if (choosesWay) {
            drawWays(ui, formats);
        } else {
            drawFormats(ui, formats);
        }
    }
    ImGui::PopStyleVar();
    ImGui::SameLine(0.0f, theme.px(8));
    if (ImGui::Button("Cancel", button)) open_ = false;
    ui.probe.markItem("browser.cancel");
    ImGui::SameLine(0.0f, theme.px(8));
    if (primaryButton(ui, request_.button.c_str(), button)) accepted = true;
    ui.probe.markItem("browser.accept");
}

std::optional<fs::path> FileBrowser::draw(Ui& ui) {
    if (!open_) return std::nullopt;
    const Theme& theme = ui.theme;
    constexpr const char* kId = "##browser";
    if (!ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(theme.px(720), display.x - theme.px(32)),
                      std::min(theme.px(520), display.y - theme.px(32)));
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowPos(
        {std::round((display.x - size.x) * 0.5f), std::round((display.y - size.y) * 0.5f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(20, 18));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(10));
    std::optional<fs::path> chosen;
    if (ImGui::BeginPopupModal(
            kId, nullptr,
            ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
        ImGui::PushFont(theme.fonts.bold);
        ImGui::TextUnformatted(request_.title.c_str());
        ImGui::PopFont();
        ImGui::Dummy(theme.px(0, 2));
        drawPath(ui);
        bool accepted = false;
        findLosses();
        const float line = ImGui::GetTextLineHeight();
        const float below = theme.px(30 + 14 + 20) + line * static_cast<float>(noteLines() - 1);
        drawList(ui, ImGui::GetContentRegionAvail().y - below, accepted);
        drawNote(ui);
        drawFooter(ui, accepted);
        if (accepted) chosen = accept();
        if (chosen || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
            open_ = false;
        }
        if (!open_) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
    return chosen;
}

}  // namespace voxprite::editor
