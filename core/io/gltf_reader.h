// clang-format off
// glTF 2.0, .glb and .gltf: the triangles of the scene, in its rest pose.
//
// Read       meshes of triangles, strips and fans; node transforms; skins, with their joints as
//            the nodes stand; base colours, base colour textures (PNG and JPEG, embedded or beside
//            the file) with their wrapping and KHR_texture_transform, vertex colours, alpha masks;
//            KHR_mesh_quantization; the diffuse part of KHR_materials_pbrSpecularGlossiness.
// Left out   with a warning: points and lines, morph targets, animations, instances of
//            EXT_mesh_gpu_instancing, skins with joints outside of the scene, textures that cannot
//            be read (the base colour stands for them). Light, metal and the like.
// Refused    what is out of range or not a number, sparse accessors, extensions that the file
//            requires and that change its shape (Draco, meshopt, instancing).
// Triangles under a mirroring transform are turned so that their outside stays outside.
// clang-format on
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/model_folder.h"
#include "core/io/triangle_mesh.h"

namespace voxprite {

struct MeshImport {
    TriangleMesh mesh;
    std::vector<std::string> warnings;
};

// Errors name the field. Memory is bounded by the file's size and the limits of triangle_mesh.h
// and mesh_texture.h.
[[nodiscard]] Result<MeshImport> readGltf(ByteView file, const ModelFolder& folder);

}  // namespace voxprite
