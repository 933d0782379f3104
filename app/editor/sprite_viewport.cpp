#include "app/editor/sprite_viewport.h"

#include <array>
#include <cstdio>

namespace voxprite::editor {
namespace {

// What an empty document shows of the scene, in voxels.
constexpr glm::ivec3 kEmptyShown(24, 24, 12);

GizmoTarget gizmoTarget(const Session& session, GizmoKind kind, double sigmaInForce) {
    const PlacedEntity placed = session.placedInGame();
    return {kind, session.document().entity, placed,
            sigmaInForce > 0.0 ? sigmaInForce : session.profile().sigma, placed.metresPerVoxel()};
}

}  // namespace

Result<SpriteViewport> SpriteViewport::create() {
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    Result<Overlay> overlay = Overlay::create();
    if (!overlay) return Failure(overlay.error());
    return SpriteViewport(std::move(*renderer), std::move(*overlay));
}

void SpriteViewport::frameModel(const Session& session) {
    PlacedEntity placed = session.placedInGame();
    if (session.bounds().empty()) placed.modelSize = kEmptyShown;
    camera_.frame(proxyCorners(placed, session.profile().sigma), 0.25, canvas_.sizePx());
}

void SpriteViewport::show(Ui& ui, ImVec2 min, ImVec2 size) {
    ViewInput input = canvas_.begin(ui, "view.sprite", min, size);
    // Where no handle is, the left button looks around, too.
    const Camera before = camera_.camera(input.sizePx);
    useGizmo(ui, input, before);
    if (input.held && !gizmo_.dragging()) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        camera_.orbit({static_cast<double>(moved.x), static_cast<double>(moved.y)});
    }
    ViewCanvas::navigate(input, camera_);

    const Camera camera = camera_.camera(input.sizePx);
    const PlacedEntity placed = ui.session.placedInGame();
    const bool empty = ui.session.bounds().empty();
    if (ui.settings.view.anchorMarker) drawAnchor(ui, camera, placed);
    if (!empty) {
        const GizmoTarget target =
            gizmoTarget(ui.session, ui.settings.tool.gizmo, stats_.sigmaInForce);
        gizmo_.draw(target, camera, ViewDrawing(canvas_, camera), ui.theme);
    }
    std::array<char, 64> detail{};
    if (stats_.drawn > 0) {
        std::snprintf(detail.data(), detail.size(), "σ %.4g   %.1f px a vpx", stats_.sigmaInForce,
                      stats_.screenPxPerPx);
    }
    canvas_.caption(ui, "Sprite", detail.data());
    canvas_.end();
}

void SpriteViewport::useGizmo(Ui& ui, const ViewInput& input, const Camera& camera) {
    if (ui.session.bounds().empty()) return;
    const GizmoTarget target = gizmoTarget(ui.session, ui.settings.tool.gizmo, stats_.sigmaInForce);
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

Result<bool> SpriteViewport::render(const Session& session, const GpuOctree& octree,
                                    const EditorSettings& settings) {
    const Shown wanted{octree.revision(), session.revision(), camera_, canvas_.sizePx(),
                       settings.view};
    if (shown_ == wanted) return false;
    Scene scene;
    scene.entities.push_back(
        {&octree, &session.document().palette, session.placedInGame(), &history_});
    scene.background = Rgba8(120, 150, 190, 255);
    scene.sky = true;
    scene.ground = Ground{};
    scene.groundGrid = settings.view.groundGrid;
    scene.shadowBlobs = settings.view.shadow;
    const Camera camera = camera_.camera(wanted.sizePx);
    Result<SceneStats> stats =
        renderer_.draw(canvas_.frame(), scene, camera, session.profile(), SpriteMode::spriteBuffer);
    if (!stats) return Failure(stats.error());
    stats_ = *stats;
    if (settings.view.proxyBox && !session.bounds().empty()) {
        const GizmoTarget target = gizmoTarget(session, settings.tool.gizmo, stats_.sigmaInForce);
        const auto corners = proxyCorners(target.placed, target.sigmaInForce);
        OverlayShapes shapes;
        shapes.addBox(corners, Rgba8(255, 255, 255, 150), 1.5f);
        overlay_.draw(canvas_.frame(), shapes, camera, OverlayDepth::faintBehind);
    }
    shown_ = wanted;
    return true;
}

}  // namespace voxprite::editor
