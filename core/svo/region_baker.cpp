#include "core/svo/region_baker.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/svo/brick_order.h"

namespace voxprite {
namespace {

static_assert(std::endian::native == std::endian::little, "rows of voxels are read as words");

// Fewer bricks than this are cut out one by one.
constexpr int kFewBricks = 8;

constexpr std::array<std::uint8_t, 512> kNoVoxels{};
constexpr std::array<std::uint64_t, 8> kNothing{};
constexpr auto kEverything = [] {
    std::array<std::uint64_t, 8> words{};
    words.fill(~std::uint64_t{0});
    return words;
}();

// Three bits at every third place.
constexpr std::array<unsigned, 8> kSpread{0, 1, 8, 9, 64, 65, 72, 73};
constexpr int gathered(unsigned bits) {
    return static_cast<int>((bits & 1u) | (bits >> 2 & 2u) | (bits >> 4 & 4u));
}
glm::ivec3 cellOf(unsigned index) {
    return {gathered(index), gathered(index >> 1), gathered(index >> 2)};
}

// The one value of 512 voxels that are all solid, or -1.
int onlyValue(const std::uint8_t* voxels, const std::uint64_t* solid) {
    const bool full = (solid[0] & solid[1] & solid[2] & solid[3] & solid[4] & solid[5] & solid[6] &
                       solid[7]) == ~std::uint64_t{0};
    return full && std::memcmp(voxels, voxels + 1, 511) == 0 ? voxels[0] : -1;
}

// Large models lie in memory that no cache holds, a block anywhere: what will be read of it is
// asked for long before. Bricks are read from two planes, whichever of them is solid.
void prefetch(const std::uint8_t* voxels, const std::uint64_t* solid) {
    for (int x = 0; x < 8; x += 2) {
        if ((solid[x] | solid[x + 1]) == 0) continue;
        __builtin_prefetch(voxels + 64 * x);
        __builtin_prefetch(voxels + 64 * x + 64);
        __builtin_prefetch(voxels + 64 * x + 127);
    }
}

}  // namespace

RegionBaker::RegionBaker(const IBox& bounds, TreeBuilder& builder)
    : bounds_(bounds), builder_(builder), offset_(bounds.min & 7) {}

std::uint32_t RegionBaker::bake(glm::ivec3 min, std::span<const VoxelRegion> sources) {
    const int edge = std::min(kEdge, 1 << builder_.maxDepth());
    min_ = min;
    firstBlock_ = (bounds_.min + min) & ~7;
    blocks_.fill({kNoVoxels.data(), kNothing.data(), 0});
    occupied_.fill(0);
    const IBox box = bounds_.intersected({bounds_.min + min, bounds_.min + min + edge});
    for (const VoxelRegion& source : sources) {
        if (source.blocks == nullptr) {
            putUniform(source, box);
            continue;
        }
        VoxelGrid::forEachBlockIn(source, box, [this](const VoxelBlock& block) {
            if (block.voxels != nullptr) prefetch(block.voxels, block.solid);
            put((block.origin - firstBlock_) >> 3,
                block.voxels == nullptr
                    ? uniformBlock(block.uniformValue)
                    : Block{block.voxels, block.solid, onlyValue(block.voxels, block.solid)});
        });
    }
    const int cellsAnEdge = std::max(1, edge / 8);
    return cells(builder_.maxDepth() - std::countr_zero(static_cast<unsigned>(edge)), 0,
                 static_cast<unsigned>(cellsAnEdge * cellsAnEdge * cellsAnEdge));
}

void RegionBaker::put(glm::ivec3 block, const Block& voxels) {
    blocks_[static_cast<std::size_t>((block.x * kBlocks + block.y) * kBlocks + block.z)] = voxels;
    // The cells that begin in it and, when they do not begin where blocks do, those before.
    const auto mark = [this](int x, int y, int z) {
        const unsigned index = kSpread[x] | kSpread[y] << 1 | kSpread[z] << 2;
        occupied_[index >> 6] |= std::uint64_t{1} << (index & 63u);
    };
    if (offset_ == glm::ivec3(0)) return mark(block.x, block.y, block.z);
    const glm::ivec3 first = glm::max(block - glm::min(offset_, glm::ivec3(1)), glm::ivec3(0));
    const glm::ivec3 last = glm::min(block, glm::ivec3(kCells - 1));
    for (int x = first.x; x <= last.x; ++x) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int z = first.z; z <= last.z; ++z) mark(x, y, z);
        }
    }
}

void RegionBaker::putUniform(const VoxelRegion& source, const IBox& box) {
    const IBox part = box.intersected({source.origin, source.origin + source.edgeVoxels});
    if (part.empty()) return;
    const Block block = uniformBlock(source.uniformValue);
    const glm::ivec3 first = (part.min - firstBlock_) >> 3;
    const glm::ivec3 last = (part.max - 1 - firstBlock_) >> 3;
    for (int x = first.x; x <= last.x; ++x) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int z = first.z; z <= last.z; ++z) put({x, y, z}, block);
        }
    }
}

RegionBaker::Block RegionBaker::uniformBlock(std::uint8_t value) {
    const auto found = std::find_if(uniforms_.begin(), uniforms_.end(),
                                    [value](const auto& made) { return (*made)[0] == value; });
    if (found != uniforms_.end()) return {(*found)->data(), kEverything.data(), value};
    uniforms_.push_back(std::make_unique<Voxels>());
    uniforms_.back()->fill(value);
    return {uniforms_.back()->data(), kEverything.data(), value};
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
    const Block* block =
        &blocks_[static_cast<std::size_t>((at.x * kBlocks + at.y) * kBlocks + at.z)];
    const bool inside = end.x >= 8 && end.y >= 8 && end.z >= 8;
    if (inside) {
        const int value = valueAround(block);
        if (value >= 0) return static_cast<std::uint32_t>(value);
    }
    const std::uint8_t* voxels = block->voxels;
    const std::uint64_t* solid = block->solid;
    const bool asItLies = inside && offset_ == glm::ivec3(0);
    if (!asItLies) {
        if (!gatherSolid(block, end)) return 0;
        gatherRows(block, end);
        voxels = reinterpret_cast<const std::uint8_t*>(rows_.data());
        solid = solid_.data();
    }
    const std::uint64_t bricks = bricksWithAny(solid);
    const std::uint64_t full = bricksWithAll(solid);
    if (std::popcount(bricks) < kFewBricks) {
        return builder_.cube(bricks, full, [&](unsigned i) { return brickOf(voxels, i); });
    }
    cutIntoBricks(voxels, payloads_.data());
    return builder_.cube(bricks, full, [&](unsigned i) { return payloads_[i]; });
}

int RegionBaker::valueAround(const Block* at) const {
    const int value = at->onlyValue;
    for (int x = 0; x <= (offset_.x != 0 ? 1 : 0); ++x) {
        for (int y = 0; y <= (offset_.y != 0 ? 1 : 0); ++y) {
            for (int z = 0; z <= (offset_.z != 0 ? 1 : 0); ++z) {
                if (at[(x * kBlocks + y) * kBlocks + z].onlyValue != value) return -1;
            }
        }
    }
    return value;
}

bool RegionBaker::gatherSolid(const Block* at, glm::ivec3 end) {
    // Of each row, what comes from the block itself; the rest comes from the next one.
    const std::uint64_t ofFirst = 0x0101'0101'0101'0101u * (0xFFu >> offset_.z);
    const auto alongZ = [&](const Block* of, int plane) {
        const std::uint64_t first = of[0].solid[plane];
        if (offset_.z == 0) return first;
        return (first >> offset_.z & ofFirst) | (of[1].solid[plane] << (8 - offset_.z) & ~ofFirst);
    };
    std::uint64_t kept = 0;
    if (end.y > 0 && end.z > 0) {
        kept = 0x0101'0101'0101'0101u * (0xFFu >> (8 - std::min(end.z, 8)));
        kept &= ~std::uint64_t{0} >> 8 * (8 - std::min(end.y, 8));
    }
    std::uint64_t any = 0;
    for (int x = 0; x < 8; ++x) {
        const int inX = x + offset_.x;
        const Block* of = at + (inX >> 3) * kBlocks * kBlocks;
        const int plane = inX & 7;
        std::uint64_t word = alongZ(of, plane);
        if (offset_.y != 0) {
            word = word >> 8 * offset_.y | alongZ(of + kBlocks, plane) << (64 - 8 * offset_.y);
        }
        solid_[static_cast<std::size_t>(x)] = x < end.x ? word & kept : 0;
        any |= solid_[static_cast<std::size_t>(x)];
    }
    return any != 0;
}

void RegionBaker::gatherRows(const Block* at, glm::ivec3 end) {
    const std::uint64_t kept = end.z <= 0  ? 0
                               : end.z < 8 ? ~std::uint64_t{0} >> (64 - 8 * end.z)
                                           : ~std::uint64_t{0};
    for (int x = 0; x < 8; ++x) {
        std::uint64_t* row = &rows_[static_cast<std::size_t>(x) << 3];
        if (solid_[static_cast<std::size_t>(x)] == 0) {
            std::fill(row, row + 8, 0);
            continue;
        }
        const int inX = x + offset_.x;
        const Block* of = at + (inX >> 3) * kBlocks * kBlocks;
        const int plane = (inX & 7) << 6;
        const int split = 8 - offset_.y;
        copyRows(of[0].voxels + plane + 8 * offset_.y, of[1].voxels + plane + 8 * offset_.y,
                 offset_.z, split, row);
        copyRows(of[kBlocks].voxels + plane, of[kBlocks + 1].voxels + plane, offset_.z, 8 - split,
                 row + split);
        if (end.y < 8) std::fill(row + std::max(end.y, 0), row + 8, 0);
        if (end.z < 8)
            for (int y = 0; y < 8; ++y) row[y] &= kept;
    }
}

}  // namespace voxprite
