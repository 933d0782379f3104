#include "core/trace/ray_packet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <vector>

#include "core/trace/picture_packets.h"
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

// The same map of a picture whose directions are given as a sum; nothing where rounding could send
// a ray further than the tolerance from its pixel.
std::optional<glm::dmat3> pictureMap(const EyePicture& picture, glm::ivec2 corner) {
    const glm::dmat3 voxelFromPicture(picture.perColumn, picture.perRow,
                                      picture.ray(corner).direction);
    if (!(std::abs(glm::determinant(voxelFromPicture)) > 0.0)) return std::nullopt;
    const glm::dmat3 map = glm::inverse(voxelFromPicture);
    // Of pixel (i, j), q is (i, j, 1) but for what `off` makes of that, and for the roundings of
    // the direction, of at most four units in the last place of the greatest number on its way.
    const glm::dmat3 off = map * voxelFromPicture - glm::dmat3(1.0);
    constexpr double kEdge = PacketHits::kEdge;
    double greatest = 0.0, inMap = 0.0, inOff = 0.0;
    for (glm::length_t k = 0; k < 3; ++k) {
        greatest =
            std::max({greatest, std::abs(picture.first[k]) +
                                    (std::abs(corner.x) + kEdge) * std::abs(picture.perColumn[k]) +
                                    (std::abs(corner.y) + kEdge) * std::abs(picture.perRow[k])});
        for (glm::length_t row = 0; row < 3; ++row) {
            inMap = std::max(inMap, std::abs(map[k][row]));
            inOff = std::max(inOff, std::abs(off[k][row]));
        }
    }
    const double error = 3.0 * inMap * std::ldexp(greatest, -50) + (2.0 * kEdge + 1.0) * inOff;
    // q.x - i q.z is off by that and i times that.
    if (!(error * (1.0 + kEdge) < kTolerancePx / 2.0)) return std::nullopt;  // NaN, too
    return map;
}

std::optional<RayPicture> pictureOf(const OctreeView& octree, const glm::dvec3& eye,
                                    const std::optional<glm::dmat3>& map, glm::ivec2 size,
                                    int maxDepth) {
    RayPicture picture;
    picture.octree = octree;
    picture.size = size;
    picture.maxDepth = maxDepth;
    picture.leafLevel = std::clamp(octree.maxDepth - maxDepth, 0, octree.maxDepth);
    if (picture.leafLevel == octree.maxDepth || !map) return std::nullopt;
    picture.eye = eye;
    picture.box = castableBox(octree, picture.leafLevel);
    picture.inside = true;
    for (int a = 0; a < 3; ++a)
        if (eye[a] < picture.box.min[a] || eye[a] >= picture.box.max[a]) picture.inside = false;
    // From inside, on a face between voxels, a ray that runs down along the axis by less than its
    // numbers can say belongs to another voxel than those that do.
    for (int a = 0; picture.inside && a < 3; ++a)
        if (std::abs(eye[a] - std::round(eye[a])) <= raySlack(octree)) return std::nullopt;
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

// rayAt(column, row) gives each.
template <class RayAt>
void castOneByOne(const OctreeView& octree, glm::ivec2 size, int maxDepth, RayPacketHits& hits,
                  const RayAt& rayAt) {
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column)
            hits.add(column, row,
                     castQuantised(octree, quantiseRay(octree, rayAt(column, row), maxDepth)));
}

// By the axes that the ray runs downward along.
unsigned groupOf(const glm::dvec3& direction) {
    return unsigned{direction.x < 0.0} | unsigned{direction.y < 0.0} << 1 |
           unsigned{direction.z < 0.0} << 2;
}

using Alive = std::array<std::uint64_t, PacketHits::kEdge + 8>;  // a bit a ray, a word a row

void walkGroup(const RayPicture& picture, unsigned group, Alive& alive, RayPacketHits& hits) {
    const glm::bvec3 mirrored((group & 1u) != 0, (group & 2u) != 0, (group & 4u) != 0);
    for (int a = 0; a < 3; ++a) {
        // Rays that run away from the box, or along its face, never come in.
        const int origin = picture.octree.treeFromVoxel[a];
        if (mirrored[a] ? picture.eye[a] < picture.box.min[a] - origin
                        : picture.eye[a] >= picture.box.max[a] - origin)
            return;
    }
    walkRays(picture, mirrored, alive.data(), hits);
}

// Sums of terms that grow, or shrink, with the column and with the row do so when they are rounded,
// too: what the corners' rays agree in, all do.
std::optional<unsigned> groupOfAll(const RayPicture& picture) {
    if (!picture.rays.empty()) return std::nullopt;
    const glm::ivec2 last = picture.size - 1;
    const unsigned group = groupOf(picture.rayAt(0, 0).direction);
    for (const glm::ivec2 corner : {glm::ivec2(last.x, 0), glm::ivec2(0, last.y), last})
        if (groupOf(picture.rayAt(corner.x, corner.y).direction) != group) return std::nullopt;
    return group;
}

void castTogether(const RayPicture& picture, RayPacketHits& hits) {
    const glm::ivec2 size = picture.size;
    hits.quantised.fill(0);
    if (const std::optional<unsigned> group = groupOfAll(picture)) {
        Alive alive{};
        std::fill_n(alive.begin(), size.y, ~std::uint64_t{0} >> (PacketHits::kEdge - size.x));
        return walkGroup(picture, *group, alive, hits);
    }
    std::array<Alive, 8> alive{};
    unsigned groups = 0;
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column) {
            const unsigned group = groupOf(picture.rayAt(column, row).direction);
            groups |= 1u << group;
            alive[group][static_cast<std::size_t>(row)] |= std::uint64_t{1} << column;
        }
    for (unsigned group = 0; group < 8; ++group)
        if ((groups >> group & 1u) != 0) walkGroup(picture, group, alive[group], hits);
}

}  // namespace

bool castRayPacket(const OctreeView& octree, std::span<const Ray> rays, glm::ivec2 size,
                   int maxDepth, RayPacketHits& hits) {
    if (size.x <= 0 || size.y <= 0) return true;
    hits.clear(size.y);
    if (castableBox(octree).empty()) return true;
    std::optional<glm::dmat3> map = pictureMap(rays, size);
    if (map && !sendsEveryRayToItsPixel(*map, rays, size)) map.reset();
    std::optional<RayPicture> picture = pictureOf(octree, rays[0].origin, map, size, maxDepth);
    if (!picture) {
        castOneByOne(octree, size, maxDepth, hits, [&](int column, int row) {
            return rays[static_cast<std::size_t>(row * size.x + column)];
        });
        return false;
    }
    picture->rays = rays;
    castTogether(*picture, hits);
    return true;
}

bool castRayPacket(const OctreeView& octree, const EyePicture& eyePicture, glm::ivec2 corner,
                   glm::ivec2 size, int maxDepth, RayPacketHits& hits) {
    if (size.x <= 0 || size.y <= 0) return true;
    hits.clear(size.y);
    if (castableBox(octree).empty()) return true;
    std::optional<RayPicture> picture =
        pictureOf(octree, eyePicture.eye, pictureMap(eyePicture, corner), size, maxDepth);
    if (!picture) {
        castOneByOne(octree, size, maxDepth, hits, [&](int column, int row) {
            return eyePicture.ray(corner + glm::ivec2(column, row));
        });
        return false;
    }
    picture->eyePicture = eyePicture;
    picture->corner = corner;
    castTogether(*picture, hits);
    return true;
}

namespace {

// castPacket(first pixel, size, hits) casts one packet of the picture; rayAt(pixel) gives a ray.
template <class MakeCastPacket, class RayAt>
void castPicture(const OctreeView& octree, glm::ivec2 size, int maxDepth, int threads,
                 const MakeCastPacket& makeCastPacket, const RayAt& rayAt,
                 const std::function<OnRaycastHit()>& eachHit) {
    forEachPacket<RayPacketHits>(size, threads, [&] {
        return [&, onHit = eachHit(), castPacket = makeCastPacket()](
                   glm::ivec2 first, glm::ivec2 part, RayPacketHits& hits) mutable {
            castPacket(first, part, hits);
            hits.forEachHit(part.y, [&](int column, int row) {
                const glm::ivec2 pixel = first + glm::ivec2(column, row);
                const Ray ray = rayAt(pixel);
                onHit(pixel, ray,
                      raycastHit(octree, ray, quantiseRay(octree, ray, maxDepth),
                                 hits.at(column, row)));
            });
        };
    });
}

}  // namespace

void raycastPicture(const OctreeView& octree, glm::ivec2 size, int maxDepth, int threads,
                    const std::function<Ray(glm::ivec2 pixel)>& rayThrough,
                    const std::function<OnRaycastHit()>& eachHit) {
    const auto makeCastPacket = [&] {
        return [&, rays = std::vector<Ray>()](glm::ivec2 first, glm::ivec2 part,
                                              RayPacketHits& hits) mutable {
            rays.clear();
            for (int row = 0; row < part.y; ++row)
                for (int column = 0; column < part.x; ++column)
                    rays.push_back(rayThrough(first + glm::ivec2(column, row)));
            castRayPacket(octree, rays, part, maxDepth, hits);
        };
    };
    castPicture(octree, size, maxDepth, threads, makeCastPacket, rayThrough, eachHit);
}

void raycastPicture(const OctreeView& octree, const EyePicture& picture, glm::ivec2 size,
                    int maxDepth, int threads, const std::function<OnRaycastHit()>& eachHit) {
    const auto makeCastPacket = [&] {
        return [&](glm::ivec2 first, glm::ivec2 part, RayPacketHits& hits) {
            castRayPacket(octree, picture, first, part, maxDepth, hits);
        };
    };
    castPicture(
        octree, size, maxDepth, threads, makeCastPacket,
        [&](glm::ivec2 pixel) { return picture.ray(pixel); }, eachHit);
}

}  // namespace voxprite
