#include "app/editor/panels/timeline.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/playback.h"
#include "app/editor/window/icons.h"
#include "core/edit/frame_edits.h"

namespace voxprite::editor {
namespace {

constexpr const char* kDraggedFrame = "voxprite.frame";
constexpr float kPadding = 6.0f, kBar = 26.0f, kLane = 16.0f, kCell = 26.0f;
constexpr int kMostLanes = 3;

// Clips that overlap lie in lanes of their own, as far as there are any.
std::vector<int> lanesOf(const std::vector<Clip>& clips) {
    std::vector<int> lanes;
    for (std::size_t i = 0; i < clips.size(); ++i) {
        int lane = 0;
        for (std::size_t k = 0; k < i; ++k) {
            const bool apart = clips[k].last < clips[i].first || clips[i].last < clips[k].first;
            if (!apart) lane = std::max(lane, lanes[k] + 1);
        }
        lanes.push_back(std::min(lane, kMostLanes - 1));
    }
    return lanes;
}

int laneCount(const std::vector<Clip>& clips) {
    const std::vector<int> lanes = lanesOf(clips);
    return lanes.empty() ? 0 : *std::ranges::max_element(lanes) + 1;
}

const char* clipNameOf(const Clip& clip) {
    return clip.name.empty() ? "Clip" : clip.name.c_str();
}

void button(Ui& ui, CommandId id, Lit lit) {
    ImGui::BeginDisabled(!isEnabled(id, ui.context));
    commandButton(ui, id, lit, ui.theme.px(24));
    ImGui::EndDisabled();
    ImGui::SameLine(0.0f, ui.theme.px(2));
}

void playButton(Ui& ui) {
    const bool plays = ui.settings.view.playing;
    const std::string hint = nameWithKey(CommandId::togglePlaying, ui.settings.input.keys);
    if (iconButton(ui, "command.play", plays ? icon::kPause : icon::kPlay,
                   plays ? Lit::filled : Lit::off, ui.theme.px(24), hint.c_str())) {
        ui.commands.ask(CommandId::togglePlaying);
    }
    ImGui::SameLine(0.0f, ui.theme.px(2));
}

// What is played: all frames, or a clip.
void clipChoice(Ui& ui) {
    const Document& document = ui.session.document();
    Playback& playback = ui.context.playback;
    const std::optional<int> chosen = playback.clip(document);
    const char* preview =
        chosen ? clipNameOf(document.clips[static_cast<std::size_t>(*chosen)]) : "All frames";
    ImGui::SetNextItemWidth(ui.theme.px(112));
    if (beginTextCombo("##clip", preview)) {
        if (ImGui::Selectable("All frames", !chosen)) playback.chooseClip(std::nullopt);
        for (int i = 0; i < static_cast<int>(document.clips.size()); ++i) {
            ImGui::PushID(i);
            if (textSelectable(clipNameOf(document.clips[static_cast<std::size_t>(i)]),
                               chosen == i)) {
                playback.chooseClip(i);
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    ui.probe.markItem("timeline.clip");
    ImGui::SameLine(0.0f, ui.theme.px(4));
}

void rate(Ui& ui) {
    const Document& document = ui.session.document();
    const Clip played = ui.context.playback.played(ui.session, ui.settings.view);
    const std::optional<int> chosen = ui.context.playback.clip(document);
    ImGui::SetNextItemWidth(ui.theme.px(64));
    if (!played.durationsMilliseconds.empty()) {
        // Frames of their own lengths: that of the frame shown.
        const int frame = std::clamp(ui.session.frame(), played.first, played.last);
        Clip edited = played;
        int& duration =
            edited.durationsMilliseconds[static_cast<std::size_t>(frame - played.first)];
        const int before = duration;
        ImGui::DragInt("##duration", &duration, 1.0f, 1, kMaxFrameMilliseconds, "%d ms",
                       ImGuiSliderFlags_AlwaysClamp);
        ui.edits.watchItem(ui.session);
        // A drag would edit every frame that an animation at play brings along.
        if (ImGui::IsItemActivated()) ui.settings.view.playing = false;
        if (duration != before) editClip(ui, *chosen, edited);
        tooltip(ui, "How long this frame shows");
    } else {
        double perSecond = played.framesPerSecond;
        constexpr double kLeast = 0.1, kMost = 120.0;
        ImGui::DragScalar("##rate", ImGuiDataType_Double, &perSecond, 0.1f, &kLeast, &kMost,
                          "%.4g fps", ImGuiSliderFlags_AlwaysClamp);
        ui.edits.watchItem(ui.session);
        if (std::isfinite(perSecond) && perSecond != played.framesPerSecond) {
            if (chosen) {
                Clip edited = played;
                edited.framesPerSecond = perSecond;
                editClip(ui, *chosen, edited);
            } else {
                ui.settings.view.framesPerSecond = perSecond;
            }
        }
        tooltip(ui, "Frames a second");
    }
    ui.probe.markItem("timeline.rate");
    ImGui::SameLine(0.0f, ui.theme.px(4));
    if (!chosen) return;
    if (iconButton(ui, "timeline.clipSettings", icon::kSettings, Lit::off, ui.theme.px(24),
                   "Name, frames and lengths of the clip")) {
        ImGui::OpenPopup(kClipPopup);
    }
    drawClipPopup(ui, *chosen);
    ImGui::SameLine(0.0f, ui.theme.px(2));
}

void drawBar(Ui& ui) {
    const Theme& theme = ui.theme;
    button(ui, CommandId::previousFrame, Lit::off);
    playButton(ui);
    button(ui, CommandId::nextFrame, Lit::off);
    ImGui::SameLine(0.0f, theme.px(8));
    clipChoice(ui);
    rate(ui);
    button(ui, CommandId::addClip, Lit::off);

    const float buttons = 6 * theme.px(24) + 5 * theme.px(2) + theme.px(8);
    ImGui::SameLine(
        std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - buttons), 0.0f);
    button(ui, CommandId::toggleOnionSkin, ui.settings.view.onionSkin ? Lit::filled : Lit::off);
    ImGui::SameLine(0.0f, theme.px(8));
    for (const CommandId id : {CommandId::addFrame, CommandId::addHeldFrame,
                               CommandId::addEmptyFrame, CommandId::deleteFrame}) {
        button(ui, id, Lit::off);
    }
    if (iconButton(ui, "timeline.fold", icon::kDown, Lit::off, theme.px(24),
                   "Fold the timeline; the Animation menu brings it back")) {
        ui.settings.window.showsTimeline = false;
    }
}

// The row of frames and the clips above them, in a child that scrolls sideways.
struct Strip {
    ImVec2 corner;  // of frame 0, below the clips
    float cellWidth = 0.0f;
    float cellHeight = 0.0f;
    float laneHeight = 0.0f;
    int lanes = 0;
    [[nodiscard]] float left(int frame) const {
        return corner.x + cellWidth * static_cast<float>(frame);
    }
};

void drawClips(Ui& ui, const Strip& strip) {
    const Theme& theme = ui.theme;
    const auto& clips = ui.session.document().clips;
    const std::vector<int> lanes = lanesOf(clips);
    const std::optional<int> chosen = ui.context.playback.clip(ui.session.document());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < clips.size(); ++i) {
        const float top =
            strip.corner.y - strip.laneHeight * static_cast<float>(strip.lanes - lanes[i]);
        const ImVec2 min(strip.left(clips[i].first) + theme.px(1), top);
        const ImVec2 max(strip.left(clips[i].last + 1) - theme.px(1),
                         top + strip.laneHeight - theme.px(2));
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetCursorScreenPos(min);
        const bool on = chosen == static_cast<int>(i);
        if (ImGui::InvisibleButton("clip", {max.x - min.x, max.y - min.y})) {
            ui.context.playback.chooseClip(on ? std::nullopt : std::optional(static_cast<int>(i)));
        }
        const bool hovered = ImGui::IsItemHovered();
        ui.probe.markItem("timeline.clip." + std::to_string(i));
        if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            ui.context.playback.chooseClip(static_cast<int>(i));
            ImGui::OpenPopup(kClipPopup);
        }
        drawClipPopup(ui, static_cast<int>(i));
        tooltip(ui, "Plays alone; a double click shows its settings");
        ImGui::PopID();
        draw.AddRectFilled(min, max,
                           on        ? theme.accent
                           : hovered ? theme.fieldActive
                                     : theme.fieldHovered,
                           theme.px(3));
        const ImVec4 clip(min.x, min.y, max.x - theme.px(4), max.y);
        ImFont* font = theme.fonts.small;
        draw.AddText(
            font, font->FontSize,
            {min.x + theme.px(6), min.y + std::floor((max.y - min.y - font->FontSize) * 0.5f)},
            on ? theme.onAccent : theme.textDim, clipNameOf(clips[i]), nullptr, 0.0f, &clip);
    }
}

// The active object's own model begins here, or the one before is held.
bool holds(const SceneNode& object, int frame) {
    return frame > 0 && modelAt(object, frame) == modelAt(object, frame - 1);
}

void dragFrame(Ui& ui, int frame, ImVec2 min, ImVec2 max) {
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) {
        ImGui::SetDragDropPayload(kDraggedFrame, &frame, sizeof(frame));
        ImGui::Text("Frame %d", frame + 1);
        ImGui::EndDragDropSource();
    }
    if (!ImGui::BeginDragDropTarget()) return;
    const ImGuiPayload* payload =
        ImGui::AcceptDragDropPayload(kDraggedFrame, ImGuiDragDropFlags_AcceptBeforeDelivery |
                                                        ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
    if (payload != nullptr) {
        const int from = *static_cast<const int*>(payload->Data);
        const float x = from < frame ? max.x : min.x;
        if (from != frame) {
            ImGui::GetWindowDrawList()->AddLine({x, min.y}, {x, max.y}, ui.theme.accent,
                                                ui.theme.px(2));
        }
        if (payload->IsDelivery() && from != frame) {
            ui.settings.view.playing = false;
            ui.edits.pushScene(
                [from, frame](const Document& now) { return moveFrame(now, from, frame); });
            // The moved frame stays the one shown.
            static_cast<void>(ui.session.setFrame(frame));
        }
    }
    ImGui::EndDragDropTarget();
}

void drawCell(Ui& ui, const Strip& strip, int frame) {
    const Theme& theme = ui.theme;
    const ImVec2 min(strip.left(frame), strip.corner.y);
    const ImVec2 max(strip.left(frame + 1) - theme.px(2), strip.corner.y + strip.cellHeight);
    ImGui::PushID(frame);
    ImGui::SetCursorScreenPos(min);
    if (ImGui::InvisibleButton("frame", {max.x - min.x, max.y - min.y})) {
        ui.settings.view.playing = false;
        // Every frame of an open document fits: they were baked with the same bounds.
        static_cast<void>(ui.session.setFrame(frame));
    }
    ui.probe.markItem("timeline.frame." + std::to_string(frame));
    const bool hovered = ImGui::IsItemHovered();
    dragFrame(ui, frame, min, max);
    ImGui::PopID();

    const bool current = frame == ui.session.frame();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(min, max,
                       current   ? theme.accentSoft
                       : hovered ? theme.fieldHovered
                                 : theme.field,
                       theme.px(4));
    if (current) draw.AddRect(min, max, theme.accent, theme.px(4), 0, theme.px(1.5f));
    char number[16];
    std::snprintf(number, sizeof number, "%d", frame + 1);
    ImFont* font = theme.fonts.small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, number);
    draw.AddText(font, font->FontSize,
                 {std::floor((min.x + max.x - size.x) * 0.5f), min.y + theme.px(3)},
                 current ? theme.accent : theme.textDim, number);
    const int active = ui.session.activeNode();
    if (active <= 0) return;
    const SceneNode& object = ui.session.document().nodes[static_cast<std::size_t>(active)];
    const ImVec2 dot(std::floor((min.x + max.x) * 0.5f), max.y - theme.px(5));
    const ImU32 colour = current ? theme.accent : theme.textFaint;
    if (holds(object, frame)) {
        draw.AddLine({min.x - theme.px(2), dot.y}, {dot.x, dot.y}, colour, theme.px(1.5f));
    } else {
        draw.AddCircleFilled(dot, theme.px(2.5f), colour);
    }
    if (frame + 1 < ui.session.frames() && holds(object, frame + 1)) {
        draw.AddLine(dot, {max.x, dot.y}, colour, theme.px(1.5f));
    }
}

void drawStrip(Ui& ui) {
    const Theme& theme = ui.theme;
    const int frames = ui.session.frames();
    const ImVec2 area = ImGui::GetContentRegionAvail();
    Strip strip;
    strip.lanes = laneCount(ui.session.document().clips);
    strip.laneHeight = theme.px(kLane);
    strip.cellHeight = theme.px(kCell);
    strip.cellWidth =
        std::clamp(std::floor(area.x / static_cast<float>(frames)), theme.px(28), theme.px(56));
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, theme.px(4));
    ImGui::BeginChild("frames", area, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0.0f) {
        ImGui::SetScrollX(ImGui::GetScrollX() - ImGui::GetIO().MouseWheel * 2 * strip.cellWidth);
    }
    strip.corner = ImGui::GetCursorScreenPos();
    strip.corner.y += strip.laneHeight * static_cast<float>(strip.lanes);
    drawClips(ui, strip);
    const auto column = [&](float x) { return static_cast<int>(x / strip.cellWidth); };
    const int first = std::clamp(column(ImGui::GetScrollX()), 0, frames - 1);
    const int last = std::clamp(column(ImGui::GetScrollX() + area.x), first, frames - 1);
    for (int frame = first; frame <= last; ++frame) drawCell(ui, strip, frame);
    // All of them take their room, drawn or not.
    ImGui::SetCursorScreenPos({strip.left(frames) - theme.px(2), strip.corner.y});
    ImGui::Dummy({1, strip.cellHeight});
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace

float timelineHeight(const Theme& theme, const Session& session, const EditorSettings& settings) {
    if (session.frames() < 2 || !settings.window.showsTimeline) return 0.0f;
    const auto lanes = static_cast<float>(laneCount(session.document().clips));
    return 2 * theme.px(kPadding) + theme.px(kBar) + theme.px(4) + lanes * theme.px(kLane) +
           theme.px(kCell) + theme.px(4);
}

void drawTimeline(Ui& ui) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ui.theme.px(6, 4));
    drawBar(ui);
    ImGui::PopStyleVar();
    ImGui::SetCursorPosY(ui.theme.px(kPadding) + ui.theme.px(kBar) + ui.theme.px(4));
    drawStrip(ui);
}

}  // namespace voxprite::editor
