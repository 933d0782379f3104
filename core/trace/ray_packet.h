// Rectangles of a perspective picture's rays at once, exactly as raycast casts them one by one.
//
// The way down the octree is that of core/trace/packet_caster.h; what differs is the rays. Each has
// integers of its own (quantiseRay), made when it is first asked for, and a voxel is tested against
// its own G and D: in doubles, where every number is an integer below 2^53 and so exact. Rays that
// run upward on the same axes share a way; a packet around an axis takes up to eight.
//
// Nodes are placed on the picture by a projective map that is found from the packet's own rays: of
// four corners' directions it makes the one that sends every ray to its pixel. Whether it does, for
// all of them and to 1/128 of a pixel, is checked; rays that do not form such a picture, or do not
// start in one point, are cast one by one, as are those with a direction component of 0. An
// EyePicture needs no such check, and none of its rays is made unless something asks for it: pixels
// beside the model cost next to nothing.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>

#include "core/trace/packet_caster.h"
#include "core/trace/raycast.h"

namespace voxprite {

// What rays hit, as PacketHits has it; a face's axis may be kInsideAxis.
class RayPacketHits : public PacketHits {
  public:
    // The rays' own numbers, mirrored: D by axis, G by pair of axes. Scratch of the caster.
    alignas(64) std::array<std::array<double, kEntries>, 3> directions;
    alignas(64) std::array<std::array<double, kEntries>, 3> products;
    std::array<std::uint64_t, kEdge> quantised;  // a bit a ray whose numbers are there
};

// The rays of a perspective picture, in voxel space: that of pixel (i, j) starts in the eye and
// runs along first + perColumn * i + perRow * j, computed in this order.
struct EyePicture {
    glm::dvec3 eye{0.0};
    glm::dvec3 first{0.0, 1.0, 0.0};
    glm::dvec3 perColumn{0.0}, perRow{0.0};

    [[nodiscard]] Ray ray(glm::ivec2 pixel) const {
        return {eye, first + perColumn * static_cast<double>(pixel.x) +
                         perRow * static_cast<double>(pixel.y)};
    }
};

// Row by row size.x * size.y rays, at most PacketHits::kEdge on either axis: for each what
// castQuantised(octree, quantiseRay(octree, ray, maxDepth)) gives. True if they were cast together.
bool castRayPacket(const OctreeView& octree, std::span<const Ray> rays, glm::ivec2 size,
                   int maxDepth, RayPacketHits& hits);
// The same of the pixels [corner, corner + size) of a picture.
bool castRayPacket(const OctreeView& octree, const EyePicture& picture, glm::ivec2 corner,
                   glm::ivec2 size, int maxDepth, RayPacketHits& hits);

// A whole picture by packets: for every pixel of [0, size) whose ray hits, what raycast gives for
// it with that depth. `eachHit` is called on several threads, for one pixel at a time on each, and
// gives what is to be called for the pixels of one thread. threads <= 0: all cores.
using OnRaycastHit = std::function<void(glm::ivec2 pixel, const Ray& ray, const RaycastHit& hit)>;
void raycastPicture(const OctreeView& octree, glm::ivec2 size, int maxDepth, int threads,
                    const std::function<Ray(glm::ivec2 pixel)>& rayThrough,
                    const std::function<OnRaycastHit()>& eachHit);
// The same of the pixels [0, size) of a picture.
void raycastPicture(const OctreeView& octree, const EyePicture& picture, glm::ivec2 size,
                    int maxDepth, int threads, const std::function<OnRaycastHit()>& eachHit);

}  // namespace voxprite
