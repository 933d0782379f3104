#include "app/editor/panels/widgets.h"

#include <algorithm>
#include <cmath>

#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr float kLabelWidth = 96.0f;
constexpr float kRowHeight = 24.0f;

ImVec2 operator+(ImVec2 a, ImVec2 b) {
    return {a.x + b.x, a.y + b.y};
}

void finishItem(Ui& ui, const char* name) {
    ui.edits.watchItem(ui.session);
    ui.probe.markItem(name);
}

// All of it, in the colour of text; cut at `end`.
void drawClipped(ImDrawList& draw, ImVec2 at, const std::string& text, ImVec2 end) {
    const ImVec4 clip(at.x, at.y, end.x, std::max(end.y, at.y + ImGui::GetFontSize()));
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, ImGui::GetColorU32(ImGuiCol_Text),
                 text.c_str(), nullptr, 0.0f, &clip);
}

// A number to drag or, on a double click, to type.
bool number(Ui& ui, const char* name, double& value, const Range& range, float width) {
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(width);
    const bool changed =
        ImGui::DragScalar("##number", ImGuiDataType_Double, &value, static_cast<float>(range.speed),
                          &range.min, &range.max, range.format, ImGuiSliderFlags_AlwaysClamp);
    finishItem(ui, name);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::PopID();
    // Typing can make a not-a-number out of what the library parses.
    if (changed && !std::isfinite(value)) value = range.min;
    return changed;
}

}  // namespace

void tooltip(Ui& ui, const char* text) {
    if (text == nullptr || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(10, 7));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.theme.px(6));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ui.theme.px(280));
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar(2);
}

bool section(Ui& ui, const char* title, bool openAtFirst) {
    const Theme& theme = ui.theme;
    ImGui::PushID(title);
    std::vector<std::string>& turned = ui.settings.window.turnedSections;
    const auto place = std::ranges::find(turned, title);
    bool open = openAtFirst == (place == turned.end());
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, theme.px(26));
    if (ImGui::InvisibleButton("heading", size)) {
        open = !open;
        if (place == turned.end()) {
            turned.emplace_back(title);
        } else {
            turned.erase(place);
        }
    }
    ui.probe.markItem(std::string("section.") + title);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 colour = ImGui::IsItemHovered() ? theme.text : theme.textDim;
    const float textY = min.y + std::floor((size.y - theme.fonts.bold->FontSize) * 0.5f);
    draw.AddText(theme.fonts.bold, theme.fonts.bold->FontSize, {min.x, textY}, theme.text, title);
    const char* arrow = open ? icon::kDown : icon::kRight;
    draw.AddText(theme.fonts.text, theme.fonts.text->FontSize,
                 {min.x + size.x - theme.px(18), textY}, colour, arrow);
    ImGui::PopID();
    return open;
}

void rowLabel(Ui& ui, const char* label, const char* hint) {
    const float x = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    tooltip(ui, hint);
    ImGui::SameLine(x + ui.theme.px(kLabelWidth), 0.0f);
}

bool numberRow(Ui& ui, const char* name, const char* label, double& value, const Range& range,
               const char* hint) {
    rowLabel(ui, label, hint);
    return number(ui, name, value, range, ImGui::GetContentRegionAvail().x);
}

bool vectorRow(Ui& ui, const char* name, const char* label, glm::dvec3& value, const Range& range,
               const char* hint, bool axisColours) {
    constexpr ImU32 kAxis[3] = {IM_COL32(214, 92, 92, 255), IM_COL32(116, 176, 92, 255),
                                IM_COL32(88, 138, 220, 255)};
    constexpr const char* kSuffix[3] = {".x", ".y", ".z"};
    rowLabel(ui, label, hint);
    const float gap = ui.theme.px(4);
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3.0f);
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) ImGui::SameLine(0.0f, gap);
        const std::string full = std::string(name) + kSuffix[axis];
        changed = number(ui, full.c_str(), value[axis], range, width) || changed;
        if (!axisColours) continue;
        const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled({min.x, max.y - ui.theme.px(2)}, max, kAxis[axis],
                                                  ui.theme.px(2), ImDrawFlags_RoundCornersBottom);
    }
    return changed;
}

double snapSigma(double sigma) {
    if (sigma < 1.0) return std::exp2(std::round(std::log2(sigma)));
    return std::round(sigma * 4.0) / 4.0;
}

bool logSliderRow(Ui& ui, const char* name, const char* label, double& value, double min,
                  double max, double (*snap)(double), const char* hint, const Range& typed) {
    const Theme& theme = ui.theme;
    rowLabel(ui, label, hint);
    const float numberWidth = theme.px(56), gap = theme.px(8);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x - numberWidth - gap, theme.px(kRowHeight));
    ImGui::PushID(name);
    ImGui::InvisibleButton("slider", size);
    finishItem(ui, name);
    ImGui::PopID();
    const float knob = theme.px(7);
    const float left = corner.x + knob, width = size.x - 2 * knob;
    const double octaves = std::log2(max / min);
    bool changed = false;
    if (ImGui::IsItemActive()) {
        const double share = std::clamp((ImGui::GetIO().MousePos.x - left) / width, 0.0f, 1.0f);
        const double wanted = snap(min * std::exp2(share * octaves));
        changed = wanted != value;
        value = wanted;
    }
    const bool lit = ImGui::IsItemActive() || ImGui::IsItemHovered();
    const auto share = static_cast<float>(
        std::clamp(std::log2(std::clamp(value, min, max) / min) / octaves, 0.0, 1.0));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float y = corner.y + size.y * 0.5f, thick = theme.px(2);
    const float x = left + share * width;
    draw.AddRectFilled({left, y - thick}, {left + width, y + thick}, theme.field, thick);
    draw.AddRectFilled({left, y - thick}, {x, y + thick}, theme.accent, thick);
    for (int octave = 1; octave < static_cast<int>(octaves); ++octave) {
        const float tick = std::round(left + width * static_cast<float>(octave / octaves));
        const float down = y + theme.px(6);
        draw.AddLine({tick, down}, {tick, down + theme.px(3)}, theme.textFaint, theme.px(1));
    }
    draw.AddCircleFilled({x, y}, knob, lit ? theme.text : theme.accent);
    draw.AddCircleFilled({x, y}, knob - theme.px(2), theme.accent);

    ImGui::SameLine(0.0f, gap);
    const std::string field = std::string(name) + ".value";
    return number(ui, field.c_str(), value, typed, numberWidth) || changed;
}

bool switchRow(Ui& ui, const char* name, const char* label, bool& value, const char* hint) {
    const Theme& theme = ui.theme;
    rowLabel(ui, label, hint);
    const ImVec2 size = theme.px(30, 16);
    const ImVec2 corner = ImGui::GetCursorScreenPos() + ImVec2(0, theme.px(4));
    ImGui::PushID(name);
    const bool changed = ImGui::InvisibleButton("switch", {size.x, theme.px(kRowHeight)});
    finishItem(ui, name);
    ImGui::PopID();
    if (changed) value = !value;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float radius = size.y * 0.5f;
    const ImU32 off = ImGui::IsItemHovered() ? theme.fieldActive : theme.fieldHovered;
    draw.AddRectFilled(corner, corner + size, value ? theme.accent : off, radius);
    draw.AddCircleFilled({corner.x + (value ? size.x - radius : radius), corner.y + radius},
                         radius - theme.px(2), value ? theme.onAccent : theme.text);
    return changed;
}

bool choiceRow(Ui& ui, const char* name, const char* label, int& value,
               std::span<const Choice> choices) {
    const Theme& theme = ui.theme;
    if (label != nullptr) rowLabel(ui, label);
    const auto count = static_cast<float>(choices.size());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float full = ImGui::GetContentRegionAvail().x, height = theme.px(kRowHeight);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, corner + ImVec2(full, height), theme.field, theme.px(4));
    bool changed = false;
    ImGui::PushID(name);
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) {
        const auto index = static_cast<float>(i);
        const float x0 = std::round(full * index / count);
        const float x1 = std::round(full * (index + 1.0f) / count);
        const Choice& choice = choices[static_cast<std::size_t>(i)];
        ImGui::SetCursorScreenPos(corner + ImVec2(x0, 0));
        ImGui::PushID(i);
        if (ImGui::InvisibleButton("choice", {x1 - x0, height}) && value != i) {
            value = i;
            changed = true;
        }
        finishItem(ui, (std::string(name) + "." + std::to_string(i)).c_str());
        tooltip(ui, choice.hint);
        ImGui::PopID();
        const bool chosen = value == i;
        if (chosen) {
            const float inset = theme.px(2);
            draw.AddRectFilled(corner + ImVec2(x0 + inset, inset),
                               corner + ImVec2(x1 - inset, height - inset), theme.accentSoft,
                               theme.px(3));
        }
        const ImVec2 text = ImGui::CalcTextSize(choice.label);
        const ImVec2 at(std::round(x0 + (x1 - x0 - text.x) * 0.5f),
                        std::round((height - text.y) * 0.5f));
        const bool hovered = ImGui::IsItemHovered();
        draw.AddText(corner + at,
                     chosen    ? theme.accent
                     : hovered ? theme.text
                               : theme.textDim,
                     choice.label);
    }
    ImGui::PopID();
    return changed;
}

void readoutRow(Ui& ui, const char* label, const std::string& text, const char* hint) {
    rowLabel(ui, label, hint);
    ImGui::TextUnformatted(text.c_str());
}

bool iconButton(Ui& ui, const char* name, const char* icon, Lit lit, float sizePx,
                const char* tooltipText, ImFont* font) {
    const Theme& theme = ui.theme;
    if (font == nullptr) font = theme.fonts.text;
    ImGui::PushID(name);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("icon", {sizePx, sizePx});
    ui.probe.markItem(name);
    tooltip(ui, tooltipText);
    ImGui::PopID();
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (lit == Lit::filled || hovered) {
        draw.AddRectFilled(corner, corner + ImVec2(sizePx, sizePx),
                           lit == Lit::filled ? theme.accentSoft : theme.fieldHovered, theme.px(6));
    }
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, icon);
    const ImVec2 at(std::round((sizePx - size.x) * 0.5f), std::round((sizePx - size.y) * 0.5f));
    const ImU32 colour =
        lit == Lit::off ? ImGui::GetColorU32(ImGuiCol_Text) : ImGui::GetColorU32(theme.accent);
    draw.AddText(font, font->FontSize, corner + at, colour, icon);
    return pressed;
}

void commandButton(Ui& ui, CommandId id, Lit lit, float sizePx, ImFont* font) {
    const Command& command = commandOf(id);
    const std::string text = nameWithKey(id, ui.settings.input.keys);
    const std::string name = std::string("command.") + command.tag;
    if (iconButton(ui, name.c_str(), command.icon, lit, sizePx, text.c_str(), font)) {
        ui.commands.ask(id);
    }
}

bool primaryButton(Ui& ui, const char* label, ImVec2 size) {
    const Theme& theme = ui.theme;
    ImGui::PushStyleColor(ImGuiCol_Button, theme.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, withAlpha(theme.accent, 0.88f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, withAlpha(theme.accent, 0.75f));
    ImGui::PushStyleColor(ImGuiCol_Text, theme.onAccent);
    const bool pressed = ImGui::Button(label, size);
    ImGui::PopStyleColor(4);
    return pressed;
}

bool textSelectable(const std::string& text, bool on, ImVec2 size, ImGuiSelectableFlags flags) {
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str()), corner = ImGui::GetCursorScreenPos();
    if (size.x == 0.0f) size.x = std::max(extent.x, ImGui::GetContentRegionAvail().x);
    if (size.y == 0.0f) size.y = extent.y;
    const bool pressed = ImGui::Selectable("##text", on, flags, size);
    const float down = (size.y - extent.y) * ImGui::GetStyle().SelectableTextAlign.y;
    drawClipped(*ImGui::GetWindowDrawList(), corner + ImVec2(0.0f, std::round(down)), text,
                corner + size);
    return pressed;
}

bool textButton(const std::string& text) {
    const ImVec2 corner = ImGui::GetCursorScreenPos(), air = ImGui::GetStyle().FramePadding;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()) + air + air;
    const bool pressed = ImGui::Button("##text", size);
    drawClipped(*ImGui::GetWindowDrawList(), corner + air, text, corner + size);
    return pressed;
}

bool beginTextCombo(const char* id, const std::string& shown) {
    const ImVec2 corner = ImGui::GetCursorScreenPos(), air = ImGui::GetStyle().FramePadding;
    const float height = ImGui::GetFrameHeight();
    const ImVec2 end = corner + ImVec2(ImGui::CalcItemWidth() - height, height);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool open = ImGui::BeginCombo(id, "");
    drawClipped(draw, corner + air, shown, end);
    return open;
}

void nothingFoundText(const Theme& theme) {
    ImGui::SetCursorPos(theme.px(10, 10));
    ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
    ImGui::TextUnformatted("Nothing is called that");
    ImGui::PopStyleColor();
}

}  // namespace voxprite::editor
