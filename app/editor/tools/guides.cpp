#include "app/editor/tools/guides.h"

#include <array>

#include "core/sprite/camera.h"

namespace voxprite::editor {
namespace {

constexpr Rgba8 kLimitsColour(255, 214, 102, 210);
constexpr double kAirVoxels = 1.5;
constexpr IBox kEmptyShown{{-8, -8, 0}, {8, 8, 16}};

Rgba8 faint(Rgba8 colour, std::uint8_t alpha) {
    return {colour.x, colour.y, colour.z, alpha};
}

void addPlane(OverlayShapes& shapes, int axis, double at, const IBox& bounds, float widthPx) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<glm::dvec3, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
        glm::dvec3 corner(0.0);
        corner[axis] = at;
        corner[u] = i == 1 || i == 2 ? bounds.max[u] + kAirVoxels : bounds.min[u] - kAirVoxels;
        corner[v] = i >= 2 ? bounds.max[v] + kAirVoxels : bounds.min[v] - kAirVoxels;
        corners[i] = worldFromVoxel(corner);
    }
    const Rgba8 colour = kAxisColours[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < 4; ++i) {
        shapes.lines.push_back({corners[i], corners[(i + 1) % 4], faint(colour, 230), widthPx});
    }
    shapes.triangles.push_back({corners[0], corners[1], corners[2], faint(colour, 18)});
    shapes.triangles.push_back({corners[0], corners[2], corners[3], faint(colour, 18)});
}

}  // namespace

OverlayShapes guidesOf(const ToolOptions& options, const IBox& bounds, float scale) {
    OverlayShapes shapes;
    const IBox around = bounds.empty() ? kEmptyShown : bounds;
    for (int axis = 0; axis < 3; ++axis) {
        if (!options.symmetry.on[static_cast<std::size_t>(axis)]) continue;
        addPlane(shapes, axis, options.symmetry.planeDoubled[axis] / 2.0, around, 1.5f * scale);
    }
    if (options.limited && !options.limits.empty()) {
        const IBox& box = options.limits;
        std::array<glm::dvec3, 8> corners{};
        for (std::size_t o = 0; o < 8; ++o) {
            corners[o] = worldFromVoxel({(o & 1) != 0 ? box.max.x : box.min.x,
                                         (o & 2) != 0 ? box.max.y : box.min.y,
                                         (o & 4) != 0 ? box.max.z : box.min.z});
        }
        shapes.addBox(corners, kLimitsColour, 1.5f * scale);
    }
    return shapes;
}

void centreSymmetry(ToolOptions& options, const IBox& bounds) {
    options.symmetry.planeDoubled =
        bounds.empty() ? glm::ivec3(0) : Symmetry::planesThroughCentre(bounds);
    options.symmetryPlaced = true;
}

void switchSymmetry(ToolOptions& options, int axis, const IBox& bounds) {
    bool& on = options.symmetry.on[static_cast<std::size_t>(axis)];
    on = !on;
    if (on && !options.symmetryPlaced) centreSymmetry(options, bounds);
}

void switchLimits(ToolOptions& options, const IBox& bounds) {
    options.limited = !options.limited;
    if (!options.limited || !options.limits.empty()) return;
    options.limits = bounds.empty() ? IBox{{-16, -16, 0}, {16, 16, 32}} : bounds;
}

}  // namespace voxprite::editor
