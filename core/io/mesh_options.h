// What may be chosen where a mesh is read or written.
#pragma once

#include <cstdint>

namespace voxprite {

enum class MeshUpAxis : std::uint8_t { y, z };

struct MeshReadOptions {
    // Voxels along the longest side, 1 ... kMaxMeshResolution.
    int resolution = 64;
    // Above 0: voxels a unit of the file (glTF: a metre), in place of `resolution`.
    double voxelsPerUnit = 0.0;
    // Whether the inside of the surface is filled.
    bool solid = false;
    // Of .obj, which does not say. (glTF is Y up.)
    MeshUpAxis objUp = MeshUpAxis::y;
    int threads = 0;  // as parallelFor
};

struct MeshWriteOptions {
    // Colours as vertex colours in place of a texture of the palette.
    bool vertexColours = false;
};

}  // namespace voxprite
