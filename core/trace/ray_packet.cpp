#include "core/trace/ray_packet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/trace/ray_walk.h"

namespace voxprite {
namespace {

// Of a pixel: how far from its own place a ray's may be. The walk allows for it.
constexpr double kTolerancePx = 1.0 / 128.0;

// The map from points (from the eye) to q, with pixel q.xy / q.z, that sends the four corners' rays
// to their pixels: directions A + i B + j C, up to scale, are those of pixels (i, j).
std::optional<glm::dmat3> pictureMap(std::span<const Ray> rays, glm::ivec2 size) {
    const auto directionAt = [&](int i, int j) {
        return glm::normalize(rays[static_cast<std::size_t>(j * size.x + i)].direction);
    };
    const glm::ivec2 last = size - 1;
    if (last.x < 1 || last.y < 1) return std::nullopt;
    const glm::dvec3 first = directionAt(0, 0);
    // Scales with  s.x right + s.y up - s.z first = opposite:  the corners of a parallelogram.
    const glm::dmat3 corners(directionAt(last.x, 0), directionAt(0, last.y), -first);
    const double volume = glm::determinant(corners);
    if (!(std::abs(volume) > 1e-12)) return std::nullopt;
    const glm::dvec3 scale = glm::inverse(corners) * directionAt(last.x, last.y);
    if (!(scale.x > 0.0 && scale.y > 0.0 && scale.z > 0.0)) return std::nullopt;
    const glm::dvec3 a = first * scale.z;
    const glm::dvec3 b = (corners[0] * scale.x - a) / static_cast<double>(last.x);
    const glm::dvec3 c = (corners[1] * scale.y - a) / static_cast<double>(last.y);
    const glm::dmat3 voxelFromPicture(b, c, a);
    if (!(std::abs(glm::determinant(voxelFromPicture)) > 1e-15)) return std::nullopt;
    return glm::inverse(voxelFromPicture);
}

bool sendsEveryRayToItsPixel(const glm::dmat3& map, std::span<const Ray> rays, glm::ivec2 size) {
    const glm::dvec3 eye = rays[0].origin;
    bool all = true;
    std::size_t at = 0;
    for (int j = 0; j < size.y; ++j) {
        for (int i = 0; i < size.x; ++i, ++at) {
            const Ray& ray = rays[at];
            const glm::dvec3 q = map * ray.direction;
            const double limit = kTolerancePx * q.z;
            // NaN fails all of them.
            all = all && std::abs(q.x - i * q.z) <= limit && std::abs(q.y - j * q.z) <= limit &&
                  ray.origin == eye;
        }
        if (!all) return false;
    }
    return true;
}

std::optional<RayPicture> pictureOf(const OctreeView& octree, std::span<const Ray> rays,
                                    glm::ivec2 size, int maxDepth) {
    RayPicture picture;
    picture.octree = octree;
    picture.rays = rays;
    picture.size = size;
    picture.maxDepth = maxDepth;
    picture.leafLevel = std::clamp(octree.maxDepth - maxDepth, 0, octree.maxDepth);
    if (picture.leafLevel == octree.maxDepth) return std::nullopt;
    const std::optional<glm::dmat3> map = pictureMap(rays, size);
    if (!map || !sendsEveryRayToItsPixel(*map, rays, size)) return std::nullopt;
    const glm::dvec3 eye = rays[0].origin;
    picture.box = castableBox(octree, picture.leafLevel);
    picture.inside = true;
    for (int a = 0; a < 3; ++a)
        if (eye[a] < picture.box.min[a] || eye[a] >= picture.box.max[a]) picture.inside = false;
    picture.box.min += octree.treeFromVoxel;
    picture.box.max += octree.treeFromVoxel;
    picture.middle = glm::dvec2(size - 1) / 2.0;
    picture.pictureFromVoxel = *map;
    for (glm::length_t column = 0; column < 3; ++column) {
        glm::dvec3& q = picture.pictureFromVoxel[column];
        q.x -= picture.middle.x * q.z;
        q.y -= picture.middle.y * q.z;
    }
    const glm::dvec3 centre =
        glm::dvec3(std::ldexp(0.5, octree.maxDepth)) - glm::dvec3(octree.treeFromVoxel);
    picture.rootCentre = picture.pictureFromVoxel * (centre - eye);
    const double farthest = std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
    picture.slack = 2.0 * raySlack(octree) + std::ldexp(farthest, -45);
    return picture;
}

void castOneByOne(const OctreeView& octree, std::span<const Ray> rays, glm::ivec2 size,
                  int maxDepth, RayPacketHits& hits) {
    std::size_t at = 0;
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column, ++at)
            hits.add(column, row, castQuantised(octree, quantiseRay(octree, rays[at], maxDepth)));
}

}  // namespace

bool castRayPacket(const OctreeView& octree, std::span<const Ray> rays, glm::ivec2 size,
                   int maxDepth, RayPacketHits& hits) {
    if (size.x <= 0 || size.y <= 0) return true;
    hits.clear(size.y);
    if (castableBox(octree).empty()) return true;
    const std::optional<RayPicture> picture = pictureOf(octree, rays, size, maxDepth);
    if (!picture) {
        castOneByOne(octree, rays, size, maxDepth, hits);
        return false;
    }
    hits.quantised.fill(0);
    // By the axes that rays run downward along.
    std::array<std::array<std::uint64_t, PacketHits::kEdge + 8>, 8> alive{};
    unsigned groups = 0;
    std::size_t at = 0;
    for (std::size_t row = 0; row < static_cast<std::size_t>(size.y); ++row)
        for (int column = 0; column < size.x; ++column, ++at) {
            const glm::dvec3& d = rays[at].direction;
            const unsigned group =
                unsigned{d.x < 0.0} | unsigned{d.y < 0.0} << 1 | unsigned{d.z < 0.0} << 2;
            groups |= 1u << group;
            alive[group][row] |= std::uint64_t{1} << column;
        }
    for (unsigned group = 0; group < 8; ++group) {
        if ((groups >> group & 1u) == 0) continue;
        const glm::bvec3 mirrored((group & 1u) != 0, (group & 2u) != 0, (group & 4u) != 0);
        walkRays(*picture, mirrored, alive[group].data(), hits);
    }
    return true;
}

void raycastPicture(const OctreeView& octree, glm::ivec2 size, int maxDepth, int threads,
                    const std::function<Ray(glm::ivec2 pixel)>& rayThrough,
                    const std::function<OnRaycastHit()>& eachHit) {
    constexpr int kEdge = PacketHits::kEdge;
    const glm::ivec2 packets = (size + (kEdge - 1)) / kEdge;
    parallelFor(packets.x * packets.y, threads, [&](int firstPacket, int lastPacket) {
        const OnRaycastHit onHit = eachHit();
        const auto hits = std::make_unique_for_overwrite<RayPacketHits>();
        std::vector<Ray> rays;
        for (int packet = firstPacket; packet < lastPacket; ++packet) {
            const glm::ivec2 first{packet % packets.x * kEdge, packet / packets.x * kEdge};
            const glm::ivec2 part = glm::min(size - first, glm::ivec2(kEdge));
            rays.clear();
            for (int row = 0; row < part.y; ++row)
                for (int column = 0; column < part.x; ++column)
                    rays.push_back(rayThrough(first + glm::ivec2(column, row)));
            castRayPacket(octree, rays, part, maxDepth, *hits);
            for (int row = 0; row < part.y; ++row)
                for (std::uint64_t bits = hits->rows[static_cast<std::size_t>(row)]; bits != 0;
                     bits &= bits - 1) {
                    const int column = std::countr_zero(bits);
                    const Ray& ray = rays[static_cast<std::size_t>(row * part.x + column)];
                    onHit(first + glm::ivec2(column, row), ray,
                          raycastHit(octree, ray, quantiseRay(octree, ray, maxDepth),
                                     hits->at(column, row)));
                }
        }
    });
}

}  // namespace voxprite
