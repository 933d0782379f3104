#include "core/sprite/sprite_buffer.h"

#include <algorithm>

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/trace/lattice_caster.h"

namespace voxprite {

namespace {

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

std::uint64_t countWhere(const std::vector<std::uint32_t>& ids, auto matches) {
    return static_cast<std::uint64_t>(std::count_if(ids.begin(), ids.end(), matches));
}

}  // namespace

std::uint32_t voxelId(glm::ivec3 voxel, glm::ivec3 modelSize) {
    const auto x = static_cast<std::uint32_t>(voxel.x);
    const auto y = static_cast<std::uint32_t>(voxel.y);
    const auto z = static_cast<std::uint32_t>(voxel.z);
    const auto width = static_cast<std::uint32_t>(modelSize.x);
    return kIdFirstVoxel + x + width * (y + static_cast<std::uint32_t>(modelSize.y) * z);
}

void dilateOutline(SpriteBuffer& buffer, Rgba8 colour) {
    const auto opaque = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= buffer.size.x || row >= buffer.size.y) return false;
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.size.x) +
                        static_cast<std::size_t>(column);
        return buffer.ids[at] >= kIdFirstVoxel;
    };
    std::size_t at = 0;
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column, ++at) {
            if (buffer.ids[at] >= kIdFirstVoxel) continue;
            if (opaque(column - 1, row) || opaque(column + 1, row) || opaque(column, row - 1) ||
                opaque(column, row + 1)) {
                buffer.ids[at] = kIdOutline;
                buffer.colours[at] = {colour.x, colour.y, colour.z, 255};
            }
        }
}

SpriteBuffer castSprite(const OctreeView& octree, const LatticeView& lattice, const LitPalette& lit,
                        int threads) {
    SpriteBuffer buffer;
    buffer.first = lattice.first;
    buffer.size = glm::max(lattice.size, glm::ivec2(0));
    buffer.colours.assign(area(buffer.size), Rgba8(0));
    buffer.ids.assign(area(buffer.size), kIdEmpty);
    const LatticeCaster caster(octree, lattice);
    const FaceShader shader(octree, lit.rays);
    parallelFor(buffer.size.y, threads, [&](int firstRow, int lastRow) {
        std::size_t at =
            static_cast<std::size_t>(firstRow) * static_cast<std::size_t>(buffer.size.x);
        VoxelFace face;  // the last one that was asked for its shade
        FaceShade shade;
        for (int row = firstRow; row < lastRow; ++row)
            for (int column = 0; column < buffer.size.x; ++column, ++at) {
                const glm::ivec2 pixel{lattice.first.x + column,
                                       lattice.first.y + buffer.size.y - 1 - row};
                const LatticeHit hit = caster.cast(pixel);
                if (hit.material == 0) continue;
                if (lit.rays.any()) {
                    const VoxelFace seen = seenFace(hit, lattice.D);
                    if (seen != face) shade = shader.shadeOf(seen);
                    face = seen;
                }
                buffer.colours[at] = lit.shade(hit.material, hit.faceAxis, shade);
                buffer.ids[at] = voxelId(hit.voxel, octree.size);
            }
    });
    if (lit.outline.enabled) dilateOutline(buffer, lit.outline.colour);
    return buffer;
}

std::string SpriteBuffer::sha256() const {
    return sha256Hex(asBytes(colours));
}

std::string SpriteBuffer::idsSha256() const {
    ByteWriter littleEndian;
    for (const std::uint32_t id : ids) littleEndian.u32(id);
    return sha256Hex(littleEndian.bytes());
}

std::uint64_t SpriteBuffer::opaqueCount() const {
    return countWhere(ids, [](std::uint32_t id) { return id >= kIdFirstVoxel; });
}

std::uint64_t SpriteBuffer::outlineCount() const {
    return countWhere(ids, [](std::uint32_t id) { return id == kIdOutline; });
}

Image SpriteBuffer::image() const {
    Image image(size.x, size.y);
    image.pixels = colours;
    return image;
}

}  // namespace voxprite
