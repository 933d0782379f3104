#include "app/editor/panels/tool_options.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/tools/guides.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

constexpr float kToolBarHeight = 24.0f;
constexpr std::array<const char*, 3> kAxisNames{"X", "Y", "Z"};
constexpr std::array<const char*, 3> kAxisProbes{"x", "y", "z"};

void gap(Ui& ui, float width = 16.0f) {
    ImGui::SameLine(0.0f, ui.theme.px(width));
}

void label(Ui& ui, const char* text, const char* hint = nullptr) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    tooltip(ui, hint);
    ImGui::SameLine(0.0f, ui.theme.px(8));
}

// One of a few, side by side; as wide as its labels.
bool segments(Ui& ui, const char* name, int& value, std::span<const Choice> choices) {
    const Theme& theme = ui.theme;
    const float pad = theme.px(10), height = theme.px(kToolBarHeight), inset = theme.px(2);
    float width = 0.0f;
    for (const Choice& choice : choices) width += ImGui::CalcTextSize(choice.label).x + 2 * pad;
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

template <class Enum>
void choose(Ui& ui, const char* name, Enum& value, std::span<const Choice> choices) {
    int index = static_cast<int>(value);
    if (segments(ui, name, index, choices)) value = static_cast<Enum>(index);
    gap(ui);
}

// A letter that is lit in its own colour while it is on.
bool letter(Ui& ui, const std::string& name, const char* text, bool on, ImU32 colour,
            const char* hint) {
    const Theme& theme = ui.theme;
    const float size = theme.px(kToolBarHeight);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(name.c_str(), {size, size});
    ui.probe.markItem(name);
    tooltip(ui, hint);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 far(corner.x + size, corner.y + size);
    const bool hovered = ImGui::IsItemHovered();
    draw.AddRectFilled(corner, far, on ? withAlpha(colour, 0.28f) : theme.field, theme.px(4));
    if (hovered || on) draw.AddRect(corner, far, withAlpha(colour, on ? 0.9f : 0.5f), theme.px(4));
    const ImVec2 extent = ImGui::CalcTextSize(text);
    draw.AddText({std::round(corner.x + (size - extent.x) * 0.5f),
                  std::round(corner.y + (size - extent.y) * 0.5f)},
                 on ? colour : theme.textDim, text);
    return pressed;
}

// `compact` leaves room for the figures of what is being made.
void drawTip(Ui& ui, ToolOptions& options, bool compact) {
    constexpr std::array<Choice, 3> kTips{Choice{"Cube", "A cube on the face, or biting into it"},
                                          Choice{"Sphere", "A sphere around the voxel"},
                                          Choice{"Disc", "One layer, round, flat on the face"}};
    choose(ui, "options.tip", options.tip, kTips);
    label(ui, "Size", "Edge or diameter of the tip in voxels");
    constexpr const char* kHint =
        "Tip in voxels: drag, Ctrl+click to type, or use the keys - and =";
    if (!compact) {
        ImGui::SetNextItemWidth(ui.theme.px(96));
        ImGui::SliderInt(
            "##slider", &options.tipEdge, 1, kMaxTipEdge, "",
            ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput);
        ui.probe.markItem("options.size");
        tooltip(ui, kHint);
        ImGui::SameLine(0.0f, ui.theme.px(4));
    }
    ImGui::SetNextItemWidth(ui.theme.px(44));
    ImGui::DragInt("##size", &options.tipEdge, 0.1f, 1, kMaxTipEdge, "%d",
                   ImGuiSliderFlags_AlwaysClamp);
    ui.probe.markItem("options.size.value");
    tooltip(ui, kHint);
    gap(ui);
}

void drawHollow(Ui& ui, ToolOptions& options) {
    constexpr std::array<Choice, 2> kFills{Choice{"Solid", "Filled"},
                                           Choice{"Hollow", "Only the wall, one voxel thick"}};
    int hollow = options.hollow ? 1 : 0;
    if (segments(ui, "options.hollow", hollow, kFills)) options.hollow = hollow == 1;
    gap(ui);
}

void drawRegion(Ui& ui, ToolOptions& options) {
    constexpr std::array<Choice, 2> kColourRules{
        Choice{"Any colour", "All voxels that touch belong together"},
        Choice{"Same colour", "Only voxels of the colour that was hit belong together"}};
    constexpr std::array<Choice, 2> kTouch{Choice{"6", "Voxels touch by their faces"},
                                           Choice{"26", "Voxels touch by edges and corners, too"}};
    int same = options.sameColour ? 1 : 0;
    if (segments(ui, "options.colour", same, kColourRules)) options.sameColour = same == 1;
    gap(ui);
    choose(ui, "options.neighbours", options.neighbours, kTouch);
}

void drawDepth(Ui& ui, ToolOptions& options) {
    constexpr std::array<Choice, 2> kSightDepths{
        Choice{"Through", "All voxels that lie behind the rectangle"},
        Choice{"In sight", "Only voxels that can be seen in the rectangle"}};
    int inSight = options.inSight ? 1 : 0;
    if (segments(ui, "options.depth", inSight, kSightDepths)) options.inSight = inSight == 1;
    gap(ui);
}

// How many voxels are selected, and what is done to them most often.
void drawSelection(Ui& ui, bool busy) {
    const VoxelSelection& selection = ui.session.selection();
    using enum CommandId;
    constexpr std::array<CommandId, 6> kArrange{turnVoxelsX, turnVoxelsY, turnVoxelsZ,
                                                flipVoxelsX, flipVoxelsY, flipVoxelsZ};
    if (!busy) {
        const std::string text = selection.empty()
                                     ? "Nothing selected"
                                     : grouped(selection.voxels().count()) + " selected";
        label(ui, text.c_str());
        gap(ui, 4);
    }
    const bool moves = !selection.floating() || selection.floating()->kind == Floating::Kind::move;
    if (!moves || (selection.empty() && !selection.floating())) return;
    for (std::size_t i = 0; i < kArrange.size(); ++i) {
        commandButton(ui, kArrange[i], Lit::off, ui.theme.px(kToolBarHeight));
        const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine({min.x + ui.theme.px(4), max.y - ui.theme.px(1)},
                                            {max.x - ui.theme.px(4), max.y - ui.theme.px(1)},
                                            toImU32(kAxisColours[i % 3]), ui.theme.px(2));
        ImGui::SameLine(0.0f, ui.theme.px(i == 2 ? 8 : 2));
    }
}

ToolAnswer drawFigures(Ui& ui, Tool& tool) {
    const std::vector<ToolFigure> figures = tool.figures();
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const ToolFigure& figure = figures[i];
        label(ui, figure.name);
        int value = figure.value;
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(ui.theme.px(52));
        if (ImGui::DragInt("##figure", &value, 0.2f, figure.min, figure.max, "%d",
                           ImGuiSliderFlags_AlwaysClamp)) {
            tool.setFigure(i, std::clamp(value, figure.min, figure.max));
        }
        ImGui::PopID();
        ui.probe.markItem("options.figure." + std::to_string(i));
        tooltip(ui, "Drag, or double-click to type");
        gap(ui, 10);
    }
    ToolAnswer answer = ToolAnswer::none;
    if (!tool.busy() || figures.empty()) return answer;
    const float size = ui.theme.px(kToolBarHeight);
    if (iconButton(ui, "options.keep", icon::kCheck, Lit::icon, size, "Keep it  (Enter)")) {
        answer = ToolAnswer::keep;
    }
    ImGui::SameLine(0.0f, ui.theme.px(2));
    if (iconButton(ui, "options.drop", icon::kClose, Lit::off, size, "Drop it  (Esc)")) {
        answer = ToolAnswer::drop;
    }
    gap(ui);
    return answer;
}

// A coordinate in half voxels: whole numbers lie between voxels, halves within one.
bool planeField(Ui& ui, int axis, int& doubled) {
    constexpr float kStep = 0.05f;
    double value = doubled / 2.0;
    ImGui::SetNextItemWidth(ui.theme.px(96));
    const std::string id = std::string("##plane") + kAxisNames[static_cast<std::size_t>(axis)];
    const bool changed = ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &value, kStep, nullptr,
                                           nullptr, "%.1f");
    ui.probe.markItem(std::string("options.plane.") + kAxisProbes[static_cast<std::size_t>(axis)]);
    if (!changed || !std::isfinite(value)) return false;
    const double reach = kMaxCoordinate;
    doubled = static_cast<int>(std::round(std::clamp(value, -reach, reach) * 2.0));
    return true;
}

void drawMirrorPopup(Ui& ui, ToolOptions& options) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(14, 12));
    if (ImGui::BeginPopup("mirror")) {
        ImGui::PushFont(ui.theme.fonts.bold);
        ImGui::TextUnformatted("Mirror planes");
        ImGui::PopFont();
        for (int axis = 0; axis < 3; ++axis) {
            label(ui, kAxisNames[static_cast<std::size_t>(axis)]);
            ImGui::SameLine(ui.theme.px(36), 0.0f);
            if (planeField(ui, axis, options.symmetry.planeDoubled[axis])) {
                options.symmetryPlaced = true;
            }
        }
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
        ImGui::TextUnformatted("Whole numbers lie between voxels,\nhalves within one.");
        ImGui::PopStyleColor();
        if (ImGui::Button("Centre on the model", {ImGui::GetContentRegionAvail().x, 0})) {
            centreSymmetry(options, ui.session.bounds());
        }
        ui.probe.markItem("options.mirror.centre");
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

void drawMirrors(Ui& ui, ToolOptions& options) {
    constexpr std::array<const char*, 3> kHints{
        "Mirror left and right: every edit happens on both sides",
        "Mirror front and back: every edit happens on both sides",
        "Mirror top and bottom: every edit happens on both sides"};
    label(ui, "Mirror");
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (letter(ui, std::string("options.mirror.") + kAxisProbes[a], kAxisNames[a],
                   options.symmetry.on[a], toImU32(kAxisColours[a]), kHints[a])) {
            switchSymmetry(options, axis, ui.session.bounds());
        }
        ImGui::SameLine(0.0f, ui.theme.px(3));
    }
    if (iconButton(ui, "options.mirror.planes", icon::kDown, Lit::off, ui.theme.px(kToolBarHeight),
                   "Where the mirror planes are")) {
        ImGui::OpenPopup("mirror");
    }
    drawMirrorPopup(ui, options);
    gap(ui, 10);
}

void drawLimitsPopup(Ui& ui, ToolOptions& options) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(14, 12));
    if (ImGui::BeginPopup("limits")) {
        ImGui::PushFont(ui.theme.fonts.bold);
        ImGui::TextUnformatted("Limit edits to a box");
        ImGui::PopFont();
        glm::ivec3 min = options.limits.min;
        glm::ivec3 size = options.limits.max - options.limits.min;
        const auto fields = [&](const char* name, glm::ivec3& values, int least) {
            label(ui, name);
            for (int axis = 0; axis < 3; ++axis) {
                ImGui::PushID(name);
                ImGui::PushID(axis);
                ImGui::SetNextItemWidth(ui.theme.px(56));
                ImGui::DragInt("##limit", &values[axis], 0.2f, least, kMaxCoordinate, "%d",
                               ImGuiSliderFlags_AlwaysClamp);
                ImGui::PopID();
                ImGui::PopID();
                if (axis < 2) ImGui::SameLine(0.0f, ui.theme.px(4));
            }
        };
        fields("From", min, -kMaxCoordinate);
        fields("Size", size, 1);
        options.limits = {min, min + size};
        if (ImGui::Button("Around the model", {ImGui::GetContentRegionAvail().x, 0}) &&
            !ui.session.bounds().empty()) {
            options.limits = ui.session.bounds();
        }
        ui.probe.markItem("options.limit.fit");
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

void drawInside(Ui& ui, ToolOptions& options) {
    constexpr ImU32 kColour = IM_COL32(255, 214, 102, 255);
    if (letter(ui, "options.inside", icon::kInside, options.insideSelection, kColour,
               "Paint and erase only what is selected. Without a selection, everywhere")) {
        options.insideSelection = !options.insideSelection;
    }
    ImGui::SameLine(0.0f, ui.theme.px(3));
}

void drawLimits(Ui& ui, ToolOptions& options) {
    constexpr ImU32 kColour = IM_COL32(255, 214, 102, 255);
    if (letter(ui, "options.limit", icon::kWireframe, options.limited, kColour,
               "Limit edits to a box: nothing outside it is changed")) {
        switchLimits(options, ui.session.bounds());
    }
    ImGui::SameLine(0.0f, ui.theme.px(3));
    if (iconButton(ui, "options.limit.box", icon::kDown, Lit::off, ui.theme.px(kToolBarHeight),
                   "Where the limits are")) {
        ImGui::OpenPopup("limits");
    }
    drawLimitsPopup(ui, options);
}

}  // namespace

ToolAnswer drawToolOptions(Ui& ui, Tool* tool) {
    ToolSettings& settings = ui.settings.tool;
    ToolOptions& options = settings.options;
    const Theme& theme = ui.theme;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(8, 4));
    ImGui::BeginGroup();
    switch (settings.tool) {
        case ToolKind::brush:
        case ToolKind::laser:
        case ToolKind::line:
            drawTip(ui, options, tool != nullptr && tool->busy() && !tool->figures().empty());
            break;
        case ToolKind::box:
        case ToolKind::sphere:
        case ToolKind::ellipse:
        case ToolKind::cylinder:
            drawHollow(ui, options);
            break;
        case ToolKind::selectRectangle:
            drawDepth(ui, options);
            break;
        case ToolKind::face:
        case ToolKind::fill:
        case ToolKind::planeFill:
        case ToolKind::wand:
            drawRegion(ui, options);
            break;
        default:
            break;
    }
    const ToolAnswer answer = tool != nullptr ? drawFigures(ui, *tool) : ToolAnswer::none;
    if (ToolSettings::isForSelection(settings.tool))
        drawSelection(ui, tool != nullptr && tool->busy());
    ImGui::EndGroup();

    const float mirrors =
        ImGui::CalcTextSize("Mirror").x + theme.px(8 + 3 * 27 + 24 + 10 + 27 + 27 + 24);
    ImGui::SameLine(ImGui::GetWindowWidth() - mirrors - theme.px(12), 0.0f);
    drawMirrors(ui, options);
    drawInside(ui, options);
    drawLimits(ui, options);
    ImGui::PopStyleVar();
    return answer;
}

}  // namespace voxprite::editor
