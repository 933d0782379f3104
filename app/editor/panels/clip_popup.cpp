// The settings of one clip.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/timeline.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/playback.h"
#include "app/editor/window/icons.h"
#include "core/edit/frame_edits.h"

namespace voxprite::editor {
namespace {

// Frames are counted from 1 on screen.
void frameRow(Ui& ui, const char* name, const char* label, int& frame, int first, int last) {
    rowLabel(ui, label);
    int shown = frame + 1;
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::DragInt("##frame", &shown, 0.05f, first + 1, last + 1, "%d",
                   ImGuiSliderFlags_AlwaysClamp);
    ui.edits.watchItem(ui.session);
    ui.probe.markItem(name);
    ImGui::PopID();
    frame = std::clamp(shown - 1, first, last);
}

void durationRows(Ui& ui, Clip& clip) {
    const Theme& theme = ui.theme;
    bool each = !clip.durationsMilliseconds.empty();
    if (switchRow(ui, "clip.each", "Own lengths", each, "A length for each frame")) {
        const auto frames = static_cast<std::size_t>(clip.last - clip.first) + 1;
        const int even = std::clamp(static_cast<int>(std::lround(1000.0 / clip.framesPerSecond)), 1,
                                    kMaxFrameMilliseconds);
        clip.durationsMilliseconds.assign(each ? frames : 0, even);
    }
    if (!each) {
        static_cast<void>(numberRow(ui, "clip.rate", "Rate", clip.framesPerSecond,
                                    {0.1, 120.0, 0.1, "%.4g fps"}, "Frames a second"));
        return;
    }
    const auto rows = std::min(clip.durationsMilliseconds.size(), std::size_t{6});
    const float height =
        static_cast<float>(rows) * (theme.px(24) + ImGui::GetStyle().ItemSpacing.y);
    ImGui::BeginChild("durations", {0, height});
    for (std::size_t i = 0; i < clip.durationsMilliseconds.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        rowLabel(ui, ("Frame " + std::to_string(clip.first + static_cast<int>(i) + 1)).c_str());
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
        ImGui::DragInt("##duration", &clip.durationsMilliseconds[i], 1.0f, 1, kMaxFrameMilliseconds,
                       "%d ms", ImGuiSliderFlags_AlwaysClamp);
        ui.edits.watchItem(ui.session);
        ImGui::PopID();
    }
    ImGui::EndChild();
}

// The edit before may have deleted it.
bool hasClip(const Document& document, int clip) {
    return clip < static_cast<int>(document.clips.size());
}

// The timeline lies at the window's lower edge, and the popup may grow while it is open.
void growUpwards() {
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    const ImVec2 corner = ImGui::GetWindowPos();
    const float below = corner.y + ImGui::GetWindowHeight() - window.WorkPos.y - window.WorkSize.y;
    if (below > 0) ImGui::SetWindowPos({corner.x, std::max(window.WorkPos.y, corner.y - below)});
}

}  // namespace

void editClip(Ui& ui, int clip, Clip edited) {
    const std::uint64_t key = ui.edits.key();
    ui.edits.pushScene(
        [clip, key, edited = std::move(edited)](const Document& now) {
            return hasClip(now, clip) ? setClip(now, clip, edited, key) : Action{};
        },
        key);
}

void drawClipPopup(Ui& ui, int clip) {
    const Theme& theme = ui.theme;
    const Document& document = ui.session.document();
    ImGui::SetNextWindowSize({theme.px(264), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(14, 12));
    const bool open = ImGui::BeginPopup(kClipPopup);
    ImGui::PopStyleVar();
    if (!open) return;
    const Clip& before = document.clips[static_cast<std::size_t>(clip)];
    Clip edited = before;
    rowLabel(ui, "Name");
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::InputText("##name", &edited.name);
    ui.edits.watchItem(ui.session);
    ui.probe.markItem("clip.name");
    const int last = ui.session.frames() - 1;
    frameRow(ui, "clip.first", "First frame", edited.first, 0, edited.last);
    frameRow(ui, "clip.last", "Last frame", edited.last, edited.first, last);
    static_cast<void>(switchRow(ui, "clip.loop", "Loop", edited.loop, "Begin again at its end"));
    durationRows(ui, edited);
    if (edited != before) editClip(ui, clip, edited);
    ImGui::Dummy({0, theme.px(2)});
    if (ImGui::Button((std::string(icon::kDelete) + " Delete clip").c_str(),
                      {ImGui::GetContentRegionAvail().x, theme.px(26)})) {
        ui.context.playback.chooseClip(std::nullopt);
        ui.edits.pushScene([clip](const Document& now) {
            return hasClip(now, clip) ? deleteClip(now, clip) : Action{};
        });
        ImGui::CloseCurrentPopup();
    }
    ui.probe.markItem("clip.delete");
    growUpwards();
    ImGui::EndPopup();
}

}  // namespace voxprite::editor
