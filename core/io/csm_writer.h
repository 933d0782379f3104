// CSM text (the format: core/io/csm_reader.h) of an octree and of a document.
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/svo/octree.h"

namespace voxprite {

// The canonical text: one epoch; a statement ">path [eight values]" for every cube whose children
// are all solid or empty, ">path value" for a solid beside finer ones; paths ascending, each a
// line. Where nothing is as deep as the tree, a last statement names voxel (0,0,0), so that the
// cube keeps its resolution. The text of a canonical octree whose size is that of its root cube
// reads back equal. Voxels lie as in the tree; origin and size are not told.
[[nodiscard]] std::string csmText(const OctreeView& octree);

// The first frame, as it is seen. The cube starts at the origin of entity space, on an axis with
// voxels below 0 at the lowest of them; it is the smallest of 2^n an edge that holds them all, or
// the canvas, where the document is one model whose canvas is such a cube (as it is in documents
// from CSM): those read back equal, but for what csmLosses tells. Fails beyond 65,536 voxels an
// edge.
[[nodiscard]] Result<Bytes> writeCsm(const Document& document);

// What is lost besides what core/io/holds.h tells: where voxels below 0 go.
[[nodiscard]] std::vector<std::string> csmLosses(const Document& document);

}  // namespace voxprite
