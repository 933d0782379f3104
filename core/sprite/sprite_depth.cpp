#include "core/sprite/sprite_depth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/trace/packet_caster.h"

namespace voxprite {

namespace {

// A pulled sprite stays this much (relatively) before the ground: more than 32-bit depth rounds.
constexpr double kGroundMargin = 1e-6;

// The depth at which the eye ray through `point` (camera-relative) meets the horizontal plane at
// `height` over the eye, which lies above it; infinity when it never does.
double groundDepth(const Camera& camera, glm::dvec3 point, double height) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double depth = glm::dot(point, camera.forward);
    if (camera.orthographic) {
        if (camera.forward.y >= 0.0) return never;
        return depth + (height - point.y) / camera.forward.y;
    }
    if (depth <= 0.0) return 0.0;  // the sprite reaches behind the eye
    return point.y < 0.0 ? depth * height / point.y : never;
}

// The depth of the ground behind the sprite is greatest or least at a corner of its quad: it is a
// quotient of two affine functions of the place in the plane.
double nearestGround(const SpriteView& view, const Camera& camera, double height) {
    double nearest = std::numeric_limits<double>::infinity();
    if (height >= 0.0 && !camera.orthographic) return nearest;  // the eye is below
    for (const glm::dvec3& corner : quadFromEye(view, view.lattice.first, view.lattice.size))
        nearest = std::min(nearest, groundDepth(camera, corner, height));
    return nearest;
}

// Where the ray enters the voxel it hit, in voxels.
glm::dvec3 entryPoint(const LatticeRay& ray, glm::ivec3 voxel) {
    const double stepsPerVoxel = std::ldexp(1.0, ray.positionBits);
    double t = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const int direction = ray.direction[axis];
        if (direction == 0) continue;
        const double face = voxel[axis] + (direction < 0 ? 1 : 0);
        t = std::max(t, (face * stepsPerVoxel - static_cast<double>(ray.origin[axis])) / direction);
    }
    return (glm::dvec3(ray.origin) + glm::dvec3(ray.direction) * t) / stepsPerVoxel;
}

}  // namespace

double spriteDepth(const SpriteView& view, const PlacedEntity& entity, const Camera& camera,
                   DepthRule rule) {
    if (rule == DepthRule::centre) return view.planeDepthMetres;
    const glm::dvec3 perVoxel = view.depthPerVoxelMetres;
    const double margin = view.metresPerPx / entity.metresPerVoxel();
    const double toCorner = glm::dot(glm::abs(perVoxel), entity.halfVoxels() + margin);
    const double nearest = std::max(view.planeDepthMetres - toCorner, camera.nearMetres);
    if (rule == DepthRule::perPixel) return nearest;
    const double ground = nearestGround(view, camera, entity.anchorMetres.y - camera.eyeMetres.y);
    if (ground > view.planeDepthMetres) return view.planeDepthMetres;
    return std::max(ground * (1.0 - kGroundMargin), nearest);
}

std::vector<float> pixelDepths(const SpriteView& view, const OctreeView& octree,
                               const SpriteBuffer& buffer, int threads) {
    constexpr float none = std::numeric_limits<float>::infinity();
    const auto width = static_cast<std::size_t>(buffer.size.x);
    std::vector<float> depths(buffer.ids.size(), none);
    castLattice(
        octree, view.lattice, buffer.first, buffer.size, threads,
        [&](glm::ivec2 pixel, const LatticeHit& hit) {
            const auto column = static_cast<std::size_t>(pixel.x - buffer.first.x);
            const auto row = static_cast<std::size_t>(buffer.first.y + buffer.size.y - 1 - pixel.y);
            const glm::dvec3 fromCentre =
                entryPoint(rayOf(view.lattice, pixel), hit.voxel) - view.centreVoxels;
            const double depth =
                view.planeDepthMetres + glm::dot(view.depthPerVoxelMetres, fromCentre);
            depths[row * width + column] = static_cast<float>(std::max(depth, view.depthMetres));
        });
    const auto opaque = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= buffer.size.x || row >= buffer.size.y) return none;
        const auto at = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
        return buffer.ids[at] >= kIdFirstVoxel ? depths[at] : none;
    };
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column) {
            const auto at =
                static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
            if (buffer.ids[at] == kIdOutline)
                depths[at] = std::min({opaque(column - 1, row), opaque(column + 1, row),
                                       opaque(column, row - 1), opaque(column, row + 1)});
        }
    return depths;
}

}  // namespace voxprite
