#include "app/editor/views/view_drawing.h"

#include <algorithm>

#include "app/editor/views/picking.h"

namespace voxprite::editor {

std::optional<ImVec2> ViewDrawing::project(glm::dvec3 world) const {
    const Camera::Projected projected = camera_->project(world);
    if (projected.depthMetres <= camera_->nearMetres) return std::nullopt;
    return canvas_->toWindow(projected.screenPx);
}

void ViewDrawing::line(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float width) const {
    const auto from = project(a), to = project(b);
    if (from && to) list_->AddLine(*from, *to, colour, width);
}

void ViewDrawing::face(const std::array<glm::dvec3, 4>& corners, ImU32 colour) const {
    std::array<ImVec2, 4> points{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto point = project(worldFromVoxel(corners[i]));
        if (!point) return;
        points[i] = *point;
    }
    list_->AddConvexPolyFilled(points.data(), 4, colour);
}

void ViewDrawing::box(const IBox& box, ImU32 colour, float width) const {
    const glm::dvec3 min(box.min), max(box.max);
    const auto corner = [&](int o) {
        return worldFromVoxel({(o & 1) != 0 ? max.x : min.x, (o & 2) != 0 ? max.y : min.y,
                               (o & 4) != 0 ? max.z : min.z});
    };
    for (int o = 0; o < 8; ++o) {
        for (const int bit : {1, 2, 4}) {
            if ((o & bit) == 0) line(corner(o), corner(o | bit), colour, width);
        }
    }
}

void ViewDrawing::boxFaces(const IBox& box, ImU32 colour) const {
    const glm::dvec3 eye = voxelFromWorld(camera_->eyeMetres);
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        double plane = 0.0;
        if (eye[axis] > box.max[axis]) {
            plane = box.max[axis];
        } else if (eye[axis] < box.min[axis]) {
            plane = box.min[axis];
        } else {
            continue;
        }
        std::array<glm::dvec3, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
            corners[i][axis] = plane;
            corners[i][u] = i == 1 || i == 2 ? box.max[u] : box.min[u];
            corners[i][v] = i >= 2 ? box.max[v] : box.min[v];
        }
        face(corners, colour);
    }
}

void ViewDrawing::label(const Theme& theme, ImVec2 at, const char* text) const {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 pad = theme.px(8, 4);
    // Wherever it belongs, it is to be read: inside the view.
    const ImVec2 min = list_->GetClipRectMin(), max = list_->GetClipRectMax();
    at.x = std::max(min.x, std::min(at.x, max.x - size.x - 3 * pad.x));
    at.y = std::max(min.y, std::min(at.y, max.y - size.y - 3 * pad.y));
    list_->AddRectFilled(at, {at.x + size.x + 2 * pad.x, at.y + size.y + 2 * pad.y},
                         IM_COL32(16, 17, 19, 200), theme.px(5));
    list_->AddText({at.x + pad.x, at.y + pad.y}, IM_COL32(240, 241, 243, 255), text);
}

}  // namespace voxprite::editor
