// The scene edits that change the tree: order, groups, merging.
#include <algorithm>
#include <array>
#include <map>

#include "core/edit/scene_edits.h"
#include "core/edit/scene_tree.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

using scene::nodeOf;
using scene::sceneAction;

// Puts `tops`, in this order, before child number `position` of `parent`.
void moveUnder(SceneState& scene, std::span<const int> tops, int parent, int position, int frames) {
    const std::vector<int> before = nodeOf(scene.nodes, parent).children;
    std::vector<int> children;
    const auto count = static_cast<int>(before.size());
    for (int i = 0; i <= count; ++i) {
        if (i == std::min(position, count))
            children.insert(children.end(), tops.begin(), tops.end());
        if (i == count) break;
        const int child = before[static_cast<std::size_t>(i)];
        if (std::ranges::find(tops, child) == tops.end()) children.push_back(child);
    }
    for (const int top : tops) {
        if (nodeOf(scene.nodes, top).parent != parent) {
            scene::keepInPlace(scene, top, parent, frames);
        }
    }
    nodeOf(scene.nodes, parent).children = std::move(children);
}

// The models of one object that shows, frame by frame, what `chosen` objects show together.
class MergedFrames {
  public:
    MergedFrames(const Document& document, std::vector<bool> chosen)
        : document_(document), chosen_(std::move(chosen)) {}

    std::vector<ModelKey> keys(int frames, std::vector<Model>& added) {
        std::vector<ModelKey> keys;
        for (int frame = 0; frame < frames; ++frame) {
            const int model = modelOf(frame, added);
            if (keys.empty() || keys.back().model != model) keys.push_back({frame, model});
        }
        return keys;
    }

  private:
    int modelOf(int frame, std::vector<Model>& added) {
        std::vector<Instance> instances = instancesOf(document_, frame, true);
        std::erase_if(instances, [&](const Instance& instance) {
            return !chosen_[static_cast<std::size_t>(instance.node)];
        });
        std::vector<int> shown;
        for (const Instance& instance : instances) {
            const glm::ivec3 t = instance.entityFromModel.translation;
            const int turn = instance.entityFromModel.rotation.toVoxByte();
            shown.insert(shown.end(), {instance.model, turn, t.x, t.y, t.z});
        }
        const auto next = static_cast<int>(document_.models.size() + added.size());
        const auto [model, isNew] = modelOfShown_.try_emplace(std::move(shown), next);
        if (isNew) added.push_back(merged(instances));
        return model->second;
    }

    [[nodiscard]] Model merged(std::span<const Instance> instances) const {
        Model model;
        for (const Instance& instance : instances) {
            const auto index = static_cast<std::size_t>(instance.model);
            document_.models[index].voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
                model.voxels.set(instance.entityFromModel.applyToVoxel(v), value);
            });
        }
        return model;
    }

    const Document& document_;
    std::vector<bool> chosen_;
    std::map<std::vector<int>, int> modelOfShown_;
};

}  // namespace

std::vector<int> topmost(const Document& document, std::span<const int> nodes) {
    std::vector<bool> chosen(document.nodes.size(), false);
    for (const int node : nodes) chosen[static_cast<std::size_t>(node)] = true;
    std::vector<int> tops;
    std::vector<bool> covered(document.nodes.size(), false);
    for (const int node : scene::drawingOrder(document.nodes)) {
        const auto index = static_cast<std::size_t>(node);
        const auto parent = static_cast<std::size_t>(document.nodes[index].parent);
        covered[index] = covered[parent] || (parent != 0 && chosen[parent]);
        if (chosen[index] && !covered[index]) tops.push_back(node);
    }
    return tops;
}

Result<Action> moveNodes(const Document& document, std::span<const int> nodes, int parent,
                         int position) {
    const std::vector<int> tops = topmost(document, nodes);
    if (!nodeOf(document.nodes, parent).isGroup()) return fail("only a group can hold objects");
    if (scene::subtree(document.nodes, tops)[static_cast<std::size_t>(parent)]) {
        return fail("a group cannot be put into itself");
    }
    return sceneAction("Reorder objects", document, [&](SceneEdit& edit) {
        moveUnder(edit.after, tops, parent, position, frameCount(document));
    });
}

Action groupNodes(const Document& document, std::span<const int> nodes, std::string name) {
    const std::vector<int> tops = topmost(document, nodes);
    return sceneAction("Group objects", document, [&](SceneEdit& edit) {
        SceneNode group;
        group.name = std::move(name);
        const int parent = nodeOf(document.nodes, tops.back()).parent;
        const int position = scene::positionOf(document.nodes, tops.back());
        const int index = scene::insert(edit.after, std::move(group), parent, position);
        moveUnder(edit.after, tops, index, 0, frameCount(document));
    });
}

Action ungroup(const Document& document, int group) {
    return sceneAction("Ungroup", document, [&](SceneEdit& edit) {
        const SceneNode before = nodeOf(document.nodes, group);
        const int position = scene::positionOf(document.nodes, group);
        moveUnder(edit.after, before.children, before.parent, position, frameCount(document));
        for (const int child : before.children) {
            SceneNode& node = nodeOf(edit.after.nodes, child);
            node.hidden = node.hidden || before.hidden;
            node.locked = node.locked || before.locked;
            if (node.layer < 0) {
                node.layer = before.layer;
            } else if (before.layer >= 0) {
                const auto layer = static_cast<std::size_t>(before.layer);
                node.hidden = node.hidden || document.layers[layer].hidden;
            }
        }
        scene::erase(edit, std::array{group});
        scene::fitClips(edit.after);
    });
}

Action mergeNodes(const Document& document, std::span<const int> nodes, std::string name) {
    const std::vector<int> tops = topmost(document, nodes);
    return sceneAction("Merge objects", document, [&](SceneEdit& edit) {
        const int frames = frameCount(document);
        SceneNode object;
        object.name = std::move(name);
        object.models = MergedFrames(document, scene::subtree(document.nodes, tops))
                            .keys(frames, edit.addedModels);
        const int parent = nodeOf(document.nodes, tops.back()).parent;
        const int position = scene::positionOf(document.nodes, tops.back()) + 1;
        const int index = scene::insert(edit.after, std::move(object), parent, position);
        // Its voxels are in entity space.
        scene::placeInEntity(edit.after, index, Placement(), frames);
        scene::erase(edit, tops);
        scene::keepFrames(edit.after, static_cast<int>(edit.after.nodes.size()) - 1, frames);
    });
}

}  // namespace voxprite
