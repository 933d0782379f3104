#include "core/io/mesh_band.h"

#include <exception>
#include <string>

namespace voxprite {
namespace {

TriangleCorners cornersOf(std::span<const MeshTriangle> triangles) {
    return {triangles.size(), [triangles](std::size_t corner) {
                return triangles[corner / 3].corners[corner % 3].position;
            }};
}

// work(library), with its exceptions as errors.
template <class Work>
auto contained(const Work& work) -> Result<decltype(work(std::declval<const VolumeLibrary&>()))> {
    const Result<const VolumeLibrary*> library = volumeLibrary();
    if (!library) return Failure(library.error());
    try {
        return work(**library);
    } catch (const std::bad_alloc&) {
        return fail("there is not enough memory to make voxels of the mesh");
    } catch (const std::exception& problem) {
        return fail(std::string("OpenVDB cannot make voxels of the mesh: ") + problem.what());
    }
}

}  // namespace

Result<std::unique_ptr<NearestTriangles>> surfaceBand(std::span<const MeshTriangle> triangles) {
    return contained([&](const VolumeLibrary& library) {
        return library.nearestTriangles(cornersOf(triangles));
    });
}

Result<CellMask> floodedInside(std::span<const MeshTriangle> triangles, glm::ivec3 size) {
    return contained([&](const VolumeLibrary& library) {
        CellMask inside(size);
        library.forEachFloodedInside(cornersOf(triangles), size,
                                     [&](glm::ivec3 cell) { inside.set(cell); });
        return inside;
    });
}

}  // namespace voxprite
