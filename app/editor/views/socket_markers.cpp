#include "app/editor/views/socket_markers.h"

#include <array>
#include <glm/geometric.hpp>

#include "app/editor/commands/command_context.h"
#include "app/editor/session/object_selection.h"
#include "core/sprite/sprite_point.h"

namespace voxprite::editor {
namespace {

// A small diamond, dark around the edge so that it shows on any colour.
void drawMark(Ui& ui, const ViewDrawing& drawing, ImVec2 at, std::size_t index, bool seen,
              const char* probe) {
    const Theme& theme = ui.theme;
    const Socket& socket = ui.session.document().sockets[index];
    const bool chosen = ui.context.objects.socket() == static_cast<int>(index);
    const float radius = theme.px(chosen ? 6.0f : 5.0f);
    // On dark in both themes.
    const ImU32 colour = chosen ? IM_COL32(255, 180, 70, 255) : IM_COL32(245, 246, 248, 255);
    const float alpha = seen ? 1.0f : 0.35f;
    ImDrawList& list = drawing.list();
    const auto diamond = [&](float r, ImU32 fill) {
        list.AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y},
                           fill);
    };
    diamond(radius + theme.px(2), IM_COL32(16, 17, 19, seen ? 220 : 110));
    diamond(radius, withAlpha(colour, alpha));
    if (!chosen) diamond(radius - theme.px(2), IM_COL32(16, 17, 19, seen ? 200 : 90));

    ImFont* font = theme.fonts.small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, socket.name.c_str());
    const ImVec2 corner(at.x + radius + theme.px(6), at.y - size.y * 0.5f);
    const ImVec2 pad = theme.px(5, 2);
    list.AddRectFilled({corner.x - pad.x, corner.y - pad.y},
                       {corner.x + size.x + pad.x, corner.y + size.y + pad.y},
                       IM_COL32(16, 17, 19, seen ? 170 : 80), theme.px(4));
    list.AddText(font, font->FontSize, corner, withAlpha(colour, alpha), socket.name.c_str());
    ui.probe.mark(std::string(probe) + std::to_string(index), {at.x - radius, at.y - radius},
                  {at.x + radius, at.y + radius});
}

}  // namespace

void drawSocketsOverVoxels(Ui& ui, const ViewDrawing& drawing) {
    if (!ui.settings.view.socketMarkers) return;
    const auto& sockets = ui.session.document().sockets;
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        const auto at = drawing.project(worldFromVoxel(positionAt(sockets[i], ui.session.frame())));
        if (at) drawMark(ui, drawing, *at, i, true, "edit.socket.");
    }
}

void drawSocketsOverSprite(Ui& ui, const ViewDrawing& drawing, const Camera& camera,
                           ViewHistory history) {
    const auto& sockets = ui.session.document().sockets;
    if (!ui.settings.view.socketMarkers || sockets.empty()) return;
    const Result<SpriteViewResult> shown =
        viewSprite(ui.session.placedInGame(), camera, ui.session.profile(), &history);
    if (!shown || !shown->view) return;
    const SpriteView& view = *shown->view;
    const IBox bounds = ui.session.shownBounds();
    const OctreeView octree = ui.session.shownOctree().view(bounds);
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        const glm::dvec3 point =
            positionAt(sockets[i], ui.session.frame()) - glm::dvec3(bounds.min);
        const glm::dvec3 fromCentre =
            (point - glm::dvec3(bounds.size()) * 0.5) * view.ortho.sigmaInForce;
        const glm::dvec2 px = glm::dvec2(glm::dot(fromCentre, view.ortho.right),
                                         glm::dot(fromCentre, view.ortho.up)) +
                              view.registrationShiftPx;
        const glm::dvec3 world = camera.eyeMetres + view.centreFromEyeMetres +
                                 (view.right * px.x + view.up * px.y) * view.metresPerPx;
        const bool seen = locateInSprite(view.lattice, octree, point).visible;
        if (const auto at = drawing.project(world)) {
            drawMark(ui, drawing, *at, i, seen, "sprite.socket.");
        }
    }
}

std::optional<int> socketAt(const Session& session, const Camera& camera, glm::dvec2 viewPx,
                            double reachPx) {
    const auto& sockets = session.document().sockets;
    std::optional<int> nearest;
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        const Camera::Projected at =
            camera.project(worldFromVoxel(positionAt(sockets[i], session.frame())));
        const double distance = glm::length(at.screenPx - viewPx);
        if (at.depthMetres <= camera.nearMetres || distance > reachPx) continue;
        reachPx = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

}  // namespace voxprite::editor
