#include "core/io/mesh_band.h"

#include <openvdb/Grid.h>
#include <openvdb/math/Transform.h>
#include <openvdb/tools/MeshToVolume.h>

#include <exception>
#include <string>
#include <utility>

namespace voxprite {
namespace {

// What OpenVDB reads triangles through. Its cells have their centre at whole numbers.
class Triangles {
  public:
    explicit Triangles(std::span<const MeshTriangle> triangles) : triangles_(triangles) {}
    [[nodiscard]] std::size_t polygonCount() const { return triangles_.size(); }
    [[nodiscard]] std::size_t pointCount() const { return 3 * triangles_.size(); }
    [[nodiscard]] std::size_t vertexCount(std::size_t /*polygon*/) const { return 3; }
    void getIndexSpacePoint(std::size_t polygon, std::size_t corner, openvdb::Vec3d& point) const {
        const glm::dvec3& p = triangles_[polygon].corners[corner].position;
        point = openvdb::Vec3d(p.x - 0.5, p.y - 0.5, p.z - 0.5);
    }

  private:
    std::span<const MeshTriangle> triangles_;
};

template <class Work>
auto contained(const Work& work) -> Result<decltype(work())> {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return fail("there is not enough memory to make voxels of the mesh");
    } catch (const std::exception& problem) {
        return fail(std::string("OpenVDB cannot make voxels of the mesh: ") + problem.what());
    }
}

}  // namespace

struct SurfaceBand::Impl {
    openvdb::Int32Grid nearest{-1};
};

SurfaceBand::SurfaceBand(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SurfaceBand::~SurfaceBand() = default;
SurfaceBand::SurfaceBand(SurfaceBand&&) noexcept = default;
SurfaceBand& SurfaceBand::operator=(SurfaceBand&&) noexcept = default;

Result<SurfaceBand> SurfaceBand::of(std::span<const MeshTriangle> triangles) {
    return contained([&] {
        auto impl = std::make_unique<Impl>();
        const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
        static_cast<void>(openvdb::tools::meshToVolume<openvdb::FloatGrid>(
            Triangles(triangles), *transform, /*exteriorBandWidth=*/1.0f,
            /*interiorBandWidth=*/1.0f, openvdb::tools::UNSIGNED_DISTANCE_FIELD, &impl->nearest));
        return SurfaceBand(std::move(impl));
    });
}

const std::int32_t* SurfaceBand::blockAt(glm::ivec3 origin) const {
    const auto* leaf =
        impl_->nearest.tree().probeConstLeaf(openvdb::Coord(origin.x, origin.y, origin.z));
    return leaf == nullptr ? nullptr : leaf->buffer().data();
}

Result<CellMask> floodedInside(std::span<const MeshTriangle> triangles, glm::ivec3 size) {
    return contained([&] {
        const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
        const openvdb::FloatGrid::Ptr grid = openvdb::tools::meshToVolume<openvdb::FloatGrid>(
            Triangles(triangles), *transform, 1.0f, 1.0f);
        CellMask inside(size);
        const auto distance = grid->getConstAccessor();
        for (glm::ivec3 cell(0); cell.z < size.z; ++cell.z) {
            for (cell.y = 0; cell.y < size.y; ++cell.y) {
                for (cell.x = 0; cell.x < size.x; ++cell.x) {
                    if (distance.getValue({cell.x, cell.y, cell.z}) < 0.0f) inside.set(cell);
                }
            }
        }
        return inside;
    });
}

}  // namespace voxprite
