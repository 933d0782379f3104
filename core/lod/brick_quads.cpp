#include "core/lod/brick_quads.h"

#include <algorithm>

#include "core/lod/octree_boxes.h"

namespace voxprite {

BrickMesher::BrickMesher(const BrickLevel& level) : level_(level) {
    const auto edge = static_cast<std::size_t>(level.brickCells);
    cells_.resize(edge * edge * edge);
    faces_.resize(edge * edge);
}

std::vector<ClusterVertex> BrickMesher::quads(glm::ivec3 brick) {
    const glm::ivec3 first = brick * level_.brickCells - level_.firstCell;
    readBox(level_.cells, {first, first + level_.brickCells}, cells_);
    std::vector<ClusterVertex> out;
    for (int face = 0; face < kFaces; ++face) {
        for (int k = 0; k < level_.brickCells; ++k) slice(face, k, brick, out);
    }
    return out;
}

std::uint8_t BrickMesher::cell(glm::ivec3 c) const {
    const int edge = level_.brickCells;
    return cells_[static_cast<std::size_t>((c.z * edge + c.y) * edge + c.x)];
}

bool BrickMesher::covered(glm::ivec3 c, int face, glm::ivec3 brick) const {
    const int axis = face % 3;
    const int step = face < 3 ? 1 : -1;
    glm::ivec3 beside = c;
    beside[axis] += step;
    if (beside[axis] >= 0 && beside[axis] < level_.brickCells) return cell(beside) != 0;
    // The layer of voxels right behind the face.
    const int edge = 1 << level_.level;
    IBox layer;
    layer.min = (brick * level_.brickCells + beside) * edge;
    if (step < 0) layer.min[axis] += edge - 1;
    layer.max = layer.min + edge;
    layer.max[axis] = layer.min[axis] + 1;
    return solidThroughout(level_.finest, layer);
}

void BrickMesher::slice(int face, int k, glm::ivec3 brick, std::vector<ClusterVertex>& out) {
    const int axis = face % 3;
    const int uAxis = (axis + 1) % 3;
    const int vAxis = (axis + 2) % 3;
    const int edge = level_.brickCells;
    const auto faceAt = [&](int u, int v) -> std::uint8_t& {
        return faces_[static_cast<std::size_t>(v * edge + u)];
    };
    glm::ivec3 c(k);
    for (int v = 0; v < edge; ++v) {
        for (int u = 0; u < edge; ++u) {
            c[uAxis] = u;
            c[vAxis] = v;
            const std::uint8_t material = cell(c);
            faceAt(u, v) = material != 0 && !covered(c, face, brick) ? material : std::uint8_t{0};
        }
    }
    for (int v = 0; v < edge; ++v) {
        for (int u = 0; u < edge; ++u) {
            const std::uint8_t material = faceAt(u, v);
            if (material == 0) continue;
            const auto equal = [&](std::uint8_t m) { return m == material; };
            int uEnd = u + 1;
            while (uEnd < edge && equal(faceAt(uEnd, v))) ++uEnd;
            int vEnd = v + 1;
            while (vEnd < edge &&
                   std::all_of(&faceAt(u, vEnd), &faceAt(u, vEnd) + (uEnd - u), equal))
                ++vEnd;
            for (int row = v; row < vEnd; ++row)
                std::fill_n(&faceAt(u, row), uEnd - u, std::uint8_t{0});
            glm::ivec3 min(k);
            glm::ivec3 max(k);
            min[uAxis] = u;
            min[vAxis] = v;
            max[uAxis] = uEnd;
            max[vAxis] = vEnd;
            if (face < 3) min[axis] = max[axis] = k + 1;
            emit(face, min, max, material, brick, out);
        }
    }
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
