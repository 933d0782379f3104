#include "core/edit/cube_bits.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace voxprite {

namespace {

constexpr std::uint64_t kLowestZ = 0x0101'0101'0101'0101u;  // z = 0 of every row
constexpr std::uint64_t kHighestZ = kLowestZ << 7;
constexpr std::uint64_t kRow = 0xFF;

// 1 in every byte that is not 0.
std::uint64_t nonZeroBytes(std::uint64_t bytes) {
    constexpr std::uint64_t kLow7 = kLowestZ * 0x7F;
    return ((((bytes & kLow7) + kLow7) | bytes) >> 7) & kLowestZ;
}

// Bytes of 0 or 1 to bits: byte i becomes bit i.
std::uint64_t gathered(std::uint64_t bytes) {
    return (bytes * 0x0102'0408'1020'4080u) >> 56;
}

// Eight voxels along z as one number, the first in its lowest byte.
std::uint64_t rowOf(const std::uint8_t* voxels) {
    std::uint64_t row = 0;
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(&row, voxels, sizeof(row));
    } else {
        for (int z = 0; z < 8; ++z) row |= std::uint64_t{voxels[z]} << (8 * z);
    }
    return row;
}

// `rowBits(eight voxels as one number)` for every row of a leaf.
template <class RowBits>
CubeBits bitsFromRows(const std::uint8_t* voxels, const RowBits& rowBits) {
    CubeBits bits{};
    for (std::size_t x = 0; x < 8; ++x) {
        for (std::size_t y = 0; y < 8; ++y) {
            bits[x] |= rowBits(rowOf(voxels + ((x << 6) | (y << 3)))) << (8 * y);
        }
    }
    return bits;
}

CubeBits uniformBits(bool set) {
    CubeBits bits;
    bits.fill(set ? ~std::uint64_t{0} : 0);
    return bits;
}

std::uint64_t grownAlongZ(std::uint64_t word) {
    return ((word << 1) & ~kLowestZ) | ((word >> 1) & ~kHighestZ);
}
std::uint64_t grownAlongY(std::uint64_t word) {
    return (word << 8) | (word >> 8);
}
CubeBits grownAlongX(const CubeBits& bits) {
    CubeBits result{};
    for (std::size_t x = 0; x < 8; ++x) {
        if (x > 0) result[x] |= bits[x - 1];
        if (x < 7) result[x] |= bits[x + 1];
    }
    return result;
}

CubeBits grownAlong(CubeBits bits, int axis) {
    if (axis == 0) return bits | grownAlongX(bits);
    for (std::uint64_t& word : bits) word |= axis == 1 ? grownAlongY(word) : grownAlongZ(word);
    return bits;
}

}  // namespace

CubeBits operator&(CubeBits a, const CubeBits& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] &= b[i];
    return a;
}

CubeBits operator|(CubeBits a, const CubeBits& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] |= b[i];
    return a;
}

CubeBits operator~(CubeBits a) {
    for (std::uint64_t& word : a) word = ~word;
    return a;
}

CubeBits bitOf(glm::ivec3 v) {
    CubeBits bits{};
    const int index = indexInCube(v);
    bits[static_cast<std::size_t>(index >> 6)] = std::uint64_t{1} << (index & 63);
    return bits;
}

CubeBits solidBits(const VoxelGrid& voxels, glm::ivec3 origin) {
    const VoxelBlock block = voxels.blockAt(origin);
    if (block.voxels == nullptr) return uniformBits(block.uniformValue != 0);
    return bitsFromRows(block.voxels,
                        [](std::uint64_t row) { return gathered(nonZeroBytes(row)); });
}

CubeBits colourBits(const VoxelGrid& voxels, glm::ivec3 origin, std::uint8_t colour) {
    const VoxelBlock block = voxels.blockAt(origin);
    if (block.voxels == nullptr) return uniformBits(block.uniformValue == colour);
    const std::uint64_t wanted = kLowestZ * colour;
    return bitsFromRows(block.voxels, [wanted](std::uint64_t row) {
        return gathered(nonZeroBytes(row ^ wanted)) ^ kRow;
    });
}

CubeBits boxBits(const IBox& box, glm::ivec3 origin) {
    const IBox inside = box.intersected({origin, origin + kCubeEdge});
    CubeBits bits{};
    if (inside.empty()) return bits;
    const glm::ivec3 first = inside.min - origin;
    const glm::ivec3 size = inside.size();
    const std::uint64_t row = (kRow >> (8 - size.z)) << first.z;
    std::uint64_t word = 0;
    for (int y = 0; y < size.y; ++y) word |= row << (8 * (first.y + y));
    for (int x = 0; x < size.x; ++x) bits[static_cast<std::size_t>(first.x + x)] = word;
    return bits;
}

std::array<std::uint8_t, kCubeVoxels> bytesOf(const CubeBits& bits) {
    std::array<std::uint8_t, kCubeVoxels> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>((bits[i >> 6] >> (i & 63)) & 1);
    }
    return bytes;
}

void insertBits(VoxelSet& set, glm::ivec3 origin, const CubeBits& bits) {
    if (!anyBit(bits)) return;
    if (allBits(bits)) {
        set.insert(IBox{origin, origin + kCubeEdge});
    } else {
        set.insertBlock(origin, bytesOf(bits).data());
    }
}

CubeBits grown(const CubeBits& bits, Neighbours neighbours) {
    if (neighbours == Neighbours::twentySix) {
        return grownAlong(grownAlong(grownAlong(bits, 2), 1), 0);
    }
    CubeBits result = bits | grownAlongX(bits);
    for (std::size_t x = 0; x < 8; ++x) result[x] |= grownAlongY(bits[x]) | grownAlongZ(bits[x]);
    return result;
}

CubeBits crossing(const CubeBits& bits, glm::ivec3 direction, Neighbours neighbours) {
    CubeBits result = bits;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] > 0) {
            result = layerMoved(result, axis, 7, 0);
        } else if (direction[axis] < 0) {
            result = layerMoved(result, axis, 0, 7);
        } else if (neighbours == Neighbours::twentySix) {
            result = grownAlong(result, axis);
        }
    }
    return result;
}

CubeBits layerMoved(const CubeBits& bits, int axis, int from, int to) {
    CubeBits result{};
    if (axis == 0) {
        result[static_cast<std::size_t>(to)] = bits[static_cast<std::size_t>(from)];
        return result;
    }
    const int stride = axis == 1 ? 8 : 1;
    const std::uint64_t layer = axis == 1 ? kRow : kLowestZ;
    for (std::size_t x = 0; x < 8; ++x) {
        result[x] = ((bits[x] >> (stride * from)) & layer) << (stride * to);
    }
    return result;
}

}  // namespace voxprite
