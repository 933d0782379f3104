#include "app/editor/views/view_cube.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/sprite/camera.h"

namespace voxprite::editor {
namespace {

// What lies this far from the middle of a face belongs to its edges; half an edge is 1.
constexpr double kInner = 0.56;

struct Face {
    int axis;
    int sign;
    const char* name;
    glm::dvec3 right, up;  // as its name is read, in voxel axes
};
constexpr std::array kFaces{
    Face{1, -1, "FRONT", {1, 0, 0}, {0, 0, 1}}, Face{1, 1, "BACK", {-1, 0, 0}, {0, 0, 1}},
    Face{0, 1, "RIGHT", {0, 1, 0}, {0, 0, 1}},  Face{0, -1, "LEFT", {0, -1, 0}, {0, 0, 1}},
    Face{2, 1, "TOP", {1, 0, 0}, {0, 1, 0}},    Face{2, -1, "BELOW", {1, 0, 0}, {0, -1, 0}}};

glm::dvec3 normalOf(const Face& face) {
    glm::dvec3 normal(0.0);
    normal[face.axis] = face.sign;
    return normal;
}

// The camera's right, up and forward in voxel axes.
struct Axes {
    glm::dvec3 right, up, forward;
    explicit Axes(const OrbitCamera& camera) {
        const glm::dmat3 world = orbitBasis({camera.yawDegrees, camera.pitchDegrees, 0.0});
        right = voxelFromWorld(world[0]);
        up = voxelFromWorld(world[1]);
        forward = voxelFromWorld(world[2]);
    }
};

// From a point of the cube, half an edge being 1, to the screen.
struct Screen {
    Axes axes;
    ImVec2 middle;
    double halfEdge;
    [[nodiscard]] ImVec2 at(glm::dvec3 point) const {
        const glm::dvec3 scaled = point * halfEdge;
        return {middle.x + static_cast<float>(glm::dot(scaled, axes.right)),
                middle.y - static_cast<float>(glm::dot(scaled, axes.up))};
    }
};

// Text that lies on a face: letters are laid out flat, then their corners are carried onto it.
void drawName(const Theme& theme, ImDrawList& draw, const Screen& screen, const Face& face,
              ImU32 colour) {
    ImFont* font = theme.fonts.bold;
    // A name is as wide as its face at most.
    const double perPx = 0.6 / static_cast<double>(theme.px(kViewCubeHalfEdge));
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, face.name);
    const int first = draw.VtxBuffer.Size;
    draw.PushClipRectFullScreen();
    draw.AddText(font, font->FontSize, {0, 0}, colour, face.name);
    draw.PopClipRect();
    for (int i = first; i < draw.VtxBuffer.Size; ++i) {
        ImVec2& at = draw.VtxBuffer[i].pos;
        const double x = static_cast<double>(at.x - size.x * 0.5f) * perPx;
        const double y = static_cast<double>(size.y * 0.5f - at.y) * perPx;
        at = screen.at(normalOf(face) + face.right * x + face.up * y);
    }
}

// The rectangle of a face that belongs to a part.
void drawPart(ImDrawList& draw, const Screen& screen, const Face& face, glm::ivec3 part,
              ImU32 colour) {
    if (part[face.axis] != face.sign) return;
    const auto range = [&](glm::dvec3 direction) {
        const double along = glm::dot(glm::dvec3(part), direction);
        if (along > 0.5) return glm::dvec2(kInner, 1.0);
        return along < -0.5 ? glm::dvec2(-1.0, -kInner) : glm::dvec2(-kInner, kInner);
    };
    const glm::dvec2 x = range(face.right), y = range(face.up);
    const glm::dvec3 normal = normalOf(face);
    const auto at = [&](double u, double v) {
        return screen.at(normal + face.right * u + face.up * v);
    };
    draw.AddQuadFilled(at(x[0], y[0]), at(x[1], y[0]), at(x[1], y[1]), at(x[0], y[1]), colour);
}

}  // namespace

std::optional<glm::ivec3> viewCubePartAt(const OrbitCamera& camera, double halfEdgePx,
                                         glm::dvec2 fromMiddlePx) {
    const Axes axes(camera);
    const glm::dvec3 onPlane =
        (axes.right * fromMiddlePx.x - axes.up * fromMiddlePx.y) / halfEdgePx;
    // The nearest of the three faces that look this way, where the line of sight meets the cube.
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(axes.forward[axis]) < 1e-9) continue;
        const double face = axes.forward[axis] < 0.0 ? 1.0 : -1.0;
        const glm::dvec3 hit =
            onPlane + axes.forward * ((face - onPlane[axis]) / axes.forward[axis]);
        glm::ivec3 part(0);
        bool inside = true;
        for (int other = 0; other < 3; ++other) {
            if (other == axis) {
                part[other] = static_cast<int>(face);
                continue;
            }
            inside = inside && std::abs(hit[other]) <= 1.0;
            if (std::abs(hit[other]) > kInner) part[other] = hit[other] > 0.0 ? 1 : -1;
        }
        if (inside) return part;
    }
    return std::nullopt;
}

void drawViewCube(const Theme& theme, ImDrawList& draw, ImVec2 middle, const OrbitCamera& camera,
                  const std::optional<glm::ivec3>& lit) {
    const Screen screen{Axes(camera), middle, static_cast<double>(theme.px(kViewCubeHalfEdge))};
    const bool dark = theme.kind == ThemeKind::dark;
    if (lit) draw.AddCircleFilled(middle, theme.px(kViewCubeRadius), IM_COL32(16, 17, 19, 70), 48);
    for (const Face& face : kFaces) {
        const glm::dvec3 normal = normalOf(face);
        const double facing = -glm::dot(normal, screen.axes.forward);
        if (facing < 1e-6) continue;
        const auto at = [&](double u, double v) {
            return screen.at(normal + face.right * u + face.up * v);
        };
        // The more a face looks this way, the lighter it is.
        const double shade = dark ? 60.0 + 46.0 * facing : 200.0 + 46.0 * facing;
        const int grey = static_cast<int>(shade);
        draw.AddQuadFilled(at(-1, -1), at(1, -1), at(1, 1), at(-1, 1),
                           IM_COL32(grey, grey + 2, grey + 6, 235));
        if (lit) drawPart(draw, screen, face, *lit, withAlpha(theme.accent, 0.85f));
        draw.AddQuad(at(-1, -1), at(1, -1), at(1, 1), at(-1, 1), IM_COL32(16, 17, 19, 160),
                     theme.px(1));
        // Seen from the side a name is a smear.
        const double legible = glm::clamp((facing - 0.25) / 0.3, 0.0, 1.0);
        const ImU32 ink = dark ? IM_COL32(240, 241, 243, 255) : IM_COL32(28, 29, 32, 255);
        if (legible > 0.0) {
            drawName(theme, draw, screen, face, withAlpha(ink, static_cast<float>(legible)));
        }
    }
}

}  // namespace voxprite::editor
