#include <nanovdb/util/OpenToNanoVDB.h>
#include <openvdb/openvdb.h>

#include <utility>

#include "app/cli/bench/openvdb/parts.h"

namespace voxprite::bench {
namespace {

using Tree = openvdb::tree::Tree4<std::int16_t, 5, 4, 3>::Type;
using Grid = openvdb::Grid<Tree>;
using Accessor = openvdb::tree::ValueAccessor<Tree, /*IsSafe=*/false>;
using Handle = nanovdb::GridHandle<nanovdb::HostBuffer>;

openvdb::Coord coord(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

class Converted : public OpenVdbGrid::NanoVdb {
  public:
    explicit Converted(Handle handle) : handle_(std::move(handle)) {}
    int get(glm::ivec3 v) const override {
        const auto* grid = handle_.grid<std::int16_t>();
        return grid == nullptr ? 0 : grid->tree().getValue(nanovdb::Coord(v.x, v.y, v.z));
    }

  private:
    Handle handle_;
};

class EditedGrid : public OpenVdbGrid {
  public:
    void set(glm::ivec3 voxel, std::uint8_t material) override {
        if (material == 0) {
            accessor_.setValueOff(coord(voxel), 0);
        } else {
            accessor_.setValueOn(coord(voxel), material);
        }
    }
    std::unique_ptr<NanoVdb> toNanoVdb() const override {
        nanovdb::OpenToNanoVDB<std::int16_t, std::int16_t> convert;
        return std::make_unique<Converted>(
            convert(*grid_, nanovdb::StatsMode::Disable, nanovdb::ChecksumMode::Disable, 0));
    }

  private:
    Grid::Ptr grid_ = Grid::create(0);
    Accessor accessor_{grid_->tree()};
};

}  // namespace

std::unique_ptr<OpenVdbGrid> makeGrid() {
    return std::make_unique<EditedGrid>();
}

}  // namespace voxprite::bench
