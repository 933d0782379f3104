// Small meshes with known answers, and .glb files made by hand.
#pragma once

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_voxels.h"
#include "core/io/triangle_mesh.h"
#include "tests/support/must.h"

namespace voxprite::test {

inline MeshTriangle triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                             glm::vec4 colour = glm::vec4(1.0f)) {
    MeshTriangle made;
    for (std::size_t k = 0; k < 3; ++k) {
        made.corners[k].position = k == 0 ? a : k == 1 ? b : c;
        made.corners[k].colour = colour;
    }
    return made;
}

inline TriangleMesh emptyMesh() {
    TriangleMesh mesh;
    mesh.materials.emplace_back();
    return mesh;
}

// A box from `low` to `high`, outside out (or inside out); without the faces of `leftOut` (bit 0 is
// -x, 1 +x, 2 -y, ...).
inline void addBox(TriangleMesh& mesh, const glm::dvec3& low, const glm::dvec3& high,
                   glm::vec4 colour = glm::vec4(1.0f), bool insideOut = false, int leftOut = 0) {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const bool far : {false, true}) {
            if ((leftOut >> (2 * axis + far) & 1) != 0) continue;
            glm::dvec3 corner[4] = {low, low, low, low};
            for (glm::dvec3& at : corner) at[axis] = far ? high[axis] : low[axis];
            corner[1][u] = corner[2][u] = high[u];
            corner[2][v] = corner[3][v] = high[v];
            const bool turned = far == insideOut;
            const glm::dvec3 b = corner[turned ? 3 : 1], d = corner[turned ? 1 : 3];
            mesh.triangles.push_back(triangle(corner[0], b, corner[2], colour));
            mesh.triangles.push_back(triangle(corner[0], corner[2], d, colour));
        }
    }
}

// Of radius 1 about the origin.
inline TriangleMesh sphere(int rings, int sectors) {
    TriangleMesh mesh = emptyMesh();
    const auto at = [&](int ring, int sector) {
        const double polar = std::numbers::pi * ring / rings;
        const double around = 2.0 * std::numbers::pi * (sector % sectors) / sectors;
        const double across = ring == 0 || ring == rings ? 0.0 : std::sin(polar);
        return glm::dvec3(across * std::cos(around), across * std::sin(around),
                          ring == 0       ? 1.0
                          : ring == rings ? -1.0
                                          : std::cos(polar));
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            const glm::dvec3 a = at(ring, sector), b = at(ring + 1, sector),
                             c = at(ring + 1, sector + 1), d = at(ring, sector + 1);
            if (ring + 1 < rings) mesh.triangles.push_back(triangle(a, b, c));
            if (ring > 0) mesh.triangles.push_back(triangle(a, c, d));
        }
    }
    return mesh;
}

inline MeshReadOptions options(int resolution, bool solid = true, int threads = 0) {
    MeshReadOptions made;
    made.resolution = resolution;
    made.solid = solid;
    made.threads = threads;
    return made;
}

inline const VoxelGrid& voxelsIn(const LoadedDocument& loaded) {
    return loaded.document.models[0].voxels;
}

inline Rgba8 colourIn(const LoadedDocument& loaded, glm::ivec3 voxel) {
    return loaded.document.palette.colours[voxelsIn(loaded).get(voxel)];
}

// Floats and other bytes one after the other: the binary chunk.
class Chunk {
  public:
    std::size_t floats(std::initializer_list<float> numbers) {
        const std::size_t at = bytes_.size();
        for (const float number : numbers) bytes_.u32(std::bit_cast<std::uint32_t>(number));
        return at;
    }
    std::size_t shorts(std::initializer_list<std::uint16_t> numbers) {
        const std::size_t at = bytes_.size();
        for (const std::uint16_t number : numbers) bytes_.u16(number);
        bytes_.alignTo(4);
        return at;
    }
    std::size_t raw(ByteView bytes) {
        const std::size_t at = bytes_.size();
        bytes_.raw(bytes);
        bytes_.alignTo(4);
        return at;
    }
    [[nodiscard]] const Bytes& bytes() const { return bytes_.bytes(); }

  private:
    ByteWriter bytes_;
};

inline Bytes glb(std::string json, const Bytes& binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    ByteWriter file;
    file.raw("glTF");
    file.u32(2);
    file.u32(static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    file.u32(static_cast<std::uint32_t>(json.size()));
    file.raw("JSON");
    file.raw(json);
    file.u32(static_cast<std::uint32_t>(binary.size()));
    file.raw(std::string_view("BIN\0", 4));
    file.raw(ByteView(binary));
    return file.release();
}

// A triangle (0,0,0), (4,0,0), (0,2,0) as mesh 0, in glTF's own axes; `nodes` is a JSON list and
// `more` further members of the file, beginning with a comma.
inline Bytes triangleGlb(const std::string& nodes, const std::string& more = "",
                         const std::string& primitive = "") {
    Chunk chunk;
    chunk.floats({0, 0, 0, 4, 0, 0, 0, 2, 0});
    chunk.shorts({0, 1, 2});
    return glb(R"({"asset":{"version":"2.0"},"nodes":)" + nodes +
                   R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" +
                   primitive +
                   R"(}]}],"accessors":[)"
                   R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
                   R"("bufferViews":[{"buffer":0,"byteLength":36},)"
                   R"({"buffer":0,"byteOffset":36,"byteLength":6}],)"
                   R"("buffers":[{"byteLength":44}])" +
                   more + "}",
               chunk.bytes());
}

}  // namespace voxprite::test
