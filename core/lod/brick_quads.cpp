#include "core/lod/brick_quads.h"

#include <algorithm>

#include "core/lod/greedy_rectangles.h"
#include "core/lod/octree_boxes.h"

namespace voxprite {

BrickMesher::BrickMesher(const BrickLevel& level) : level_(level) {
    const auto edge = static_cast<std::size_t>(level.brickCells);
    cells_.resize(edge * edge * edge);
    open_.resize(edge * edge);
    faces_.resize(edge * edge);
}

std::vector<ClusterVertex> BrickMesher::quads(glm::ivec3 brick) {
    const int edge = level_.brickCells;
    const glm::ivec3 first = brick * edge - level_.firstCell;
    readBox(level_.cells, {first, first + edge}, cells_);
    const bool solid = std::ranges::find(cells_, 0) == cells_.end();
    std::vector<ClusterVertex> out;
    for (int face = 0; face < kFaces; ++face) {
        const int border = face < 3 ? edge - 1 : 0;
        openBorder(face, brick);
        slice(face, border, brick, out);
        if (solid) continue;
        for (int k = 0; k < edge; ++k) {
            if (k != border) slice(face, k, brick, out);
        }
    }
    return out;
}

void BrickMesher::openBorder(int face, glm::ivec3 brick) {
    const int axis = face % 3;
    const int uAxis = (axis + 1) % 3;
    const int vAxis = (axis + 2) % 3;
    const int log2Cell = level_.level;
    const int edge = level_.brickCells;
    // The layer of voxels right behind the brick.
    const glm::ivec3 corner = (brick * edge) << log2Cell;
    IBox layer{corner, corner + (edge << log2Cell)};
    if (face < 3) {
        layer.min[axis] = layer.max[axis]++;
    } else {
        layer.max[axis] = layer.min[axis]--;
    }
    const bool outside = layer.min[axis] < 0 || layer.min[axis] >= 1 << level_.finest.maxDepth;
    std::ranges::fill(open_, outside ? std::uint8_t{1} : std::uint8_t{0});
    if (outside) return;
    forEachEmptyPart(level_.finest, layer, [&](const IBox& part) {
        const glm::ivec3 low = (part.min - corner) >> log2Cell;
        const glm::ivec3 high = (part.max - 1 - corner) >> log2Cell;
        for (int v = low[vAxis]; v <= high[vAxis]; ++v) {
            for (int u = low[uAxis]; u <= high[uAxis]; ++u)
                open_[static_cast<std::size_t>(v * edge + u)] = 1;
        }
    });
}

void BrickMesher::slice(int face, int k, glm::ivec3 brick, std::vector<ClusterVertex>& out) {
    const int axis = face % 3;
    const int uAxis = (axis + 1) % 3;
    const int vAxis = (axis + 2) % 3;
    const int edge = level_.brickCells;
    const glm::ivec3 stride(1, edge, edge * edge);
    const bool border = k == (face < 3 ? edge - 1 : 0);
    const std::uint8_t* own = cells_.data() + k * stride[axis];
    const std::uint8_t* beside = own + (face < 3 ? 1 : -1) * (border ? 0 : stride[axis]);
    bool any = false;
    for (int v = 0; v < edge; ++v) {
        for (int u = 0; u < edge; ++u) {
            const int at = u * stride[uAxis] + v * stride[vAxis];
            const auto slot = static_cast<std::size_t>(v * edge + u);
            const bool seen = border ? open_[slot] != 0 : beside[at] == 0;
            faces_[slot] = seen ? own[at] : std::uint8_t{0};
            any = any || faces_[slot] != 0;
        }
    }
    if (!any) return;
    takeRectangles(faces_, edge, edge,
                   [&](int u, int v, int width, int height, std::uint8_t material) {
                       glm::ivec3 min(face < 3 ? k + 1 : k);
                       min[uAxis] = u;
                       min[vAxis] = v;
                       glm::ivec3 max = min;
                       max[uAxis] += width;
                       max[vAxis] += height;
                       emit(face, min, max, material, brick, out);
                   });
}

void BrickMesher::emit(int face, glm::ivec3 min, glm::ivec3 max, std::uint8_t material,
                       glm::ivec3 brick, std::vector<ClusterVertex>& out) const {
    const int uAxis = (face + 1) % 3;
    const int vAxis = (face + 2) % 3;
    const glm::ivec3 corner = brick * level_.brickCells;
    for (const auto& [uFar, vFar] :
         {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
        glm::ivec3 at = min;
        if (uFar) at[uAxis] = max[uAxis];
        if (vFar) at[vAxis] = max[vAxis];
        at = (corner + at) * (1 << level_.level);
        out.push_back({static_cast<std::uint16_t>(at.x), static_cast<std::uint16_t>(at.y),
                       static_cast<std::uint16_t>(at.z), material,
                       static_cast<std::uint8_t>(face)});
    }
}

}  // namespace voxprite
