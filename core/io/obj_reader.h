// clang-format off
// Wavefront .obj with its .mtl, through tinyobjloader (which stays in the .cpp).
//
// Read       v (with colours), vt, f (polygons of at most 255 corners are cut into triangles),
//            usemtl, mtllib (one file, or several, names with blanks); of materials Kd, and map_Kd
//            (PNG or JPEG), which takes the place of Kd; "-clamp on". Colours are sRGB. A material
//            with neither is white, and so are vertices without colours beside others.
// Left out   all other statements, transparency among them. With a warning: materials and textures
//            that cannot be read, and names of materials that no .mtl has.
// Refused    indices out of range, numbers that are none.
// clang-format on
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_options.h"
#include "core/io/model_folder.h"

namespace voxprite {

[[nodiscard]] Result<MeshImport> readObj(ByteView file, const ModelFolder& folder, MeshUpAxis up);

}  // namespace voxprite
