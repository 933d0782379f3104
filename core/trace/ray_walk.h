// The walk of one packet of rays through one eye: core/trace/ray_packet.h says what for.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>

#include "core/trace/packet_tables.h"
#include "core/trace/ray_packet.h"

namespace voxprite {

// A packet whose rays form a picture.
struct RayPicture {
    OctreeView octree;
    std::span<const Ray> rays;  // row by row; none: they are those of `eyePicture` from `corner` on
    EyePicture eyePicture;
    glm::ivec2 corner{0};
    glm::dvec3 eye{0.0};
    glm::ivec2 size{0};
    int maxDepth = 0;
    int leafLevel = 0;
    IBox box;             // castable, tree coordinates
    bool inside = false;  // the eye is in the box
    // With p from the eye, in voxels: q = pictureFromVoxel * p is seen at the pixel q.xy / q.z, if
    // q.z is positive. Pixel (0, 0) is the packet's middle: `middle` of its pixels.
    glm::dmat3 pictureFromVoxel{1.0};
    glm::dvec2 middle{0.0};
    glm::dvec3 rootCentre{0.0};  // the root cube's centre there
    // How far from a node a ray may run whose quantised line meets it, in voxels, on each axis.
    double slack = 0.0;

    [[nodiscard]] Ray rayAt(int column, int row) const {
        if (rays.empty()) return eyePicture.ray(corner + glm::ivec2(column, row));
        return rays[static_cast<std::size_t>(row * size.x + column)];
    }
};

// Casts the rays of `alive` (a bit a ray, a word a row; kEdge words and 8 more to read), all of
// whose directions point downward on the `mirrored` axes and upward, or nowhere, on the others.
void walkRays(const RayPicture& picture, glm::bvec3 mirrored, std::uint64_t* alive,
              RayPacketHits& hits);

}  // namespace voxprite
