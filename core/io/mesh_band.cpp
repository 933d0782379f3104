#include "core/io/mesh_band.h"

#include <openvdb/Grid.h>
#include <openvdb/math/Transform.h>
#include <openvdb/tools/MeshToVolume.h>

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace voxprite {
namespace {

// The triangles as OpenVDB reads them; its cells have their centre at whole numbers. In floats, and
// without anything of ours in its templates, since that is what the library itself is compiled for:
// a minute and a half less for the compiler. The band is wider than its cells by far more than
// floats are off.
class Surface {
  public:
    explicit Surface(std::span<const MeshTriangle> triangles) {
        points_.reserve(3 * triangles.size());
        corners_.reserve(triangles.size());
        for (const MeshTriangle& triangle : triangles) {
            const auto first = static_cast<openvdb::Index32>(points_.size());
            corners_.emplace_back(first, first + 1, first + 2);
            for (const auto& corner : triangle.corners) {
                const glm::vec3 p(corner.position - 0.5);
                points_.emplace_back(p.x, p.y, p.z);
            }
        }
    }

    [[nodiscard]] openvdb::FloatGrid::Ptr distances(int flags, openvdb::Int32Grid* nearest) const {
        constexpr float kBandVoxels = 1.0f;
        const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
        openvdb::util::NullInterrupter interrupter;
        const openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I> mesh(
            points_, corners_);
        return openvdb::tools::meshToVolume<openvdb::FloatGrid>(
            interrupter, mesh, *transform, kBandVoxels, kBandVoxels, flags, nearest);
    }

  private:
    std::vector<openvdb::Vec3s> points_;
    std::vector<openvdb::Vec3I> corners_;
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
        static_cast<void>(
            Surface(triangles).distances(openvdb::tools::UNSIGNED_DISTANCE_FIELD, &impl->nearest));
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
        const openvdb::FloatGrid::Ptr grid = Surface(triangles).distances(0, nullptr);
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
