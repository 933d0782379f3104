#include "app/cli/conformance/literal.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

namespace voxprite::conformance {
namespace {

// GLSL's ProjectionMatrix[0][0] and [1][1].
glm::dvec2 projectionScale(const Camera& camera) {
    return 2.0 / (glm::dvec2(camera.viewportPx) * camera.metresPerScreenPx(1.0));
}

}  // namespace

glm::dvec2 literalAnchorOffset(const Camera& camera, glm::dvec3 anchorMetres, double cameraDistance,
                               double voxelSizeMetres, glm::dvec2 screenPx) {
    const glm::dvec2 scale = projectionScale(camera);
    const glm::dvec3 fromEye = anchorMetres - camera.eyeMetres;
    const double w = camera.orthographic ? 1.0 : glm::dot(fromEye, camera.forward);
    const glm::dvec2 anchorNdc = glm::dvec2(glm::dot(fromEye, camera.right) * scale.x,
                                            glm::dot(fromEye, camera.up) * scale.y) /
                                 w;
    const glm::dvec2 fromTop = screenPx / glm::dvec2(camera.viewportPx);
    const glm::dvec2 fragmentNdc{fromTop.x * 2.0 - 1.0, 1.0 - fromTop.y * 2.0};
    return (fragmentNdc - anchorNdc) * cameraDistance / scale / voxelSizeMetres;
}

double euclideanDistance(const Camera& camera, glm::dvec3 pointMetres) {
    return glm::length(pointMetres - camera.eyeMetres);
}

glm::dvec3 literalAnchorToCentre(glm::ivec3 modelSize) {
    return glm::dvec3(modelSize) * 0.5;
}

glm::dmat3 literalVoxelAxes(const Camera& camera) {
    return {voxelFromWorld(camera.right), voxelFromWorld(camera.up),
            voxelFromWorld(camera.forward)};
}

std::array<long double, 3> centredSample(const OrthoView& view, glm::ivec3 modelSize,
                                         glm::ivec2 pixel, double offsetPx) {
    std::array<long double, 3> at{};
    for (int axis = 0; axis < 3; ++axis) {
        const long double u = pixel.x + static_cast<long double>(offsetPx);
        const long double v = pixel.y + static_cast<long double>(offsetPx);
        at[static_cast<std::size_t>(axis)] =
            modelSize[axis] * 0.5L + (u * view.right[axis] + v * view.up[axis]) / view.sigmaInForce;
    }
    return at;
}

glm::dvec2 projectThroughFp32World(const Camera& camera, glm::dvec3 objectMetres,
                                   glm::dvec3 pointFromObject) {
    glm::mat4 worldFromModel(1.0f);
    worldFromModel[3] = glm::vec4(glm::vec3(objectMetres), 1.0f);
    const glm::mat3 axes(glm::vec3(camera.right), glm::vec3(camera.up), glm::vec3(-camera.forward));
    glm::mat4 viewFromWorld{glm::transpose(axes)};
    viewFromWorld[3] = glm::vec4(-(glm::transpose(axes) * glm::vec3(camera.eyeMetres)), 1.0f);
    const glm::vec2 scale(projectionScale(camera));
    const glm::vec4 view =
        viewFromWorld * (worldFromModel * glm::vec4(glm::vec3(pointFromObject), 1.0f));
    const glm::vec2 ndc = glm::vec2(view.x, view.y) * scale / -view.z;
    return (glm::dvec2(ndc.x, -ndc.y) * 0.5 + 0.5) * glm::dvec2(camera.viewportPx);
}

std::uint32_t depth24(double nearMetres, double farMetres, double depthMetres) {
    const double ndc = (farMetres + nearMetres - 2.0 * farMetres * nearMetres / depthMetres) /
                       (farMetres - nearMetres);
    return static_cast<std::uint32_t>(std::lround((ndc * 0.5 + 0.5) * ((1 << 24) - 1)));
}

std::uint8_t materialInProseOrder(const OctreeView& octree, glm::ivec3 tree) {
    std::uint32_t word = octree.nodes[0];
    for (int bit = octree.maxDepth - 1;; --bit) {
        const unsigned swapped = octantOf({tree.z, tree.y, tree.x}, bit);
        if (node::isBrick(word))
            return payloadMaterial(octree.payloads[node::payloadIndex(word)], swapped);
        if (!node::isInternal(word)) return static_cast<std::uint8_t>(word);
        if (!node::hasChild(word, swapped)) return 0;
        word = octree.nodes[node::childIndex(word, swapped)];
    }
}

LatticeHit castCells(const OctreeView& octree, const std::array<long double, 3>& origin,
                     const std::array<long double, 3>& direction, long double unitsPerVoxel) {
    constexpr long double kInfinity = std::numeric_limits<long double>::infinity();
    long double enter = -kInfinity;
    long double leave = kInfinity;
    std::size_t axis = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const long double edge = octree.size[static_cast<int>(a)] * unitsPerVoxel;
        if (direction[a] == 0) {
            if (origin[a] < 0 || origin[a] >= edge) return {};
            continue;
        }
        const long double low = -origin[a] / direction[a];
        const long double high = (edge - origin[a]) / direction[a];
        if (std::min(low, high) >= enter) {
            enter = std::min(low, high);
            axis = a;
        }
        leave = std::min(leave, std::max(low, high));
    }
    if (!(enter < leave)) return {};
    glm::ivec3 cell{0};
    std::array<long double, 3> next{};
    const auto crossAhead = [&](std::size_t a) {
        if (direction[a] == 0) return kInfinity;
        const int face = cell[static_cast<int>(a)] + (direction[a] > 0 ? 1 : 0);
        return (face * unitsPerVoxel - origin[a]) / direction[a];
    };
    for (std::size_t a = 0; a < 3; ++a) {
        const long double at =
            (direction[a] == 0 ? origin[a] : origin[a] + enter * direction[a]) / unitsPerVoxel;
        const long double behind = direction[a] < 0 ? std::ceil(at) - 1 : std::floor(at);
        cell[static_cast<int>(a)] =
            std::clamp(static_cast<int>(behind), 0, octree.size[static_cast<int>(a)] - 1);
        next[a] = crossAhead(a);
    }
    for (;;) {
        if (const std::uint8_t material = materialAt(octree, cell); material != 0)
            return {material, static_cast<std::uint8_t>(axis), cell};
        axis = 0;
        if (next[1] < next[axis]) axis = 1;
        if (next[2] < next[axis]) axis = 2;
        const int a = static_cast<int>(axis);
        cell[a] += direction[axis] > 0 ? 1 : -1;
        if (cell[a] < 0 || cell[a] >= octree.size[a]) return {};
        next[axis] = crossAhead(axis);
    }
}

}  // namespace voxprite::conformance
