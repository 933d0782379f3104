#include "app/editor/scene_edits.h"

#include <algorithm>
#include <map>

#include "app/editor/make_action.h"

namespace voxprite::editor {
namespace {

SceneNode& nodeOf(SceneState& scene, int node) {
    return scene.nodes[static_cast<std::size_t>(node)];
}

// An action whose scene is `document`'s after `edit`.
template <class Edit>
Action sceneAction(std::string label, const Document& document, Edit edit) {
    SceneEdit part;
    part.before = part.after = sceneOf(document);
    part.modelsBefore = document.models.size();
    edit(part);
    return makeAction(std::move(label), std::move(part));
}

void appendUnder(SceneState& scene, int parent, SceneNode node) {
    node.parent = parent;
    const auto index = static_cast<int>(scene.nodes.size());
    scene.nodes.push_back(std::move(node));
    nodeOf(scene, parent).children.push_back(index);
}

}  // namespace

SceneState sceneOf(const Document& document) {
    return {document.nodes, document.layers, document.clips};
}

Action setHidden(const Document& document, int node, bool hidden) {
    return sceneAction(hidden ? "Hide object" : "Show object", document,
                       [&](SceneEdit& edit) { nodeOf(edit.after, node).hidden = hidden; });
}

Action setLocked(const Document& document, int node, bool locked) {
    return sceneAction(locked ? "Lock object" : "Unlock object", document,
                       [&](SceneEdit& edit) { nodeOf(edit.after, node).locked = locked; });
}

Action rename(const Document& document, int node, std::string name) {
    return sceneAction("Rename object", document,
                       [&](SceneEdit& edit) { nodeOf(edit.after, node).name = std::move(name); });
}

Action moveObject(const Document& document, int node, glm::ivec3 translation,
                  std::uint64_t mergeKey) {
    Action action = sceneAction("Move object", document, [&](SceneEdit& edit) {
        auto& keys = nodeOf(edit.after, node).placements;
        const glm::ivec3 step = translation - keys.front().placement.translation;
        for (PlacementKey& key : keys) key.placement.translation += step;
    });
    action.mergeKey = mergeKey;
    return action;
}

Action addObject(const Document& document, std::string name) {
    return sceneAction("Add object", document, [&](SceneEdit& edit) {
        SceneNode node;
        node.name = std::move(name);
        node.models = {ModelKey{0, static_cast<int>(document.models.size())}};
        edit.addedModels.emplace_back();
        appendUnder(edit.after, 0, std::move(node));
    });
}

Action duplicateObject(const Document& document, int node) {
    return sceneAction("Duplicate object", document, [&](SceneEdit& edit) {
        SceneNode copy = nodeOf(edit.before, node);
        copy.name += " copy";
        std::map<int, int> copied;
        for (ModelKey& key : copy.models) {
            const auto next = static_cast<int>(document.models.size() + edit.addedModels.size());
            const auto [place, isNew] = copied.try_emplace(key.model, next);
            if (isNew) {
                edit.addedModels.push_back(document.models[static_cast<std::size_t>(key.model)]);
            }
            key.model = place->second;
        }
        appendUnder(edit.after, copy.parent, std::move(copy));
    });
}

Action deleteNode(const Document& document, int node) {
    return sceneAction("Delete object", document, [&](SceneEdit& edit) {
        auto& nodes = edit.after.nodes;
        std::vector<bool> goes(nodes.size(), false);
        std::vector<int> open{node};
        while (!open.empty()) {
            const int next = open.back();
            open.pop_back();
            goes[static_cast<std::size_t>(next)] = true;
            const auto& children = nodeOf(edit.after, next).children;
            open.insert(open.end(), children.begin(), children.end());
        }
        std::vector<int> indexAfter(nodes.size(), -1);
        std::vector<SceneNode> kept;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (goes[i]) continue;
            indexAfter[i] = static_cast<int>(kept.size());
            kept.push_back(std::move(nodes[i]));
        }
        const auto after = [&](int index) { return indexAfter[static_cast<std::size_t>(index)]; };
        for (SceneNode& each : kept) {
            if (each.parent >= 0) each.parent = after(each.parent);
            std::erase_if(each.children, [&](int child) { return after(child) < 0; });
            std::ranges::transform(each.children, each.children.begin(), after);
        }
        nodes = std::move(kept);
    });
}

}  // namespace voxprite::editor
