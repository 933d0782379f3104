// From the file's graph, in which nodes may be shared, to a document's tree.

#include <algorithm>
#include <numeric>

#include "core/io/vox_file.h"

namespace voxprite {

namespace {

// What copies of shared nodes may take beyond a small multiple of the file's own length.
constexpr std::uint64_t kSharingAllowance = std::uint64_t{64} << 20;

// What is below a node, the node itself included.
struct Below {
    enum class State : std::uint8_t { unseen, open, done };

    State state = State::unseen;
    int depth = 0;            // levels
    std::uint64_t bytes = 0;  // as a tree
};

std::uint64_t bytesOf(const SceneNode& node) {
    std::uint64_t bytes = sizeof(SceneNode) + node.name.size() +
                          node.placements.size() * sizeof(PlacementKey) +
                          node.models.size() * sizeof(ModelKey);
    for (const auto& [key, value] : node.attributes) bytes += 128 + key.size() + value.size();
    return bytes;
}

// Walks the graph without recursion, each node once, and refuses what is no tree of sane size.
class GraphCheck {
  public:
    GraphCheck(const VoxFile& file, std::uint64_t maxBytes)
        : file_(file), maxBytes_(maxBytes), below_(file.nodes.size()) {}

    Status run(std::size_t root) {
        enter(root);
        while (!open_.empty()) {
            Open& top = open_.back();
            const VoxNode& node = file_.nodes[top.node];
            if (top.nextLink == node.links.size()) {
                if (Status s = leave(top.node); !s) return s;
                open_.pop_back();
                continue;
            }
            const int id = node.links[top.nextLink++];
            const auto found = file_.nodeFromId.find(id);
            if (found == file_.nodeFromId.end()) {
                return failAtByte(node.offset, node.name() + " refers to node " +
                                                   std::to_string(id) + ", which does not exist");
            }
            const Below& child = below_[found->second];
            shared_ = shared_ || child.state != Below::State::unseen;
            if (child.state == Below::State::open) {
                return failAtByte(node.offset, node.name() + " contains itself, by way of node " +
                                                   std::to_string(id));
            }
            if (child.state == Below::State::unseen) enter(found->second);
        }
        return {};
    }

    [[nodiscard]] std::size_t unreached() const {
        return static_cast<std::size_t>(
            std::count_if(below_.begin(), below_.end(),
                          [](const Below& node) { return node.state == Below::State::unseen; }));
    }

    // Is any node used more than once?
    [[nodiscard]] bool shared() const { return shared_; }

  private:
    struct Open {
        std::size_t node;
        std::size_t nextLink;
    };

    void enter(std::size_t index) {
        below_[index].state = Below::State::open;
        open_.push_back({index, 0});
    }

    // Everything below is known now.
    Status leave(std::size_t index) {
        const VoxNode& node = file_.nodes[index];
        Below& below = below_[index];
        below.state = Below::State::done;
        below.bytes = bytesOf(node.part);
        for (const int id : node.links) {
            const Below& child = below_[file_.nodeFromId.at(id)];
            below.depth = std::max(below.depth, child.depth);
            below.bytes = std::min(below.bytes + child.bytes, maxBytes_ + 1);
        }
        below.depth += 1;
        if (below.depth > kMaxVoxDepth) {
            return failAtByte(node.offset, node.name() + " is nested deeper than " +
                                               std::to_string(kMaxVoxDepth) + " levels");
        }
        if (below.bytes > maxBytes_) {
            return failAtByte(node.offset,
                              node.name() +
                                  " uses shared nodes so often that the scene would take"
                                  " more than " +
                                  std::to_string(maxBytes_ >> 20) + " MiB");
        }
        for (const ModelKey& key : node.part.models) {
            if (key.model < 0 || static_cast<std::size_t>(key.model) >= file_.models.size()) {
                return failAtByte(node.offset, node.name() + " shows model " +
                                                   std::to_string(key.model) + "; there are " +
                                                   std::to_string(file_.models.size()));
            }
        }
        return {};
    }

    const VoxFile& file_;
    std::uint64_t maxBytes_;
    std::vector<Below> below_;
    std::vector<Open> open_;
    bool shared_ = false;
};

// A transform and the group or shape that it places are one document node. A transform that places
// another transform is a group of one.
SceneNode mergedNode(const VoxFile& file, const VoxNode& node, std::vector<int>& links) {
    SceneNode merged = node.part;
    links = node.links;
    if (node.kind != VoxNode::Kind::transform) return merged;
    const VoxNode& child = file.nodes[file.nodeFromId.at(node.links[0])];
    if (child.kind == VoxNode::Kind::transform) return merged;
    merged.models = child.part.models;
    merged.loopModels = child.part.loopModels;
    for (const auto& attribute : child.part.attributes) merged.attributes.insert(attribute);
    links = child.links;
    return merged;
}

struct Tree {
    std::vector<SceneNode> nodes;
    std::vector<std::size_t> fileNodes;  // of each node, its index in the file
};

// Parents first, children in drawing order.
Tree treeFromGraph(const VoxFile& file, std::size_t root) {
    struct Open {
        std::size_t fileNode;
        int parent;
    };
    Tree tree;
    std::vector<SceneNode>& nodes = tree.nodes;
    std::vector<Open> open{{root, -1}};
    std::vector<int> links;
    while (!open.empty()) {
        const Open top = open.back();
        open.pop_back();
        SceneNode node = mergedNode(file, file.nodes[top.fileNode], links);
        if (nodes.empty() && !node.isGroup()) {
            nodes.emplace_back();  // the root is always a group
            tree.fileNodes.push_back(top.fileNode);
            node.parent = 0;
        } else {
            node.parent = top.parent;
        }
        const auto index = static_cast<int>(nodes.size());
        if (node.parent >= 0) {
            nodes[static_cast<std::size_t>(node.parent)].children.push_back(index);
        }
        nodes.push_back(std::move(node));
        tree.fileNodes.push_back(top.fileNode);
        for (auto link = links.rbegin(); link != links.rend(); ++link) {
            open.push_back({file.nodeFromId.at(*link), index});
        }
    }
    return tree;
}

// The nodes in the order of the file, the root first: a document that was written comes back in its
// own order.
std::vector<SceneNode> inFileOrder(Tree tree) {
    std::vector<int> order(tree.nodes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin() + 1, order.end(), [&](int a, int b) {
        return tree.fileNodes[static_cast<std::size_t>(a)] <
               tree.fileNodes[static_cast<std::size_t>(b)];
    });
    std::vector<int> placeOf(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        placeOf[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    }
    std::vector<SceneNode> nodes;
    nodes.reserve(order.size());
    for (const int index : order) {
        SceneNode& node =
            nodes.emplace_back(std::move(tree.nodes[static_cast<std::size_t>(index)]));
        if (node.parent >= 0) node.parent = placeOf[static_cast<std::size_t>(node.parent)];
        for (int& child : node.children) child = placeOf[static_cast<std::size_t>(child)];
    }
    return nodes;
}

// Files from before the scene graph: one object with its pivot over the origin and its bottom at
// z = 0, which is where MagicaVoxel puts a model that it opens. Several models (PACK) were how
// those files held an animation: a model a frame.
std::vector<SceneNode> sceneOfModels(const VoxFile& file) {
    SceneNode root;
    if (file.models.empty()) return {root};
    SceneNode object;
    object.parent = 0;
    object.placements.clear();
    for (std::size_t i = 0; i < file.models.size(); ++i) {
        const int frame = static_cast<int>(i);
        Placement placement;
        placement.translation.z = -file.models[i].canvas.min.z;
        object.models.push_back({frame, frame});
        if (object.placements.empty() || !(object.placements.back().placement == placement)) {
            object.placements.push_back({frame, placement});
        }
    }
    root.children = {1};
    return {root, object};
}

}  // namespace

Result<std::vector<SceneNode>> sceneFromVox(VoxFile& file, std::uint64_t fileBytes) {
    if (file.nodes.empty()) return sceneOfModels(file);
    const auto root = file.nodeFromId.find(0);
    if (root == file.nodeFromId.end()) {
        return failAtByte(file.nodes[0].offset, "the scene graph has no node 0, its root");
    }
    GraphCheck check(file, kSharingAllowance + 64 * fileBytes);
    if (Status s = check.run(root->second); !s) return tl::unexpected(s.error());
    if (const std::size_t unreached = check.unreached(); unreached > 0) {
        file.warnings.add(std::to_string(unreached) +
                          " nodes do not hang on the root; they are left out");
    }
    Tree tree = treeFromGraph(file, root->second);
    std::vector<SceneNode> nodes =
        check.shared() ? std::move(tree.nodes) : inFileOrder(std::move(tree));
    for (SceneNode& node : nodes) {
        const bool exists =
            node.layer >= 0 && static_cast<std::size_t>(node.layer) < file.layers.size();
        // Many writers name layer 0 and write no layers at all.
        if (!exists && node.layer >= 0 && !file.layers.empty()) {
            file.warnings.add("a node lies on layer " + std::to_string(node.layer) +
                              ", which does not exist");
        }
        if (!exists) node.layer = -1;
    }
    return nodes;
}

}  // namespace voxprite
