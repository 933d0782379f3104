// Triangles with colours, as mesh files hold them (.obj, .glb, .gltf): what is made into voxels.
//
// Space  right-handed, Z up, in the file's unit of length (glTF: metres). Readers have applied node
//        transforms and turned the file's axes. Outside is where the corners run counter-clockwise.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/image.h"

namespace voxprite {

// A reader refuses files with more, instances of a mesh counted each.
inline constexpr std::size_t kMaxMeshTriangles = std::size_t{1} << 22;

struct MeshCorner {
    glm::dvec3 position{0.0};  // finite
    // Of the texture: (0,0) its upper left corner, v downwards. Finite.
    glm::vec2 uv{0.0f};
    glm::vec4 colour{1.0f};  // linear light and alpha, multiplied with the material's
};

struct MeshTriangle {
    std::array<MeshCorner, 3> corners;
    std::uint32_t material = 0;  // index into TriangleMesh::materials
};

enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };

struct MeshMaterial {
    glm::dvec4 colour{1.0};  // linear light and alpha
    int texture = -1;        // index into TriangleMesh::textures; -1 is none
    TextureWrap wrapU = TextureWrap::repeat;
    TextureWrap wrapV = TextureWrap::repeat;
    // Where alpha is less there is nothing: leaves cut out of a square.
    double leastAlpha = 0.0;
};

struct TriangleMesh {
    std::vector<MeshTriangle> triangles;
    std::vector<MeshMaterial> materials;
    std::vector<Image> textures;  // sRGB, each at least a pixel
};

// The colour (sRGB, alpha 255) of the point that is the corners' mean by `weights`, which are at
// least 0 and add up to 1: colours between the corners are mixed in linear light, of the texture
// the nearest texel is taken. None where the material leaves a hole.
[[nodiscard]] std::optional<Rgba8> colourAt(const TriangleMesh& mesh, const MeshTriangle& triangle,
                                            const glm::dvec3& weights);

}  // namespace voxprite
