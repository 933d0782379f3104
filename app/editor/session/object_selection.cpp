#include "app/editor/session/object_selection.h"

#include <algorithm>
#include <utility>

namespace voxprite::editor {

void ObjectSelection::follow(const Session& session) {
    const Document& document = session.document();
    const bool otherTree = document.nodes.size() != nodeCount_;
    if (otherTree) {
        // Indices mean others now.
        nodeCount_ = document.nodes.size();
        nodes_.clear();
        renaming_.reset();
    }
    // Another object was taken in hand elsewhere.
    const auto isGroup = [&](int node) {
        return document.nodes[static_cast<std::size_t>(node)].isGroup();
    };
    if (!std::ranges::all_of(nodes_, isGroup) &&
        std::ranges::find(nodes_, session.activeNode()) == nodes_.end()) {
        nodes_.clear();
    }
    // A socket that was put there just now is the one to be named.
    const std::size_t sockets = document.sockets.size();
    if (sockets != socketCount_) {
        renamingSocket_.reset();
        socket_.reset();
        if (!otherTree && sockets == socketCount_ + 1) socket_ = static_cast<int>(sockets) - 1;
        socketCount_ = sockets;
    }
}

std::vector<int> ObjectSelection::nodes(const Session& session) const {
    if (!nodes_.empty()) return nodes_;
    if (session.activeNode() > 0) return {session.activeNode()};
    return {};
}

int ObjectSelection::node(const Session& session) const {
    return nodes_.empty() ? session.activeNode() : nodes_.back();
}

bool ObjectSelection::isChosen(const Session& session, int node) const {
    return std::ranges::find(nodes_, node) != nodes_.end() ||
           (nodes_.empty() && node == session.activeNode());
}

void ObjectSelection::takeActive(Session& session, int node) {
    const auto& nodes = session.document().nodes;
    if (!nodes[static_cast<std::size_t>(node)].isGroup()) session.setActiveNode(node);
    if (std::exchange(nodeCount_, nodes.size()) != nodes.size()) renaming_.reset();
    socket_.reset();
}

void ObjectSelection::choose(Session& session, int node) {
    nodes_ = {node};
    takeActive(session, node);
}

void ObjectSelection::toggle(Session& session, int node) {
    nodes_ = nodes(session);
    if (const auto found = std::ranges::find(nodes_, node); found == nodes_.end()) {
        nodes_.push_back(node);
    } else if (nodes_.size() > 1) {
        nodes_.erase(found);
    }
    takeActive(session, nodes_.back());
}

}  // namespace voxprite::editor
