// The tree of a scene being edited: what the scene edits are made of. Private to core/edit.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/edit/make_action.h"

namespace voxprite::scene {

inline constexpr int kLast = std::numeric_limits<int>::max();  // after all other children

template <class Nodes>
[[nodiscard]] auto& nodeOf(Nodes& nodes, int node) {
    return nodes[static_cast<std::size_t>(node)];
}

// An action whose scene is `document`'s after `edit(SceneEdit&)`.
template <class Edit>
[[nodiscard]] Action sceneAction(std::string label, const Document& document, Edit edit) {
    SceneEdit part;
    part.before = part.after = sceneOf(document);
    part.modelsBefore = document.models.size();
    edit(part);
    return makeAction(std::move(label), std::move(part));
}

// Which nodes are `tops` or lie under them.
[[nodiscard]] std::vector<bool> subtree(const std::vector<SceneNode>& nodes,
                                        std::span<const int> tops);
// The nodes without the root in drawing order: a group before what it holds.
[[nodiscard]] std::vector<int> drawingOrder(const std::vector<SceneNode>& nodes);
// Which child of its parent it is.
[[nodiscard]] int positionOf(const std::vector<SceneNode>& nodes, int node);
// Appends a node without children as child number `position` of `parent`; its index.
int insert(SceneState& scene, SceneNode node, int parent, int position);
// Takes nodes out of what is after the edit, with all under them; the indices of the others close
// up, and the edit says so.
void erase(SceneEdit& edit, std::span<const int> tops);

[[nodiscard]] int frameCount(const std::vector<SceneNode>& nodes);
// Cuts the clips to the frames that there are.
void fitClips(SceneState& scene);
// The scene keeps at least `frames` frames: the node says so, if no other does.
void keepFrames(SceneState& scene, int node, int frames);
// The node's placements become such that it lies there in each of `frames` frames.
void placeInEntity(SceneState& scene, int node, const Placement& entityFromNode, int frames);
// Hands `node` from its parent, where it stays a child, to `parent`, where it is none yet. Its
// placements become such that it stays where it is in each of `frames` frames.
void keepInPlace(SceneState& scene, int node, int parent, int frames);

}  // namespace voxprite::scene
