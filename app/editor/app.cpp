#include "app/editor/app.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/editor/panels/panels.h"
#include "app/editor/panels/tool_options.h"
#include "app/editor/widgets.h"
#include "app/editor/window.h"

namespace voxprite::editor {
namespace {

constexpr ImGuiWindowFlags kPanelFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus |
                                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings;

// A panel that fills `area`. Always ends with ImGui::End().
void beginPanel(Ui& ui, const char* name, const Area& area, ImVec2 padding,
                ImGuiWindowFlags more = 0) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr, kPanelFlags | more);
    ImGui::PopStyleVar(2);
    ui.probe.mark(name, area.min, area.max());
}

}  // namespace

Status App::openAtStart(const std::filesystem::path& file) {
    Status opened = session_.open(file);
    if (opened) settings_.remember(file);
    return opened;
}

Status App::openProfileAtStart(const std::filesystem::path& file) {
    return session_.openProfile(file);
}

Result<std::unique_ptr<App>> App::create(EditorSettings settings,
                                         std::optional<std::filesystem::path> layoutDump) {
    Result<VoxelViewport> voxels = VoxelViewport::create();
    if (!voxels) return Failure(voxels.error());
    Result<SpriteViewport> sprite = SpriteViewport::create();
    if (!sprite) return Failure(sprite.error());
    return std::unique_ptr<App>(new App(std::move(settings), std::move(layoutDump),
                                        std::move(*voxels), std::move(*sprite)));
}

void App::frame(const Theme& theme, const std::vector<InputEvent>& events) {
    std::vector<glm::dvec2> path{pointer_};
    for (const InputEvent& event : events) {
        if (event.kind == InputKind::move) path.push_back(event.position);
        if (event.kind == InputKind::drop && !event.files.empty()) requestOpen(event.files.front());
    }
    pointer_ = path.back();
    // An edit answers the oldest input of its frame.
    editStart_.reset();
    if (!events.empty()) editStart_ = events.front().seconds;
    advanceAnimation();
    figures_.strokeSize.clear();
    Ui ui{theme, session_, settings_, edits_, commands_, context_, probe_, figures_, path};
    commands_.askByKeys(settings_.input.keys);
    buildUi(ui);
    for (Action& action : edits_.take()) context_.perform(std::move(action));
    for (const CommandId id : commands_.take()) {
        // A file holds what is seen: what a tool is still making, too.
        if (commandOf(id).menu == MenuId::file) keepToolsWork();
        if (isEnabled(id, context_)) commandOf(id).run(context_);
    }
    if (files_.takeReplaced()) startOver();
    lockCameras();
    renderViews();
    dumpLayout();
}

void App::buildUi(Ui& ui) {
    const Theme& theme = ui.theme;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Layout layout = layoutFor(theme, window, settings_.window.split);

    std::string refusal;
    voxels_.show(ui, layout.edit.min, layout.edit.size, refusal);
    sprite_.show(ui, layout.sprite.min, layout.sprite.size);
    figures_.hovered.reset();
    if (voxels_.hovered()) figures_.hovered = voxels_.hovered()->voxel;
    if (!refusal.empty()) toasts_.error(refusal);
    drawDivider(ui, layout);

    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 8));
    beginPanel(ui, "panel.menu", layout.menu, {0, 0},
               ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (const auto recent = drawMenuBar(ui)) requestOpen(*recent);
    ImGui::End();

    beginPanel(ui, "panel.tools", layout.tools, theme.px(6, 8), ImGuiWindowFlags_NoScrollbar);
    drawToolColumn(ui);
    ImGui::End();

    beginPanel(ui, "panel.options", layout.options, theme.px(12, 6), ImGuiWindowFlags_NoScrollbar);
    const ToolAnswer answer = drawToolOptions(ui, voxels_.tools().tool());
    if (answer == ToolAnswer::keep) keepToolsWork();
    if (answer == ToolAnswer::drop) voxels_.tools().cancel(session_);
    ImGui::End();

    beginPanel(ui, "panel.inspector", layout.inspector, theme.px(14, 10));
    drawInspector(ui);
    ImGui::End();

    beginPanel(ui, "panel.dock", layout.dock, theme.px(14, 6), ImGuiWindowFlags_NoScrollbar);
    drawDock(ui);
    ImGui::End();

    beginPanel(ui, "panel.status", layout.status, theme.px(12, 6), ImGuiWindowFlags_NoScrollbar);
    drawStatusBar(ui);
    ImGui::End();

    files_.draw(ui);
    const float left = layout.edit.min.x, right = layout.sprite.max().x;
    toasts_.draw(theme, {(left + right) * 0.5f, layout.edit.max().y},
                 std::min(theme.px(560), right - left - theme.px(32)));
}

void App::drawDivider(Ui& ui, const Layout& layout) {
    const Area& area = layout.divider;
    beginPanel(ui, "panel.divider", area, {0, 0},
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton("drag", area.size);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    if (ImGui::IsItemActive()) {
        const float views = layout.sprite.max().x - layout.edit.min.x;
        const float wanted = (ImGui::GetIO().MousePos.x - layout.edit.min.x) / views;
        settings_.window.split = std::clamp(wanted, 0.15f, 0.85f);
    }
    const float x = area.min.x + std::floor(area.size.x * 0.5f);
    const float y = area.min.y + std::floor(area.size.y * 0.5f), half = ui.theme.px(16);
    const ImU32 colour =
        ImGui::IsItemActive() || ImGui::IsItemHovered() ? ui.theme.accent : ui.theme.fieldActive;
    ImGui::GetWindowDrawList()->AddLine({x, y - half}, {x, y + half}, colour, ui.theme.px(2));
    ImGui::End();
}

void App::drawDock(Ui& ui) {
    constexpr std::array<const char*, 4> kTabs{"Palette", "Objects", "History", "Scene"};
    const Theme& theme = ui.theme;
    DockTab& chosen = settings_.window.dockTab;
    for (std::size_t i = 0; i < kTabs.size(); ++i) {
        const bool on = static_cast<std::size_t>(chosen) == i;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 text = ImGui::CalcTextSize(kTabs[i]);
        const ImVec2 size(text.x + theme.px(2), theme.px(28));
        ImGui::PushID(kTabs[i]);
        if (ImGui::InvisibleButton("tab", size)) chosen = static_cast<DockTab>(i);
        ui.probe.markItem(std::string("dock.") + kTabs[i]);
        ImGui::PopID();
        const ImU32 colour = on ? theme.text : ImGui::IsItemHovered() ? theme.text : theme.textDim;
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddText(theme.fonts.bold, theme.fonts.bold->FontSize, {at.x, at.y + theme.px(5)},
                     colour, kTabs[i]);
        if (on) {
            draw.AddRectFilled({at.x, at.y + size.y - theme.px(2)}, {at.x + size.x, at.y + size.y},
                               theme.accent);
        }
        ImGui::SameLine(0.0f, theme.px(18));
    }
    ImGui::NewLine();
    switch (chosen) {
        case DockTab::palette:
            return drawPalette(ui);
        case DockTab::objects:
            return drawObjects(ui);
        case DockTab::history:
            return drawHistory(ui);
        case DockTab::scene:
            return drawScene(ui);
    }
}

void App::keepToolsWork() {
    if (auto action = voxels_.tools().confirm(session_)) context_.perform(std::move(*action));
}

void App::startOver() {
    voxels_.tools().cancel(session_);
    sprite_.forget();
    framed_ = false;
    figures_.editMilliseconds.reset();
}

void App::renderViews() {
    if (!framed_) {
        voxels_.frameModel(session_);
        sprite_.frameModel(session_);
        framed_ = true;
    }
    const OctreeChanges changes = session_.takeOctreeChanges();
    const OctreeView view = session_.shownOctree().view(session_.shownBounds());
    if (changes.any() || octree_.size() != view.size) octree_.update(view, changes);

    bool drew = voxels_.render(session_, octree_, settings_);
    const Result<bool> sprite = sprite_.render(session_, octree_, settings_);
    if (!sprite) {
        toasts_.error(sprite.error().describe());
    } else {
        drew = drew || *sprite;
    }
    for (const Error& problem : sprite_.takeProblems()) toasts_.error(problem.describe());
    figures_.sigmaInForce = sprite_.stats().drawn > 0 ? sprite_.stats().sigmaInForce : 0.0;
    figures_.screenPxPerPx = sprite_.stats().screenPxPerPx;
    if (session_.modelRevision() != shownModel_) {
        // Only an edit waits for the pictures to be finished, so that its time is honest.
        glFinish();
        const bool edited = shownModel_ != 0 && session_.history().position() > 0;
        if (edited && drew && editStart_) {
            figures_.editMilliseconds = (Window::seconds() - *editStart_) * 1000.0;
        }
        shownModel_ = session_.modelRevision();
    }
}

void App::lockCameras() {
    OrbitCamera& edit = voxels_.camera();
    OrbitCamera& sprite = sprite_.camera();
    if (settings_.view.lockCameras && framed_) {
        const PlacedEntity inEdit = session_.placedForEditing();
        const PlacedEntity inGame = session_.placedInGame();
        const double metres = inGame.metresPerVoxel();
        const bool spriteMoved = sprite != before_.sprite && edit == before_.edit;
        const OrbitCamera from = spriteMoved ? sprite : edit;
        OrbitCamera& to = spriteMoved ? edit : sprite;
        const double unit = spriteMoved ? 1.0 / metres : metres;
        const glm::dvec3 fromCentre = spriteMoved ? inGame.centreMetres() : inEdit.centreMetres();
        const glm::dvec3 toCentre = spriteMoved ? inEdit.centreMetres() : inGame.centreMetres();
        to = from;
        to.distance = from.distance * unit;
        to.target = toCentre + (from.target - fromCentre) * unit;
    }
    before_ = {edit, sprite};
}

void App::advanceAnimation() {
    if (!settings_.view.playing || session_.frames() < 2) return;
    const auto& clips = session_.document().clips;
    const double rate = clips.empty() ? 8.0 : std::max(0.1, clips.front().framesPerSecond);
    animationSeconds_ += static_cast<double>(ImGui::GetIO().DeltaTime);
    if (animationSeconds_ < 1.0 / rate) return;
    animationSeconds_ = 0.0;
    context_.report(session_.setFrame((session_.frame() + 1) % session_.frames()));
}

bool App::animates() const {
    if (sprite_.animates(settings_)) return true;
    return settings_.view.playing && session_.frames() > 1;
}

std::string App::windowTitle() const {
    return session_.title() + (session_.unsaved() ? " •" : "") + " – voxprite";
}

void App::dumpLayout() {
    if (!probe_.wanted()) return;
    nlohmann::json state{{"voxels", session_.octree().solidCount()},
                         {"unsaved", session_.unsaved()},
                         {"steps", session_.history().position()},
                         {"sigma", session_.profile().sigma},
                         {"file", session_.path() ? session_.path()->string() : ""},
                         {"dialog", files_.isBrowsing() ? "browser" : dialogs_.openName()},
                         {"colour", settings_.tool.colour},
                         {"toast", toasts_.newest()}};
    if (const auto& hovered = voxels_.hovered()) {
        const glm::ivec3 v = hovered->voxel, n = hovered->normal;
        state["hovered"] = {
            {"voxel", {v.x, v.y, v.z}}, {"normal", {n.x, n.y, n.z}}, {"ground", hovered->ground}};
    }
    context_.report(probe_.endFrame(state));
}

}  // namespace voxprite::editor
