#include "core/io/quad_mesh.h"

#include <meshoptimizer.h>

#include <new>
#include <utility>

#include "core/io/voxel_quads.h"

namespace voxprite {
namespace {

// Vertex cache misses that sorting against overdraw may add: what the library's manual proposes.
constexpr float kOverdrawThreshold = 1.05f;

void addQuad(const VoxelQuad& quad, QuadMesh& mesh) {
    const int uAxis = (quad.face + 1) % 3, vAxis = (quad.face + 2) % 3;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [uFar, vFar] :
         {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
        glm::ivec3 at = quad.min;
        if (uFar) at[uAxis] = quad.max[uAxis];
        if (vFar) at[vAxis] = quad.max[vAxis];
        mesh.vertices.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                                 static_cast<float>(at.z), quad.material, quad.face, 0});
    }
    // u, v and the axis are right-handed: this order looks along the positive axis.
    const bool positive = quad.face < 3;
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
        mesh.indices.push_back(first + (positive ? corner : (4 - corner) % 4));
    }
}

void order(QuadMesh& mesh) {
    const std::size_t indices = mesh.indices.size();
    std::vector<unsigned> remap(mesh.vertices.size());
    const std::size_t distinct =
        meshopt_generateVertexRemap(remap.data(), mesh.indices.data(), indices,
                                    mesh.vertices.data(), mesh.vertices.size(), sizeof(QuadVertex));
    QuadMesh shared;
    shared.vertices.resize(distinct);
    shared.indices.resize(indices);
    meshopt_remapIndexBuffer(shared.indices.data(), mesh.indices.data(), indices, remap.data());
    meshopt_remapVertexBuffer(shared.vertices.data(), mesh.vertices.data(), mesh.vertices.size(),
                              sizeof(QuadVertex), remap.data());
    meshopt_optimizeVertexCache(mesh.indices.data(), shared.indices.data(), indices, distinct);
    meshopt_optimizeOverdraw(shared.indices.data(), mesh.indices.data(), indices,
                             &shared.vertices[0].x, distinct, sizeof(QuadVertex),
                             kOverdrawThreshold);
    mesh.vertices.resize(distinct);
    meshopt_optimizeVertexFetch(mesh.vertices.data(), shared.indices.data(), indices,
                                shared.vertices.data(), distinct, sizeof(QuadVertex));
    mesh.indices = std::move(shared.indices);
}

}  // namespace

glm::ivec3 normalOf(std::uint8_t face) {
    glm::ivec3 normal(0);
    normal[face % 3] = face < 3 ? 1 : -1;
    return normal;
}

Result<QuadMesh> quadMeshOf(const VoxelGrid& voxels) {
    try {
        const Result<std::vector<VoxelQuad>> quads = openQuads(voxels);
        if (!quads) return Failure(quads.error());
        QuadMesh mesh;
        mesh.vertices.reserve(4 * quads->size());
        mesh.indices.reserve(6 * quads->size());
        for (const VoxelQuad& quad : *quads) addQuad(quad, mesh);
        if (!mesh.vertices.empty()) order(mesh);
        return mesh;
    } catch (const std::bad_alloc&) {
        return fail("there is not enough memory for the model's mesh");
    }
}

}  // namespace voxprite
