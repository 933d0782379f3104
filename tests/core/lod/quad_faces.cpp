#include "tests/core/lod/quad_faces.h"

#include <gtest/gtest.h>

#include <set>

namespace voxprite::test {
namespace {

glm::ivec3 positionOf(const ClusterVertex& v) {
    return {v.x, v.y, v.z};
}

void addQuad(const ClusterMesh& mesh, std::uint32_t first, int level, CellFaces& faces) {
    const ClusterVertex& corner = mesh.vertices[first];
    const int axis = corner.face % 3;
    const glm::ivec3 from = positionOf(corner);
    const glm::ivec3 to = positionOf(mesh.vertices[first + 2]);
    glm::ivec3 u = from;
    glm::ivec3 v = from;
    u[(axis + 1) % 3] = to[(axis + 1) % 3];
    v[(axis + 2) % 3] = to[(axis + 2) % 3];
    EXPECT_EQ(positionOf(mesh.vertices[first + 1]), u);
    EXPECT_EQ(positionOf(mesh.vertices[first + 3]), v);
    EXPECT_EQ(from[axis], to[axis]);
    const int edge = 1 << level;
    for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(from[a] % edge, 0);
        EXPECT_EQ(to[a] % edge, 0);
        EXPECT_TRUE(a == axis || from[a] < to[a]);
    }
    // The cell behind a face that looks up an axis lies before the plane.
    glm::ivec3 low = from / edge;
    glm::ivec3 high = to / edge;
    if (corner.face < 3) low[axis] -= 1;
    high[axis] = low[axis] + 1;
    for (int z = low.z; z < high.z; ++z) {
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                EXPECT_TRUE(faces.try_emplace({x, y, z, corner.face}, corner.material).second)
                    << "covered twice: " << x << ' ' << y << ' ' << z;
            }
        }
    }
}

}  // namespace

CellFaces facesOf(const ClusterMesh& mesh, int level) {
    CellFaces faces;
    const ClusterLevel& range = mesh.levels[static_cast<std::size_t>(level)];
    for (std::uint32_t i = range.firstPage; i < range.firstPage + range.pageCount; ++i) {
        const ClusterPage& page = mesh.pages[i];
        for (std::uint32_t index = 0; index < page.indexCount; index += 6)
            addQuad(mesh, mesh.indices[page.firstIndex + index], level, faces);
    }
    return faces;
}

CellFaces requiredFaces(const VoxelMap& voxels, int level, int brickCells) {
    std::set<std::array<int, 3>> cells;
    for (const auto& [at, material] : voxels) {
        const auto& [x, y, z] = at;
        cells.insert({x >> level, y >> level, z >> level});
    }
    CellFaces faces;
    for (const std::array<int, 3>& cell : cells) {
        for (int face = 0; face < 6; ++face) {
            const auto axis = static_cast<std::size_t>(face % 3);
            std::array<int, 3> beside = cell;
            beside[axis] += face < 3 ? 1 : -1;
            bool covered = true;
            const bool sameBrick =
                beside[axis] >= 0 && beside[axis] / brickCells == cell[axis] / brickCells;
            if (sameBrick) {
                covered = cells.contains(beside);
            } else {
                const int edge = 1 << level;
                for (int i = 0; i < edge * edge; ++i) {
                    std::array<int, 3> voxel = {beside[0] * edge, beside[1] * edge,
                                                beside[2] * edge};
                    if (face >= 3) voxel[axis] += edge - 1;
                    voxel[(axis + 1) % 3] += i % edge;
                    voxel[(axis + 2) % 3] += i / edge;
                    covered = covered && voxels.contains({voxel[0], voxel[1], voxel[2]});
                }
            }
            if (!covered) faces[{cell[0], cell[1], cell[2], face}] = 0;
        }
    }
    return faces;
}

}  // namespace voxprite::test
