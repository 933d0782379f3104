#include "core/sprite/sprite_buffer.h"

#include <algorithm>
#include <bit>

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/sprite/sprite_outline.h"
#include "core/trace/picture_packets.h"

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
    const std::uint32_t id =
        kIdFirstVoxel + x + width * (y + static_cast<std::uint32_t>(modelSize.y) * z);
    return id < kIdFirstVoxel ? id + kIdFirstVoxel : id;  // never nothing, never outline
}

void dilateOutline(SpriteBuffer& buffer, Rgba8 colour) {
    drawOutline(opaquePixels(buffer), colour, buffer);
}

namespace {

// Colours and numbers of one packet's hits; `corner` is its first pixel's column and its lowest row
// from the bottom.
class PacketPainter {
  public:
    PacketPainter(const OctreeView& octree, const LatticeView& lattice, const LitPalette& lit,
                  SpriteBuffer& buffer, PixelBits& opaque)
        : octree_(octree),
          lattice_(lattice),
          lit_(lit),
          shader_(octree, lit.rays),
          buffer_(buffer),
          opaque_(opaque) {}

    void paint(const PacketHits& hits, glm::ivec2 corner, int height) {
        std::uint32_t last = 0;  // of the entries: pixels of one face are one colour
        Rgba8 colour(0);
        std::uint32_t id = kIdEmpty;
        for (int up = 0; up < height; ++up) {
            const int row = buffer_.size.y - 1 - corner.y - up;
            std::uint64_t hit = hits.rows[static_cast<std::size_t>(up)];
            opaque_.row(row)[corner.x / PacketHits::kEdge] = hit;
            const std::size_t start =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer_.size.x) +
                static_cast<std::size_t>(corner.x);
            for (; hit != 0; hit &= hit - 1) {
                const int column = std::countr_zero(hit);
                const std::uint32_t entry = hits.entries[PacketHits::index(column, up)];
                if (entry != last) {
                    last = entry;
                    const LatticeHit met = hits.at(column, up);
                    colour = colourOf(met);
                    id = voxelId(met.voxel, octree_.size);
                }
                buffer_.colours[start + static_cast<std::size_t>(column)] = colour;
                buffer_.ids[start + static_cast<std::size_t>(column)] = id;
            }
        }
    }

  private:
    Rgba8 colourOf(const LatticeHit& hit) {
        if (lit_.rays.any()) {
            const VoxelFace seen = seenFace(hit, lattice_.D);
            if (seen != face_) shade_ = shader_.shadeOf(seen);
            face_ = seen;
        }
        return lit_.shade(hit.material, hit.faceAxis, shade_);
    }

    const OctreeView& octree_;
    const LatticeView& lattice_;
    const LitPalette& lit_;
    FaceShader shader_;
    SpriteBuffer& buffer_;
    PixelBits& opaque_;
    VoxelFace face_;  // the last one that was asked for its shade
    FaceShade shade_;
};

}  // namespace

SpriteBuffer castSprite(const OctreeView& octree, const LatticeView& lattice, const LitPalette& lit,
                        int threads) {
    SpriteBuffer buffer;
    buffer.first = lattice.first;
    buffer.size = glm::max(lattice.size, glm::ivec2(0));
    buffer.colours.assign(area(buffer.size), Rgba8(0));
    buffer.ids.assign(area(buffer.size), kIdEmpty);
    PixelBits opaque(buffer.size);
    const PacketCaster caster(octree, lattice);
    forEachPacket<PacketHits>(buffer.size, threads, [&] {
        return [&, painter = PacketPainter(octree, lattice, lit, buffer, opaque)](
                   glm::ivec2 corner, glm::ivec2 size, PacketHits& hits) mutable {
            caster.cast(lattice.first + corner, size, hits);
            painter.paint(hits, corner, size.y);
        };
    });
    if (lit.outline.enabled) drawOutline(opaque, lit.outline.colour, buffer);
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
