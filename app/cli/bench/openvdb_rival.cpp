#include <openvdb/openvdb.h>
#include <openvdb/tools/RayIntersector.h>

#include <limits>

#include "app/cli/bench/volume_rivals.h"

namespace voxprite::bench {
namespace {

using Grid32 = openvdb::Int32Grid;
using VdbRay = openvdb::math::Ray<double>;
using Intersector = openvdb::tools::VolumeRayIntersector<
    Grid32, Grid32::TreeType::RootNodeType::ChildNodeType::LEVEL, VdbRay>;

}  // namespace

struct OpenVdbRival::Grid {
    Grid32::Ptr grid;
    std::unique_ptr<Intersector> intersector;  // null: nothing to hit
    glm::ivec3 size{0};
};

OpenVdbRival::OpenVdbRival(const OctreeView& octree) : grid_(std::make_unique<Grid>()) {
    openvdb::initialize();
    grid_->grid = Grid32::create(0);
    grid_->size = octree.size;
    Grid32::Accessor accessor = grid_->grid->getAccessor();
    forEachSolid(octree, [&](glm::ivec3 v, std::uint8_t material) {
        accessor.setValue(openvdb::Coord(v.x, v.y, v.z), material);
    });
    if (!grid_->grid->empty()) grid_->intersector = std::make_unique<Intersector>(*grid_->grid);
}

OpenVdbRival::~OpenVdbRival() = default;

struct OpenVdbRival::Caster::State {
    glm::ivec3 size;
    Intersector intersector;
    Grid32::ConstAccessor accessor;
};

OpenVdbRival::Caster::Caster(const OpenVdbRival& rival) {
    if (rival.grid_->intersector)
        state_ = std::make_unique<State>(State{rival.grid_->size, *rival.grid_->intersector,
                                               rival.grid_->grid->getConstAccessor()});
}

OpenVdbRival::Caster::~Caster() = default;

std::uint8_t OpenVdbRival::Caster::cast(const Ray& ray) {
    if (!state_) return 0;
    const Span span = clip(ray, state_->size);
    if (span.tIn > span.tOut) return 0;
    const glm::dvec3 start = ray.origin + ray.direction * span.tIn;
    const VdbRay vdbRay({start.x, start.y, start.z},
                        {ray.direction.x, ray.direction.y, ray.direction.z}, 0.0);
    if (!state_->intersector.setIndexRay(vdbRay)) return 0;
    double t0 = 0.0, t1 = 0.0;
    while (state_->intersector.march(t0, t1)) {
        openvdb::math::DDA<VdbRay> voxels(vdbRay, t0, t1);
        int material = 0;
        do {
            if (state_->accessor.probeValue(voxels.voxel(), material))
                return static_cast<std::uint8_t>(material);
        } while (voxels.step());
    }
    return 0;
}

}  // namespace voxprite::bench
