#include "core/edit/selection.h"

#include <algorithm>
#include <utility>

#include "core/edit/cube_bits.h"
#include "core/edit/patch_builder.h"

namespace voxprite {

namespace {

enum class Lies : std::uint8_t { inside, outside, across };

// Of the middles of the voxels in `box`, which are those of its corner voxels and between.
Lies where(std::span<const HalfSpace> sides, const IBox& box) {
    const glm::dvec3 first = glm::dvec3(box.min) + 0.5, last = glm::dvec3(box.max) - 0.5;
    Lies lies = Lies::inside;
    for (const HalfSpace& side : sides) {
        double least = -side.offset, most = -side.offset;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = side.normal[axis] * first[axis], b = side.normal[axis] * last[axis];
            least += std::min(a, b);
            most += std::max(a, b);
        }
        if (most < 0.0) return Lies::outside;
        if (least < 0.0) lies = Lies::across;
    }
    return lies;
}

// `box` is a cube, all solid where it is larger than 8.
void selectInBlock(const VoxelGrid& voxels, std::span<const HalfSpace> sides, const IBox& box,
                   VoxelSet& set) {
    const Lies lies = where(sides, box);
    if (lies == Lies::outside) return;
    const int edge = box.size().x;
    if (edge == 8) {
        if (lies == Lies::inside) {
            insertBits(set, box.min, solidBits(voxels, box.min));
            return;
        }
        const CubeBytes values = cubeBytes(voxels, box.min);
        for (int i = 0; i < 512; ++i) {
            if (values[static_cast<std::size_t>(i)] == 0) continue;
            const glm::ivec3 v = box.min + glm::ivec3(i >> 6, (i >> 3) & 7, i & 7);
            if (where(sides, {v, v + 1}) == Lies::inside) set.insert(v);
        }
        return;
    }
    if (lies == Lies::inside) return set.insert(box);
    const int half = edge / 2;
    for (int octant = 0; octant < 8; ++octant) {
        const glm::ivec3 min =
            box.min + half * glm::ivec3(octant & 1, (octant >> 1) & 1, (octant >> 2) & 1);
        selectInBlock(voxels, sides, {min, min + half}, set);
    }
}

// All of `set`?
bool isSolid(const VoxelGrid& voxels, const VoxelSet& set) {
    bool solid = true;
    set.grid().forEachBlock([&](const VoxelBlock& block) {
        if (!solid) return;
        const VoxelBlock there = voxels.blockAt(block.origin);
        if (there.voxels == nullptr && there.edgeVoxels >= block.edgeVoxels) {
            solid = there.uniformValue != 0;
            return;
        }
        if (block.voxels != nullptr) {
            solid = !anyBit(solidBits(set.grid(), block.origin) & ~solidBits(voxels, block.origin));
            return;
        }
        const IBox box = block.box();
        for (int x = box.min.x; solid && x < box.max.x; x += kCubeEdge) {
            for (int y = box.min.y; solid && y < box.max.y; y += kCubeEdge) {
                for (int z = box.min.z; solid && z < box.max.z; z += kCubeEdge) {
                    solid = allBits(solidBits(voxels, {x, y, z}));
                }
            }
        }
    });
    return solid;
}

}  // namespace

VoxelSet combined(VoxelSet selection, const VoxelSet& with, SelectMode mode) {
    switch (mode) {
        case SelectMode::replace:
            return with;
        case SelectMode::add:
            selection.unite(with);
            break;
        case SelectMode::remove:
            selection.subtract(with);
            break;
        case SelectMode::intersect:
            selection.intersect(with);
            break;
    }
    return selection;
}

VoxelSet selectAll(const VoxelGrid& voxels) {
    return selectBox(voxels, {glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)});
}

VoxelSet selectBox(const VoxelGrid& voxels, const IBox& box) {
    VoxelSet set;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        const IBox inside = block.box().intersected(box);
        if (inside.empty()) return;
        if (block.voxels == nullptr) {
            set.insert(inside);
        } else {
            insertBits(set, block.origin,
                       solidBits(voxels, block.origin) & boxBits(box, block.origin));
        }
    });
    return set;
}

VoxelSet selectInside(const VoxelGrid& voxels, std::span<const HalfSpace> sides) {
    VoxelSet set;
    voxels.forEachBlock(
        [&](const VoxelBlock& block) { selectInBlock(voxels, sides, block.box(), set); });
    return set;
}

VoxelSet inverted(const VoxelGrid& voxels, const VoxelSet& selection) {
    VoxelSet set = selectAll(voxels);
    set.subtract(selection);
    return set;
}

VoxelSet stillSolid(const VoxelGrid& voxels, VoxelSet selection) {
    // Mostly all of it is, which is much sooner seen than a set is made.
    if (isSolid(voxels, selection)) return selection;
    selection.intersect(selectAll(voxels));
    return selection;
}

}  // namespace voxprite
