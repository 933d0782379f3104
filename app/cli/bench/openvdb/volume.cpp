#include <openvdb/openvdb.h>
#include <openvdb/tools/RayIntersector.h>

#include <mutex>
#include <optional>

#include "app/cli/bench/openvdb/parts.h"

namespace voxprite::bench {
namespace {

using Grid32 = openvdb::Int32Grid;
using VdbRay = openvdb::math::Ray<double>;
using Intersector = openvdb::tools::VolumeRayIntersector<
    Grid32, Grid32::TreeType::RootNodeType::ChildNodeType::LEVEL, VdbRay>;

class VolumeCaster : public OpenVdbVolume::Caster {
  public:
    VolumeCaster(glm::ivec3 size, const Grid32& grid)
        : size_(size), intersector_(grid), accessor_(grid.getConstAccessor()) {}

    std::uint8_t cast(const Ray& ray) override {
        const Span span = clip(ray, size_);
        if (span.tIn > span.tOut) return 0;
        const glm::dvec3 start = ray.origin + ray.direction * span.tIn;
        const VdbRay vdbRay({start.x, start.y, start.z},
                            {ray.direction.x, ray.direction.y, ray.direction.z}, 0.0);
        if (!intersector_.setIndexRay(vdbRay)) return 0;
        double t0 = 0.0, t1 = 0.0;
        while (intersector_.march(t0, t1)) {
            openvdb::math::DDA<VdbRay> voxels(vdbRay, t0, t1);
            int material = 0;
            do {
                if (accessor_.probeValue(voxels.voxel(), material)) {
                    return static_cast<std::uint8_t>(material);
                }
            } while (voxels.step());
        }
        return 0;
    }

  private:
    glm::ivec3 size_;
    Intersector intersector_;
    Grid32::ConstAccessor accessor_;
};

class NothingCaster : public OpenVdbVolume::Caster {
  public:
    std::uint8_t cast(const Ray&) override { return 0; }
};

class Volume : public OpenVdbVolume {
  public:
    explicit Volume(glm::ivec3 size) : size_(size) { openvdb::initialize(); }

    void set(glm::ivec3 voxel, std::uint8_t material) override {
        accessor_.setValue(openvdb::Coord(voxel.x, voxel.y, voxel.z), material);
    }
    std::unique_ptr<Caster> caster() override {
        if (grid_->empty()) return std::make_unique<NothingCaster>();
        std::call_once(made_, [&] { first_.emplace(size_, *grid_); });
        return std::make_unique<VolumeCaster>(*first_);
    }

  private:
    glm::ivec3 size_;
    Grid32::Ptr grid_ = Grid32::create(0);
    Grid32::Accessor accessor_ = grid_->getAccessor();
    // To find where the leaves are takes long, to copy that does not.
    std::once_flag made_;
    std::optional<VolumeCaster> first_;
};

}  // namespace

std::unique_ptr<OpenVdbVolume> makeVolume(glm::ivec3 size) {
    return std::make_unique<Volume>(size);
}

}  // namespace voxprite::bench
