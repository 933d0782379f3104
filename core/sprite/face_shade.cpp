#include "core/sprite/face_shade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace voxprite {

namespace {

constexpr int kHalfVoxelBits = 1;  // the lattice of half voxels

using Cells = std::vector<glm::ivec3>;

// The cells that a ray from (1/2, 1/2, 0) enters, after the first, until it has left the reach.
// Faces that it meets at the same time are crossed together. Times count in 1 / (2 x y z).
Cells cellsAlong(glm::ivec3 direction) {
    const glm::ivec3 speed = glm::abs(direction);
    const glm::ivec3 perHalf{speed.y * speed.z, speed.x * speed.z, speed.x * speed.y};
    const int product = 2 * speed.x * speed.y * speed.z;
    const auto squaredSpeed =
        std::int64_t{speed.x} * speed.x + speed.y * speed.y + std::int64_t{speed.z} * speed.z;
    glm::ivec3 next{perHalf.x, perHalf.y, 2 * perHalf.z};
    glm::ivec3 cell(0);
    Cells cells;
    for (;;) {
        const std::int64_t time = std::min({next.x, next.y, next.z});
        const std::int64_t end = std::int64_t{kOcclusionReach} * product;
        if (time * time * squaredSpeed >= end * end) return cells;
        for (int axis = 0; axis < 3; ++axis) {
            if (next[axis] != time) continue;
            cell[axis] += direction[axis] < 0 ? -1 : 1;
            next[axis] += 2 * perHalf[axis];
        }
        cells.push_back(cell);
    }
}

std::vector<Cells> allRays() {
    constexpr std::array kDirections{glm::ivec3{2, 2, 11}, glm::ivec3{4, 4, 5},
                                     glm::ivec3{11, 3, 10}, glm::ivec3{3, 11, 10}};
    std::vector<Cells> rays;
    for (const glm::ivec3 direction : kDirections) {
        for (const int x : {1, -1}) {
            for (const int y : {1, -1}) rays.push_back(cellsAlong(direction * glm::ivec3{x, y, 1}));
        }
    }
    return rays;
}

// The steps of rays that have gone the same way through `depth` cells.
void addSteps(const std::vector<Cells>& rays, std::size_t depth,
              std::vector<OcclusionStep>& steps) {
    std::vector<bool> done(rays.size());
    for (std::size_t first = 0; first < rays.size(); ++first) {
        if (done[first] || rays[first].size() <= depth) continue;
        const glm::ivec3 cell = rays[first][depth];
        std::vector<Cells> together;
        for (std::size_t k = first; k < rays.size(); ++k) {
            if (rays[k].size() <= depth || rays[k][depth] != cell) continue;
            done[k] = true;
            together.push_back(rays[k]);
        }
        const std::size_t at = steps.size();
        steps.push_back({cell, static_cast<int>(together.size()), 0});
        addSteps(together, depth + 1, steps);
        steps[at].next = static_cast<int>(steps.size());
    }
}

glm::ivec3 unit(int axis) {
    glm::ivec3 direction(0);
    direction[axis] = 1;
    return direction;
}

}  // namespace

int occlusionLevel(int blockedRays) {
    return std::max(0, blockedRays - 1) / 4;
}

glm::ivec3 shadowDirection(glm::dvec3 towardLight) {
    const double largest =
        std::max({std::abs(towardLight.x), std::abs(towardLight.y), std::abs(towardLight.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) return glm::ivec3(0);
    return glm::ivec3(glm::round(towardLight / largest * double{kShadowDirection}));
}

std::span<const OcclusionStep> occlusionSteps() {
    static const std::vector<OcclusionStep> kSteps = [] {
        std::vector<OcclusionStep> steps;
        addSteps(allRays(), 0, steps);
        return steps;
    }();
    return kSteps;
}

FaceShader::FaceShader(const OctreeView& octree, const FaceRays& rays)
    : octree_(octree), rays_(rays), towardLight_(octree, rays.towardLight, kHalfVoxelBits) {}

FaceShade FaceShader::shadeOf(const VoxelFace& face) const {
    return {rays_.occlusion ? occlusionLevel(blockedRays(face)) : 0,
            rays_.shadows() && inShadow(face)};
}

int FaceShader::blockedRays(const VoxelFace& face) const {
    const std::span<const OcclusionStep> steps = occlusionSteps();
    const int u = (face.axis + 1) % 3;
    const int v = (face.axis + 2) % 3;
    int blocked = 0;
    for (std::size_t k = 0; k < steps.size();) {
        const OcclusionStep& step = steps[k];
        glm::ivec3 cell = face.voxel;
        cell[u] += step.offset.x;
        cell[v] += step.offset.y;
        cell[face.axis] += face.side * (1 + step.offset.z);
        if (materialAt(octree_, cell) == 0) {
            ++k;
            continue;
        }
        blocked += step.rays;
        k = static_cast<std::size_t>(step.next);
    }
    return blocked;
}

bool FaceShader::inShadow(const VoxelFace& face) const {
    if (rays_.towardLight[face.axis] * face.side <= 0) return false;
    const glm::ivec3 cell = face.voxel + octree_.treeFromVoxel;
    const glm::ivec3 middle = 2 * cell + 1 + face.side * unit(face.axis);
    const Line line(towardLight_, glm::i64vec3(middle));
    // The line crosses the face where it starts: at time 0, whose key is the axis alone.
    return walk(towardLight_, line, face.axis).material != 0;
}

}  // namespace voxprite
