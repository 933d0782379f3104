#include "app/editor/app.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/editor/panels/panel_area.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/split_bars.h"
#include "app/editor/panels/timeline.h"
#include "app/editor/panels/tool_options.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/window.h"
#include "core/io/profile_json.h"

namespace voxprite::editor {
namespace {

constexpr int kViews = 2;
constexpr double kCommandSeconds = 0.04;  // of a frame, for what was asked for

}  // namespace

Status App::openAtStart(const std::filesystem::path& file, std::optional<std::size_t> entity) {
    ReadOptions options;
    options.entity = entity;
    Status opened = session_.open(file, options);
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
    std::unique_ptr<App> app(new App(std::move(settings), std::move(layoutDump), std::move(*voxels),
                                     std::move(*sprite)));
    if (!app->settings_.window.tourSeen) app->overlays_.tour.open();
    return app;
}

void App::frame(const Theme& theme, const std::vector<InputEvent>& events) {
    std::vector<glm::dvec2> path{pointer_};
    for (const InputEvent& event : events) {
        if (event.kind == InputKind::move) path.push_back(event.position);
        if (event.kind == InputKind::drop && !event.files.empty()) drop(event.files);
    }
    pointer_ = path.back();
    seconds_ += static_cast<double>(ImGui::GetIO().DeltaTime);
    // An edit answers the oldest input of its frame.
    editStart_.reset();
    if (!events.empty()) editStart_ = events.front().seconds;
    // A drag that takes long is worked out for the frame that is shown.
    if (!files_.blocks() && !files_.drags()) {
        const auto passed = static_cast<double>(ImGui::GetIO().DeltaTime);
        context_.report(playback_.advance(session_, settings_.view, passed));
    }
    session_.limitHistory(static_cast<std::size_t>(settings_.window.historyMegabytes) << 20);
    objects_.follow(session_);
    figures_.strokeSize.clear();
    Ui ui{theme, session_, settings_, edits_, commands_, context_, probe_, figures_, path};
    commands_.askByKeys(settings_.input.keys);
    buildUi(ui);
    context_.perform(edits_);
    runCommands();
    if (files_.takeReplaced()) startOver();
    lockCameras();
    placeCameras();
    voxels_.follow(session_, settings_);
    followTrade();
    clock_.end(FramePart::work);
    renderViews();
    clock_.end(FramePart::draw);
    keepCopy();
    clock_.end(FramePart::work);
    dumpLayout();
}

void App::drop(const std::vector<std::filesystem::path>& files) {
    // A question is answered first; cards that only tell something give way.
    const std::string dialog = openDialog();
    if (!dialog.empty() && dialog != "error" && dialog != "about") {
        return toasts_.info("Close this first, then drop " + files.front().filename().string());
    }
    if (files.size() > 1) sayOneAtATime(files.front());
    requestOpen(files.front());
}

void App::runCommands() {
    const double begin = Window::seconds();
    for (const CommandId id : commands_.take()) {
        // Many steps of the history may be asked for at once.
        const bool late = Window::seconds() - begin > kCommandSeconds;
        const Command& command = commandOf(id);
        // A file holds what is seen: what a tool is still making, too.
        const bool settles = command.settles || command.menu == MenuId::file;
        const bool waits = late || files_.blocks() || files_.drags();
        if (!waits && settles) keepToolsWork();
        if (waits || files_.blocks()) {
            commands_.ask(id);
        } else if (isEnabled(id, context_)) {
            command.run(context_);
        }
    }
}

void App::buildUi(Ui& ui) {
    const Theme& theme = ui.theme;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Layout layout =
        layoutFor(theme, window, settings_.window, timelineHeight(theme, session_, settings_));

    std::string refusal;
    voxels_.show(ui, layout.edit.min, layout.edit.size, !files_.blocks(), refusal);
    sprite_.show(ui, layout.sprite.min, layout.sprite.size);
    figures_.hovered.reset();
    if (voxels_.hovered()) figures_.hovered = voxels_.hovered()->voxel;
    if (!refusal.empty()) toasts_.error(refusal);
    drawSplitBars(ui, layout);

    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 8));
    beginPanel(ui, "panel.menu", layout.menu, {0, 0},
               ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (const auto recent = drawMenuBar(ui)) requestOpen(*recent);
    ImGui::End();

    if (layout.tools.shown()) {
        beginPanel(ui, "panel.tools", layout.tools, theme.px(6, 8), ImGuiWindowFlags_NoScrollbar);
        drawToolColumn(ui);
        ImGui::End();
    }

    beginPanel(ui, "panel.options", layout.options, theme.px(12, 6), ImGuiWindowFlags_NoScrollbar);
    const ToolAnswer answer = drawToolOptions(ui, voxels_.tools().tool());
    if (answer == ToolAnswer::keep) commands_.ask(CommandId::keepMade);
    if (answer == ToolAnswer::drop) voxels_.tools().cancel(session_);
    ImGui::End();

    if (layout.inspector.shown()) {
        beginPanel(ui, "panel.inspector", layout.inspector, theme.px(14, 10));
        drawInspector(ui);
        ImGui::End();
        beginPanel(ui, "panel.dock", layout.dock, theme.px(14, 6), ImGuiWindowFlags_NoScrollbar);
        drawDock(ui);
        ImGui::End();
    }

    if (layout.timeline.shown()) {
        beginPanel(ui, "panel.timeline", layout.timeline, theme.px(10, 6),
                   ImGuiWindowFlags_NoScrollbar);
        drawTimeline(ui);
        ImGui::End();
    }

    beginPanel(ui, "panel.status", layout.status, theme.px(12, 6), ImGuiWindowFlags_NoScrollbar);
    drawStatusBar(ui);
    ImGui::End();

    // What was asked before this frame is answered by it; see FileFlow::draw().
    const bool asked = files_.asks() || files_.blocks();
    files_.draw(ui);
    if (!asked) drawOverlays(ui, layout);
    const float left = layout.edit.min.x, right = layout.sprite.max().x;
    toasts_.draw(theme, {(left + right) * 0.5f, layout.edit.max().y},
                 std::min(theme.px(560), right - left - theme.px(32)));
}

void App::drawDock(Ui& ui) {
    if (!drawDockTabs(ui)) return;
    switch (settings_.window.dockTab) {
        case DockTab::palette:
            return palettePanel_.draw(ui);
        case DockTab::objects:
            return drawObjects(ui);
        case DockTab::history:
            return drawHistory(ui);
        case DockTab::scene:
            return drawScene(ui);
        case DockTab::trade:
            return drawTrade(ui);
    }
}

void App::drawOverlays(Ui& ui, const Layout& layout) {
    if (recovery_.isOpen()) {
        if (const auto work = recovery_.draw(ui)) recover(*work);
    } else if (overlays_.palette.isOpen()) {
        overlays_.palette.draw(ui);
    } else if (overlays_.preferences.isOpen()) {
        overlays_.preferences.draw(ui);
    } else if (overlays_.cameras.isOpen()) {
        if (const auto saved = overlays_.cameras.draw(ui, voxels_.camera())) {
            voxels_.camera() = cameraFrom(*saved, sphereInEditView(session_));
            sprite_.camera() = cameraFrom(*saved, sphereInSpriteView(session_));
        }
    } else if (overlays_.sheet.isOpen()) {
        if (auto sheet = overlays_.sheet.draw(ui)) files_.exportSheet(std::move(*sheet));
    } else {
        overlays_.tour.draw(ui, layout);
    }
}

void App::keepToolsWork() {
    static_cast<void>(context_.settle());
}

Status App::keepCopiesIn(const std::filesystem::path& recovery) {
    recovery_.offer(findLostWork(recovery));
    Result<RecoveryFolder> folder = RecoveryFolder::create(recovery);
    if (!folder) return Failure(folder.error());
    autosave_ = std::make_unique<Autosave>(std::move(*folder));
    return {};
}

void App::recover(const LostWork& work) {
    const Result<GameProfile> profile = readProfileFile(work.profile);
    const Status recovered =
        profile ? session_.recover(work.document, *profile, work.file, work.profileFile)
                : Failure(profile.error());
    if (!recovered) return dialogs_.showError(recovered.error().describe());
    startOver();
    // The copy goes only when this editor has one of its own.
    const Status copied = autosave_->copyNow(session_);
    if (!copied) return context_.report(copied);
    discard(work);
    toasts_.info("Recovered " + work.title + ": save it to keep it");
}

void App::keepCopy() {
    if (!autosave_) return;
    // A document counts as saved while it is being written: its copy stays until that is done.
    autosave_->update(session_, Window::seconds(), files_.isWorking());
    if (const auto problem = autosave_->takeProblem()) {
        toasts_.error("No copy of the unsaved work can be kept: " + problem->describe());
    }
}

void App::startOver() {
    voxels_.tools().cancel(session_);
    sprite_.forget();
    study_.forget();
    objects_ = {};
    playback_ = {};
    framed_ = false;
    figures_.editMilliseconds.reset();
    clock_.forget();
}

void App::placeCameras() {
    if (framed_) return;
    voxels_.frameModel(session_);
    sprite_.frameModel(session_);
    framed_ = true;
}

void App::renderViews() {
    const OctreeChanges changes = session_.takeOctreeChanges();
    const OctreeView view = session_.shownOctree().view(session_.shownBounds());
    if (changes.any() || octree_.size() != view.size) octree_.update(view, changes);
    clock_.end(FramePart::upload);

    bool drew = true;
    if (viewsByGl_ > 0) {
        drew = voxels_.render(session_, octree_, settings_);
    } else {
        voxels_.renderFirst(session_, settings_);
    }
    Result<bool> sprite = true;
    if (viewsByGl_ > 1) {
        sprite = sprite_.render(session_, octree_, settings_);
    } else {
        sprite_.renderFirst(session_);
    }
    if (viewsByGl_ < kViews && !files_.isWorking()) ++viewsByGl_;
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

bool App::looksAtTrade() const {
    const WindowSettings& window = settings_.window;
    const bool panel = window.showsSide && window.showsDock && window.dockTab == DockTab::trade;
    return panel || settings_.trade.showsB();
}

void App::followTrade() {
    // What holds the document now comes first.
    if (!looksAtTrade() || files_.blocks()) return study_.rest();
    std::vector<trade::Setting> also{
        settingInForce(session_.profile(), settings_.scene.representations)};
    if (settings_.trade.b) also.push_back(*settings_.trade.b);
    study_.follow(session_, also, seconds_);
}

void App::lockCameras() {
    OrbitCamera& edit = voxels_.camera();
    OrbitCamera& sprite = sprite_.camera();
    if (!settings_.view.lockCameras) {
        // What the edit view has done to the game's picture goes with the lock.
        if (unlocked_) sprite.orthographic = unlocked_->orthographic;
        unlocked_.reset();
    } else if (framed_) {
        if (!unlocked_) unlocked_ = sprite;
        const PlacedEntity inEdit = session_.placedForEditing();
        const PlacedEntity inGame = session_.placedInGame();
        if (sprite != before_.sprite && edit == before_.edit) {
            edit.lookLike(sprite, inGame, inEdit);
        } else {
            sprite.lookLike(edit, inEdit, inGame);
        }
    }
    before_ = {edit, sprite};
}

std::string App::openDialog() const {
    if (std::string dialog = dialogs_.openName(); !dialog.empty()) return dialog;
    if (files_.isBrowsing()) return "browser";
    if (files_.isImporting()) return "import";
    if (files_.entities().isOpen()) return "entities";
    return recovery_.isOpen() ? "recovery" : overlays_.openName();
}

bool App::animates() const {
    if (sprite_.animates(settings_) || files_.isWorking() || commands_.any()) return true;
    if (viewsByGl_ < kViews) return true;
    if (voxels_.turns() || voxels_.prepares() || sprite_.turns()) return true;
    if (voxels_.tools().previewsLater() || overlays_.sheet.working()) return true;
    if (looksAtTrade() && study_.busy()) return true;
    return settings_.view.playing && session_.frames() > 1;
}

std::string App::windowTitle() const {
    return session_.title() + (session_.unsaved() ? " •" : "") + " – voxprite";
}

void App::dumpLayout() {
    if (!probe_.wanted()) return;
    nlohmann::json state{{"voxels", session_.octree().solidCount()},
                         {"unsaved", session_.unsaved()},
                         {"pointer", {pointer_.x, pointer_.y}},
                         {"making", voxels_.tools().busy()},
                         {"selected", session_.selection().voxels().count()},
                         {"steps", session_.history().position()},
                         {"sigma", session_.profile().sigma},
                         {"file", session_.path() ? session_.path()->string() : ""},
                         {"title", session_.title()},
                         {"dialog", openDialog()},
                         {"browser", files_.browserSays()},
                         {"colour", settings_.tool.colour},
                         {"toast", toasts_.newest()}};
    if (overlays_.sheet.isOpen()) {
        state["sheet"] = overlays_.sheet.said();
        state["sheet_file"] = overlays_.sheet.saysOfFile();
    }
    if (files_.entities().isOpen()) state["entities"] = files_.entities().said();
    if (const auto& floating = session_.selection().floating()) state["amount"] = floating->amount;
    const SceneFigures& sprites = sprite_.figures();
    state["sprites"] = {{"entities", sprites.entities},
                        {"drawn", sprites.stats.drawn},
                        {"draw_calls", sprites.stats.drawCalls},
                        {"drawn_by", sprites.stats.drawnBy}};
    const RepresentationSettings& representations = settings_.scene.representations;
    state["representations"] = {{"compared", representations.compared},
                                {"flying", representations.flying},
                                {"size_px", representations.comparedSizePx},
                                {"measured", sprites.progress.empty()}};
    const TradeSettings& trade = settings_.trade;
    const HeatMap* heat = sprite_.heat().map();
    state["trade"] = {{"points", study_.curve().points.size()},
                      {"busy", study_.busy()},
                      {"cancelled", study_.cancelled()},
                      {"b", trade.b ? trade::describe(*trade.b, trade::Setting{}) : ""},
                      {"side", static_cast<int>(trade.side)},
                      {"wipe", trade.wipe},
                      {"saved", trade.saved.size()},
                      {"heat", trade.heat},
                      {"heat_mean", heat != nullptr ? heat->mean : -1.0}};
    const OrbitCamera& camera = voxels_.camera();
    state["camera"] = {{"yaw", camera.yawDegrees},
                       {"pitch", camera.pitchDegrees},
                       {"distance", camera.distance},
                       {"orthographic", camera.orthographic}};
    const auto copied = autosave_ ? autosave_->copiedPosition() : std::nullopt;
    state["copied"] = copied ? static_cast<long long>(*copied) : -1;
    state["working"] = files_.isWorking();
    state["longest_frame_ms"] = std::round(clock_.longestFrame());
    // Busy time of the window's thread, rounded up to what a glance can tell apart.
    const auto busy = [&](FramePart part) { return std::ceil(clock_.longest(part) / 5.0) * 5.0; };
    state["busy_ms"] = {{"work", busy(FramePart::work)},
                        {"upload", busy(FramePart::upload)},
                        {"draw", busy(FramePart::draw)},
                        {"present", busy(FramePart::present)}};
    if (const auto& hovered = voxels_.hovered()) {
        const glm::ivec3 v = hovered->voxel, n = hovered->normal;
        state["hovered"] = {
            {"voxel", {v.x, v.y, v.z}}, {"normal", {n.x, n.y, n.z}}, {"ground", hovered->ground}};
    }
    context_.report(probe_.endFrame(state));
}

}  // namespace voxprite::editor
