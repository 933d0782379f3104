#include "app/cli/bench/nanovdb_rival.h"

#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/Ray.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/cli/bench/rivals.h"

namespace voxprite::bench {
namespace {

using Grid32 = nanovdb::NanoGrid<std::uint32_t>;
using Accessor = nanovdb::DefaultReadAccessor<std::uint32_t>;

constexpr float kFar = std::numeric_limits<float>::max();

// NanoVDB's HDDA but for the cell behind a crossing.
class Walk {
  public:
    Walk(const glm::vec3& start, const glm::vec3& direction, nanovdb::Coord cell, int dim)
        : start_(start), direction_(direction) {
        for (int a = 0; a < 3; ++a) {
            step_[a] = direction[a] > 0.0f ? 1 : direction[a] < 0.0f ? -1 : 0;
            inverse_[a] = step_[a] == 0 ? 0.0f : 1.0f / direction[a];
        }
        enter(cell, dim);
    }

    [[nodiscard]] int dim() const { return dim_; }
    [[nodiscard]] const nanovdb::Coord& cell() const { return cell_; }

    // Into the node of edge `dim` around the cell.
    void enter(const nanovdb::Coord& cell, int dim) {
        dim_ = dim;
        for (int a = 0; a < 3; ++a) {
            cell_[a] = cell[a] & ~(dim - 1);
            const float face = static_cast<float>(cell_[a] + (step_[a] > 0 ? dim : 0));
            next_[a] = step_[a] == 0 ? kFar : (face - start_[a]) * inverse_[a];
        }
    }
    // Over the nearest face; where that leads.
    nanovdb::Coord step() {
        const int axis =
            next_[0] <= next_[1] ? (next_[0] <= next_[2] ? 0 : 2) : (next_[1] <= next_[2] ? 1 : 2);
        const float time = next_[axis];
        next_[axis] += static_cast<float>(dim_) * std::abs(inverse_[axis]);
        cell_[axis] += step_[axis] * dim_;
        if (dim_ == 1) return cell_;
        nanovdb::Coord behind = cell_;
        for (int a = 0; a < 3; ++a) {
            if (a == axis) {
                behind[a] += step_[a] < 0 ? dim_ - 1 : 0;
            } else {
                const float at = start_[a] + time * direction_[a];
                behind[a] =
                    std::clamp(static_cast<int>(std::floor(at)), cell_[a], cell_[a] + dim_ - 1);
            }
        }
        return behind;
    }

  private:
    glm::vec3 start_, direction_, inverse_{0.0f}, next_{0.0f};
    glm::ivec3 step_{0};
    nanovdb::Coord cell_;
    int dim_ = 1;
};

}  // namespace

struct NanoVdbRival::Grid {
    nanovdb::GridHandle<> handle;
    const Grid32* grid = nullptr;
    glm::ivec3 size{0};
};

NanoVdbRival::NanoVdbRival(const OctreeView& octree) : grid_(std::make_unique<Grid>()) {
    nanovdb::GridBuilder<std::uint32_t> builder(0);
    auto accessor = builder.getAccessor();
    forEachSolid(octree, [&](glm::ivec3 v, std::uint8_t material) {
        accessor.setValue(nanovdb::Coord(v.x, v.y, v.z), material);
    });
    grid_->handle = builder.getHandle<>();
    grid_->grid = grid_->handle.grid<std::uint32_t>();
    grid_->size = octree.size;
}

NanoVdbRival::~NanoVdbRival() = default;

struct NanoVdbRival::Caster::State {
    glm::ivec3 size;
    Accessor accessor;
};

NanoVdbRival::Caster::Caster(const NanoVdbRival& rival)
    : state_(std::make_unique<State>(State{rival.grid_->size, rival.grid_->grid->getAccessor()})) {}

NanoVdbRival::Caster::~Caster() = default;

std::uint8_t NanoVdbRival::Caster::cast(const Ray& ray) {
    const Span span = clip(ray, state_->size);
    if (span.tIn > span.tOut) return 0;
    Accessor& accessor = state_->accessor;
    const glm::ivec3& size = state_->size;
    const glm::ivec3 first = cellAt(ray, span.tIn, size);
    nanovdb::Coord at(first.x, first.y, first.z);
    // From where it comes in: single precision is enough from there.
    const nanovdb::Ray<float> unused;
    Walk walk(glm::vec3(ray.origin + ray.direction * span.tIn), glm::vec3(ray.direction), at,
              static_cast<int>(accessor.getDim(at, unused)));
    while (!accessor.isActive(at)) {
        at = walk.step();
        for (int a = 0; a < 3; ++a)
            if (at[a] < 0 || at[a] >= size[a]) return 0;
        const int dim = static_cast<int>(accessor.getDim(at, unused));
        if (dim != walk.dim()) walk.enter(at, dim);
    }
    return static_cast<std::uint8_t>(accessor.getValue(at));
}

}  // namespace voxprite::bench
