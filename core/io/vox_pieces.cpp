#include "core/io/vox_pieces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

namespace voxprite {

namespace {

// The smallest size whose pivot, floor(size / 2), can lie at the origin with `box` around it; the
// canvas itself where it is such a box already.
std::optional<glm::ivec3> sizeAroundPivot(const IBox& box) {
    glm::ivec3 size(1);
    for (int axis = 0; axis < 3; ++axis) {
        // floor(size / 2) >= -min and ceil(size / 2) >= max
        size[axis] = std::max({1, -2 * box.min[axis], 2 * box.max[axis] - 1});
        if (size[axis] > kMaxVoxEdge) return std::nullopt;
    }
    return size;
}

void append(Bytes& voxels, glm::ivec3 v, std::uint8_t value) {
    for (int axis = 0; axis < 3; ++axis) voxels.push_back(static_cast<std::uint8_t>(v[axis]));
    voxels.push_back(value);
}

VoxPiece pieceAround(glm::ivec3 pivot, const VoxelGrid& grid, glm::ivec3 size) {
    VoxPiece piece{size, {}};
    piece.voxels.reserve(static_cast<std::size_t>(grid.solidCount()) * 4);
    const glm::ivec3 corner = pivot - size / 2;
    grid.forEachSolid(
        [&](glm::ivec3 v, std::uint8_t value) { append(piece.voxels, v - corner, value); });
    return piece;
}

int tileOf(int coordinate) {
    return coordinate >= 0 ? coordinate / kMaxVoxEdge : (coordinate + 1) / kMaxVoxEdge - 1;
}

void appendTiles(const VoxelGrid& grid, VoxPieces& result, std::vector<PlacedPiece>& placed) {
    std::map<std::array<int, 3>, Bytes> tiles;
    grid.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        const glm::ivec3 tile(tileOf(v.x), tileOf(v.y), tileOf(v.z));
        append(tiles[{tile.x, tile.y, tile.z}], v - tile * kMaxVoxEdge, value);
    });
    for (auto& [tile, voxels] : tiles) {
        const glm::ivec3 origin = glm::ivec3(tile[0], tile[1], tile[2]) * kMaxVoxEdge;
        placed.push_back({origin + kMaxVoxEdge / 2, static_cast<int>(result.pieces.size())});
        result.pieces.push_back({glm::ivec3(kMaxVoxEdge), std::move(voxels)});
    }
}

}  // namespace

Result<VoxPieces> piecesOf(const Document& document) {
    std::uint64_t voxels = 0;
    for (const Model& model : document.models) voxels += model.voxels.solidCount();
    if (voxels > std::numeric_limits<std::int32_t>::max() / 4) {
        return fail("a .vox file cannot hold " + std::to_string(voxels) + " voxels");
    }
    VoxPieces result;
    for (const Model& model : document.models) {
        std::vector<PlacedPiece>& placed = result.ofModel.emplace_back();
        const IBox bounds = model.voxels.bounds();
        std::optional<glm::ivec3> size = sizeAroundPivot(model.canvas.united(bounds));
        if (!size) size = sizeAroundPivot(bounds);  // then the canvas is what is too large
        glm::ivec3 pivot(0);
        const glm::ivec3 edges = bounds.size();
        if (!size && std::max({edges.x, edges.y, edges.z}) <= kMaxVoxEdge) {
            size = edges;
            pivot = bounds.min + edges / 2;
        }
        if (size) {
            placed.push_back({pivot, static_cast<int>(result.pieces.size())});
            result.pieces.push_back(pieceAround(pivot, model.voxels, *size));
        } else {
            appendTiles(model.voxels, result, placed);
        }
    }
    return result;
}

}  // namespace voxprite
