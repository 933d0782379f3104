#include "core/edit/scene_edits.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/edit/free_name.h"
#include "core/edit/make_action.h"
#include "core/edit/scene_tree.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

using scene::nodeOf;
using scene::sceneAction;

std::string named(const char* verb, const Document& document, int node) {
    return std::string(verb) + (nodeOf(document.nodes, node).isGroup() ? " group" : " object");
}

// "Leg" becomes "Leg 2", that "Leg 3": the next that no node has.
std::string nameOfCopy(const Document& document, const std::string& name) {
    const std::size_t space = name.find_last_not_of("0123456789");
    const bool numbered =
        space != std::string::npos && space + 1 < name.size() && name[space] == ' ';
    return freeName(numbered ? name.substr(0, space) : name, document.nodes);
}

// Models that the edit adds in place of others, each once.
class CopiedModels {
  public:
    CopiedModels(const Document& document, SceneEdit& edit) : document_(document), edit_(edit) {}

    int copyOf(int model) {
        const auto next = static_cast<int>(document_.models.size() + edit_.addedModels.size());
        const auto [place, isNew] = copies_.try_emplace(model, next);
        if (isNew) {
            edit_.addedModels.push_back(document_.models[static_cast<std::size_t>(model)]);
        }
        return place->second;
    }

  private:
    const Document& document_;
    SceneEdit& edit_;
    std::map<int, int> copies_;
};

// For each model: do nodes that are `inside`, or not, show it?
std::vector<bool> modelsShown(const Document& document, const std::vector<bool>& inside,
                              bool wanted) {
    std::vector<bool> shown(document.models.size(), false);
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
        if (inside[i] != wanted) continue;
        for (const ModelKey& key : document.nodes[i].models) {
            shown[static_cast<std::size_t>(key.model)] = true;
        }
    }
    return shown;
}

Action placeAll(std::string label, const Document& document, int node,
                const Placement& parentFromParent) {
    return sceneAction(std::move(label), document, [&](SceneEdit& edit) {
        for (PlacementKey& key : nodeOf(edit.after.nodes, node).placements) {
            key.placement = parentFromParent * key.placement;
        }
    });
}

// What `rotation` makes of the node's box, around the same middle.
Placement aroundMiddle(const Document& document, int node, int frame,
                       const SignedPermutation& rotation) {
    IBox box = nodeBounds(document, node, frame);
    if (box.empty()) {
        const glm::ivec3 place = placementAt(nodeOf(document.nodes, node), frame).translation;
        return {rotation, place - rotation.apply(place)};
    }
    const Placement turn{rotation, glm::ivec3(0)};
    const IBox turned = turn.applyToBox(box);
    return {rotation, box.min + (box.size() - turned.size()) / 2 - turned.min};
}

}  // namespace

Action setHidden(const Document& document, int node, bool hidden) {
    return sceneAction(named(hidden ? "Hide" : "Show", document, node), document,
                       [&](SceneEdit& edit) { nodeOf(edit.after.nodes, node).hidden = hidden; });
}

Action setLocked(const Document& document, int node, bool locked) {
    return sceneAction(named(locked ? "Lock" : "Unlock", document, node), document,
                       [&](SceneEdit& edit) { nodeOf(edit.after.nodes, node).locked = locked; });
}

Action rename(const Document& document, int node, std::string name) {
    return sceneAction(named("Rename", document, node), document, [&](SceneEdit& edit) {
        nodeOf(edit.after.nodes, node).name = std::move(name);
    });
}

Action addObject(const Document& document, std::string name) {
    return sceneAction("Add object", document, [&](SceneEdit& edit) {
        SceneNode node;
        node.name = std::move(name);
        node.models = {ModelKey{0, static_cast<int>(document.models.size())}};
        edit.addedModels.emplace_back();
        scene::insert(edit.after, std::move(node), 0, scene::kLast);
    });
}

Action duplicateNode(const Document& document, int node, Copy copy) {
    return sceneAction(named("Duplicate", document, node), document, [&](SceneEdit& edit) {
        CopiedModels models(document, edit);
        const int parent = nodeOf(document.nodes, node).parent;
        struct Open {
            int original, parent, position;
        };
        std::vector<Open> open{{node, parent, scene::positionOf(document.nodes, node) + 1}};
        // The first copy comes first among the new nodes; children follow in their order.
        for (std::size_t next = 0; next < open.size(); ++next) {
            const Open from = open[next];
            SceneNode made = nodeOf(document.nodes, from.original);
            if (next == 0 && !made.name.empty()) made.name = nameOfCopy(document, made.name);
            const std::vector<int> children = std::exchange(made.children, {});
            if (copy == Copy::own) {
                for (ModelKey& key : made.models) key.model = models.copyOf(key.model);
            }
            const int index =
                scene::insert(edit.after, std::move(made), from.parent, from.position);
            for (const int child : children) open.push_back({child, index, scene::kLast});
        }
    });
}

bool sharesModels(const Document& document, int node) {
    const std::vector<bool> inside = scene::subtree(document.nodes, std::array{node});
    const std::vector<bool> own = modelsShown(document, inside, true);
    const std::vector<bool> others = modelsShown(document, inside, false);
    for (std::size_t model = 0; model < own.size(); ++model) {
        if (own[model] && others[model]) return true;
    }
    return false;
}

Action makeSingleUser(const Document& document, int node) {
    return sceneAction("Make single user", document, [&](SceneEdit& edit) {
        const std::vector<bool> inside = scene::subtree(document.nodes, std::array{node});
        const std::vector<bool> others = modelsShown(document, inside, false);
        CopiedModels models(document, edit);
        for (std::size_t i = 0; i < inside.size(); ++i) {
            if (!inside[i]) continue;
            for (ModelKey& key : edit.after.nodes[i].models) {
                if (others[static_cast<std::size_t>(key.model)])
                    key.model = models.copyOf(key.model);
            }
        }
    });
}

Action deleteNodes(const Document& document, std::span<const int> nodes) {
    const std::vector<int> gone = topmost(document, nodes);
    return sceneAction(gone.size() == 1 ? named("Delete", document, gone[0]) : "Delete objects",
                       document, [&](SceneEdit& edit) {
                           scene::erase(edit, gone);
                           scene::fitClips(edit.after);
                       });
}

Action moveObject(const Document& document, int node, glm::ivec3 translation,
                  std::uint64_t mergeKey) {
    const glm::ivec3 before = nodeOf(document.nodes, node).placements.front().placement.translation;
    Action action =
        placeAll(named("Move", document, node), document, node, {{}, translation - before});
    action.mergeKey = mergeKey;
    return action;
}

Action turnNode(const Document& document, int node, int frame, int axis, int quarterTurns) {
    const auto a = static_cast<std::size_t>(axis);
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    SignedPermutation quarter;  // b becomes c, c becomes -b
    quarter.axis[b] = static_cast<std::uint8_t>(c);
    quarter.sign[b] = -1;
    quarter.axis[c] = static_cast<std::uint8_t>(b);
    SignedPermutation rotation;
    for (int turn = 0; turn < ((quarterTurns % 4) + 4) % 4; ++turn) rotation = quarter * rotation;
    return placeAll(named("Turn", document, node), document, node,
                    aroundMiddle(document, node, frame, rotation));
}

Action mirrorNode(const Document& document, int node, int frame, int axis) {
    SignedPermutation mirror;
    mirror.sign[static_cast<std::size_t>(axis)] = -1;
    return placeAll(named("Mirror", document, node), document, node,
                    aroundMiddle(document, node, frame, mirror));
}

}  // namespace voxprite
