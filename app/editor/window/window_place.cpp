#include "app/editor/window/window_place.h"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>

namespace voxprite::editor {
namespace {

std::int64_t overlap(const WorkArea& area, const WindowPlace& place) {
    const glm::ivec2 corner(place.x, place.y), size(place.width, place.height);
    const glm::ivec2 low = glm::max(area.corner, corner);
    const glm::ivec2 shared = glm::min(area.corner + area.size, corner + size) - low;
    if (shared.x <= 0 || shared.y <= 0) return 0;
    return std::int64_t{shared.x} * shared.y;
}

}  // namespace

WindowPlace placeOn(std::span<const WorkArea> displays, WindowPlace wanted, double contentScale) {
    wanted.width = static_cast<int>(wanted.width * contentScale);
    wanted.height = static_cast<int>(wanted.height * contentScale);
    if (displays.empty()) return wanted;
    const auto most = std::ranges::max_element(
        displays, {}, [&](const WorkArea& area) { return overlap(area, wanted); });
    wanted.known = wanted.known && overlap(*most, wanted) > 0;
    const WorkArea& area = wanted.known ? *most : displays.front();
    wanted.width = std::min(wanted.width, area.size.x);
    wanted.height = std::min(wanted.height, area.size.y);
    wanted.x = std::clamp(wanted.x, area.corner.x, area.corner.x + area.size.x - wanted.width);
    wanted.y = std::clamp(wanted.y, area.corner.y, area.corner.y + area.size.y - wanted.height);
    return wanted;
}

}  // namespace voxprite::editor
