// Qubicle Binary (.qb), versions 1.x: voxel matrices with positions, coloured voxel by voxel.
//
// All numbers are little-endian, u unsigned, i two's complement.
//
//   byte  type    header (24 bytes)
//      0  u8[4]   version: major, minor, release, build; 1 1 0 0 is written
//      4  u32     colour format: 0 R G B A, 1 B G R A
//      8  u32     z axis: 0 left-handed, 1 right-handed
//     12  u32     compression: 0 none, 1 runs
//     16  u32     visibility mask: 0 A is 0 or 255, 1 A tells which faces are seen
//     20  u32     number of matrices
//
//   each matrix: u8 length and that many bytes of name, u32[3] size, i32[3] position, then the
//   colours, x fastest, then y, then z: all of them, or slice by slice (z) in runs: the number 2 is
//   followed by a count and a colour, 6 ends the slice (what it has not reached is empty), any
//   other number is one colour.
//
// Space       Qubicle has y up. Left-handed, its z runs away from the viewer: its (x, y, z) is
//             (x, z, y) here. Right-handed, z comes toward the viewer: cell z is cell -z - 1 here,
//             positions and all.
// Objects     A matrix is an object at the root with a model of its own, whose canvas is the
//             matrix and begins at -floor(size / 2), or at its position where the object would
//             reach beyond the range of voxels else. Later ones win where they overlap.
// Flaws       A matrix without size is an empty object over the origin; fewer matrices than
//             announced are taken where the file ends between two (Goxel counts empty layers, but
//             writes none): both with a warning.
// Voxels      A voxel is solid where A is not 0, with or without mask. (Some writers leave the
//             inside of solid parts out together with a mask; it cannot be told from empty space.)
// Colours     R, G and B; reduced to the palette's 255 where there are more
//             (core/io/colour_reduction.h).
// Names       UTF-8, else Latin-1.
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

struct QbImport {
    Document document;
    std::vector<std::string> warnings;
};

// All or nothing. Fails with the byte offset on anything that is not a .qb or is cut short, on
// matrices outside the range of voxels, and on files that would take too much memory: blocks of the
// grids (8 x 8 x 8 voxels) may take 1 GiB and 32 times the file's length.
[[nodiscard]] Result<QbImport> readQb(ByteView bytes);

// Version 1.1, RGBA, left-handed, in runs: a matrix for each object that is seen in the first
// frame, turned as it stands, as small as its voxels. An object without voxels is a matrix of one
// empty cell. Fails on an invalid document and on objects too large for it.
[[nodiscard]] Result<Bytes> writeQb(const Document& document);
// What is lost besides what core/io/holds.h tells: long names are cut.
[[nodiscard]] std::vector<std::string> qbLosses(const Document& document);

}  // namespace voxprite
