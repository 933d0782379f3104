#include "core/svo/live_octree.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/svo/bake.h"
#include "core/svo/tree_builder.h"

namespace voxprite {
namespace {

// What one edit can add to the node array at most: a block of eight on every level.
constexpr std::size_t kMaxNodesAnEdit = 8 * (kMaxOctreeDepth + 1);

const IBox kReachable{glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)};

Failure failTooManyNodes(std::uint32_t limit) {
    return fail("the model needs more octree nodes than the limit of " + std::to_string(limit));
}

// Grows `bounds` by what is solid under a node.
void addBounds(const OctreeView& tree, std::uint32_t word, glm::ivec3 min, int edge, IBox& bounds) {
    const IBox cube{min, min + edge};
    if (node::isEmpty(word) || bounds.united(cube) == bounds) return;
    if (node::isUniform(word)) {
        bounds = bounds.united(cube);
        return;
    }
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::ivec3 childMin = min + octantCorner(octant) * (edge / 2);
        if (node::isBrick(word)) {
            if (payloadMaterial(tree.payloads[node::payloadIndex(word)], octant) != 0) {
                bounds = bounds.united({childMin, childMin + 1});
            }
        } else if (node::hasChild(word, octant)) {
            addBounds(tree, tree.nodes[node::childIndex(word, octant)], childMin, edge / 2, bounds);
        }
    }
}

}  // namespace

OctreeView LiveOctree::wholeTree() const {
    return {pool_.nodes(), pool_.payloads(), maxDepth_, glm::ivec3(1 << maxDepth_), glm::ivec3(0)};
}

IBox LiveOctree::rootBox() const {
    return {origin_, origin_ + (1 << maxDepth_)};
}

Status LiveOctree::adopt(Result<Octree> octree) {
    if (!octree) return tl::unexpected(octree.error());
    if (octree->nodes.size() > maxNodes_) return failTooManyNodes(maxNodes_);
    pool_.replace(std::move(octree->nodes), std::move(octree->payloads));
    maxDepth_ = octree->maxDepth;
    origin_ = octree->origin;
    return {};
}

void LiveOctree::clear() {
    pool_.replace({0}, {});
    maxDepth_ = 1;
    origin_ = glm::ivec3(0);
}

Status LiveOctree::rebuild(const VoxelGrid& voxels) {
    if (auto ok = adopt(bake(voxels)); !ok) return ok;
    solidCount_ = voxels.solidCount();
    return {};
}

std::uint8_t LiveOctree::at(glm::ivec3 entityVoxel) const {
    if (!rootBox().contains(entityVoxel)) return 0;
    return materialAtTree(wholeTree(), entityVoxel - origin_);
}

IBox LiveOctree::solidBounds() const {
    IBox bounds;
    addBounds(wholeTree(), pool_.node(0), origin_, 1 << maxDepth_, bounds);
    return bounds;
}

OctreeView LiveOctree::view(const IBox& bounds) const {
    OctreeView view = wholeTree();
    view.size = bounds.empty() ? glm::ivec3(0) : bounds.size();
    // An empty tree stands nowhere: it may be far from the bounds of other frames.
    if (!node::isEmpty(pool_.node(0))) view.treeFromVoxel = bounds.min - origin_;
    return view;
}

Result<Octree> LiveOctree::canonical(const IBox& bounds) const {
    if (bounds.empty()) return Octree{};
    return relayout(wholeTree(), bounds.min - origin_, bounds.size(), bounds.min);
}

Status LiveOctree::apply(std::span<const Edit> edits) {
    IBox filled;
    for (const Edit& edit : edits) {
        if (edit.material == 0) continue;
        if (!kReachable.contains(edit.voxel)) return fail("a voxel lies beyond 2^24 on an axis");
        filled = filled.united(IBox::around(edit.voxel, edit.voxel));
    }
    if (auto ok = reach(filled); !ok) return ok;

    // Close to the limit a batch may fail half way: keep the way back.
    std::optional<LiveOctree> before;
    if (pool_.nodes().size() + kMaxNodesAnEdit * edits.size() > maxNodes_) before = *this;
    for (const Edit& edit : edits) {
        if (!rootBox().contains(edit.voxel)) continue;
        if (auto ok = makeRoom(kMaxNodesAnEdit); !ok) {
            *this = std::move(*before);
            dropNeedlessLevels();
            return ok;
        }
        set(edit.voxel - origin_, edit.material);
    }
    dropNeedlessLevels();
    return {};
}

Status LiveOctree::makeRoom(std::size_t nodes) {
    if (pool_.nodes().size() + nodes <= maxNodes_) return {};
    const glm::ivec3 size(1 << maxDepth_);
    if (auto ok = adopt(relayout(wholeTree(), glm::ivec3(0), size, origin_)); !ok) return ok;
    if (pool_.nodes().size() + nodes <= maxNodes_) return {};
    return failTooManyNodes(maxNodes_);
}

Status LiveOctree::reach(const IBox& box) {
    if (box.empty()) return {};
    if (node::isEmpty(pool_.node(0))) origin_ = box.min;

    // Toward the negative side first: the positive side comes with every level.
    int levels = 0;
    IBox root = rootBox();
    std::array<glm::ivec3, kMaxOctreeDepth> corners;
    while (root.united(box) != root) {
        if (maxDepth_ + levels == kMaxOctreeDepth) {
            const IBox all = solidBounds().united(box);
            return adopt(relayout(wholeTree(), all.min - origin_, all.size(), all.min));
        }
        const int edge = root.size().x;
        const glm::ivec3 below(box.min.x < root.min.x, box.min.y < root.min.y,
                               box.min.z < root.min.z);
        root.min -= below * edge;
        root.max = root.min + 2 * edge;
        corners[static_cast<std::size_t>(levels++)] = below;
    }
    if (auto ok = makeRoom(static_cast<std::size_t>(levels)); !ok) return ok;
    for (int i = 0; i < levels; ++i) addLevel(corners[static_cast<std::size_t>(i)]);
    return {};
}

void LiveOctree::addLevel(glm::ivec3 oldRootCorner) {
    origin_ -= oldRootCorner * (1 << maxDepth_);
    ++maxDepth_;
    const std::uint32_t root = pool_.node(0);
    if (node::isEmpty(root)) return;
    const std::uint32_t block = pool_.addNodes({&root, 1});
    pool_.setNode(0, node::internal(block, 1u << octantOf(oldRootCorner, 0)));
}

void LiveOctree::dropNeedlessLevels() {
    std::uint32_t root = pool_.node(0);
    while (node::isInternal(root) && std::has_single_bit(node::childMask(root))) {
        const auto octant = static_cast<unsigned>(std::countr_zero(node::childMask(root)));
        const std::uint32_t block = node::childBase(root);
        root = pool_.node(block);
        pool_.setNode(0, root);
        pool_.freeNodes(block, 1);
        --maxDepth_;
        origin_ += octantCorner(octant) * (1 << maxDepth_);
    }
    const bool untouched = pool_.nodes().size() == 1 && pool_.payloads().empty();
    if (node::isEmpty(root) && !untouched) clear();
}

void LiveOctree::set(glm::ivec3 tree, std::uint8_t material) {
    std::array<std::uint32_t, kMaxOctreeDepth> path{};  // node indices from the root on
    const auto last = static_cast<std::size_t>(maxDepth_) - 1;
    for (std::size_t depth = 0; depth < last; ++depth) {
        const std::uint32_t index = path[depth];
        const unsigned octant = octantOf(tree, maxDepth_ - 1 - static_cast<int>(depth));
        const std::uint32_t word = pool_.node(index);
        if (!node::isInternal(word)) {
            if (word == material) return;
            split(index, octant);
        } else if (!node::hasChild(word, octant)) {
            if (material == 0) return;
            insertChild(index, octant);
        }
        path[depth + 1] = node::childIndex(pool_.node(index), octant);
    }

    const std::uint32_t index = path[last];
    const std::uint32_t word = pool_.node(index);
    const bool wasBrick = node::isBrick(word);
    const std::uint64_t before = wasBrick ? pool_.payload(node::payloadIndex(word))
                                          : uniformPayload(static_cast<std::uint8_t>(word));
    const unsigned octant = octantOf(tree, 0);
    const std::uint8_t old = payloadMaterial(before, octant);
    if (old == material) return;
    solidCount_ += (material != 0 ? 1u : 0u);
    solidCount_ -= (old != 0 ? 1u : 0u);

    const std::uint64_t after =
        before ^ (std::uint64_t{static_cast<std::uint8_t>(old ^ material)} << (8 * octant));
    if (after == uniformPayload(material)) {
        if (wasBrick) pool_.freePayload(node::payloadIndex(word));
        pool_.setNode(index, material);
        collapse({path.data(), last + 1}, tree);
    } else if (wasBrick) {
        pool_.setPayload(node::payloadIndex(word), after);
    } else {
        pool_.setNode(index, node::brick(pool_.addPayload(after)));
    }
}

void LiveOctree::split(std::uint32_t index, unsigned octant) {
    const std::uint32_t word = pool_.node(index);
    std::array<std::uint32_t, 8> children;
    children.fill(word);
    const std::uint32_t mask = node::isEmpty(word) ? 1u << octant : 0xFFu;
    const std::uint32_t block = pool_.addNodes({children.data(), node::isEmpty(word) ? 1u : 8u});
    pool_.setNode(index, node::internal(block, mask));
}

void LiveOctree::insertChild(std::uint32_t parent, unsigned octant) {
    const std::uint32_t word = pool_.node(parent);
    const std::uint32_t mask = node::childMask(word) | 1u << octant;
    const auto count = static_cast<unsigned>(std::popcount(mask));
    const std::uint32_t at = node::childIndex(word, octant) - node::childBase(word);
    std::array<std::uint32_t, 8> children{};
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
        children[i < at ? i : i + 1] = pool_.node(node::childBase(word) + i);
    }
    const std::uint32_t block = pool_.addNodes({children.data(), count});
    pool_.freeNodes(node::childBase(word), count - 1);
    pool_.setNode(parent, node::internal(block, mask));
}

void LiveOctree::collapse(std::span<const std::uint32_t> path, glm::ivec3 tree) {
    for (std::size_t depth = path.size() - 1; depth-- > 0;) {
        const std::uint32_t parent = path[depth];
        const std::uint32_t word = pool_.node(parent);
        const std::uint32_t base = node::childBase(word);
        const auto count = static_cast<unsigned>(std::popcount(node::childMask(word)));
        const std::uint32_t child = pool_.node(path[depth + 1]);
        if (node::isEmpty(child)) {
            const unsigned octant = octantOf(tree, maxDepth_ - 1 - static_cast<int>(depth));
            const std::uint32_t mask = node::childMask(word) & ~(1u << octant);
            if (mask != 0) {
                std::array<std::uint32_t, 8> children{};
                unsigned kept = 0;
                for (std::uint32_t i = base; i < base + count; ++i) {
                    if (i != path[depth + 1]) children[kept++] = pool_.node(i);
                }
                const std::uint32_t block = pool_.addNodes({children.data(), kept});
                pool_.freeNodes(base, count);
                pool_.setNode(parent, node::internal(block, mask));
                return;
            }
        } else {
            for (std::uint32_t i = base; i < base + count; ++i) {
                if (pool_.node(i) != child) return;
            }
            if (count != 8) return;
        }
        pool_.setNode(parent, child);
        pool_.freeNodes(base, count);
    }
}

}  // namespace voxprite
