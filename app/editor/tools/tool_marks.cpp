#include "app/editor/tools/tool_marks.h"

#include <algorithm>

namespace voxprite::editor {

void markFace(const ViewDrawing& drawing, const Theme& theme, const Pick& pick, EditMode mode) {
    drawing.face(faceCorners(pick), withAlpha(colourOf(theme, mode), 0.35f));
}

std::string sizeText(glm::ivec3 size) {
    return std::to_string(size.x) + " × " + std::to_string(size.y) + " × " + std::to_string(size.z);
}

void markSize(const ViewDrawing& drawing, const Theme& theme, const IBox& box) {
    std::optional<ImVec2> corner;
    for (int o = 0; o < 8; ++o) {
        const glm::dvec3 at((o & 1) != 0 ? box.max.x : box.min.x,
                            (o & 2) != 0 ? box.max.y : box.min.y,
                            (o & 4) != 0 ? box.max.z : box.min.z);
        const auto px = drawing.project(worldFromVoxel(at));
        if (!px) continue;
        if (!corner) corner = px;
        corner = ImVec2{std::max(corner->x, px->x), std::min(corner->y, px->y)};
    }
    if (!corner) return;
    drawing.label(theme, {corner->x + theme.px(10), corner->y - theme.px(12)},
                  sizeText(box.size()).c_str());
}

}  // namespace voxprite::editor
