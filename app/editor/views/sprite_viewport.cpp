#include "app/editor/views/sprite_viewport.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "app/editor/session/trade_study.h"
#include "app/editor/views/first_pictures.h"
#include "app/editor/views/socket_markers.h"
#include "app/editor/views/sprite_picture.h"
#include "app/editor/views/sprite_toolbar.h"

namespace voxprite::editor {
namespace {

// What an empty document shows of the scene, in voxels.
constexpr glm::ivec3 kEmptyShownVoxels(24, 24, 12);

// A picture that took longer than this is not drawn again at once.
constexpr double kSlowMs = 60.0;

double milliseconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

GizmoTarget gizmoTarget(const Session& session, GizmoKind kind, double sigmaInForce) {
    // Of the document: an edit that is only being shown moves no handle.
    const PlacedEntity placed = session.madeInGame();
    return {kind, session.document().entity, placed,
            sigmaInForce > 0.0 ? sigmaInForce : session.profile().sigma, placed.metresPerVoxel()};
}

void add(SceneStats& sum, const SceneStats& stats) {
    sum.drawn += stats.drawn;
    sum.unseen += stats.unseen;
    sum.rays += stats.rays;
    sum.casts += stats.casts;
    sum.castsReused += stats.castsReused;
    sum.drawCalls += stats.drawCalls;
    for (std::size_t k = 0; k < sum.drawnBy.size(); ++k) sum.drawnBy[k] += stats.drawnBy[k];
    sum.atlasBytes = stats.atlasBytes;  // one atlas for all
}

}  // namespace

Result<SpriteViewport> SpriteViewport::create() {
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    return SpriteViewport(std::move(*renderer));
}

glm::ivec2 SpriteViewport::cellPx() const {
    return areas_.size() > 1 ? areas_.front().size : canvas_.sizePx();
}

void SpriteViewport::frameModel(const Session& session) {
    PlacedEntity placed = session.placedInGame();
    if (session.shownBounds().empty()) placed.modelSize = kEmptyShownVoxels;
    camera_.frame(proxyCorners(placed, session.profile().sigma), 0.25, cellPx());
}

void SpriteViewport::frameScene(const Session& session) {
    const PlacedEntity placed = session.placedInGame();
    const double reach = std::max(scene_.radiusMetres(), placed.radiusMetres());
    std::vector<glm::dvec3> points;
    for (const double height : {0.0, placed.modelSize.z * placed.metresPerVoxel()}) {
        for (double degrees = 0.0; degrees < 360.0; degrees += 30.0) {
            const SinCos around = sinCosDegrees(degrees);
            points.push_back(placed.anchorMetres +
                             glm::dvec3(reach * around.cos, height, reach * around.sin));
        }
    }
    // From level with the ground the first rank would hide all others.
    camera_.pitchDegrees = std::max(camera_.pitchDegrees, 25.0);
    camera_.frame(points, 0.05, cellPx());
}

void SpriteViewport::toGameDistance(const Session& session, double screenPxPerPx) {
    const PlacedEntity placed = session.placedInGame();
    camera_.target = placed.centreMetres();
    camera_.distance = 1.0;
    const double metresPerPx = session.profile().voxelSizeMetres / session.profile().sigma;
    camera_.distance =
        metresPerPx / (screenPxPerPx * camera_.camera(cellPx()).metresPerScreenPx(1.0));
}

void SpriteViewport::show(Ui& ui, ImVec2 min, ImVec2 size) {
    ViewInput input = canvas_.begin(ui, "view.sprite", min, size);
    turn_.advance(camera_, static_cast<double>(ImGui::GetIO().DeltaTime));
    SceneSettings& settings = ui.settings.scene;
    settings.comparison.follow(ui.session.profile().sigma);
    reference_ = ui.context.study.reference();
    gapPx_ = static_cast<int>(ui.theme.px(2));
    scale_ = ui.theme.scale;
    areas_ = cellAreas(canvas_.sizePx(), settings.comparison.cells, gapPx_);
    comparedPx_ = glm::max(canvas_.sizePx() - glm::ivec2(0, RepresentationCells::barPx(ui.theme)),
                           glm::ivec2(1));
    compared_.advance(settings.representations, static_cast<double>(ImGui::GetIO().DeltaTime));
    if (ui.settings.view.playing) {
        scene_.advance(static_cast<double>(ImGui::GetIO().DeltaTime), ui.session, settings);
    }
    ui.figures.scene = figures_;
    // Cells that have just been asked for have no pictures yet.
    if (settings.representations.compared) {
        showRepresentations(ui, input);
    } else if (areas_.size() > 1 && cells_.size() == areas_.size()) {
        showCells(ui, input);
    } else {
        showAlone(ui, input);
    }
    if (!settings.representations.compared) drawSpriteToolbar(ui, canvas_);
    canvas_.end();
}

void SpriteViewport::showCells(Ui& ui, ViewInput& input) {
    // The cell under the pointer is what is looked around in.
    for (const CellArea& area : areas_) {
        const glm::dvec2 in = input.pointerPx - glm::dvec2(area.min);
        if (in.x < 0.0 || in.y < 0.0 || in.x >= area.size.x || in.y >= area.size.y) continue;
        input.pointerPx = in;
        break;
    }
    input.sizePx = cellPx();
    if (input.held) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        camera_.orbit({static_cast<double>(moved.x), static_cast<double>(moved.y)});
    }
    ViewCanvas::navigate(input, camera_);
    // What is shown now is drawn after it: the textures have to be those that will be drawn into.
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        if (cells_[i].frame) cells_[i].frame->resize(areas_[i].size);
    }
    showSigmaCells(ui, canvas_, areas_, cells_);
}

void SpriteViewport::showRepresentations(Ui& ui, ViewInput& input) {
    const bool onCells = input.pointerPx.y < comparedPx_.y;
    if (input.held && onCells) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        camera_.orbit({static_cast<double>(moved.x), static_cast<double>(moved.y)});
    }
    // Near and far are the row's: the wheel goes there, too.
    RepresentationSettings& settings = ui.settings.scene.representations;
    const ViewMotion motion = motionOf(input);
    const double notches = motion.dragNotches + motion.wheelNotches;
    if (notches != 0.0) {
        settings.flying = false;
        settings.comparedSizePx = std::clamp(settings.comparedSizePx * std::exp2(notches / 6.0),
                                             kLeastComparedPx, kMostComparedPx);
    }
    if (motion.orbitPx != glm::dvec2(0.0)) camera_.orbit(motion.orbitPx);
    compared_.show(ui, canvas_, *library_);
}

void SpriteViewport::showAlone(Ui& ui, ViewInput& input) {
    // Where no handle is, the left button looks around, too.
    const Camera before = camera_.camera(input.sizePx);
    if (input.pressed && ImGui::GetIO().KeyAlt) {
        const std::uint8_t colour =
            colourUnder(ui.session, before, history(ui.settings.scene), input.pointerPx);
        if (colour != 0) ui.settings.tool.colour = colour;
        input.pressed = false;  // picking takes hold of no handle
    }
    useGizmo(ui, input, before);
    if (input.held && !gizmo_.dragging()) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        camera_.orbit({static_cast<double>(moved.x), static_cast<double>(moved.y)});
    }
    ViewCanvas::navigate(input, camera_);
    if (showsSides(ui.settings.trade)) showSides(ui);

    // In the first frame of all the camera does not know yet where it belongs.
    if (drawnAt_ == std::chrono::steady_clock::time_point()) {
        return canvas_.caption(ui, "Sprite", "", leftOfSpriteToolbar(ui.theme, canvas_));
    }
    const Camera camera = camera_.camera(input.sizePx);
    if (ui.settings.trade.heat) heat_->show(ui, canvas_, input.pointerPx);
    if (ui.settings.view.anchorMarker) drawAnchor(ui, camera, ui.session.placedInGame());
    if (!ui.session.bounds().empty()) {
        const GizmoTarget target =
            gizmoTarget(ui.session, ui.settings.tool.gizmo, stats().sigmaInForce);
        gizmo_.draw(target, camera, ViewDrawing(canvas_, camera), ui.theme);
    }
    drawSocketsOverSprite(ui, ViewDrawing(canvas_, camera), camera, history(ui.settings.scene));
    std::array<char, 64> detail{};
    if (stats().drawn > 0) {
        // What belongs together is joined by unbreakable blanks.
        std::snprintf(detail.data(), detail.size(), "σ\u00a0%.4g   %.1f\u00a0px\u00a0a\u00a0vpx",
                      stats().sigmaInForce, stats().screenPxPerPx);
    }
    canvas_.caption(ui, "Sprite", detail.data(), leftOfSpriteToolbar(ui.theme, canvas_));
}

void SpriteViewport::useGizmo(Ui& ui, const ViewInput& input, const Camera& camera) {
    if (ui.session.bounds().empty()) return;
    const GizmoTarget target =
        gizmoTarget(ui.session, ui.settings.tool.gizmo, stats().sigmaInForce);
    if (input.pressed) gizmoKey_ = ui.session.newMergeKey();
    const auto entity =
        gizmo_.update(target, camera, input, ui.theme.scale, ImGui::GetIO().KeyCtrl);
    if (!entity || !validate(*entity)) return;
    constexpr std::array kLabels{"", "Move proxy box", "Rotate proxy box", "Scale proxy box"};
    ui.edits.push(makeAction(kLabels[static_cast<std::size_t>(target.kind)],
                             EntityEdit{target.entity, *entity}, gizmoKey_));
}

void SpriteViewport::drawAnchor(Ui& ui, const Camera& camera, const PlacedEntity& placed) {
    const Theme& theme = ui.theme;
    const ViewDrawing drawing(canvas_, camera);
    const auto at = drawing.project(placed.anchorMetres);
    if (!at) return;
    const float inner = theme.px(3), outer = theme.px(9);
    ImDrawList& list = drawing.list();
    for (const ImU32 colour : {IM_COL32(16, 17, 19, 200), theme.accent}) {
        const float width = theme.px(colour == theme.accent ? 2.0f : 4.0f);
        list.AddCircle(*at, theme.px(6), colour, 0, width);
        list.AddLine({at->x - outer, at->y}, {at->x - inner, at->y}, colour, width);
        list.AddLine({at->x + inner, at->y}, {at->x + outer, at->y}, colour, width);
        list.AddLine({at->x, at->y - outer}, {at->x, at->y - inner}, colour, width);
        list.AddLine({at->x, at->y + inner}, {at->x, at->y + outer}, colour, width);
    }
    ui.probe.mark("sprite.anchor", {at->x - outer, at->y - outer}, {at->x + outer, at->y + outer});
}

ViewHistory SpriteViewport::history(const SceneSettings& settings) const {
    const std::size_t cell = settings.comparison.inForceAmong(cells_.size());
    if (cell >= cells_.size() || cells_[cell].histories.empty()) return {};
    return cells_[cell].histories.front();
}

Result<Image> SpriteViewport::picture(const Session& session,
                                      const EditorSettings& settings) const {
    const SceneSettings& scene = settings.scene;
    const Camera camera = camera_.camera(cellPx());
    if (showsSides(settings.trade) && settings.trade.side == SideShown::b) {
        const GameProfile profile = trade::profileWith(session.profile(), *settings.trade.b);
        const auto& histories = cellB_.histories;
        return spritePicture(session, profile, camera,
                             histories.empty() ? ViewHistory() : histories.front(),
                             scene.pictureScale);
    }
    return spritePicture(session, session.profile(), camera, history(scene), scene.pictureScale);
}

bool SpriteViewport::animates(const EditorSettings& settings) const {
    const RepresentationSettings& representations = settings.scene.representations;
    if (library_->busy() || (settings.trade.heat && heat_->busy())) return true;
    if (representations.compared && (representations.flying || compared_.pending())) return true;
    return postponed_ || settings.scene.everyFrame ||
           (settings.view.playing && scene_.moves(settings.scene));
}

void SpriteViewport::prepare(SpriteCell& cell) {
    // A copy's history is of no use to whoever comes to stand in its place.
    if (cell.arrangement == scene_.arrangement() && !cell.histories.empty()) return;
    cell.arrangement = scene_.arrangement();
    cell.histories.resize(std::min<std::size_t>(cell.histories.size(), 1));
    cell.histories.resize(scene_.entityCount());
    cell.chosen.assign(scene_.entityCount(), std::nullopt);
}

Status SpriteViewport::renderCell(SpriteCell& cell, Frame& frame, const Session& session,
                                  const GpuOctree& octree, const EditorSettings& settings,
                                  const GameProfile& profile) {
    prepare(cell);
    Scene scene = scene_.make(session, octree, settings.view, profile, cell.histories);
    const Camera camera = camera_.camera(frame.sizePx());
    cell.shares = representations_.choose(scene, camera, settings.scene.representations, *library_,
                                          cell.chosen);
    const Result<SceneStats> stats = renderer_.draw(frame, scene, camera, profile, profile.mode);
    if (!stats) return Failure(stats.error());
    cell.stats = *stats;
    if (settings.view.proxyBox && !session.bounds().empty()) {
        const GizmoTarget target =
            gizmoTarget(session, settings.tool.gizmo, cell.stats.sigmaInForce);
        const auto corners = proxyCorners(target.placed, target.sigmaInForce);
        OverlayShapes shapes;
        shapes.addBox(corners, Rgba8(255, 255, 255, 150), 1.5f * scale_);
        overlay_.draw(frame, shapes, camera, OverlayDepth::faintBehind);
    }
    return {};
}

void SpriteViewport::followLevels(const Session& session, const GpuOctree& octree,
                                  const EditorSettings& settings) {
    const RepresentationSettings& representations = settings.scene.representations;
    const bool forB =
        showsSides(settings.trade) && settings.trade.b->drawnBy != Representation::sprite;
    if (representations.rule == DrawRule::exact && !representations.compared && !forB) {
        return library_->clear();
    }
    const bool measured = representations.compared || representations.rule == DrawRule::automatic;
    const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
    library_->follow(scene_.levelSources(session, octree), representations, session.profile(),
                     measured, now.count());
    // An edit that is only being shown is not what is measured, and a hand at work comes first.
    if (!session.previews() && !ImGui::IsAnyMouseDown()) library_->work(renderer_);
}

Result<bool> SpriteViewport::renderCompared(const Session& session, const GpuOctree& octree,
                                            const RepresentationSettings& settings) {
    if (session.bounds().empty()) {
        compared_.clear();
        return false;
    }
    const OrbitAngles angles{camera_.yawDegrees, camera_.pitchDegrees, 0.0};
    const RepresentationCells::Subject subject{
        &octree, &session.shownPalette(), session.placedInGame(), session.profile(),
        angles,  session.revision()};
    return compared_.render(renderer_, subject, *library_, settings, comparedPx_, gapPx_);
}

void SpriteViewport::renderFirst(const Session& session) {
    canvas_.frame().set(firstSpritePicture(session, camera_.camera(canvas_.sizePx())));
}

Result<bool> SpriteViewport::render(const Session& session, const GpuOctree& octree,
                                    const EditorSettings& settings) {
    Result<bool> drew = renderScene(session, octree, settings);
    if (!drew || !wantsHeat(session, settings)) {
        heat_->clear();
        return drew;
    }
    if (const Status heat = followHeat(session, octree, settings); !heat) {
        return Failure(heat.error());
    }
    return drew;
}

Result<bool> SpriteViewport::renderScene(const Session& session, const GpuOctree& octree,
                                         const EditorSettings& settings) {
    std::ranges::move(scene_.follow(session, settings.scene), std::back_inserter(problems_));
    followLevels(session, octree, settings);
    figures_.progress = library_->progress();
    if (settings.scene.representations.compared) {
        shown_.reset();
        return renderCompared(session, octree, settings.scene.representations);
    }
    const SigmaComparison& comparison = settings.scene.comparison;
    const Shown wanted{octree.revision(),
                       session.revision(),
                       scene_.revision(),
                       camera_,
                       canvas_.sizePx(),
                       areas_.size(),
                       scale_,
                       settings.view,
                       comparison,
                       settings.scene.representations,
                       library_->revision(),
                       showsSides(settings.trade) ? settings.trade.b : std::nullopt,
                       settings.trade.side};
    postponed_ = false;
    if (shown_ == wanted && !settings.scene.everyFrame) return false;
    const auto start = std::chrono::steady_clock::now();
    // A crowd that takes long to draw must not hold up the hand that moves over the edit view: half
    // of the time is left to it.
    postponed_ = session.previews() && figures_.cpuMs > kSlowMs &&
                 milliseconds(start - drawnAt_) < figures_.cpuMs && shown_ &&
                 shown_->sizePx == wanted.sizePx;
    if (postponed_) return false;
    cells_.resize(areas_.size());
    Status done;
    SceneStats sum;
    timer_.begin();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        SpriteCell& cell = cells_[i];
        GameProfile profile = session.profile();
        if (cells_.size() == 1) {
            cell.frame.reset();
            done = renderCell(cell, canvas_.frame(), session, octree, settings, profile);
        } else {
            profile.sigma = comparison.sigmas[i];
            if (!cell.frame) cell.frame = std::make_unique<Frame>(areas_[i].size);
            cell.frame->resize(areas_[i].size);
            // One value that is out of reach does not take the others away.
            const Status drawn = renderCell(cell, *cell.frame, session, octree, settings, profile);
            cell.problem = drawn ? "" : drawn.error().describe();
        }
        add(sum, cell.stats);
    }
    if (showsSides(settings.trade)) {
        const Status drawn = renderB(session, octree, settings);
        cellB_.problem = drawn ? "" : drawn.error().describe();
        add(sum, cellB_.stats);
    }
    drawnAt_ = std::chrono::steady_clock::now();
    timer_.end();
    shown_ = wanted;
    const SpriteCell& cellInForce = cells_[comparison.inForceAmong(cells_.size())];
    figures_.shares = cellInForce.shares;
    if (!done) return Failure(done.error());
    const bool isB = showsSides(settings.trade) && settings.trade.side == SideShown::b;
    const SceneStats& inForce = isB ? cellB_.stats : cellInForce.stats;
    sum.sigmaInForce = inForce.sigmaInForce;
    sum.screenPxPerPx = inForce.screenPxPerPx;
    figures_.entities = scene_.entityCount();
    figures_.stats = sum;
    figures_.cpuMs = milliseconds(drawnAt_ - start);
    figures_.gpuMs = timer_.readyMs();
    figures_.cpuTimes.push(static_cast<float>(figures_.cpuMs));
    return true;
}

}  // namespace voxprite::editor
