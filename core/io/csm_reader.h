// clang-format off
// CSM, "cube script model": an octree as text. The format of k0sti/crossworld.
//
//   Model     = Epoch ( '|' Epoch )*
//   Epoch     = Statement*
//   Statement = '>' Path Cube             Path: letters a ... h, none for the root
//   Cube      = Value                     0 ... 255; 0 is empty, the rest are palette indices
//             | '[' Cube x 8 ']'          the children a ... h
//             | '<' Path                  a cube of the epoch before
//             | '/' Axes Cube             mirrored along the axes named (x, y, z)
//             | '^' Axes Cube             with axes exchanged
//
// '#' begins a comment to the end of the line; white space separates and may be left out where
// nothing becomes ambiguous. A byte order mark at the start is passed over. Letters a = 000 ...
// h = 111 are the bits (x, y, z) of an octant, x the high one, at the axes' lower (0) or upper
// half.
//
// Statement   Puts its cube where the path leads, over what the epoch has put there before: later
//             ones refine or replace earlier ones. What no statement of the epoch reaches is empty;
//             nothing is carried over from the epoch before.
// Model       The last epoch that assigned anything. None: an empty model.
// Reference   Only a path that a statement of the epoch before (the last one that assigned
//             anything) named, letter by letter; the cube is what stands there at that epoch's end.
// Mirror      All the way down, as space is mirrored.
// Exchange    Two axes change places all the way down; with three, what lay along the first lies
//             along the second, and so on round. With one axis the two halves along it change
//             places, each as it is: the reading of crossworld's own parser, which does this for
//             every axis named.
// Resolution  The deepest path or bracket of the epoch tells how many voxels an edge the cube has,
//             2^levels; a cube above it is solid all over its octant. At most 16 levels.
//
// Voxel (0,0,0) is the cube's lowest corner and the origin of entity space; a file's axes are taken
// as they stand. Colours are not in the file.
// clang-format on
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/svo/octree.h"

namespace voxprite {

// A text that makes more than this many cubes with children is refused, and a model that unfolds
// into more.
inline constexpr std::uint64_t kMaxCsmCubes = kMaxOctreeNodes;

// The cube as a canonical octree, its size the whole cube's. Errors name line and column (bytes,
// from 1). Time and memory are bounded by the text's length and the limits on octrees.
[[nodiscard]] Result<Octree> octreeFromCsm(ByteView text);

// One object that shows one model, whose canvas is the cube. Refuses, besides, what the voxel grid
// cannot hold in about a gigabyte, and more than 2^40 solid voxels.
[[nodiscard]] Result<Document> readCsm(ByteView text, const Palette& palette = Palette::standard());

}  // namespace voxprite
