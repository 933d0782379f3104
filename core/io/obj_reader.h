// Wavefront .obj with its .mtl, through tinyobjloader (which stays in the .cpp).
//
// Read       v (with colours), vt, f (polygons of at most 255 corners are cut into triangles), g,
// o,
//            usemtl, mtllib; of materials Kd, d, and map_Kd (PNG or JPEG), which takes the place of
//            Kd; "-clamp on". Colours are sRGB.
// Left out   all other statements. With a warning: materials and textures that cannot be read.
// Refused    indices out of range, numbers that are none.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_options.h"
#include "core/io/model_folder.h"

namespace voxprite {

[[nodiscard]] Result<MeshImport> readObj(ByteView file, const ModelFolder& folder, MeshUpAxis up);

}  // namespace voxprite
