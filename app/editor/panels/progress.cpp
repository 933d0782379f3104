#include "app/editor/panels/progress.h"

#include <algorithm>
#include <cmath>

#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

// The share that is done, or, before anything is known, a light that runs along.
void bar(Ui& ui, double share, double seconds) {
    const Theme& theme = ui.theme;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, theme.px(6));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(min, {min.x + size.x, min.y + size.y}, theme.field, theme.px(3));
    double from = 0.0, to = share;
    if (share <= 0.0) {
        const double middle = std::fmod(seconds * 0.7, 1.3) - 0.15;
        from = std::clamp(middle - 0.15, 0.0, 1.0);
        to = std::clamp(middle + 0.15, 0.0, 1.0);
    }
    draw.AddRectFilled({min.x + size.x * static_cast<float>(from), min.y},
                       {min.x + size.x * static_cast<float>(to), min.y + size.y}, theme.accent,
                       theme.px(3));
    ImGui::Dummy(size);
}

bool content(Ui& ui, const BackgroundJob& job) {
    ImGui::PushFont(ui.theme.fonts.bold);
    ImGui::TextUnformatted((job.title() + "…").c_str());
    ImGui::PopFont();
    bar(ui, job.share(), job.seconds());
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(job.stage().c_str());
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(88, 28);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button.x);
    ImGui::BeginDisabled(job.stopping());
    const bool cancelled = ImGui::Button("Cancel", button);
    ui.probe.markItem("progress.cancel");
    ImGui::EndDisabled();
    return cancelled;
}

}  // namespace

bool drawProgress(Ui& ui, const BackgroundJob& job, bool blocks, bool shows) {
    if (!blocks && !shows) return false;
    const Theme& theme = ui.theme;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
    ImGui::SetNextWindowSize({std::min(theme.px(380), display.x - theme.px(32)), 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(18, 16));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, shows ? 1.0f : 0.0f);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme.raised);
    if (!shows) ImGui::PushStyleColor(ImGuiCol_ModalWindowDimBg, ImVec4(0, 0, 0, 0));
    bool cancelled = false;
    if (blocks) {
        if (!ImGui::IsPopupOpen("##working")) ImGui::OpenPopup("##working");
        ImGui::SetNextWindowPos({std::round(display.x * 0.5f), std::round(display.y * 0.42f)},
                                ImGuiCond_Always, {0.5f, 0.5f});
        if (ImGui::BeginPopupModal("##working", nullptr, kFlags)) {
            cancelled = content(ui, job);
            ImGui::EndPopup();
        }
    } else {
        ImGui::SetNextWindowPos({display.x - theme.px(16), display.y - theme.px(42)},
                                ImGuiCond_Always, {1.0f, 1.0f});
        ImGui::Begin("##working", nullptr, kFlags | ImGuiWindowFlags_NoFocusOnAppearing);
        cancelled = content(ui, job);
        ImGui::End();
    }
    if (!shows) ImGui::PopStyleColor();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
    return cancelled;
}

}  // namespace voxprite::editor
