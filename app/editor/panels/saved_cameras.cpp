#include "app/editor/panels/saved_cameras.h"

#include <algorithm>

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr float kListHeight = 196.0f;

}  // namespace

std::string freeViewName(std::span<const SavedCamera> kept) {
    std::size_t number = kept.size() + 1;
    const auto name = [&] { return "View " + std::to_string(number); };
    while (std::ranges::find(kept, name(), &SavedCamera::name) != kept.end()) ++number;
    return name();
}

void SavedCameras::keep(Ui& ui, const OrbitCamera& now) {
    auto& cameras = ui.settings.cameras;
    std::string name(name_.data());
    if (name.empty()) name = freeViewName(cameras);
    const SavedCamera kept = savedFrom(now, sphereInEditView(ui.session), name);
    // A name stands for one view: the old one gives way.
    const auto same = std::ranges::find(cameras, name, &SavedCamera::name);
    if (same != cameras.end()) {
        *same = kept;
    } else {
        cameras.push_back(kept);
    }
    name_ = {};
}

std::optional<SavedCamera> SavedCameras::draw(Ui& ui, const OrbitCamera& now) {
    std::optional<SavedCamera> chosen;
    if (!open_ || !beginDialog(ui, "##cameras", "Saved views", 420)) return chosen;
    const Theme& theme = ui.theme;
    auto& cameras = ui.settings.cameras;
    ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
    ImGui::TextWrapped(
        "Kept in the model's own measure: each shows any model from the same side, "
        "as large.");
    ImGui::PopStyleColor();
    ImGui::BeginChild("list", {0.0f, theme.px(kListHeight)});
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const float square = theme.px(26), width = ImGui::GetContentRegionAvail().x;
        const std::string label = std::string(icon::kCamera) + "  " + cameras[i].name;
        if (textSelectable(label, false, {width - square - theme.px(8), square})) {
            chosen = cameras[i];
        }
        ui.probe.markItem("cameras." + cameras[i].name);
        ImGui::SameLine();
        if (iconButton(ui, "remove", icon::kDelete, Lit::off, square, "Forget this view")) {
            removed = i;
        }
        ImGui::PopID();
    }
    if (cameras.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme.textFaint);
        ImGui::TextUnformatted("None yet");
        ImGui::PopStyleColor();
    }
    ImGui::EndChild();
    if (removed) cameras.erase(cameras.begin() + static_cast<std::ptrdiff_t>(*removed));

    const ImVec2 button = theme.px(108, 30);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 6));
    ImGui::SetNextItemWidth(-button.x - theme.px(8));
    const bool entered =
        ImGui::InputTextWithHint("##name", "Name of the view as it is now", name_.data(),
                                 name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleVar();
    ui.probe.markItem("cameras.name");
    ImGui::SameLine();
    if (ImGui::Button("Keep", button) || entered) keep(ui, now);
    ui.probe.markItem("cameras.keep");
    placeButtons(ui, button, 1);
    if (primaryButton(ui, "Done", button) || pressedKey(ImGuiKey_Escape) || chosen) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ui.probe.markItem("cameras.done");
    endDialog();
    return chosen;
}

}  // namespace voxprite::editor
