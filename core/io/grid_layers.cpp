#include "core/io/grid_layers.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace voxprite {
namespace {

constexpr int kSlab = 8;
constexpr std::uint64_t kMaxCellsOfLayer = std::uint64_t{1} << 26;

// The layers of one row of blocks.
class Slab {
  public:
    Slab(const IBox& box, int axis)
        : box_(box), axis_(axis), across_(axis == 2 ? 1 : 2), size_(box.max - box.min) {}

    void clear(int first) {
        first_ = first;
        cells_.assign(static_cast<std::size_t>(kSlab) * cellsOfLayer(), 0);
    }

    void put(const VoxelBlock& block) {
        IBox layers = box_;
        layers.min[axis_] = first_;
        layers.max[axis_] = first_ + kSlab;
        const IBox part =
            IBox{block.origin, block.origin + block.edgeVoxels}.intersected(layers).intersected(
                box_);
        for (int x = part.min.x; x < part.max.x; ++x) {
            for (int y = part.min.y; y < part.max.y; ++y) {
                for (int z = part.min.z; z < part.max.z; ++z) {
                    cells_[placeOf({x, y, z})] = valueAt(block, glm::ivec3(x, y, z) - block.origin);
                }
            }
        }
    }

    [[nodiscard]] std::span<const std::uint8_t> layer(int coordinate) const {
        return std::span(cells_).subspan(
            static_cast<std::size_t>(coordinate - first_) * cellsOfLayer(), cellsOfLayer());
    }

  private:
    static std::uint8_t valueAt(const VoxelBlock& block, glm::ivec3 v) {
        return block.voxels != nullptr ? block.voxels[v.x << 6 | v.y << 3 | v.z]
                                       : block.uniformValue;
    }
    [[nodiscard]] std::size_t cellsOfLayer() const {
        return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_[across_]);
    }
    [[nodiscard]] std::size_t placeOf(glm::ivec3 v) const {
        const auto row = static_cast<std::size_t>(v[across_] - box_.min[across_]);
        return static_cast<std::size_t>(v[axis_] - first_) * cellsOfLayer() +
               row * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(v.x - box_.min.x);
    }

    IBox box_;
    int axis_;
    int across_;
    glm::ivec3 size_;
    int first_ = 0;
    std::vector<std::uint8_t> cells_;
};

int slabOf(int coordinate) {
    return coordinate >> 3;
}

}  // namespace

Status forEachLayer(const VoxelGrid& grid, const IBox& box, int axis, const VisitLayer& visit) {
    if (box.empty()) return {};
    const auto edge = [&](int k) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(box.max[k]) - box.min[k]);
    };
    const std::uint64_t layerCells = edge(0) * edge(axis == 2 ? 1 : 2);
    if (layerCells > kMaxCellsOfLayer || layerCells * edge(axis) > kMaxLayerCells) {
        return fail("a box of " + std::to_string(edge(0)) + " x " + std::to_string(edge(1)) +
                    " x " + std::to_string(edge(2)) + " voxels is too large to list every cell");
    }
    std::map<int, std::vector<VoxelBlock>> ofSlab;
    grid.forEachBlock([&](const VoxelBlock& block) {
        const IBox part = IBox{block.origin, block.origin + block.edgeVoxels}.intersected(box);
        if (part.empty()) return;
        for (int k = slabOf(part.min[axis]); k <= slabOf(part.max[axis] - 1); ++k) {
            ofSlab[k].push_back(block);
        }
    });
    Slab slab(box, axis);
    for (int k = slabOf(box.min[axis]); k <= slabOf(box.max[axis] - 1); ++k) {
        slab.clear(k * kSlab);
        for (const VoxelBlock& block : ofSlab[k]) slab.put(block);
        const int end = std::min(box.max[axis], (k + 1) * kSlab);
        for (int at = std::max(box.min[axis], k * kSlab); at < end; ++at) {
            if (Status s = visit(at, slab.layer(at)); !s) return s;
        }
    }
    return {};
}

}  // namespace voxprite
