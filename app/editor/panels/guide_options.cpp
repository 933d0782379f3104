// What guides every tool: mirrors, what is selected, limits.
#include <array>
#include <cmath>

#include "app/editor/panels/option_bar.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/tools/guides.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

constexpr std::array<const char*, 3> kAxisNames{"X", "Y", "Z"};
constexpr std::array<const char*, 3> kAxisProbes{"x", "y", "z"};
constexpr float kLetterGap = 3.0f;

// A letter that is lit in its own colour while it is on.
bool letter(Ui& ui, const std::string& name, const char* text, bool on, ImU32 colour,
            const char* hint) {
    const Theme& theme = ui.theme;
    const float size = theme.px(kOptionHeight);
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
            optionLabel(ui, kAxisNames[static_cast<std::size_t>(axis)]);
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
    optionLabel(ui, "Mirror");
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (letter(ui, std::string("options.mirror.") + kAxisProbes[a], kAxisNames[a],
                   options.symmetry.on[a], toImU32(kAxisColours[a]), kHints[a])) {
            switchSymmetry(options, axis, ui.session.bounds());
        }
        ImGui::SameLine(0.0f, ui.theme.px(kLetterGap));
    }
    if (iconButton(ui, "options.mirror.planes", icon::kDown, Lit::off, ui.theme.px(kOptionHeight),
                   "Where the mirror planes are")) {
        ImGui::OpenPopup("mirror");
    }
    drawMirrorPopup(ui, options);
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
            optionLabel(ui, name);
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
}

void drawLimits(Ui& ui, ToolOptions& options) {
    constexpr ImU32 kColour = IM_COL32(255, 214, 102, 255);
    if (letter(ui, "options.limit", icon::kWireframe, options.limited, kColour,
               "Limit edits to a box: nothing outside it is changed")) {
        switchLimits(options, ui.session.bounds());
    }
    ImGui::SameLine(0.0f, ui.theme.px(kLetterGap));
    if (iconButton(ui, "options.limit.box", icon::kDown, Lit::off, ui.theme.px(kOptionHeight),
                   "Where the limits are")) {
        ImGui::OpenPopup("limits");
    }
    drawLimitsPopup(ui, options);
}

}  // namespace

std::vector<OptionPart> guideParts(Ui& ui, ToolOptions& options) {
    const Theme& theme = ui.theme;
    const float square = theme.px(kOptionHeight), gap = theme.px(kLetterGap);
    const auto& mirrored = options.symmetry.on;
    std::vector<OptionPart> parts;
    parts.push_back({.worth = 2,
                     .width = optionLabelWidth(ui, "Mirror") + 3 * (square + gap) + square,
                     .behind = theme.px(10),
                     .draw = [&] { drawMirrors(ui, options); },
                     .atRight = true,
                     .on = mirrored[0] || mirrored[1] || mirrored[2]});
    parts.push_back({.worth = 0,
                     .width = square,
                     .behind = gap,
                     .draw = [&] { drawInside(ui, options); },
                     .atRight = true,
                     .on = options.insideSelection});
    parts.push_back({.worth = 1,
                     .width = square + gap + square,
                     .draw = [&] { drawLimits(ui, options); },
                     .atRight = true,
                     .on = options.limited});
    return parts;
}

}  // namespace voxprite::editor
