// clang-format off
// What the writers of meshes share: space, colours and losses.
//
// Space   metres, Y up, toward the viewer +Z: voxel (x, y, z) is (x, z, -y) times VoxelSize. The
//         entity's anchor is the origin.
// Shape   of each visible object of the first frame its open faces (core/io/voxel_quads.h),
//         exactly; objects that share a model share its mesh in .glb. Objects that overlap are
//         drawn both.
// Colour  a texture of 256 x 1, the palette, of which each vertex shows the middle of a texel; or
//         vertex colours.
// clang-format on
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/formats.h"
#include "core/model/document.h"

namespace voxprite {

// The middle of a palette colour's texel, along u; v is 0.5.
[[nodiscard]] inline float paletteU(std::uint8_t material) {
    return (static_cast<float>(material) + 0.5f) / 256.0f;
}
// A PNG of the palette: texel i is colour i, all but 0 opaque.
[[nodiscard]] Result<Bytes> paletteTexture(const Palette& palette);

// Where the anchor lies in entity space, in voxels.
[[nodiscard]] glm::dvec3 originOf(const Document& document);

// One file, with everything in it.
[[nodiscard]] Result<Bytes> writeGlb(const SaveRequest& request);
// The .obj, and beside it its .mtl and the palette as .png, named after it.
[[nodiscard]] Result<std::vector<NamedBytes>> writeObj(const SaveRequest& request);
// What it names them, without a folder, the .obj last.
[[nodiscard]] std::vector<std::string> objNames(const std::filesystem::path& name,
                                                const Document& document);
// The other files that the .obj that lies there names, relative to its folder: by `mtllib`, and in
// those materials by `map_Kd`. Only their first 64 KiB are looked at.
[[nodiscard]] std::vector<std::filesystem::path> objRefersTo(const std::filesystem::path& path);

}  // namespace voxprite
