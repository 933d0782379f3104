#include <openvdb/Grid.h>
#include <openvdb/math/Transform.h>
#include <openvdb/tools/MeshToVolume.h>

#include <vector>

#include "core/volume/openvdb_library.h"

namespace voxprite {
namespace {

// The distance of cells to the triangles as OpenVDB reads them; its cells have their centre at
// whole numbers. In floats, and without anything of ours in its templates, since that is what the
// library itself is compiled for: a minute and a half less for the compiler. The band is wider than
// its cells by far more than floats are off.
openvdb::FloatGrid::Ptr distancesTo(const TriangleCorners& surface, int flags,
                                    openvdb::Int32Grid* nearest) {
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> corners;
    points.reserve(3 * surface.triangles);
    corners.reserve(surface.triangles);
    for (std::size_t triangle = 0; triangle < surface.triangles; ++triangle) {
        const auto first = static_cast<openvdb::Index32>(points.size());
        corners.emplace_back(first, first + 1, first + 2);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p(surface.at(3 * triangle + k) - 0.5);
            points.emplace_back(p.x, p.y, p.z);
        }
    }
    constexpr float kBandVoxels = 1.0f;
    const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
    openvdb::util::NullInterrupter interrupter;
    const openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I> mesh(points,
                                                                                          corners);
    return openvdb::tools::meshToVolume<openvdb::FloatGrid>(
        interrupter, mesh, *transform, kBandVoxels, kBandVoxels, flags, nearest);
}

class OpenVdbNearest : public NearestTriangles {
  public:
    explicit OpenVdbNearest(const TriangleCorners& surface) {
        static_cast<void>(distancesTo(surface, openvdb::tools::UNSIGNED_DISTANCE_FIELD, &nearest_));
    }
    const std::int32_t* blockAt(glm::ivec3 origin) const override {
        const auto* leaf =
            nearest_.tree().probeConstLeaf(openvdb::Coord(origin.x, origin.y, origin.z));
        return leaf == nullptr ? nullptr : leaf->buffer().data();
    }

  private:
    openvdb::Int32Grid nearest_{-1};
};

}  // namespace

std::unique_ptr<NearestTriangles> openVdbNearestTriangles(const TriangleCorners& corners) {
    return std::make_unique<OpenVdbNearest>(corners);
}

void openVdbFloodedInside(const TriangleCorners& corners, glm::ivec3 size,
                          const std::function<void(glm::ivec3 cell)>& visit) {
    const openvdb::FloatGrid::Ptr grid = distancesTo(corners, 0, nullptr);
    const auto distance = grid->getConstAccessor();
    for (glm::ivec3 cell(0); cell.z < size.z; ++cell.z) {
        for (cell.y = 0; cell.y < size.y; ++cell.y) {
            for (cell.x = 0; cell.x < size.x; ++cell.x) {
                if (distance.getValue({cell.x, cell.y, cell.z}) < 0.0f) visit(cell);
            }
        }
    }
}

}  // namespace voxprite
