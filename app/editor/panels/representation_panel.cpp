// By what the scene draws its entities: chosen within a budget or by hand, shown by colours, and
// what each kind costs.
#include <array>
#include <cstdio>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/views/scene_representations.h"

namespace voxprite::editor {
namespace {

constexpr std::array kRules{
    Choice{"Exact", "Every entity is the sprite of the very view that the camera has"},
    Choice{"Automatic", "What is cheapest and measured to be within the budget, entity by entity"},
    Choice{"Snapshot", "The sprite of the nearest of a set of views, kept once it is cast"},
    Choice{"Clusters", "A mesh, as fine as its size on the screen asks for"},
    Choice{"Coarse", "The sprite of a coarser octree"}};
constexpr std::array kLevels{Choice{"1", "Cells of 2 voxels"}, Choice{"2", "Cells of 4 voxels"},
                             Choice{"3", "Cells of 8 voxels"}};
struct Views {
    const char* name;
    const char* label;
};
constexpr std::array kViewSets{
    Views{"canonical26", "26, all round"}, Views{"octahedral:8", "64, all round"},
    Views{"octahedral:16", "256, all round"}, Views{"hemisphere:12", "144, from above"},
    Views{"hemisphere:24", "576, from above"}};

// One of several under each other. Returns the one that was clicked.
template <class Label>
std::optional<std::size_t> comboRow(Ui& ui, const char* name, const char* label, const char* hint,
                                    const char* preview, std::size_t count, std::size_t chosen,
                                    const Label& labelOf) {
    rowLabel(ui, label, hint);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::PushID(name);
    const bool open = ImGui::BeginCombo("##combo", preview);
    ui.probe.markItem(name);
    std::optional<std::size_t> clicked;
    if (open) {
        for (std::size_t k = 0; k < count; ++k) {
            const Choice choice = labelOf(k);
            if (ImGui::Selectable(choice.label, k == chosen)) clicked = k;
            ui.probe.markItem(std::string(name) + "." + std::to_string(k));
            tooltip(ui, choice.hint);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return clicked;
}

double wholePercent(double percent) {
    return std::round(percent);
}

void drawRule(Ui& ui, RepresentationSettings& settings) {
    const auto rule = static_cast<std::size_t>(settings.rule);
    if (const auto clicked = comboRow(
            ui, "scene.rule", "Drawn by", "What stands for an entity in this view",
            kRules[rule].label, kRules.size(), rule, [](std::size_t k) { return kRules[k]; })) {
        settings.rule = static_cast<DrawRule>(*clicked);
    }
    double percent = 100.0 * settings.errorBudget;
    if (logSliderRow(
            ui, "scene.budget", "Error", percent, 100.0 * kLeastErrorBudget,
            100.0 * kMostErrorBudget, wholePercent,
            "How far off the exact sprite what is chosen may be: FLIP, the mean over the "
            "model. 0 % is equal; from some 10 % on one sees it when flipping between them",
            {100.0 * kLeastErrorBudget, 100.0 * kMostErrorBudget, 0.1, "%.0f %%"})) {
        settings.errorBudget = percent / 100.0;
    }
    if (settings.rule == DrawRule::coarse) {
        int left = settings.coarserLevels - 1;
        if (choiceRow(ui, "scene.levels", "Levels", left, kLevels))
            settings.coarserLevels = left + 1;
    }
}

void drawSources(Ui& ui, RepresentationSettings& settings) {
    std::size_t chosen = kViewSets.size();
    for (std::size_t k = 0; k < kViewSets.size(); ++k) {
        if (settings.views == kViewSets[k].name) chosen = k;
    }
    const char* preview =
        chosen < kViewSets.size() ? kViewSets[chosen].label : settings.views.c_str();
    if (const auto clicked = comboRow(ui, "scene.views", "Views", "What snapshots are taken from",
                                      preview, kViewSets.size(), chosen, [](std::size_t k) {
                                          return Choice{kViewSets[k].label, nullptr};
                                      })) {
        settings.views = kViewSets[*clicked].name;
    }
    static_cast<void>(numberRow(ui, "scene.clusterBudget", "Mesh", settings.clusterBudgetPx,
                                {0.0, kMostClusterBudgetPx, 0.02, "%.2f px off"},
                                "Screen pixels that the surface of clusters may be off"));
}

// Dot, name, how many there are and what they cost.
void drawLegend(Ui& ui) {
    const Theme& theme = ui.theme;
    const RepresentationShares& shares = ui.figures.scene.shares;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float left = ImGui::GetWindowContentRegionMin().x;
    const float width = ImGui::GetWindowContentRegionWidth();
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const auto kind = static_cast<Representation>(k);
        const RepresentationShare& share = shares[k];
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const Rgba8 tint = tintOf(kind);
        draw.AddCircleFilled({at.x + theme.px(6), at.y + ImGui::GetFontSize() * 0.5f}, theme.px(5),
                             IM_COL32(tint.x, tint.y, tint.z, 255));
        ImGui::PushStyleColor(ImGuiCol_Text, share.entities > 0 ? theme.text : theme.textFaint);
        ImGui::SetCursorPosX(left + theme.px(20));
        ImGui::TextUnformatted(nameOf(kind));
        const auto rightAligned = [&](const std::string& text, float edge, const char* name) {
            ImGui::SameLine();
            ImGui::SetCursorPosX(left + edge - ImGui::CalcTextSize(text.c_str()).x);
            ImGui::TextUnformatted(text.c_str());
            ui.probe.markItem(name + std::to_string(k));
        };
        rightAligned(grouped(static_cast<std::uint64_t>(share.entities)), 0.62f * width,
                     "scene.drawnBy.");
        std::array<char, 32> cost{};
        std::snprintf(cost.data(), cost.size(), "%.2f ms", share.microseconds / 1000.0);
        rightAligned(share.microseconds > 0.0 ? cost.data() : "–", width, "scene.costOf.");
        tooltip(ui, "A frame of a moving camera, by what was measured of each model");
        ImGui::PopStyleColor();
    }
}

}  // namespace

void drawRepresentations(Ui& ui) {
    if (!section(ui, "Representations")) return;
    RepresentationSettings& settings = ui.settings.scene.representations;
    drawRule(ui, settings);
    drawSources(ui, settings);
    static_cast<void>(switchRow(ui, "scene.tint", "Tint", settings.tint,
                                "Entities show by their colour what they are drawn by"));
    drawLegend(ui);
    const std::string& progress = ui.figures.scene.progress;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(progress.empty() ? " " : progress.c_str());
    ImGui::PopStyleColor();
    ui.probe.markItem("scene.progress");
    const bool compared = settings.compared;
    if (ImGui::Button(compared ? "Back to the scene" : "Compare side by side",
                      {ImGui::GetContentRegionAvail().x, ui.theme.px(26)})) {
        ui.commands.ask(CommandId::compareRepresentations);
    }
    ui.probe.markItem("scene.compare");
}

}  // namespace voxprite::editor
