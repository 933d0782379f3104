// The game scene around the edited model: which copies stand there, from how far they are seen, and
// what drawing them costs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr std::array kPatterns{Choice{"Alone", "Only the edited model"},
                               Choice{"Grid", "Copies in rows and columns around it"},
                               Choice{"Crowd", "Copies at random places around it"},
                               Choice{"March", "Ranks of copies that walk past it"}};
constexpr std::array kModes{
    Choice{"Buffers",
           "Each sprite is cast once, a ray a virtual pixel, and kept while it is shown"},
    Choice{"Single pass", "Every screen pixel casts its own rays: the same picture, much slower"}};

// Two figures of a number are enough.
double snapCount(double count) {
    const double step = std::max(1.0, std::pow(10.0, std::floor(std::log10(count)) - 1.0));
    return std::clamp(std::round(count / step) * step, 1.0, static_cast<double>(kMostCopies));
}

std::string milliseconds(double ms) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), ms < 10.0 ? "%.2f ms" : "%.1f ms", ms);
    return text.data();
}

void seedRow(Ui& ui, int& seed) {
    rowLabel(ui, "Seed", "Another number, another crowd; the same number, the same crowd");
    const float square = ui.theme.px(24), gap = ui.theme.px(4);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - square - gap);
    ImGui::DragInt("##seed", &seed, 0.1f, 0, 1'000'000, "%d", ImGuiSliderFlags_AlwaysClamp);
    ui.probe.markItem("scene.seed");
    ImGui::SameLine(0.0f, gap);
    if (iconButton(ui, "scene.shuffle", icon::kDice, Lit::off, square, "Another arrangement")) {
        ++seed;
    }
}

void drawPattern(Ui& ui) {
    CopySettings& copies = ui.settings.scene.copies;
    if (enumRow(ui, "scene.pattern", nullptr, copies.pattern, kPatterns) &&
        copies.pattern == CopyPattern::march) {
        ui.settings.view.playing = true;
    }
}

void drawCopies(Ui& ui) {
    SceneSettings& scene = ui.settings.scene;
    CopySettings& copies = scene.copies;
    if (copies.pattern == CopyPattern::none) return;
    auto count = static_cast<double>(copies.count);
    if (logSliderRow(ui, "scene.count", "How many", count, 1.0, kMostCopies, snapCount,
                     "Beside the edited model", {1.0, kMostCopies, 1.0, "%.0f"})) {
        copies.count = static_cast<int>(std::lround(count));
    }
    static_cast<void>(numberRow(ui, "scene.spacing", "Spacing", copies.spacing,
                                {kLeastSpacing, kMostSpacing, 0.01, "%.2f"},
                                "Times what the sizes of the models suggest"));
    if (copies.pattern == CopyPattern::march) {
        static_cast<void>(numberRow(ui, "scene.pace", "Pace", scene.pace,
                                    {0.0, 10.0, 0.01, "%.2f heights/s"},
                                    "Heights of the edited model that the ranks walk a second"));
        static_cast<void>(switchRow(ui, "scene.playing", "Walking", ui.settings.view.playing,
                                    "Plays the animation, too"));
    } else {
        static_cast<void>(switchRow(ui, "scene.turned", "Turned", copies.turned,
                                    "Each stands its own way, in steps of 45 degrees"));
    }
    seedRow(ui, copies.seed);
}

enum class RowAsks : std::uint8_t { nothing, toggle, remove };

RowAsks modelRow(Ui& ui, const std::string& id, const std::string& name, bool used,
                 const char* hint, bool removable) {
    const Theme& theme = ui.theme;
    const float height = theme.px(24), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    RowAsks asks = RowAsks::nothing;
    ImGui::PushID(id.c_str());
    if (ImGui::InvisibleButton("row", {width - (removable ? height : 0.0f), height})) {
        asks = RowAsks::toggle;
    }
    ui.probe.markItem(id);
    tooltip(ui, hint);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered()) {
        draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme.fieldHovered,
                           theme.px(4));
    }
    const float textY = corner.y + std::floor((height - ImGui::GetFontSize()) * 0.5f);
    draw.AddText({corner.x + theme.px(4), textY}, used ? theme.accent : theme.textFaint,
                 used ? icon::kVisible : icon::kHidden);
    const ImVec4 clip(corner.x, corner.y, corner.x + width - height, corner.y + height);
    draw.AddText(theme.fonts.text, theme.fonts.text->FontSize, {corner.x + theme.px(28), textY},
                 used ? theme.text : theme.textFaint, name.c_str(), nullptr, 0.0f, &clip);
    if (removable) {
        ImGui::SetCursorScreenPos({corner.x + width - height, corner.y});
        ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
        if (iconButton(ui, (id + ".remove").c_str(), icon::kClose, Lit::off, height,
                       "Take it out of the scene")) {
            asks = RowAsks::remove;
        }
        ImGui::PopStyleColor();
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos({corner.x, corner.y + height});
    return asks;
}

void drawModels(Ui& ui) {
    SceneSettings& scene = ui.settings.scene;
    if (scene.copies.pattern == CopyPattern::none || !section(ui, "Models")) return;
    if (modelRow(ui, "scene.edited", ui.session.title() + "  (edited)", scene.copies.editedUsed,
                 "Copies of the edited model follow every edit", false) == RowAsks::toggle) {
        scene.copies.editedUsed = !scene.copies.editedUsed;
    }
    for (std::size_t i = 0; i < scene.extras.size(); ++i) {
        ExtraModelChoice& extra = scene.extras[i];
        const std::string name =
            extra.entity ? extra.entityName + "  (" + extra.file.filename().string() + ")"
                         : extra.file.stem().string();
        const RowAsks asks = modelRow(ui, "scene.extra." + std::to_string(i), name, extra.used,
                                      extra.file.c_str(), true);
        if (asks == RowAsks::toggle) extra.used = !extra.used;
        if (asks == RowAsks::remove) {
            scene.extras.erase(scene.extras.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    }
    const std::string label = std::string(icon::kPlus) + "  Add a model…";
    if (ImGui::Button(label.c_str(), {ImGui::GetContentRegionAvail().x, ui.theme.px(26)})) {
        ui.commands.ask(CommandId::addSceneModel);
    }
    ui.probe.markItem("scene.add");
}

void drawCamera(Ui& ui) {
    struct Preset {
        const char* label;
        const char* hint;
        CommandId command;
    };
    using enum CommandId;
    constexpr std::array kPresets{
        Preset{"Model", "The edited model fills the view", frameModel},
        Preset{"4×", "From as far away as lets a virtual pixel cover 4 screen pixels",
               gameDistance4},
        Preset{"2×", "A virtual pixel covers 2 screen pixels", gameDistance2},
        Preset{"1×", "A virtual pixel covers 1 screen pixel", gameDistance1},
        Preset{"All", "The whole scene", frameScene}};
    const Theme& theme = ui.theme;
    rowLabel(ui, "Camera", "From how far the game shows the model");
    const float gap = theme.px(4);
    const float width = std::floor(
        (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(kPresets.size() - 1)) /
        static_cast<float>(kPresets.size() + 1));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(0, 4));
    for (const Preset& preset : kPresets) {
        const bool wide = preset.command == frameModel;
        if (ImGui::Button(preset.label, {wide ? 2.0f * width : width, theme.px(24)})) {
            ui.commands.ask(preset.command);
        }
        ui.probe.markItem("scene.camera." + std::string(commandOf(preset.command).tag));
        tooltip(ui, preset.hint);
        ImGui::SameLine(0.0f, gap);
    }
    ImGui::PopStyleVar();
    ImGui::NewLine();
}

// A label and a value in one of two columns.
void figure(Ui& ui, int column, const char* name, const char* label, const std::string& value,
            const char* hint) {
    const float half = std::floor(ImGui::GetWindowContentRegionWidth() * 0.5f);
    const float x = ImGui::GetWindowContentRegionMin().x + static_cast<float>(column) * half;
    if (column > 0) ImGui::SameLine();
    ImGui::SetCursorPosX(x);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    tooltip(ui, hint);
    ImGui::SameLine(x + ui.theme.px(78), 0.0f);
    ImGui::TextUnformatted(value.c_str());
    ui.probe.markItem(name);
    tooltip(ui, hint);
}

// Milliseconds of the last frames as bars; the highest fills the height.
void drawTimes(Ui& ui, std::span<const float> times) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, theme.px(36));
    ImGui::Dummy(size);
    ui.probe.markItem("scene.times");
    tooltip(ui, "Milliseconds of the last frames");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, theme.field, theme.px(4));
    if (times.empty()) return;
    const float most = std::max(1.0f, *std::ranges::max_element(times));
    const float step = size.x / static_cast<float>(FrameTimes::kKept);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const float x = corner.x + size.x - step * static_cast<float>(times.size() - i);
        const float height = std::max(1.0f, (size.y - theme.px(4)) * times[i] / most);
        draw.AddRectFilled({x, corner.y + size.y - height},
                           {x + std::max(1.0f, step - 1.0f), corner.y + size.y},
                           withAlpha(theme.accent, 0.75f));
    }
    const std::string label = milliseconds(static_cast<double>(most));
    draw.AddText(theme.fonts.small, theme.fonts.small->FontSize,
                 {corner.x + theme.px(6), corner.y + theme.px(2)}, theme.textDim, label.c_str());
}

void drawCost(Ui& ui) {
    if (!section(ui, "Cost of the last picture")) return;
    GameProfile profile = ui.session.profile();
    if (enumRow(ui, "scene.mode", "Mode", profile.mode, kModes)) {
        ui.edits.push("Mode", ProfileEdit{ui.session.profile(), profile}, false);
    }
    const SceneFigures& figures = ui.figures.scene;
    const SceneStats& stats = figures.stats;
    const auto count = [](auto number) { return grouped(static_cast<std::uint64_t>(number)); };
    figure(ui, 0, "scene.sprites", "Sprites", count(stats.drawn), "Sprites drawn, of all entities");
    figure(ui, 1, "scene.entities", "Entities", count(figures.entities),
           "The edited model and its copies");
    figure(ui, 0, "scene.rays", "Rays", count(stats.rays), "Rays cast: a still scene casts none");
    figure(ui, 1, "scene.draws", "Draw calls", count(stats.drawCalls),
           "That put sprites onto the screen");
    figure(ui, 0, "scene.hits", "Cache hits", count(stats.castsReused),
           "Sprites that were there already, from the frame before or from another entity");
    figure(ui, 1, "scene.casts", "Casts", count(stats.casts), "Sprites cast anew");
    figure(ui, 0, "scene.cpu", "CPU", milliseconds(figures.cpuMs), "Until all commands were given");
    figure(ui, 1, "scene.gpu", "GPU", figures.gpuMs ? milliseconds(*figures.gpuMs) : "–",
           "By the GPU's own clock, of the newest picture that it is done with");
    figure(ui, 0, "scene.atlas", "Atlas", byteText(stats.atlasBytes),
           "Memory of the finished sprites");
    drawTimes(ui, figures.cpuTimes.all());
    static_cast<void>(switchRow(ui, "scene.everyFrame", "Every frame", ui.settings.scene.everyFrame,
                                "Draw without need, to read what a frame costs"));
}

}  // namespace

void drawScene(Ui& ui) {
    ImGui::BeginChild("scene");
    drawPattern(ui);
    drawCamera(ui);
    drawCopies(ui);
    drawModels(ui);
    drawRepresentations(ui);
    drawCost(ui);
    ImGui::EndChild();
}

}  // namespace voxprite::editor
