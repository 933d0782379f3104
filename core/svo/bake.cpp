#include "core/svo/bake.h"

#include <bit>
#include <cstring>

#include "core/svo/tree_builder.h"

namespace voxprite {
namespace {

static_assert(std::endian::native == std::endian::little, "rows of voxels are read as words");

// A block of the grid in tree space.
struct Source {
    IBox box;                              // what of the block lies within the bounds
    glm::ivec3 origin{0};                  // of voxels[0]
    const std::uint8_t* voxels = nullptr;  // null: uniform
    std::uint8_t value = 0;
};

std::int64_t volume(const IBox& box) {
    const glm::ivec3 size = box.size();
    return std::int64_t{size.x} * size.y * size.z;
}

// Eight voxels along z at (x, y) of a dense block, the lowest z in the lowest byte.
std::uint64_t loadRow(const std::uint8_t* voxels, int x, int y) {
    std::uint64_t row = 0;
    std::memcpy(&row, voxels + ((x << 6) | (y << 3)), sizeof row);
    return row;
}

// The one value of a dense block, or -1.
int uniformValueOf(const std::uint8_t* voxels) {
    const std::uint64_t first = uniformPayload(voxels[0]);
    for (int row = 0; row < 64; ++row) {
        if (loadRow(voxels, row >> 3, row & 7) != first) return -1;
    }
    return voxels[0];
}

// Goes down from the root with the blocks that touch each cube; a cube of eight voxels is gathered
// into rows and cut into bricks. Blocks need not be aligned to the cubes: those across a border go
// to both sides.
class Baker {
  public:
    Baker(const VoxelGrid& voxels, const IBox& bounds)
        : bounds_(bounds), builder_(depthForSize(bounds.size())) {
        voxels.forEachBlock([this](const VoxelBlock& block) { add(block); });
    }

    Result<Octree> run() {
        for (std::uint32_t i = 0; i < sources_.size(); ++i) pending_.push_back(i);
        return builder_.finish(cube(0, glm::ivec3(0), 0), bounds_.size(), bounds_.min);
    }

  private:
    void add(const VoxelBlock& block) {
        const IBox inside =
            bounds_.intersected({block.origin, block.origin + glm::ivec3(block.edgeVoxels)});
        if (inside.empty()) return;
        Source source;
        source.box = {inside.min - bounds_.min, inside.max - bounds_.min};
        source.origin = block.origin - bounds_.min;
        source.value = block.uniformValue;
        if (block.voxels != nullptr) {
            const int value = uniformValueOf(block.voxels);
            if (value == 0) return;
            if (value > 0) source.value = static_cast<std::uint8_t>(value);
            if (value < 0) source.voxels = block.voxels;
        }
        sources_.push_back(source);
    }

    // pending_[first, end) are the sources that touch the cube.
    [[nodiscard]] std::uint32_t cube(int depth, glm::ivec3 min, std::size_t first) {
        const std::size_t last = pending_.size();
        if (first == last || builder_.full()) return 0;
        const int edge = 1 << (builder_.maxDepth() - depth);
        const IBox box{min, min + edge};
        if (const std::uint8_t value = coveringValue(box, first); value != 0) {
            return node::uniform(value);
        }
        if (edge <= 8) {
            gather(box, first);
            cut();
            return denseCube(depth, 0, edge == 8 ? 64 : edge == 4 ? 8 : 1);
        }
        return builder_.internal(depth, [&](unsigned octant) {
            const glm::ivec3 childMin = min + octantCorner(octant) * (edge / 2);
            const glm::ivec3 childMax = childMin + edge / 2;
            for (std::size_t i = first; i < last; ++i) {
                const IBox& b = sources_[pending_[i]].box;
                if (b.min.x < childMax.x && b.max.x > childMin.x && b.min.y < childMax.y &&
                    b.max.y > childMin.y && b.min.z < childMax.z && b.max.z > childMin.z) {
                    pending_.push_back(pending_[i]);
                }
            }
            const std::uint32_t word = cube(depth + 1, childMin, last);
            pending_.resize(last);
            return word;
        });
    }

    // The material that fills the whole cube, or 0. Sources do not overlap, so volumes tell.
    [[nodiscard]] std::uint8_t coveringValue(const IBox& box, std::size_t first) const {
        const std::uint8_t value = sources_[pending_[first]].value;
        std::int64_t covered = 0;
        for (std::size_t i = first; i < pending_.size(); ++i) {
            const Source& source = sources_[pending_[i]];
            if (source.voxels != nullptr || source.value != value) return 0;
            covered += volume(source.box.intersected(box));
        }
        return covered == volume(box) ? value : std::uint8_t{0};
    }

    // Fills rows_ with the voxels of a cube of edge 8 (or of the whole tree, if that is smaller).
    void gather(const IBox& cube, std::size_t first) {
        rows_.fill(0);
        for (std::size_t i = first; i < pending_.size(); ++i) {
            const Source& source = sources_[pending_[i]];
            const IBox part = source.box.intersected(cube);
            const int z = part.min.z - cube.min.z;
            const int bits = 8 * (part.max.z - part.min.z);
            const std::uint64_t mask = (~std::uint64_t{0} >> (64 - bits)) << (8 * z);
            const glm::ivec3 shift = cube.min - source.origin;
            for (int x = part.min.x - cube.min.x; x < part.max.x - cube.min.x; ++x) {
                for (int y = part.min.y - cube.min.y; y < part.max.y - cube.min.y; ++y) {
                    std::uint64_t row = uniformPayload(source.value);
                    if (source.voxels != nullptr) {
                        row = loadRow(source.voxels, x + shift.x, y + shift.y);
                        row = shift.z >= 0 ? row >> (8 * shift.z) : row << (-8 * shift.z);
                    }
                    rows_[static_cast<std::size_t>((x << 3) | y)] |= row & mask;
                }
            }
        }
    }

    // Cuts rows_ into bricks_, in the octree's own order (the bits of x, y and z interleaved).
    void cut() {
        occupied_ = 0;
        for (unsigned column = 0; column < 16; ++column) {  // bricks at the same x and y
            const unsigned x = column >> 2;
            const unsigned y = column & 3u;
            const std::size_t row = (x << 4) | (y << 1);
            const std::array<std::uint64_t, 4> rows{rows_[row], rows_[row + 8], rows_[row + 1],
                                                    rows_[row + 9]};
            if ((rows[0] | rows[1] | rows[2] | rows[3]) == 0) continue;
            for (unsigned z = 0; z < 4; ++z) {
                std::uint64_t payload = 0;
                for (unsigned i = 0; i < 4; ++i) {  // octants i and i + 4
                    const std::uint64_t pair = rows[i] >> (16 * z);
                    payload |= ((pair & 0xFF) | (pair & 0xFF00) << 24) << (8 * i);
                }
                if (payload == 0) continue;
                const glm::ivec3 brick(x, y, z);
                const unsigned index = octantOf(brick, 1) << 3 | octantOf(brick, 0);
                bricks_[index] = payload;
                occupied_ |= std::uint64_t{1} << index;
            }
        }
    }

    // The node at `depth` over bricks_[first, first + count).
    [[nodiscard]] std::uint32_t denseCube(int depth, unsigned first, unsigned count) {
        if (((occupied_ >> first) & (~std::uint64_t{0} >> (64 - count))) == 0) return 0;
        if (count == 1) return builder_.brick(bricks_[first]);
        return builder_.internal(depth, [&](unsigned octant) {
            return denseCube(depth + 1, first + octant * (count / 8), count / 8);
        });
    }

    IBox bounds_;
    TreeBuilder builder_;
    std::vector<Source> sources_;
    std::vector<std::uint32_t> pending_;
    std::array<std::uint64_t, 64> rows_{};    // [(x << 3) | y]: eight voxels along z
    std::array<std::uint64_t, 64> bricks_{};  // payloads; only those with their bit in occupied_
    std::uint64_t occupied_ = 0;
};

void unpack(const Octree& octree, std::uint32_t word, int depth, glm::ivec3 min,
            VoxelGrid& voxels) {
    const int edge = 1 << (octree.maxDepth - depth);
    if (node::isUniform(word)) {
        voxels.fill({min, min + edge}, static_cast<std::uint8_t>(word));
    } else if (node::isBrick(word)) {
        const std::uint64_t payload = octree.payloads[node::payloadIndex(word)];
        for (unsigned octant = 0; octant < 8; ++octant) {
            const std::uint8_t material = payloadMaterial(payload, octant);
            if (material != 0) voxels.set(min + octantCorner(octant), material);
        }
    } else if (node::isInternal(word)) {
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (!node::hasChild(word, octant)) continue;
            unpack(octree, octree.nodes[node::childIndex(word, octant)], depth + 1,
                   min + octantCorner(octant) * (edge / 2), voxels);
        }
    }
}

}  // namespace

Result<Octree> bake(const VoxelGrid& voxels, const IBox& bounds) {
    if (bounds.empty()) return Octree{};
    if (auto fits = checkOctreeSize(bounds.size()); !fits) return tl::unexpected(fits.error());
    return Baker(voxels, bounds).run();
}

Result<Octree> bake(const VoxelGrid& voxels) {
    return bake(voxels, voxels.bounds());
}

VoxelGrid toVoxels(const Octree& octree) {
    VoxelGrid voxels;
    unpack(octree, octree.nodes[0], 0, octree.origin, voxels);
    return voxels;
}

}  // namespace voxprite
