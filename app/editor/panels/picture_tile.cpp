#include "app/editor/panels/picture_tile.h"

#include <algorithm>
#include <cmath>

#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {

void drawPictureTile(const Theme& theme, ImVec2 corner, float edge, const PictureTexture& picture) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + edge, corner.y + edge}, theme.field, theme.px(6));
    if (picture.width() == 0) return;
    const auto largest = static_cast<float>(std::max(picture.width(), picture.height()));
    const float fit = (edge - theme.px(8)) / largest;
    const float scale = fit >= 1.0f ? std::floor(fit) : fit;
    const ImVec2 size(static_cast<float>(picture.width()) * scale,
                      static_cast<float>(picture.height()) * scale);
    const ImVec2 at(std::floor(corner.x + (edge - size.x) * 0.5f),
                    std::floor(corner.y + (edge - size.y) * 0.5f));
    list.AddImage(imguiTexture(picture.id()), at, {at.x + size.x, at.y + size.y});
}

}  // namespace voxprite::editor
