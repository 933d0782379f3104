// OpenVDB files (.vdb): sparse grids of other programs (Houdini, Blender, ...) as voxels, and
// voxels as grids.
//
// Read are files of OpenVDB 3 (2014) and later, file versions 222 to 225. Which grids become
// voxels:
//
// index grids   of whole numbers: an object each, what is active and not 0 is a voxel. Values of 1
//               to 255 are palette indices; others are numbered in their order, if there are at
//               most 255.
// masks         of bool or mask: an object each, what is active (and true) is a voxel of index 1.
// level sets    of floats, class "level set": negative is inside.
// density       any other floats: above the threshold is inside.
// colours       of three floats, 0 ... 1, taken as sRGB: those beside a level set or density colour
//               it ("Cd", "color", ... or the only one); alone, what is active is a voxel.
//
// Where there are index grids or masks those are taken, all of them; else one grid: the one that
// the options name, else "density", else the first level set, else the first of floats, else
// colours. A warning says what was done and which grids were passed over.
//
// Space       A grid's index space is entity space as it stands; transforms are not applied (they
//             are linear ones; grids of a camera's frustum are refused). An object's model has
//             the bounds of its voxels for a canvas, which begins at -floor(size / 2), or near it
//             where there are very many voxels.
// Written     An Int32 grid an object that is seen in the first frame, under its name, turned as it
//             stands, with VoxelSize for a transform; and in the file's metadata "voxprite", the
//             text of a project (core/io/project_json.h) with palette, entity and sockets, so that
//             these read back equal. The file's identity is made of its content: equal documents
//             give equal bytes.
//
// The reader is our own, as that of OpenVDB takes lengths and positions on trust; packed data is
// unpacked by zlib and Blosc.
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

struct VdbReadOptions {
    std::string grid;        // by name; empty: see above
    double threshold = 0.5;  // of density
};

struct VdbImport {
    Document document;
    std::vector<std::string> warnings;
};

// All or nothing, with the byte offset. What is uniform stays so, however large; blocks of the
// grids (8 x 8 x 8 voxels) and the nodes above them may take 1 GiB and 32 times the file's length.
[[nodiscard]] Result<VdbImport> readVdb(ByteView bytes, const VdbReadOptions& options = {});

// Fails on an invalid document. `voxelSizeMetres` becomes the grids' transform.
[[nodiscard]] Result<Bytes> writeVdb(const Document& document, const AuthoredValues& authored);

}  // namespace voxprite
