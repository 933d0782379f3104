#include "app/editor/panels/tool_options.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/option_bar.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/tools/guides.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

// How much room the bar has for the same parts.
enum class Form : std::uint8_t {
    roomy,   // all there is
    plain,   // without what says the same twice
    narrow,  // small fields
};

constexpr float kSegmentAir = 10.0f, kPartGap = 16.0f;
constexpr float kSlider = 96.0f, kSliderGap = 4.0f, kTipEdge = 44.0f;
constexpr float kFigure = 52.0f, kNarrowFigure = 40.0f;
constexpr float kButtonGap = 2.0f, kHalvesGap = 8.0f;

constexpr std::array<Choice, 3> kTips{Choice{"Cube", "A cube on the face, or biting into it"},
                                      Choice{"Sphere", "A sphere around the voxel"},
                                      Choice{"Disc", "One layer, round, flat on the face"}};
constexpr std::array<Choice, 2> kFills{Choice{"Solid", "Filled"},
                                       Choice{"Hollow", "Only the wall, one voxel thick"}};
constexpr std::array<Choice, 2> kColourRules{
    Choice{"Any colour", "All voxels that touch belong together"},
    Choice{"Same colour", "Only voxels of the colour that was hit belong together"}};
constexpr std::array<Choice, 2> kTouch{Choice{"6", "Voxels touch by their faces"},
                                       Choice{"26", "Voxels touch by edges and corners, too"}};
constexpr std::array<Choice, 2> kSightDepths{
    Choice{"Through", "All voxels that lie behind the rectangle"},
    Choice{"In sight", "Only voxels that can be seen in the rectangle"}};

constexpr std::array<CommandId, 6> kArrange{CommandId::turnVoxelsX, CommandId::turnVoxelsY,
                                            CommandId::turnVoxelsZ, CommandId::flipVoxelsX,
                                            CommandId::flipVoxelsY, CommandId::flipVoxelsZ};

float segmentsWidth(const Ui& ui, std::span<const Choice> choices) {
    float width = 0.0f;
    for (const Choice& choice : choices) {
        width += ImGui::CalcTextSize(choice.label).x + 2 * ui.theme.px(kSegmentAir);
    }
    return width;
}

// One of a few, side by side; as wide as its labels.
bool segments(Ui& ui, const char* name, int& value, std::span<const Choice> choices) {
    const Theme& theme = ui.theme;
    const float pad = theme.px(kSegmentAir), height = theme.px(kOptionHeight), inset = theme.px(2);
    const float width = segmentsWidth(ui, choices);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme.field, theme.px(4));
    bool changed = false;
    float x = corner.x;
    ImGui::PushID(name);
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) {
        const Choice& choice = choices[static_cast<std::size_t>(i)];
        const ImVec2 text = ImGui::CalcTextSize(choice.label);
        const float part = text.x + 2 * pad;
        ImGui::SetCursorScreenPos({x, corner.y});
        ImGui::PushID(i);
        if (ImGui::InvisibleButton("segment", {part, height}) && value != i) {
            value = i;
            changed = true;
        }
        ui.probe.markItem(std::string(name) + "." + std::to_string(i));
        tooltip(ui, choice.hint);
        ImGui::PopID();
        const bool hovered = ImGui::IsItemHovered();
        if (value == i) {
            draw.AddRectFilled({x + inset, corner.y + inset},
                               {x + part - inset, corner.y + height - inset}, theme.accentSoft,
                               theme.px(3));
        }
        draw.AddText({x + pad, corner.y + std::round((height - text.y) * 0.5f)},
                     value == i ? theme.accent
                     : hovered  ? theme.text
                                : theme.textDim,
                     choice.label);
        x += part;
    }
    ImGui::PopID();
    return changed;
}

void drawSize(Ui& ui, ToolOptions& options, bool slider) {
    optionLabel(ui, "Size", "Edge or diameter of the tip in voxels");
    constexpr const char* kHint =
        "Tip in voxels: drag, Ctrl+click to type, or use the keys - and =";
    if (slider) {
        ImGui::SetNextItemWidth(ui.theme.px(kSlider));
        ImGui::SliderInt(
            "##slider", &options.tipEdge, 1, kMaxTipEdge, "",
            ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput);
        ui.probe.markItem("options.size");
        tooltip(ui, kHint);
        ImGui::SameLine(0.0f, ui.theme.px(kSliderGap));
    }
    ImGui::SetNextItemWidth(ui.theme.px(kTipEdge));
    ImGui::DragInt("##size", &options.tipEdge, 0.1f, 1, kMaxTipEdge, "%d",
                   ImGuiSliderFlags_AlwaysClamp);
    ui.probe.markItem("options.size.value");
    tooltip(ui, kHint);
}

// What is done most often to what is selected.
void drawArrange(Ui& ui) {
    for (std::size_t i = 0; i < kArrange.size(); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, ui.theme.px(i == 3 ? kHalvesGap : kButtonGap));
        commandButton(ui, kArrange[i], Lit::off, ui.theme.px(kOptionHeight));
        const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine({min.x + ui.theme.px(4), max.y - ui.theme.px(1)},
                                            {max.x - ui.theme.px(4), max.y - ui.theme.px(1)},
                                            toImU32(kAxisColours[i % 3]), ui.theme.px(2));
    }
}

void drawFigure(Ui& ui, Tool& tool, std::size_t index, const ToolFigure& figure, float width) {
    optionLabel(ui, figure.name);
    int value = figure.value;
    ImGui::PushID(static_cast<int>(index));
    ImGui::SetNextItemWidth(width);
    if (ImGui::DragInt("##figure", &value, 0.2f, figure.min, figure.max, "%d",
                       ImGuiSliderFlags_AlwaysClamp)) {
        tool.setFigure(index, std::clamp(value, figure.min, figure.max));
    }
    ImGui::PopID();
    ui.probe.markItem("options.figure." + std::to_string(index));
    tooltip(ui, "Drag, or double-click to type");
}

void drawAnswer(Ui& ui, ToolAnswer& answer) {
    const float size = ui.theme.px(kOptionHeight);
    if (iconButton(ui, "options.keep", icon::kCheck, Lit::icon, size, "Keep it  (Enter)")) {
        answer = ToolAnswer::keep;
    }
    ImGui::SameLine(0.0f, ui.theme.px(kButtonGap));
    if (iconButton(ui, "options.drop", icon::kClose, Lit::off, size, "Drop it  (Esc)")) {
        answer = ToolAnswer::drop;
    }
}

// The parts of the bar for the tool in hand. What they refer to outlives them.
class ToolParts {
  public:
    ToolParts(Ui& ui, Tool* tool, ToolAnswer& answer, Form form)
        : ui_(ui), options_(ui.settings.tool.options), form_(form) {
        addOptions(ui.settings.tool.tool);
        if (tool != nullptr) addFigures(*tool, answer);
        if (ToolSettings::isForSelection(ui.settings.tool.tool)) {
            addSelection(tool != nullptr && tool->busy());
        }
        const std::vector<OptionPart> guides = guideParts(ui, options_);
        parts.insert(parts.end(), guides.begin(), guides.end());
    }
    std::vector<OptionPart> parts;

  private:
    // What gives way first, after the guides.
    enum Worth : std::uint8_t { said = 3, arrange, option, size, figures, answers = 100 };

    void add(int worth, float width, std::function<void()> draw) {
        parts.push_back({.worth = worth,
                         .width = width,
                         .behind = ui_.theme.px(kPartGap),
                         .draw = std::move(draw)});
    }
    template <class Value>
    void addChoice(const char* name, Value& value, std::span<const Choice> choices) {
        add(option, segmentsWidth(ui_, choices), [&ui = ui_, name, &value, choices] {
            int index = static_cast<int>(value);
            if (segments(ui, name, index, choices)) value = static_cast<Value>(index);
        });
    }
    void addOptions(ToolKind tool) {
        switch (tool) {
            case ToolKind::brush:
            case ToolKind::laser:
            case ToolKind::line:
                addChoice("options.tip", options_.tip, kTips);
                return addSize();
            case ToolKind::box:
            case ToolKind::sphere:
            case ToolKind::ellipse:
            case ToolKind::cylinder:
                return addChoice("options.hollow", options_.hollow, kFills);
            case ToolKind::selectRectangle:
                return addChoice("options.depth", options_.inSight, kSightDepths);
            case ToolKind::face:
            case ToolKind::fill:
            case ToolKind::planeFill:
            case ToolKind::wand:
                addChoice("options.colour", options_.sameColour, kColourRules);
                return addChoice("options.neighbours", options_.neighbours, kTouch);
            default:
                return;
        }
    }
    void addSize() {
        const bool slider = form_ == Form::roomy;
        const float width = kTipEdge + (slider ? kSlider + kSliderGap : 0.0f);
        add(size, optionLabelWidth(ui_, "Size") + ui_.theme.px(width),
            [&ui = ui_, &options = options_, slider] { drawSize(ui, options, slider); });
    }
    void addFigures(Tool& tool, ToolAnswer& answer) {
        const std::vector<ToolFigure> shown = tool.figures();
        const float width = ui_.theme.px(form_ == Form::narrow ? kNarrowFigure : kFigure);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const ToolFigure& figure = shown[i];
            // The last one gives way first.
            const int worth = figures + static_cast<int>(shown.size() - i);
            add(worth, optionLabelWidth(ui_, figure.name) + width,
                [&ui = ui_, &tool, i, figure, width] { drawFigure(ui, tool, i, figure, width); });
            parts.back().behind = ui_.theme.px(form_ == Form::narrow ? 6 : 10);
        }
        if (!tool.busy() || shown.empty()) return;
        add(answers, ui_.theme.px(2 * kOptionHeight + kButtonGap),
            [&ui = ui_, &answer] { drawAnswer(ui, answer); });
    }
    void addSelection(bool busy) {
        const VoxelSelection& selection = ui_.session.selection();
        if (!busy) {
            const std::string text = selection.empty()
                                         ? "Nothing selected"
                                         : grouped(selection.voxels().count()) + " selected";
            add(said, optionLabelWidth(ui_, text.c_str()), [&ui = ui_, text] {
                optionLabel(ui, text.c_str());
                ImGui::NewLine();
            });
            parts.back().behind = ui_.theme.px(4);
        }
        const auto& floating = selection.floating();
        const bool moves = !floating || floating->kind == Floating::Kind::move;
        if (!moves || (selection.empty() && !floating)) return;
        add(arrange, ui_.theme.px(6 * kOptionHeight + 4 * kButtonGap + kHalvesGap),
            [&ui = ui_] { drawArrange(ui); });
    }

    Ui& ui_;
    ToolOptions& options_;
    Form form_;
};

}  // namespace

ToolAnswer drawToolOptions(Ui& ui, Tool* tool) {
    ToolAnswer answer = ToolAnswer::none;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ui.theme.px(8, 4));
    std::vector<OptionPart> parts;
    for (const Form form : {Form::roomy, Form::plain, Form::narrow}) {
        parts = ToolParts(ui, tool, answer, form).parts;
        if (widthOf(parts) <= ImGui::GetContentRegionAvail().x) break;
    }
    drawOptionBar(ui, parts);
    ImGui::PopStyleVar();
    return answer;
}

}  // namespace voxprite::editor
