#include "app/cli/bench/vdb_rival.h"

#include <nanovdb/util/OpenToNanoVDB.h>
#include <openvdb/openvdb.h>

namespace voxprite::bench {
namespace {

using Tree = openvdb::tree::Tree4<std::int16_t, 5, 4, 3>::Type;
using Grid = openvdb::Grid<Tree>;
using Accessor = openvdb::tree::ValueAccessor<Tree, /*IsSafe=*/false>;

openvdb::Coord coord(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

nanovdb::GridHandle<nanovdb::HostBuffer> converted(const Grid& grid) {
    nanovdb::OpenToNanoVDB<std::int16_t, std::int16_t> convert;
    return convert(grid, nanovdb::StatsMode::Disable, nanovdb::ChecksumMode::Disable, 0);
}

}  // namespace

struct VdbGrid::Impl {
    Grid::Ptr grid = Grid::create(0);
    Accessor accessor{grid->tree()};
};

VdbGrid::VdbGrid(const VoxelGrid& voxels) : impl_(std::make_unique<Impl>()) {
    voxels.forEachSolid([this](glm::ivec3 v, std::uint8_t material) { set(v, material); });
}

VdbGrid::~VdbGrid() = default;

void VdbGrid::set(glm::ivec3 voxel, std::uint8_t material) {
    if (material == 0) {
        impl_->accessor.setValueOff(coord(voxel), 0);
    } else {
        impl_->accessor.setValueOn(coord(voxel), material);
    }
}

std::size_t VdbGrid::toNanoVdb() const {
    return converted(*impl_->grid).size();
}

bool VdbGrid::nanoVdbHolds(const VoxelGrid& voxels) const {
    const auto handle = converted(*impl_->grid);
    const auto* grid = handle.grid<std::int16_t>();
    if (grid == nullptr) return false;
    bool same = true;
    const auto reader = grid->getAccessor();
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t material) {
        same = same && reader.getValue(nanovdb::Coord(v.x, v.y, v.z)) == material;
    });
    return same;
}

}  // namespace voxprite::bench
