// Edits of the scene graph as actions: pure functions of a document.
#pragma once

#include <optional>
#include <string>

#include "core/edit/history.h"

namespace voxprite::editor {

[[nodiscard]] SceneState sceneOf(const Document& document);
[[nodiscard]] Action setHidden(const Document& document, int node, bool hidden);
[[nodiscard]] Action setLocked(const Document& document, int node, bool locked);
[[nodiscard]] Action rename(const Document& document, int node, std::string name);
// Its first placement's translation; frames keep their distances to it.
[[nodiscard]] Action moveObject(const Document& document, int node, glm::ivec3 translation,
                                std::uint64_t mergeKey);
// An object with an empty model of its own, under the root, drawn last.
[[nodiscard]] Action addObject(const Document& document, std::string name);
// A copy with models of its own, beside the original and drawn after it.
[[nodiscard]] Action duplicateObject(const Document& document, int node);
// The node and all under it go; models stay (the history keeps them for undo anyway).
[[nodiscard]] Action deleteNode(const Document& document, int node);

}  // namespace voxprite::editor
