#include "app/editor/panels/entity_dialog.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/commands/fuzzy.h"
#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/number_text.h"
#include "app/editor/panels/picture_tile.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/views/small_sprite.h"
#include "app/editor/window/icons.h"
#include "core/io/svo_set.h"

namespace voxprite::editor {
namespace {

constexpr float kEntityDialogWidth = 560.0f, kEntityRow = 64.0f, kEntityTile = 56.0f;
constexpr int kEntityTilePx = 48;  // what the tile has room for at content scale 1
constexpr std::size_t kEntityRows = 6;

std::string figuresText(const EntityFigures& figures) {
    const glm::ivec3 size = figures.size;
    std::string text = std::to_string(size.x) + " × " + std::to_string(size.y) + " × " +
                       std::to_string(size.z) + "   ·   " + grouped(figures.voxels) +
                       (figures.voxels == 1 ? " voxel" : " voxels");
    if (figures.frames > 1) text += "   ·   " + grouped(figures.frames) + " frames";
    return text;
}

bool repeats(ImGuiKey_ key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace

void EntityDialog::open(std::filesystem::path file, std::vector<SvoFile> set, Asks asks) {
    close();
    file_ = std::move(file);
    set_ = std::move(set);
    asks_ = asks;
    moved_ = true;
    for (std::size_t index = 0; index < set_.size(); ++index) {
        Row& row = rows_.emplace_back();
        row.index = index;
        row.name = set_[index].name;
        if (row.name.empty()) row.name = "Number " + std::to_string(index);
        found_.push_back(index);
    }
}

void EntityDialog::close() {
    set_.clear();
    rows_.clear();
    found_.clear();
    search_.clear();
    chosen_ = 0;
}

std::size_t EntityDialog::ticked() const {
    return static_cast<std::size_t>(std::ranges::count(rows_, true, &Row::ticked));
}

std::string EntityDialog::said() const {
    const std::string name = found_.empty() ? std::string() : rows_[found_[chosen_]].name;
    return asks_ == Asks::one ? name : name + ", " + std::to_string(ticked()) + " ticked";
}

EntityDialog::Answer EntityDialog::answer() {
    Answer answer{file_, asks_, {}};
    const auto add = [&](const Row& row) {
        answer.entities.push_back({row.index, set_[row.index].name});
    };
    if (asks_ == Asks::one) {
        add(rows_[found_[chosen_]]);
    } else {
        for (const Row& row : rows_) {
            if (row.ticked) add(row);
        }
    }
    return answer;
}

void EntityDialog::see(const Ui& ui, Row& row) {
    if (!row.figures.empty()) return;
    const SvoFile& entity = set_[row.index];
    const EntityFigures figures = figuresOf(entity);
    row.figures = figuresText(figures);
    const Octree& octree = entity.models[figures.firstModel].octree;
    Palette palette;
    palette.colours = entity.palette;
    const IBox bounds{octree.origin, octree.origin + octree.size};
    const auto sprite = smallSprite(
        {octree.view(), bounds, Entity{}, ui.session.profile(), palette}, kEntityTilePx);
    row.picture.set(sprite ? sprite->image() : Image{});
}

void EntityDialog::drawSearch(Ui& ui) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ui.theme.px(10, 7));
    ImGui::SetNextItemWidth(-1.0f);
    const std::string hint = std::string(icon::kSearch) + "  Find by name";
    if (ImGui::InputTextWithHint("##search", hint.c_str(), &search_)) {
        found_.clear();
        chosen_ = 0;
        moved_ = true;
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            if (search_.empty() || fuzzyMatch(search_, rows_[row].name)) found_.push_back(row);
        }
    }
    ImGui::PopStyleVar();
    ui.probe.markItem("entities.search");
}

void EntityDialog::moveByKeys() {
    const std::size_t before = chosen_, last = found_.size() - 1;
    if (repeats(ImGuiKey_DownArrow)) chosen_ = std::min(chosen_ + 1, last);
    if (repeats(ImGuiKey_UpArrow)) chosen_ -= std::min<std::size_t>(chosen_, 1);
    if (repeats(ImGuiKey_PageDown)) chosen_ = std::min(chosen_ + kEntityRows, last);
    if (repeats(ImGuiKey_PageUp)) chosen_ -= std::min(chosen_, kEntityRows);
    // In a text these keys belong to it.
    if (!ImGui::GetIO().WantTextInput) {
        if (repeats(ImGuiKey_Home)) chosen_ = 0;
        if (repeats(ImGuiKey_End)) chosen_ = last;
        Row& row = rows_[found_[chosen_]];
        if (asks_ == Asks::some && pressedKey(ImGuiKey_Space)) row.ticked = !row.ticked;
    }
    moved_ = moved_ || chosen_ != before;
}

void EntityDialog::drawRow(Ui& ui, Row& row, ImVec2 corner, ImVec2 size) {
    const Theme& theme = ui.theme;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float air = std::round((size.y - theme.px(kEntityTile)) * 0.5f);
    float x = corner.x + air;
    if (asks_ == Asks::some) {
        const float box = theme.px(18);
        const ImVec2 at(x + theme.px(6), std::round(corner.y + (size.y - box) * 0.5f));
        const ImVec2 max(at.x + box, at.y + box);
        draw.AddRectFilled(at, max, row.ticked ? theme.accent : theme.field, theme.px(4));
        if (row.ticked) {
            const ImVec2 tick = ImGui::CalcTextSize(icon::kCheck);
            draw.AddText({std::round(at.x + (box - tick.x) * 0.5f),
                          std::round(at.y + (box - tick.y) * 0.5f)},
                         theme.onAccent, icon::kCheck);
        } else {
            draw.AddRect(at, max, theme.textFaint, theme.px(4));
        }
        x = max.x + theme.px(12);
    }
    drawPictureTile(theme, {x, corner.y + air}, theme.px(kEntityTile), row.picture);
    x += theme.px(kEntityTile + 14);
    const float lines = theme.fonts.text->FontSize + theme.fonts.small->FontSize + theme.px(4);
    const float y = std::round(corner.y + (size.y - lines) * 0.5f);
    const ImVec4 clip(corner.x, corner.y, corner.x + size.x - theme.px(8), corner.y + size.y);
    const bool on = asks_ == Asks::one || row.ticked;
    draw.AddText(theme.fonts.text, theme.fonts.text->FontSize, {x, y},
                 on ? theme.text : theme.textDim, row.name.c_str(), nullptr, 0.0f, &clip);
    draw.AddText(theme.fonts.small, theme.fonts.small->FontSize,
                 {x, y + theme.fonts.text->FontSize + theme.px(4)}, theme.textDim,
                 row.figures.c_str(), nullptr, 0.0f, &clip);
}

bool EntityDialog::drawList(Ui& ui) {
    const Theme& theme = ui.theme;
    bool twice = false;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const auto shown = static_cast<float>(std::min(rows_.size(), kEntityRows));
    ImGui::BeginChild("entities", {0.0f, shown * theme.px(kEntityRow)});
    for (std::size_t k = 0; k < found_.size(); ++k) {
        Row& row = rows_[found_[k]];
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 size(ImGui::GetContentRegionAvail().x, theme.px(kEntityRow));
        const ImVec2 max(corner.x + size.x, corner.y + size.y);
        ImGui::PushID(static_cast<int>(row.index));
        if (ImGui::InvisibleButton("row", size)) {
            chosen_ = k;
            if (asks_ == Asks::some) row.ticked = !row.ticked;
        }
        ImGui::PopID();
        const bool hovered = ImGui::IsItemHovered();
        twice = twice || (asks_ == Asks::one && hovered && k == chosen_ &&
                          ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
        if (moved_ && k == chosen_) ImGui::SetScrollHereY();
        if (!ImGui::IsRectVisible(corner, max)) continue;
        ui.probe.mark("entities.row." + std::to_string(row.index), corner, max);
        see(ui, row);
        if (k == chosen_ || hovered) {
            ImGui::GetWindowDrawList()->AddRectFilled(
                corner, max, k == chosen_ ? theme.accentSoft : theme.fieldHovered, theme.px(6));
        }
        drawRow(ui, row, corner, size);
    }
    if (found_.empty()) nothingFoundText(theme);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    moved_ = false;
    return twice;
}

void EntityDialog::drawTicking(Ui& ui, ImVec2 button) {
    const float y = ImGui::GetCursorPosY(), x = ImGui::GetCursorPosX();
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMin().x);
    const auto tickAll = [&](bool tick) {
        for (const std::size_t row : found_) rows_[row].ticked = tick;
    };
    if (ImGui::Button("All", button)) tickAll(true);
    ui.probe.markItem("entities.all");
    ImGui::SameLine();
    if (ImGui::Button("None", button)) tickAll(false);
    ui.probe.markItem("entities.none");
    ImGui::SetCursorPos({x, y});
}

bool EntityDialog::drawFooter(Ui& ui, bool listens) {
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 2);
    if (asks_ == Asks::some) drawTicking(ui, ui.theme.px(72, 30));
    if (ImGui::Button("Cancel", button) || pressedKey(ImGuiKey_Escape)) close();
    ui.probe.markItem("entities.cancel");
    ImGui::SameLine();
    const std::size_t count =
        asks_ == Asks::some ? ticked() : std::min<std::size_t>(found_.size(), 1);
    const std::string label =
        asks_ == Asks::one ? std::string("Open") : "Add " + grouped(count) + "###add";
    ImGui::BeginDisabled(count == 0);
    const bool pressed = primaryButton(ui, label.c_str(), button);
    ImGui::EndDisabled();
    ui.probe.markItem("entities.accept");
    return isOpen() && count > 0 && (pressed || (listens && pressedEnter()));
}

std::optional<EntityDialog::Answer> EntityDialog::draw(Ui& ui) {
    if (!isOpen()) return std::nullopt;
    const char* title = asks_ == Asks::one ? "Open which one?" : "Add which ones?";
    if (!beginDialog(ui, "##entities", title, kEntityDialogWidth)) return std::nullopt;
    // The Enter that chose the file does not answer this, too.
    const bool listens = !ImGui::IsWindowAppearing();
    std::string text =
        file_.filename().string() + " holds " + grouped(rows_.size()) + " models for the game.";
    if (asks_ == Asks::one)
        text += " Each opens as a document of its own; the file stays as it is.";
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ImGui::Dummy(ui.theme.px(0, 2));
    if (rows_.size() > kEntityRows) drawSearch(ui);
    if (!found_.empty()) moveByKeys();
    const bool twice = drawList(ui);
    std::optional<Answer> chosen;
    if (drawFooter(ui, listens) || twice) {
        chosen = answer();
        close();
    }
    if (!isOpen()) ImGui::CloseCurrentPopup();
    endDialog();
    return chosen;
}

}  // namespace voxprite::editor
