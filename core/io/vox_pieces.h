// Which models a .vox file gets for the models of a document: the format places a model by its
// pivot, floor(size / 2), and holds at most 256 voxels on an edge.
#pragma once

#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

inline constexpr int kMaxVoxEdge = 256;

// A model of the file. Its voxel v is v - floor(size / 2) + (where the scene graph puts it).
struct VoxPiece {
    glm::ivec3 size{1};
    Bytes voxels;  // as in XYZI: x, y, z, colour
};

// Where in the space of a document's model a piece lies: its pivot is at `pivot`.
struct PlacedPiece {
    glm::ivec3 pivot{0};
    int piece = 0;
};

struct VoxPieces {
    std::vector<VoxPiece> pieces;
    // For each model of the document. One piece wherever the voxels fit, with its pivot at the
    // origin if that is possible, too; else one for each cube of 256 voxels that holds any.
    std::vector<std::vector<PlacedPiece>> ofModel;
};

// Fails when the voxels exceed what the format's 31-bit lengths can count.
[[nodiscard]] Result<VoxPieces> piecesOf(const Document& document);

}  // namespace voxprite
