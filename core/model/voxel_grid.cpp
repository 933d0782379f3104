#include "core/model/voxel_grid.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <glm/vector_relational.hpp>
#include <vector>

#include "core/base/check.h"
#include "core/model/voxel_tree.h"

namespace voxprite {

using namespace grid;

namespace {

using Writer = openvdb::tree::ValueAccessor<Tree, /*IsSafe=*/false>;
using ConstReader = openvdb::tree::ValueAccessor<const Tree, /*IsSafe=*/false>;

constexpr int kLeafEdge = 8;
constexpr int kBranching = 8;
constexpr std::size_t kLeafVoxels = 512;
static_assert(Leaf::DIM == kLeafEdge && Leaf::NUM_VALUES == kLeafVoxels);
static_assert(Upper::DIM == 512 && Lower::DIM == 64);

openvdb::Coord coord(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

glm::ivec3 vector(const openvdb::Coord& c) {
    return {c.x(), c.y(), c.z()};
}

std::uint64_t voxelsInCube(int edge) {
    const auto e = static_cast<std::uint64_t>(edge);
    return e * e * e;
}

// visit(tile as VoxelBlock) for tiles, visitLeaf(leaf) for leaves, in the order of the tree.
template <class VisitTile, class VisitLeaf>
void visitNode(const Leaf& leaf, const VisitTile&, const VisitLeaf& visitLeaf) {
    if (!leaf.isEmpty()) visitLeaf(leaf);
}

template <class Node, class VisitTile, class VisitLeaf>
void visitNode(const Node& node, const VisitTile& visitTile, const VisitLeaf& visitLeaf) {
    const auto occupied = node.getChildMask() | node.getValueMask();
    for (openvdb::Index n = occupied.findFirstOn(); n < Node::NUM_VALUES;
         n = occupied.findNextOn(n + 1)) {
        if (node.getChildMask().isOn(n)) {
            visitNode(*node.getTable()[n].getChild(), visitTile, visitLeaf);
        } else {
            visitTile(VoxelBlock{vector(node.offsetToGlobalCoord(n)),
                                 static_cast<int>(Node::ChildNodeType::DIM),
                                 node.getTable()[n].getValue(), nullptr});
        }
    }
}

template <class VisitTile, class VisitLeaf>
void visitTree(const Tree& tree, const VisitTile& visitTile, const VisitLeaf& visitLeaf) {
    for (auto cell = tree.root().cbeginChildAll(); cell; ++cell) {
        Value value{};
        if (const Upper* child = cell.probeChild(value)) {
            visitNode(*child, visitTile, visitLeaf);
        } else if (value != 0) {
            visitTile(
                VoxelBlock{vector(cell.getCoord()), static_cast<int>(Upper::DIM), value, nullptr});
        }
    }
}

// In the order of VoxelBlock.
const std::uint8_t* voxelsOf(const Leaf& leaf) {
    return reinterpret_cast<const std::uint8_t*>(leaf.buffer().data());
}

VoxelBlock blockFromLeaf(const Leaf& leaf, glm::ivec3 origin) {
    // A mask is nothing but its words.
    static_assert(sizeof(Leaf::NodeMaskType) == kLeafVoxels / 8);
    return {origin, kLeafEdge, 0, voxelsOf(leaf),
            reinterpret_cast<const std::uint64_t*>(&leaf.valueMask())};
}

VoxelBlock blockFromLeaf(const Leaf& leaf) {
    return blockFromLeaf(leaf, vector(leaf.origin()));
}

// Of a node with 8 x 8 x 8 children, word x of a mask: the bits (y << 3 | z) of those in [low,
// high], bounds included.
std::uint64_t layerBits(glm::ivec3 low, glm::ivec3 high) {
    if (low.y > high.y || low.z > high.z) return 0;
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    const std::uint64_t rows = kAll >> (8 * (7 - high.y + low.y)) << (8 * low.y);
    const std::uint64_t row = 0xFFu >> (7 - high.z + low.z) << low.z;
    return rows & row * 0x0101'0101'0101'0101u;
}

// Around the bits of a mask that has some: word x has the bit (y << 3 | z).
IBox boundsOf(const Leaf::NodeMaskType& mask) {
    glm::ivec3 low(kLeafEdge), high(0);
    std::uint64_t across = 0;
    for (int x = 0; x < kLeafEdge; ++x) {
        const auto word = mask.getWord<openvdb::Index64>(static_cast<openvdb::Index>(x));
        if (word == 0) continue;
        across |= word;
        low.x = std::min(low.x, x);
        high.x = x + 1;
    }
    low.y = std::countr_zero(across) / kLeafEdge;
    high.y = kLeafEdge - std::countl_zero(across) / kLeafEdge;
    across |= across >> 32;
    across |= across >> 16;
    const auto along = static_cast<std::uint8_t>(across | across >> 8);
    low.z = std::countr_zero(along);
    high.z = kLeafEdge - std::countl_zero(along);
    return {low, high};
}

// The eight-fold division of a cube, in the order of the tree: visit(origin of each part).
template <class Visit>
void forEachPart(glm::ivec3 origin, int edge, const Visit& visit) {
    const int part = edge / kBranching;
    for (int x = 0; x < edge; x += part) {
        for (int y = 0; y < edge; y += part) {
            for (int z = 0; z < edge; z += part) visit(origin + glm::ivec3(x, y, z));
        }
    }
}

// The voxels of a tile, in the order they would have as leaves.
template <class Visit>
void forEachVoxelOfCube(glm::ivec3 origin, int edge, const Visit& visit) {
    if (edge == 1) {
        visit(origin);
        return;
    }
    forEachPart(origin, edge,
                [&](glm::ivec3 part) { forEachVoxelOfCube(part, edge / kBranching, visit); });
}

// Edge of the cube around a position that is stored as one value. `reader`: a root or accessor.
template <class Reader>
int uniformEdgeAt(const Reader& reader, const openvdb::Coord& position) {
    switch (reader.getValueDepth(position)) {
        case 3:
            return 1;
        case 2:
            return 8;
        case 1:
            return 64;
        default:
            return 512;
    }
}

// Is every voxel of the cube `value`? Goes only as deep as `reader` itself is divided.
bool cubeIsUniform(const ConstReader& reader, glm::ivec3 origin, int edge, std::uint8_t value) {
    const openvdb::Coord position = coord(origin);
    if (uniformEdgeAt(reader, position) >= edge) return reader.getValue(position) == value;
    if (edge == kLeafEdge) {
        const std::uint8_t* voxels = voxelsOf(*reader.probeConstLeaf(position));
        return std::all_of(voxels, voxels + kLeafVoxels,
                           [value](std::uint8_t v) { return v == value; });
    }
    bool uniform = true;
    forEachPart(origin, edge, [&](glm::ivec3 part) {
        uniform = uniform && cubeIsUniform(reader, part, edge / kBranching, value);
    });
    return uniform;
}

bool leafEquals(const ConstReader& reader, const Leaf& leaf) {
    const std::uint8_t* voxels = voxelsOf(leaf);
    if (const Leaf* other = reader.probeConstLeaf(leaf.origin())) {
        return std::memcmp(voxels, voxelsOf(*other), kLeafVoxels) == 0;
    }
    const std::uint8_t value = reader.getValue(leaf.origin());
    return std::all_of(voxels, voxels + kLeafVoxels,
                       [value](std::uint8_t v) { return v == value; });
}

}  // namespace

// Copying a grid costs nothing: it is the first write to one of two copies that gives it voxels of
// its own. So whoever only reads a copy (a preview, the clipboard, a file being written behind the
// window) never makes anybody wait.
struct VoxelGrid::Impl {
    // What copies share until one of them is written to.
    struct Voxels {
        Voxels() = default;
        Voxels(const Voxels& other) : tree(other.tree) {}
        Voxels& operator=(const Voxels&) = delete;

        Tree tree;
        Writer writer{tree};  // remembers the last leaf; cleared whenever nodes may go away
    };
    std::shared_ptr<Voxels> shared = std::make_shared<Voxels>();

    [[nodiscard]] const Tree& tree() const { return shared->tree; }
    // To be written to.
    [[nodiscard]] Voxels& own() {
        if (shared.use_count() > 1) {
            shared = std::make_shared<Voxels>(*shared);
        } else {
            // Whoever let go of the last copy, on another thread perhaps, has done reading it.
            std::atomic_thread_fence(std::memory_order_acquire);
        }
        return *shared;
    }
};

VoxelGrid::VoxelGrid() : impl_(std::make_unique<Impl>()) {}
VoxelGrid::~VoxelGrid() = default;
VoxelGrid::VoxelGrid(const VoxelGrid& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
VoxelGrid::VoxelGrid(VoxelGrid&&) noexcept = default;
VoxelGrid& VoxelGrid::operator=(VoxelGrid&&) noexcept = default;

VoxelGrid& VoxelGrid::operator=(const VoxelGrid& other) {
    if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
    return *this;
}

std::uint8_t VoxelGrid::get(glm::ivec3 v) const {
    return impl_->tree().root().getValue(coord(v));
}

void VoxelGrid::set(glm::ivec3 v, std::uint8_t value) {
    VOXPRITE_CHECK(isInVoxelRange(v));
    Writer& writer = impl_->own().writer;
    if (value == 0) {
        writer.setValueOff(coord(v), Value{});
    } else {
        writer.setValueOn(coord(v), Value{value});
    }
}

void VoxelGrid::fill(const IBox& box, std::uint8_t value) {
    if (box.empty()) return;
    VOXPRITE_CHECK(isInVoxelRange(box.min) && isInVoxelRange(box.max - 1));
    Impl::Voxels& own = impl_->own();
    own.writer.clear();
    const auto fillWith = [&](const IBox& part, bool active) {
        own.tree.root().sparseFill({coord(part.min), coord(part.max - 1)}, Value{value}, active);
    };
    if (value != 0) {
        fillWith(box, true);
        return;
    }
    // Only what is there is cleared: a large box over nothing must not grow the tree.
    std::vector<IBox> parts;
    forEachBlock([&](const VoxelBlock& block) {
        const IBox part = box.intersected({block.origin, block.origin + block.edgeVoxels});
        if (!part.empty()) parts.push_back(part);
    });
    for (const IBox& part : parts) fillWith(part, false);
}

void VoxelGrid::setBlock(glm::ivec3 origin, const std::uint8_t* voxels) {
    VOXPRITE_CHECK(isInVoxelRange(origin) && (origin & (kLeafEdge - 1)) == glm::ivec3(0));
    Leaf::NodeMaskType solid;
    for (openvdb::Index n = 0; n < kLeafVoxels; ++n) solid.set(n, voxels[n] != 0);
    const openvdb::Coord position = coord(origin);
    Writer& writer = impl_->own().writer;
    if (solid.isOff() && writer.probeConstLeaf(position) == nullptr &&
        writer.getValue(position) == 0) {
        return;  // nothing must not grow the tree
    }
    Leaf* leaf = writer.touchLeaf(position);
    std::memcpy(leaf->buffer().data(), voxels, kLeafVoxels);
    leaf->setValueMask(solid);
}

void VoxelGrid::clear() {
    impl_->shared = std::make_shared<Impl::Voxels>();
}

std::uint64_t VoxelGrid::solidCount() const {
    std::uint64_t count = 0;
    visitTree(
        impl_->tree(), [&](const VoxelBlock& tile) { count += voxelsInCube(tile.edgeVoxels); },
        [&](const Leaf& leaf) { count += leaf.onVoxelCount(); });
    return count;
}

std::uint64_t VoxelGrid::cubeCount() const {
    std::uint64_t count = 0;
    visitTree(
        impl_->tree(),
        [&](const VoxelBlock& tile) { count += voxelsInCube(tile.edgeVoxels / kLeafEdge); },
        [&](const Leaf&) { ++count; });
    return count;
}

bool VoxelGrid::empty() const {
    const auto holdsOne = [](const auto& self, const auto& node) -> bool {
        if constexpr (std::is_same_v<std::decay_t<decltype(node)>, Leaf>) {
            return !node.isEmpty();
        } else {
            if (node.cbeginValueOn()) return true;
            for (auto child = node.cbeginChildOn(); child; ++child) {
                if (self(self, *child)) return true;
            }
            return false;
        }
    };
    return !holdsOne(holdsOne, impl_->tree().root());
}

std::size_t VoxelGrid::bytes() const {
    std::vector<openvdb::Index32> nodes(Tree::DEPTH);  // leaves first
    impl_->tree().root().nodeCount(nodes);
    return sizeof(Impl) + nodes[0] * (sizeof(Leaf) + kLeafVoxels) + nodes[1] * sizeof(Lower) +
           nodes[2] * sizeof(Upper);
}

IBox VoxelGrid::bounds() const {
    IBox box;
    IBox leaves;  // whole ones, those that turn out to be empty included
    std::vector<const Lower*> lowers;
    const auto addTiles = [&box](auto tile, int edge) {
        for (; tile; ++tile) {
            const glm::ivec3 origin = vector(tile.getCoord());
            box = box.united({origin, origin + edge});
        }
    };
    const auto& root = impl_->tree().root();
    addTiles(root.cbeginValueOn(), Upper::DIM);
    for (auto upper = root.cbeginChildOn(); upper; ++upper) {
        addTiles(upper->cbeginValueOn(), Lower::DIM);
        for (auto child = upper->cbeginChildOn(); child; ++child) {
            const Lower& lower = *child;
            addTiles(lower.cbeginValueOn(), kLeafEdge);
            if (lower.getChildMask().isOff()) continue;
            lowers.push_back(&lower);
            const IBox part = boundsOf(lower.getChildMask());
            const glm::ivec3 origin = vector(lower.origin());
            leaves = leaves.united({origin + kLeafEdge * part.min, origin + kLeafEdge * part.max});
        }
    }
    // The leaves that are not in `inner`, whose corners are those of leaves.
    const auto addLeavesOutside = [&](const IBox& inner) {
        for (const Lower* lower : lowers) {
            const glm::ivec3 origin = vector(lower->origin());
            const glm::ivec3 low = glm::max((inner.min - origin) >> 3, glm::ivec3(0));
            const glm::ivec3 high = glm::min((inner.max - origin) >> 3, glm::ivec3(kBranching)) - 1;
            const std::uint64_t inside = layerBits(low, high);
            for (int x = 0; x < kBranching; ++x) {
                std::uint64_t rest =
                    lower->getChildMask().getWord<openvdb::Index64>(static_cast<openvdb::Index>(x));
                if (x >= low.x && x <= high.x) rest &= ~inside;
                for (; rest != 0; rest &= rest - 1) {
                    const int child = x << 6 | std::countr_zero(rest);
                    const Leaf& leaf = *lower->getTable()[child].getChild();
                    if (leaf.isEmpty()) continue;
                    const IBox part = boundsOf(leaf.valueMask());
                    const glm::ivec3 corner =
                        origin + kLeafEdge * glm::ivec3(child >> 6, child >> 3 & 7, child & 7);
                    box = box.united({corner + part.min, corner + part.max});
                }
            }
        }
    };
    if (leaves.empty()) return box;
    // On each side the voxels of the outermost leaves decide, if there are any in them.
    const IBox inner{leaves.min + kLeafEdge, leaves.max - kLeafEdge};
    addLeavesOutside(inner);
    const bool decided = !box.empty() && glm::all(glm::lessThanEqual(box.min, inner.min)) &&
                         glm::all(glm::greaterThanEqual(box.max, inner.max));
    if (!decided) addLeavesOutside({});
    return box;
}

VoxelBlock VoxelGrid::blockAt(glm::ivec3 v) const {
    const openvdb::Coord position = coord(v);
    const auto& root = impl_->tree().root();
    if (const Leaf* leaf = root.probeConstLeaf(position)) return blockFromLeaf(*leaf);
    const int edge = uniformEdgeAt(root, position);
    return {v & ~(edge - 1), edge, root.getValue(position), nullptr};
}

void VoxelGrid::forEachBlock(const std::function<void(const VoxelBlock&)>& visit) const {
    visitTree(impl_->tree(), visit, [&](const Leaf& leaf) { visit(blockFromLeaf(leaf)); });
}

void VoxelGrid::forEachRegion(const std::function<void(const VoxelRegion&)>& visit) const {
    for (auto cell = impl_->tree().root().cbeginChildAll(); cell; ++cell) {
        Value value{};
        const Upper* upper = cell.probeChild(value);
        if (upper == nullptr) {
            if (value != 0) visit({vector(cell.getCoord()), Upper::DIM, value, 0, nullptr});
            continue;
        }
        for (auto tile = upper->cbeginValueOn(); tile; ++tile) {
            visit({vector(tile.getCoord()), Lower::DIM, tile.getValue(), 0, nullptr});
        }
        for (auto lower = upper->cbeginChildOn(); lower; ++lower) {
            const auto occupied = lower->getChildMask() | lower->getValueMask();
            visit({vector(lower.getCoord()), Lower::DIM, 0, static_cast<int>(occupied.countOn()),
                   &*lower});
        }
    }
}

void VoxelGrid::forEachBlockIn(const VoxelRegion& region, const IBox& box,
                               const std::function<void(const VoxelBlock&)>& visit) {
    const Lower& node = *static_cast<const Lower*>(region.blocks);
    const IBox part = box.intersected({region.origin, region.origin + region.edgeVoxels});
    if (part.empty()) return;
    const glm::ivec3 low = (part.min - region.origin) / kLeafEdge;
    const glm::ivec3 high = (part.max - 1 - region.origin) / kLeafEdge;
    const std::uint64_t layer = layerBits(low, high);
    for (int x = low.x; x <= high.x; ++x) {
        const auto word = static_cast<openvdb::Index>(x);
        const std::uint64_t leaves = node.getChildMask().getWord<openvdb::Index64>(word) & layer;
        const std::uint64_t tiles = node.getValueMask().getWord<openvdb::Index64>(word) & layer;
        const auto leafAt = [&](int bit) -> const Leaf& {
            return *node.getTable()[x << 6 | bit].getChild();
        };
        // They lie anywhere in memory: asked for all at once they come much sooner.
        for (std::uint64_t rest = leaves; rest != 0; rest &= rest - 1) {
            const auto* leaf = reinterpret_cast<const char*>(&leafAt(std::countr_zero(rest)));
            __builtin_prefetch(leaf);
            __builtin_prefetch(leaf + sizeof(Leaf) - 1);
        }
        for (std::uint64_t rest = leaves | tiles; rest != 0; rest &= rest - 1) {
            const int bit = std::countr_zero(rest);
            const glm::ivec3 origin = region.origin + kLeafEdge * glm::ivec3(x, bit >> 3, bit & 7);
            if ((leaves >> bit & 1u) == 0) {
                visit({origin, kLeafEdge, node.getTable()[x << 6 | bit].getValue(), nullptr});
            } else if (const Leaf& leaf = leafAt(bit); !leaf.isEmpty()) {
                visit(blockFromLeaf(leaf, origin));
            }
        }
    }
}

void VoxelGrid::forEachSolid(
    const std::function<void(glm::ivec3 v, std::uint8_t value)>& visit) const {
    visitTree(
        impl_->tree(),
        [&](const VoxelBlock& tile) {
            forEachVoxelOfCube(tile.origin, tile.edgeVoxels,
                               [&](glm::ivec3 v) { visit(v, tile.uniformValue); });
        },
        [&](const Leaf& leaf) {
            for (auto voxel = leaf.cbeginValueOn(); voxel; ++voxel) {
                visit(vector(voxel.getCoord()), voxel.getValue());
            }
        });
}

bool VoxelGrid::operator==(const VoxelGrid& other) const {
    if (impl_->shared == other.impl_->shared) return true;
    // Equally many solid voxels, and all of these are the same in the other.
    if (solidCount() != other.solidCount()) return false;
    const ConstReader reader(other.impl_->tree());
    bool equal = true;
    visitTree(
        impl_->tree(),
        [&](const VoxelBlock& tile) {
            equal = equal && cubeIsUniform(reader, tile.origin, tile.edgeVoxels, tile.uniformValue);
        },
        [&](const Leaf& leaf) { equal = equal && leafEquals(reader, leaf); });
    return equal;
}

struct VoxelGrid::Reader::Impl {
    ConstReader reader;
};

VoxelGrid::Reader::Reader(const VoxelGrid& grid)
    : impl_(std::make_unique<Impl>(Impl{ConstReader(grid.impl_->tree())})) {}
VoxelGrid::Reader::~Reader() = default;

std::uint8_t VoxelGrid::Reader::get(glm::ivec3 v) const {
    return impl_->reader.getValue(coord(v));
}

}  // namespace voxprite
