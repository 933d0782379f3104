#include "core/edit/brush.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/check.h"
#include "core/edit/shapes.h"

namespace voxprite {

namespace {

Shape shapeOf(const BrushTip& tip, glm::ivec3 v) {
    switch (tip.shape) {
        case TipShape::cube:
            break;
        case TipShape::sphere:
            return {ShapeKind::ellipsoid, tipBox(tip, v), tip.axis, false};
        case TipShape::disc:
            return {ShapeKind::cylinder, tipBox(tip, v), tip.axis, false};
    }
    return {ShapeKind::box, tipBox(tip, v), tip.axis, false};
}

// What comes after `i` of `steps` steps to a component that lies `whole` away, exact halves nearer.
int partOfWay(std::int64_t whole, std::int64_t i, std::int64_t steps) {
    const std::int64_t length = std::abs(whole) * i;
    const std::int64_t rounded = (2 * length + steps - 1) / (2 * steps);
    return static_cast<int>(whole < 0 ? -rounded : rounded);
}

bool comesFirst(glm::ivec3 a, glm::ivec3 b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

std::size_t indexOfStep(glm::ivec3 step) {
    const int index = (step.x + 1) * 9 + (step.y + 1) * 3 + step.z + 1;
    return static_cast<std::size_t>(index);
}

}  // namespace

IBox tipBox(const BrushTip& tip, glm::ivec3 v) {
    VOXPRITE_CHECK(tip.edge >= 1 && tip.edge <= kMaxTipEdge && tip.axis >= 0 && tip.axis < 3);
    IBox box{v - (tip.edge - 1) / 2, v - (tip.edge - 1) / 2 + tip.edge};
    if (tip.shape == TipShape::disc) {
        box.min[tip.axis] = v[tip.axis];
        box.max[tip.axis] = v[tip.axis] + 1;
    }
    return box;
}

std::vector<glm::ivec3> tipVoxels(const BrushTip& tip, glm::ivec3 v) {
    // The shape is made at the origin, where it is never out of range.
    std::vector<glm::ivec3> voxels;
    shapeVoxels(shapeOf(tip, glm::ivec3(0)))->forEach([&](glm::ivec3 offset) {
        if (isInVoxelRange(v + offset)) voxels.push_back(v + offset);
    });
    return voxels;
}

std::vector<glm::ivec3> voxelLine(glm::ivec3 a, glm::ivec3 b) {
    const glm::ivec3 way = b - a;
    const int steps = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
    std::vector<glm::ivec3> line;
    line.reserve(static_cast<std::size_t>(steps) + 1);
    // Halves fall toward the nearer end, so that both directions give the same voxels; exactly in
    // the middle, where both ends are as near, toward the one that comes first.
    const bool forth = comesFirst(a, b);
    for (int i = 0; i <= steps; ++i) {
        const bool nearA = 2 * i < steps || (2 * i == steps && forth);
        const int count = nearA ? i : steps - i;
        const glm::ivec3 wayFromEnd = nearA ? way : -way;
        glm::ivec3 v = nearA ? a : b;
        for (int axis = 0; steps > 0 && axis < 3; ++axis) {
            v[axis] += partOfWay(wayFromEnd[axis], count, steps);
        }
        line.push_back(v);
    }
    return line;
}

BrushTrail::BrushTrail(const BrushTip& tip) : offsets_(tipVoxels(tip, glm::ivec3(0))) {}

std::vector<glm::ivec3> BrushTrail::startAt(glm::ivec3 v) {
    std::vector<glm::ivec3> fresh;
    cover(v, offsets_, fresh);
    at_ = v;
    return fresh;
}

std::vector<glm::ivec3> BrushTrail::lineTo(glm::ivec3 v) {
    if (!at_) return startAt(v);
    std::vector<glm::ivec3> fresh;
    for (const glm::ivec3 next : voxelLine(*at_, v)) {
        if (next != *at_) cover(next, frontOf(next - *at_), fresh);
        at_ = next;
    }
    return fresh;
}

void BrushTrail::cover(glm::ivec3 at, const std::vector<glm::ivec3>& offsets,
                       std::vector<glm::ivec3>& fresh) {
    for (const glm::ivec3 offset : offsets) {
        const glm::ivec3 v = at + offset;
        if (!isInVoxelRange(v) || covered_.contains(v)) continue;
        covered_.insert(v);
        fresh.push_back(v);
    }
}

const std::vector<glm::ivec3>& BrushTrail::frontOf(glm::ivec3 step) {
    std::vector<glm::ivec3>& front = fronts_[indexOfStep(step)];
    if (front.empty()) {
        const VoxelSet tip{std::span<const glm::ivec3>(offsets_)};
        for (const glm::ivec3 offset : offsets_) {
            if (!tip.contains(offset + step)) front.push_back(offset);
        }
    }
    return front;
}

}  // namespace voxprite
