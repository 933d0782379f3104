// Edits of the scene graph as actions: pure functions of a document. Nodes are indices into
// Document::nodes; none of these touches the root. Models are shared unless it says otherwise, and
// never changed or removed: an action only adds models and changes who shows what.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/edit/history.h"

namespace voxprite {

[[nodiscard]] Action setHidden(const Document& document, int node, bool hidden);
[[nodiscard]] Action setLocked(const Document& document, int node, bool locked);
[[nodiscard]] Action rename(const Document& document, int node, std::string name);

// An object with an empty model of its own, under the root, drawn last. It is the last node.
[[nodiscard]] Action addObject(const Document& document, std::string name);
// A copy of the node and all under it, drawn right after the original. The copy is the node at
// index document.nodes.size(). Copied models are its own; within the copy they are shared as they
// were. Linked: it shows the very models of the original.
enum class Copy : std::uint8_t { own, linked };
[[nodiscard]] Action duplicateNode(const Document& document, int node, Copy copy);
// Does anything outside `node` show one of its models?
[[nodiscard]] bool sharesModels(const Document& document, int node);
// The node and all under it get copies of the models that something else shows, too.
[[nodiscard]] Action makeSingleUser(const Document& document, int node);
// The nodes and all under them go; models stay (the history keeps them for undo anyway).
[[nodiscard]] Action deleteNodes(const Document& document, std::span<const int> nodes);

// --- placement, in the space of the parent; all keys of a node move together

// The translation of its first placement.
[[nodiscard]] Action moveObject(const Document& document, int node, glm::ivec3 translation,
                                std::uint64_t mergeKey);
// By quarter turns about `axis`, counter-clockwise seen from its positive end, around the middle of
// what the node shows in `frame`. Where that middle does not fall on the lattice it moves by half a
// voxel, so that four quarter turns are none and a turn back leads back.
[[nodiscard]] Action turnNode(const Document& document, int node, int frame, int axis,
                              int quarterTurns);
// Mirrored along `axis`, in place.
[[nodiscard]] Action mirrorNode(const Document& document, int node, int frame, int axis);

// --- the tree

// Those of `nodes` that lie under no other of them, in drawing order; the root is left out.
[[nodiscard]] std::vector<int> topmost(const Document& document, std::span<const int> nodes);
// Puts the nodes, in drawing order, under the group `parent`, before its child number `position` as
// it is now (its number of children: last). They stay where they are in entity space, in every
// frame. Fails when a group would come to lie in itself, or the parent is no group.
[[nodiscard]] Result<Action> moveNodes(const Document& document, std::span<const int> nodes,
                                       int parent, int position);
// A group around the nodes, in the place of the last of them. It is the last node. At least one.
[[nodiscard]] Action groupNodes(const Document& document, std::span<const int> nodes,
                                std::string name);
// What lies in the group takes its place, hidden or locked if the group (or its layer) was.
[[nodiscard]] Action ungroup(const Document& document, int group);
// One object, the last node, with models of its own for all that lies under the nodes, hidden or
// not, in every frame; where they overlap the later one wins. It takes the place of the last.
[[nodiscard]] Action mergeNodes(const Document& document, std::span<const int> nodes,
                                std::string name);

}  // namespace voxprite
