#include "app/cli/bench/rivals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <memory>

#include "core/base/box.h"

namespace voxprite::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// The largest empty or solid cube of the tree around a cell.
struct Leaf {
    std::uint8_t material = 0;
    int edge = 1;
};
Leaf leafAround(const OctreeView& octree, glm::ivec3 cell) {
    std::uint32_t word = octree.nodes[0];
    for (int bit = octree.maxDepth - 1;; --bit) {
        const auto octant = static_cast<unsigned>(
            ((cell.z >> bit) & 1) << 2 | ((cell.y >> bit) & 1) << 1 | ((cell.x >> bit) & 1));
        if (node::isBrick(word)) {
            return {payloadMaterial(octree.payloads[node::payloadIndex(word)], octant), 1};
        }
        if (!node::isInternal(word)) return {static_cast<std::uint8_t>(word), 2 << bit};
        if (!node::hasChild(word, octant)) return {0, 1 << bit};
        word = octree.nodes[node::childIndex(word, octant)];
    }
}

void forEachSolidUnder(const OctreeView& octree, std::uint32_t word, glm::ivec3 corner, int edge,
                       const std::function<void(glm::ivec3, std::uint8_t)>& body) {
    if (edge == 1) return body(corner - octree.treeFromVoxel, static_cast<std::uint8_t>(word));
    for (unsigned octant = 0; octant < 8; ++octant) {
        std::uint32_t child = word;
        if (node::isInternal(word))
            child = node::hasChild(word, octant) ? octree.nodes[node::childIndex(word, octant)] : 0;
        else if (node::isBrick(word))
            child = payloadMaterial(octree.payloads[node::payloadIndex(word)], octant);
        if (node::isEmpty(child)) continue;
        forEachSolidUnder(octree, child, corner + octantCorner(octant) * (edge / 2), edge / 2,
                          body);
    }
}

}  // namespace

void forEachSolid(const OctreeView& octree,
                  const std::function<void(glm::ivec3, std::uint8_t)>& body) {
    if (!node::isEmpty(octree.nodes[0]))
        forEachSolidUnder(octree, octree.nodes[0], glm::ivec3(0), 1 << octree.maxDepth, body);
}

DenseGrid::DenseGrid(const OctreeView& octree) : size_(octree.size) {
    voxels_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                   static_cast<std::size_t>(size_.z));
    forEachSolid(octree, [&](glm::ivec3 v, std::uint8_t material) {
        if (!IBox{glm::ivec3(0), size_}.contains(v)) return;
        voxels_[static_cast<std::size_t>(v.x) +
                static_cast<std::size_t>(size_.x) *
                    (static_cast<std::size_t>(v.y) +
                     static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(v.z))] = material;
    });
}

std::uint8_t DenseGrid::cast(const Ray& ray) const {
    const Span span = clip(ray, size_);
    if (span.tIn > span.tOut) return 0;
    glm::ivec3 cell = cellAt(ray, span.tIn, size_);
    const std::ptrdiff_t stride[3] = {1, size_.x, static_cast<std::ptrdiff_t>(size_.x) * size_.y};
    std::ptrdiff_t at = cell.x + cell.y * stride[1] + cell.z * stride[2];
    glm::dvec3 tNext(kNever);
    glm::dvec3 tStep(kNever);
    glm::ivec3 step(0);
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        if (d == 0.0) continue;
        step[axis] = d > 0.0 ? 1 : -1;
        tStep[axis] = std::abs(1.0 / d);
        tNext[axis] = (cell[axis] + (d > 0.0 ? 1 : 0) - ray.origin[axis]) / d;
    }
    while (true) {
        if (const std::uint8_t material = voxels_[static_cast<std::size_t>(at)]) return material;
        int axis = tNext.x <= tNext.y ? 0 : 1;
        if (tNext.z < tNext[axis]) axis = 2;
        cell[axis] += step[axis];
        if (cell[axis] < 0 || cell[axis] >= size_[axis]) return 0;
        at += step[axis] * stride[axis];
        tNext[axis] += tStep[axis];
    }
}

std::uint8_t castByRestart(const OctreeView& octree, const Ray& ray) {
    const Span span = clip(ray, octree.size);
    if (span.tIn > span.tOut) return 0;
    glm::ivec3 cell = cellAt(ray, span.tIn, octree.size);
    while (true) {
        const Leaf leaf = leafAround(octree, cell + octree.treeFromVoxel);
        if (leaf.material != 0) return leaf.material;
        // Out of the empty cube through its nearest far face. The cell on that axis is exact, so
        // the walk always moves on.
        const glm::ivec3 low =
            (cell + octree.treeFromVoxel) / leaf.edge * leaf.edge - octree.treeFromVoxel;
        double tExit = kNever;
        int exitAxis = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.direction[axis];
            if (d == 0.0) continue;
            const int face = low[axis] + (d > 0.0 ? leaf.edge : 0);
            const double t = (face - ray.origin[axis]) / d;
            if (t < tExit) {
                tExit = t;
                exitAxis = axis;
            }
        }
        const glm::dvec3 exit = ray.origin + ray.direction * tExit;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == exitAxis) {
                cell[axis] = ray.direction[axis] > 0.0 ? low[axis] + leaf.edge : low[axis] - 1;
            } else {
                cell[axis] = std::clamp(static_cast<int>(std::floor(exit[axis])), low[axis],
                                        low[axis] + leaf.edge - 1);
            }
            if (cell[axis] < 0 || cell[axis] >= octree.size[axis]) return 0;
        }
    }
}

namespace {

// A node before it has a place in the array.
struct Building {
    std::array<std::unique_ptr<Building>, 8> children;  // of cubes larger than a brick
    std::uint64_t payload = 0;                          // of bricks
    bool uniform = false;                               // once collapsed: all of it is `payload`
};

void insert(Building& root, int maxDepth, glm::ivec3 tree, std::uint8_t material) {
    Building* at = &root;
    for (int bit = maxDepth - 1; bit > 0; --bit) {
        std::unique_ptr<Building>& child = at->children[octantOf(tree, bit)];
        if (!child) child = std::make_unique<Building>();
        at = child.get();
    }
    at->payload |= std::uint64_t{material} << (8 * octantOf(tree, 0));
}

void collapse(Building& node, int edge) {
    if (edge == 2) {
        node.uniform = node.payload == std::rotl(node.payload, 8);
        return;
    }
    bool alike = true;
    for (const std::unique_ptr<Building>& child : node.children) {
        if (child) collapse(*child, edge / 2);
        alike = alike && child && child->uniform && child->payload == node.children[0]->payload;
    }
    if (!alike) return;
    node.uniform = true;
    node.payload = node.children[0]->payload;
    for (std::unique_ptr<Building>& child : node.children) child.reset();
}

}  // namespace

Result<Octree> bakeNaively(const VoxelGrid& voxels) {
    const IBox bounds = voxels.bounds();
    Octree octree;
    if (bounds.empty()) return octree;
    octree.size = bounds.size();
    octree.origin = bounds.min;
    octree.maxDepth = depthForSize(octree.size);
    Building root;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t material) {
        insert(root, octree.maxDepth, v - bounds.min, material);
    });
    collapse(root, 1 << octree.maxDepth);
    // Breadth first: the queue holds the nodes in the order of the array.
    std::vector<const Building*> queue{&root};
    octree.nodes.clear();
    for (std::size_t k = 0, levelEnd = 1, edge = std::size_t{1} << octree.maxDepth;
         k < queue.size(); ++k) {
        if (k == levelEnd) {
            levelEnd = queue.size();
            edge /= 2;
        }
        const Building& built = *queue[k];
        if (built.uniform) {
            octree.nodes.push_back(node::uniform(static_cast<std::uint8_t>(built.payload)));
        } else if (edge == 2) {
            const auto index = static_cast<std::uint32_t>(octree.payloads.size());
            octree.nodes.push_back(node::brick(index));
            octree.payloads.push_back(built.payload);
        } else {
            const auto base = static_cast<std::uint32_t>(queue.size());
            std::uint32_t mask = 0;
            for (unsigned octant = 0; octant < 8; ++octant) {
                if (!built.children[octant]) continue;
                mask |= 1u << octant;
                queue.push_back(built.children[octant].get());
            }
            octree.nodes.push_back(node::internal(base, mask));
        }
    }
    if (octree.nodes.size() > kMaxOctreeNodes) return fail("more nodes than an octree can hold");
    return octree;
}

}  // namespace voxprite::bench
