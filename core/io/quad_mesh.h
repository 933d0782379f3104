// The open faces of a model as triangles that share vertices, in an order that GPUs draw well:
// what .glb and .obj are written from.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

// Model space, whose corners are whole numbers (exact as floats up to 2^24).
struct QuadVertex {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    std::uint8_t material = 0;  // 1 ... 255
    std::uint8_t face = 0;      // the normal, as VoxelQuad says
    std::uint16_t unused = 0;   // vertices are compared byte by byte
    bool operator==(const QuadVertex&) const = default;
};
static_assert(sizeof(QuadVertex) == 16);

struct QuadMesh {
    std::vector<QuadVertex> vertices;    // no two alike
    std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise seen from outside
};

[[nodiscard]] glm::ivec3 normalOf(std::uint8_t face);

// Two triangles for each of openQuads. Order, of triangles for the vertex cache and against
// overdraw, of vertices for fetching, by meshoptimizer; the same voxels give the same mesh.
[[nodiscard]] Result<QuadMesh> quadMeshOf(const VoxelGrid& voxels);

}  // namespace voxprite
