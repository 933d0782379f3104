#include "core/sheet/sheet_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "core/trace/packet_caster.h"

namespace voxprite {
namespace {

std::uint8_t byteOf(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

Rgba8 grey(std::uint8_t value) {
    return {value, value, value, 255};
}

// A picture of `ofOutline` and of what `ofHit` makes of the hits.
template <class OfHit>
Image pictureOf(const SpriteBuffer& buffer, const SpriteView& view, const OctreeView& octree,
                Rgba8 ofOutline, OfHit ofHit) {
    Image image(buffer.size.x, buffer.size.y);
    for (std::size_t at = 0; at < image.pixels.size(); ++at)
        if (buffer.ids[at] == kIdOutline) image.pixels[at] = ofOutline;
    castLattice(octree, view.lattice, buffer.first, buffer.size, 1,
                [&](glm::ivec2 pixel, const LatticeHit& hit) {
                    const int column = pixel.x - buffer.first.x;
                    const int row = buffer.first.y + buffer.size.y - 1 - pixel.y;
                    image.pixels[static_cast<std::size_t>(row * buffer.size.x + column)] =
                        ofHit(hit);
                });
    return image;
}

}  // namespace

Image normalsOf(const SpriteBuffer& buffer, const SpriteView& view, const OctreeView& octree) {
    const auto coded = [](glm::dvec3 n) {
        return Rgba8(byteOf(n.x * 0.5 + 0.5), byteOf(n.y * 0.5 + 0.5), byteOf(n.z * 0.5 + 0.5),
                     255);
    };
    // Rays see one face an axis.
    std::array<Rgba8, 3> faces{};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = view.lattice.D[axis] > 0 ? -1.0 : 1.0;
        faces[static_cast<std::size_t>(axis)] =
            coded({glm::dot(normal, view.ortho.right), glm::dot(normal, view.ortho.up),
                   -glm::dot(normal, view.ortho.forward)});
    }
    return pictureOf(buffer, view, octree, coded({0.0, 0.0, 1.0}),
                     [&](const LatticeHit& hit) { return faces[hit.faceAxis]; });
}

Image depthsOf(const SpriteBuffer& buffer, const SpriteView& view, const OctreeView& octree,
               double rangeMetres) {
    Image image(buffer.size.x, buffer.size.y);
    const std::vector<float> depths = pixelDepths(view, octree, buffer, 1);
    for (std::size_t at = 0; at < depths.size(); ++at) {
        if (buffer.ids[at] == kIdEmpty) continue;
        const double behind = depths[at] - view.planeDepthMetres;
        image.pixels[at] = grey(byteOf(0.5 - 0.5 * behind / rangeMetres));
    }
    return image;
}

Image indicesOf(const SpriteBuffer& buffer, const SpriteView& view, const OctreeView& octree) {
    return pictureOf(buffer, view, octree, grey(0),
                     [](const LatticeHit& hit) { return grey(hit.material); });
}

}  // namespace voxprite
