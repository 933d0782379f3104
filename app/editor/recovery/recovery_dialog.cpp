#include "app/editor/recovery/recovery_dialog.h"

#include <algorithm>
#include <chrono>

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/number_text.h"
#include "app/editor/panels/picture_tile.h"
#include "app/editor/panels/widgets.h"
#include "core/io/png.h"

namespace voxprite::editor {
namespace {

constexpr float kRecoveryWidth = 560.0f, kRecoveryTile = 112.0f, kRecoveryGap = 16.0f;
constexpr std::size_t kShownAtOnce = 3;

std::string counted(std::int64_t count, const char* thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string ageOf(std::int64_t unixSeconds) {
    using namespace std::chrono;
    const std::int64_t now = duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
    const std::int64_t age = std::max<std::int64_t>(0, now - unixSeconds);
    if (age < 60) return "less than a minute ago";
    if (age < 3600) return counted(age / 60, "minute") + " ago";
    if (age < 86400) return counted(age / 3600, "hour") + " ago";
    return counted(age / 86400, "day") + " ago";
}

}  // namespace

void RecoveryDialog::offer(std::vector<LostWork> works) {
    offered_.clear();
    for (LostWork& work : works) {
        Offered offered{std::move(work), {}};
        if (const Result<Image> image = readPngFile(offered.work.picture)) {
            offered.picture.set(*image);
        }
        offered_.push_back(std::move(offered));
    }
}

RecoveryDialog::Answer RecoveryDialog::drawOne(Ui& ui, const Offered& offered) {
    const Theme& theme = ui.theme;
    const LostWork& work = offered.work;
    Answer answer = Answer::none;
    drawPictureTile(theme, ImGui::GetCursorScreenPos(), theme.px(kRecoveryTile), offered.picture);
    ImGui::Dummy(theme.px(kRecoveryTile, kRecoveryTile));
    ImGui::SameLine(0.0f, theme.px(kRecoveryGap));
    ImGui::BeginGroup();
    ImGui::PushFont(theme.fonts.bold);
    ImGui::TextUnformatted(work.title.c_str());
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
    const std::string when =
        ageOf(work.unixSeconds) + "  ·  " + counted(static_cast<std::int64_t>(work.edits), "edit");
    ImGui::TextUnformatted(when.c_str());
    const std::string file = work.file ? work.file->path.string() : "in no file yet";
    ImGui::PushTextWrapPos(ImGui::GetContentRegionMax().x);
    ImGui::TextUnformatted(file.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::Dummy(theme.px(0, 2));
    const ImVec2 button = theme.px(108, 28);
    if (primaryButton(ui, "Recover", button)) answer = Answer::recover;
    ui.probe.markItem("recovery.recover");
    ImGui::SameLine();
    if (ImGui::Button("Discard", button)) answer = Answer::discard;
    ui.probe.markItem("recovery.discard");
    ImGui::EndGroup();
    return answer;
}

std::optional<LostWork> RecoveryDialog::draw(Ui& ui) {
    std::optional<LostWork> chosen;
    if (!isOpen() || !beginDialog(ui, "##recovery", "Recover unsaved work?", kRecoveryWidth))
        return chosen;
    const Theme& theme = ui.theme;
    ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
    ImGui::TextWrapped("The editor did not end in an orderly way. This is how far its copies go.");
    ImGui::PopStyleColor();
    ImGui::Dummy(theme.px(0, 4));
    const auto shown = static_cast<float>(std::min(offered_.size(), kShownAtOnce));
    ImGui::BeginChild("works", {0.0f, shown * theme.px(kRecoveryTile + 12)});
    std::optional<std::size_t> discarded;
    for (std::size_t i = 0; i < offered_.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const Answer answer = drawOne(ui, offered_[i]);
        if (answer == Answer::recover) chosen = offered_[i].work;
        if (answer == Answer::discard) discarded = i;
        ImGui::PopID();
    }
    ImGui::EndChild();
    if (discarded) {
        discard(offered_[*discarded].work);
        offered_.erase(offered_.begin() + static_cast<std::ptrdiff_t>(*discarded));
    }
    const ImVec2 button = theme.px(108, 30);
    placeButtons(ui, button, 1);
    const bool later = ImGui::Button("Later", button) || pressedKey(ImGuiKey_Escape);
    ui.probe.markItem("recovery.later");
    if (later || chosen) offered_.clear();
    if (offered_.empty()) ImGui::CloseCurrentPopup();
    endDialog();
    return chosen;
}

}  // namespace voxprite::editor
