#include "app/editor/tools/handles.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace voxprite::editor {
namespace {

constexpr double kHandleReachPx = 10.0;
constexpr float kHalfPx = 4.5f;

}  // namespace

int handleAt(std::span<const Handle> handles, const Camera& camera, glm::dvec2 pointerPx,
             float scale) {
    int best = -1;
    double bestPx = kHandleReachPx * static_cast<double>(scale);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const Camera::Projected at = camera.project(worldFromVoxel(handles[i].at));
        if (at.depthMetres <= camera.nearMetres) continue;
        const double px = glm::length(at.screenPx - pointerPx);
        if (px < bestPx) {
            bestPx = px;
            best = static_cast<int>(i);
        }
    }
    return best;
}

void drawHandles(std::span<const Handle> handles, int hot, const ViewDrawing& drawing,
                 const Theme& theme) {
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const auto at = drawing.project(worldFromVoxel(handles[i].at));
        if (!at) continue;
        const bool isHot = static_cast<int>(i) == hot;
        const float half = theme.px(isHot ? kHalfPx + 1.5f : kHalfPx);
        const float line = theme.px(1.5f);
        ImDrawList& list = drawing.list();
        list.AddRectFilled({at->x - half - line, at->y - half - line},
                           {at->x + half + line, at->y + half + line}, IM_COL32(16, 17, 19, 220),
                           theme.px(3));
        list.AddRectFilled({at->x - half, at->y - half}, {at->x + half, at->y + half},
                           isHot ? theme.accent : IM_COL32(245, 246, 248, 255), theme.px(2));
    }
}

std::optional<double> alongAxis(const Camera::Ray& ray, glm::dvec3 origin, int axis) {
    const glm::dvec3 eye = voxelFromWorld(ray.origin);
    const glm::dvec3 direction = glm::normalize(voxelFromWorld(ray.direction));
    const glm::dvec3 from = eye - origin;
    const double cosine = direction[axis];
    const double sineSquared = 1.0 - cosine * cosine;
    if (sineSquared < 1e-4) return std::nullopt;
    const double t = (from[axis] - cosine * glm::dot(from, direction)) / sineSquared;
    return origin[axis] + t;
}

}  // namespace voxprite::editor
