#include "core/svo/region_baker.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace voxprite {
namespace {

static_assert(std::endian::native == std::endian::little, "rows of voxels are read as words");

// Every row of a uniform block, by its value.
constexpr auto kUniformRows = [] {
    std::array<std::uint64_t, 256> rows{};
    for (std::size_t value = 0; value < rows.size(); ++value) {
        rows[value] = uniformPayload(static_cast<std::uint8_t>(value));
    }
    return rows;
}();

const std::uint8_t* uniformRow(std::uint8_t value) {
    return reinterpret_cast<const std::uint8_t*>(&kUniformRows[value]);
}

std::uint64_t load(const std::uint8_t* row) {
    std::uint64_t voxels = 0;
    std::memcpy(&voxels, row, sizeof voxels);
    return voxels;
}

// Three bits to every third place.
constexpr unsigned spread(int bits) {
    const auto b = static_cast<unsigned>(bits);
    return (b & 1u) | (b & 2u) << 2 | (b & 4u) << 4;
}
constexpr int gathered(unsigned bits) {
    return static_cast<int>((bits & 1u) | (bits >> 2 & 2u) | (bits >> 4 & 4u));
}
glm::ivec3 cellOf(unsigned index) {
    return {gathered(index), gathered(index >> 1), gathered(index >> 2)};
}

// The one value of 512 voxels, or -1.
int onlyValue(const std::uint8_t* voxels) {
    return std::memcmp(voxels, voxels + 1, 511) == 0 ? voxels[0] : -1;
}

using Words = std::uint64_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));
using Pairs = std::uint16_t __attribute__((vector_size(16)));

Bytes loadBytes(const std::uint8_t* row) {
    return reinterpret_cast<Bytes>(Words{load(row), 0});
}
Bytes interleave(Bytes a, Bytes b) {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}

// Cuts 8x8x8 voxels (z fastest, then y) into payloads of bricks in the order of octants: the rows
// at x, x + 1, y and y + 1 are interleaved byte by byte.
void cut(const std::uint8_t* voxels, std::uint64_t* payloads) {
    for (unsigned column = 0; column < 16; ++column) {  // bricks at the same x and y
        const unsigned x = column & 3u;
        const unsigned y = column >> 2;
        const std::uint8_t* rows = voxels + (x << 7 | y << 4);
        const auto low = reinterpret_cast<Pairs>(interleave(loadBytes(rows), loadBytes(rows + 64)));
        const auto high =
            reinterpret_cast<Pairs>(interleave(loadBytes(rows + 8), loadBytes(rows + 72)));
        const Pairs first = __builtin_shufflevector(low, high, 0, 8, 1, 9, 2, 10, 3, 11);
        const Pairs second = __builtin_shufflevector(low, high, 4, 12, 5, 13, 6, 14, 7, 15);
        // Bricks at z = 0 and 1 differ in the low bit of z, those at 2 and 3 have its high one,
        // too.
        std::uint64_t* out = payloads + ((x & 1u) | (y & 1u) << 1 | (x >> 1) << 3 | (y >> 1) << 4);
        std::memcpy(out, &first, 8);
        std::memcpy(out + 4, reinterpret_cast<const char*>(&first) + 8, 8);
        std::memcpy(out + 32, &second, 8);
        std::memcpy(out + 36, reinterpret_cast<const char*>(&second) + 8, 8);
    }
}

}  // namespace

RegionBaker::RegionBaker(const IBox& bounds, TreeBuilder& builder)
    : bounds_(bounds), builder_(builder), offset_(bounds.min & 7) {}

std::uint32_t RegionBaker::bake(glm::ivec3 min, std::span<const VoxelRegion> sources) {
    const int edge = std::min(kEdge, 1 << builder_.maxDepth());
    min_ = min;
    firstBlock_ = (bounds_.min + min) & ~7;
    blocks_.fill({uniformRow(0), 0});
    occupied_.fill(0);
    const IBox box = bounds_.intersected({bounds_.min + min, bounds_.min + min + edge});
    for (const VoxelRegion& source : sources) {
        if (source.blocks.empty()) putUniform(source, box);
        for (const VoxelBlock& block : source.blocks) {
            if (box.intersected({block.origin, block.origin + 8}).empty()) continue;
            const bool uniform = block.voxels == nullptr;
            put((block.origin - firstBlock_) >> 3,
                uniform ? Block{uniformRow(block.uniformValue), 0} : Block{block.voxels, 1});
        }
    }
    const int cellsAnEdge = std::max(1, edge / 8);
    return cells(builder_.maxDepth() - std::countr_zero(static_cast<unsigned>(edge)), 0,
                 static_cast<unsigned>(cellsAnEdge * cellsAnEdge * cellsAnEdge));
}

void RegionBaker::put(glm::ivec3 block, Block rows) {
    blocks_[static_cast<std::size_t>((block.x * kBlocks + block.y) * kBlocks + block.z)] = rows;
    // The cells that begin in it and, when they do not begin where blocks do, those before.
    const glm::ivec3 first = glm::max(block - glm::min(offset_, glm::ivec3(1)), glm::ivec3(0));
    const glm::ivec3 last = glm::min(block, glm::ivec3(kCells - 1));
    for (int x = first.x; x <= last.x; ++x) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int z = first.z; z <= last.z; ++z) {
                const unsigned index = spread(x) | spread(y) << 1 | spread(z) << 2;
                occupied_[index >> 6] |= std::uint64_t{1} << (index & 63u);
            }
        }
    }
}

void RegionBaker::putUniform(const VoxelRegion& source, const IBox& box) {
    const IBox part = box.intersected({source.origin, source.origin + source.edgeVoxels});
    if (part.empty()) return;
    const glm::ivec3 first = (part.min - firstBlock_) >> 3;
    const glm::ivec3 last = (part.max - 1 - firstBlock_) >> 3;
    for (int x = first.x; x <= last.x; ++x) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int z = first.z; z <= last.z; ++z) {
                put({x, y, z}, {uniformRow(source.uniformValue), 0});
            }
        }
    }
}

bool RegionBaker::anyCell(unsigned first, unsigned count) const {
    const std::uint64_t word = occupied_[first >> 6];
    return count == 512 || ((word >> (first & 63u)) & (~std::uint64_t{0} >> (64 - count))) != 0;
}

std::uint32_t RegionBaker::cells(int depth, unsigned first, unsigned count) {
    if (count == 1) return cell(first);
    return builder_.internal(depth, [&](unsigned octant) {
        const unsigned at = first + octant * (count / 8);
        return anyCell(at, count / 8) ? cells(depth + 1, at, count / 8) : 0;
    });
}

std::uint32_t RegionBaker::cell(unsigned index) {
    const glm::ivec3 at = cellOf(index);
    const glm::ivec3 end = bounds_.size() - min_ - at * 8;  // of the bounds, from the cell
    const Block* blocks =
        &blocks_[static_cast<std::size_t>((at.x * kBlocks + at.y) * kBlocks + at.z)];
    const bool inside = end.x >= 8 && end.y >= 8 && end.z >= 8;
    const std::uint8_t* voxels = blocks->rows;
    if (inside) {
        const int value = valueAround(blocks);
        if (value >= 0) return node::uniform(static_cast<std::uint8_t>(value));
    }
    if (!inside || offset_ != glm::ivec3(0)) {
        gather(blocks);
        if (!inside) clip(end);
        voxels = reinterpret_cast<const std::uint8_t*>(rows_.data());
    }
    const int value = onlyValue(voxels);
    if (value >= 0) return node::uniform(static_cast<std::uint8_t>(value));
    cut(voxels, payloads_.data());
    return builder_.cube(payloads_);
}

int RegionBaker::valueAround(const Block* at) const {
    const std::uint8_t value = at->rows[0];
    for (int x = 0; x <= (offset_.x != 0 ? 1 : 0); ++x) {
        for (int y = 0; y <= (offset_.y != 0 ? 1 : 0); ++y) {
            for (int z = 0; z <= (offset_.z != 0 ? 1 : 0); ++z) {
                const Block& block = at[(x * kBlocks + y) * kBlocks + z];
                if (block.step != 0 || block.rows[0] != value) return -1;
            }
        }
    }
    return value;
}

void RegionBaker::gather(const Block* at) {
    const int shift = 8 * offset_.z;
    std::size_t row = 0;
    for (int x = 0; x < 8; ++x) {
        const int inX = x + offset_.x;
        for (int y = 0; y < 8; ++y) {
            const int inY = y + offset_.y;
            const Block* low = at + ((inX >> 3) * kBlocks + (inY >> 3)) * kBlocks;
            const Block* high = low + (shift != 0 ? 1 : 0);
            const std::ptrdiff_t place = (inX & 7) << 6 | (inY & 7) << 3;
            // In two steps, for nothing comes from above when the shift is 0.
            rows_[row++] = load(low->rows + place * low->step) >> shift |
                           load(high->rows + place * high->step) << 1 << (63 - shift);
        }
    }
}

void RegionBaker::clip(glm::ivec3 end) {
    const std::uint64_t kept = end.z <= 0  ? 0
                               : end.z < 8 ? ~std::uint64_t{0} >> (64 - 8 * end.z)
                                           : ~std::uint64_t{0};
    for (int x = 0; x < 8; ++x) {
        for (int y = 0; y < 8; ++y) {
            std::uint64_t& row = rows_[static_cast<std::size_t>(x << 3 | y)];
            row = x < end.x && y < end.y ? row & kept : 0;
        }
    }
}

}  // namespace voxprite
