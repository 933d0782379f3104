#include "core/sprite/sprite_buffer.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/sprite/sprite_outline.h"
#include "core/trace/picture_packets.h"

namespace voxprite {

namespace {

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

std::uint64_t countWhere(const UnfilledVector<std::uint32_t>& ids, auto matches) {
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

    // With the outline of its hits as far as it lies in the packet.
    void paint(const PacketHits& hits, glm::ivec2 corner, glm::ivec2 size) {
        static_assert(kIdEmpty == 0);  // of all four bytes
        faces_.assign(4 * hits.voxels.size(), kNotAsked);
        // What hit nothing and is painted is outline.
        faces_[0] = faceOf(Rgba8(glm::u8vec3(lit_.outline.colour), 255), kIdOutline);
        const auto columns = static_cast<std::size_t>(size.x);
        for (int up = 0; up < size.y; ++up) {
            const int row = buffer_.size.y - 1 - corner.y - up;
            std::uint64_t painted = hits.rows[static_cast<std::size_t>(up)];
            opaque_.strip(corner.x / PacketHits::kEdge)[row] = painted;
            if (lit_.outline.enabled) painted |= outlineBits(hits, up, size);
            const std::size_t start =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer_.size.x) +
                static_cast<std::size_t>(corner.x);
            Rgba8* const colours = buffer_.colours.data() + start;
            std::uint32_t* const ids = buffer_.ids.data() + start;
            std::memset(colours, 0, columns * sizeof(Rgba8));
            std::memset(ids, 0, columns * sizeof(std::uint32_t));
            paintRow(hits, up, painted, colours, ids);
        }
    }

  private:
    // A face's colour in the lower half, its voxel's id in the upper.
    using Face = std::uint64_t;
    static constexpr Face kNotAsked = 0;

    static Face faceOf(Rgba8 colour, std::uint32_t id) {
        return std::bit_cast<std::uint32_t>(colour) | Face{id} << 32;
    }

    [[nodiscard]] Face faceOf(const LatticeHit& hit) const {
        FaceShade shade;
        if (lit_.rays.any()) shade = shader_.shadeOf(seenFace(hit, lattice_.D));
        return faceOf(lit_.shade(hit.material, hit.faceAxis, shade),
                      voxelId(hit.voxel, octree_.size));
    }

    void paintRow(const PacketHits& hits, int up, std::uint64_t painted, Rgba8* colours,
                  std::uint32_t* ids) {
        const std::uint32_t* const entries = &hits.entries[PacketHits::index(0, up)];
        Face* const faces = faces_.data();
        for (; painted != 0; painted &= painted - 1) {
            const int column = std::countr_zero(painted);
            Face face = faces[entries[column]];
            if (face == kNotAsked) face = faces[entries[column]] = faceOf(hits.at(column, up));
            colours[column] = std::bit_cast<Rgba8>(static_cast<std::uint32_t>(face));
            ids[column] = static_cast<std::uint32_t>(face >> 32);
        }
    }

    static std::uint64_t outlineBits(const PacketHits& hits, int up, glm::ivec2 size) {
        const auto row = static_cast<std::size_t>(up);
        const std::uint64_t middle = hits.rows[row];
        const std::uint64_t above = up + 1 < size.y ? hits.rows[row + 1] : 0;
        const std::uint64_t below = up > 0 ? hits.rows[row - 1] : 0;
        const std::uint64_t columns = ~std::uint64_t{0} >> (PacketHits::kEdge - size.x);
        return (middle << 1 | middle >> 1 | above | below) & ~middle & columns;
    }

    const OctreeView& octree_;
    const LatticeView& lattice_;
    const LitPalette& lit_;
    FaceShader shader_;
    SpriteBuffer& buffer_;
    PixelBits& opaque_;
    std::vector<Face> faces_;  // of one packet, by its entries
};

}  // namespace

SpriteBuffer castSprite(const OctreeView& octree, const LatticeView& lattice, const LitPalette& lit,
                        int threads) {
    SpriteBuffer buffer;
    buffer.first = lattice.first;
    buffer.size = glm::max(lattice.size, glm::ivec2(0));
    buffer.colours.resize(area(buffer.size));  // the painters fill them
    buffer.ids.resize(area(buffer.size));
    PixelBits opaque(buffer.size);
    const PacketCaster caster(octree, lattice);
    forEachPacket<PacketHits>(buffer.size, threads, [&] {
        return [&, painter = PacketPainter(octree, lattice, lit, buffer, opaque)](
                   glm::ivec2 corner, glm::ivec2 size, PacketHits& hits) mutable {
            caster.cast(lattice.first + corner, size, hits);
            painter.paint(hits, corner, size);
        };
    });
    if (lit.outline.enabled) drawOutlineAtSeams(opaque, lit.outline.colour, buffer);
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
    image.pixels.assign(colours.begin(), colours.end());
    return image;
}

}  // namespace voxprite
