#include "core/edit/scene_tree.h"

#include <algorithm>

#include "core/model/entity_voxels.h"

namespace voxprite::scene {
namespace {

// From the space inside `group` (of its children) to that of the entity.
Placement entityFromInside(const std::vector<SceneNode>& nodes, int group, int frame) {
    Placement placement;
    for (int node = group; node >= 0; node = nodeOf(nodes, node).parent) {
        placement = placementAt(nodeOf(nodes, node), frame) * placement;
    }
    return placement;
}

bool standsStill(const std::vector<SceneNode>& nodes, int group) {
    for (int node = group; node >= 0; node = nodeOf(nodes, node).parent) {
        if (nodeOf(nodes, node).placements.size() > 1) return false;
    }
    return true;
}

}  // namespace

std::vector<bool> subtree(const std::vector<SceneNode>& nodes, std::span<const int> tops) {
    std::vector<bool> inside(nodes.size(), false);
    std::vector<int> open(tops.begin(), tops.end());
    while (!open.empty()) {
        const int next = open.back();
        open.pop_back();
        inside[static_cast<std::size_t>(next)] = true;
        const auto& children = nodeOf(nodes, next).children;
        open.insert(open.end(), children.begin(), children.end());
    }
    return inside;
}

std::vector<int> drawingOrder(const std::vector<SceneNode>& nodes) {
    std::vector<int> order;
    std::vector<int> open{0};
    while (!open.empty()) {
        const int next = open.back();
        open.pop_back();
        if (next != 0) order.push_back(next);
        const auto& children = nodeOf(nodes, next).children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return order;
}

int positionOf(const std::vector<SceneNode>& nodes, int node) {
    const auto& siblings = nodeOf(nodes, nodeOf(nodes, node).parent).children;
    return static_cast<int>(std::ranges::find(siblings, node) - siblings.begin());
}

int insert(SceneState& scene, SceneNode node, int parent, int position) {
    node.parent = parent;
    const auto index = static_cast<int>(scene.nodes.size());
    scene.nodes.push_back(std::move(node));
    auto& children = nodeOf(scene.nodes, parent).children;
    children.insert(children.begin() + std::min(position, static_cast<int>(children.size())),
                    index);
    return index;
}

void erase(SceneEdit& edit, std::span<const int> tops) {
    SceneState& scene = edit.after;
    const std::vector<bool> goes = subtree(scene.nodes, tops);
    std::vector<int> indexAfter(scene.nodes.size(), -1);
    std::vector<SceneNode> kept;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (goes[i]) continue;
        indexAfter[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(scene.nodes[i]));
    }
    const auto after = [&](int index) { return indexAfter[static_cast<std::size_t>(index)]; };
    for (SceneNode& node : kept) {
        if (node.parent >= 0) node.parent = after(node.parent);
        std::erase_if(node.children, [&](int child) { return after(child) < 0; });
        std::ranges::transform(node.children, node.children.begin(), after);
    }
    scene.nodes = std::move(kept);
    indexAfter.resize(edit.before.nodes.size());
    edit.nodesAfter = std::move(indexAfter);
}

int frameCount(const std::vector<SceneNode>& nodes) {
    int last = 0;
    for (const SceneNode& node : nodes) {
        last = std::max(last, node.placements.back().frame);
        if (!node.isGroup()) last = std::max(last, node.models.back().frame);
    }
    return last + 1;
}

void fitClips(SceneState& scene) {
    const int last = frameCount(scene.nodes) - 1;
    std::erase_if(scene.clips, [&](const Clip& clip) { return clip.first > last; });
    for (Clip& clip : scene.clips) {
        clip.last = std::min(clip.last, last);
        if (clip.durationsMilliseconds.empty()) continue;
        clip.durationsMilliseconds.resize(static_cast<std::size_t>(clip.last - clip.first) + 1);
    }
}

void keepFrames(SceneState& scene, int node, int frames) {
    if (frameCount(scene.nodes) >= frames) return;
    std::vector<PlacementKey>& placements = nodeOf(scene.nodes, node).placements;
    placements.push_back({frames - 1, placementAt(nodeOf(scene.nodes, node), frames - 1)});
}

void placeInEntity(SceneState& scene, int node, const Placement& entityFromNode, int frames) {
    const int parent = nodeOf(scene.nodes, node).parent;
    const int different = standsStill(scene.nodes, parent) ? 1 : frames;
    std::vector<PlacementKey> keys;
    for (int frame = 0; frame < different; ++frame) {
        const Placement place =
            entityFromInside(scene.nodes, parent, frame).inverse() * entityFromNode;
        if (keys.empty() || keys.back().placement != place) keys.push_back({frame, place});
    }
    nodeOf(scene.nodes, node).placements = std::move(keys);
}

void keepInPlace(SceneState& scene, int node, int parent, int frames) {
    const int before = nodeOf(scene.nodes, node).parent;
    const auto parentFromBefore = [&](int frame) {
        return entityFromInside(scene.nodes, parent, frame).inverse() *
               entityFromInside(scene.nodes, before, frame);
    };
    SceneNode& moved = nodeOf(scene.nodes, node);
    const Placement change = parentFromBefore(0);
    // Places between keys are rounded down, and would be the other way round on a turned axis.
    const bool roundsAlike = std::ranges::count(change.rotation.sign, -1) == 0;
    if (standsStill(scene.nodes, before) && standsStill(scene.nodes, parent) &&
        (roundsAlike || !movesBetweenKeys(moved))) {
        for (PlacementKey& key : moved.placements) key.placement = change * key.placement;
    } else {
        std::vector<PlacementKey> keys;
        for (int frame = 0; frame < frames; ++frame) {
            const Placement place = parentFromBefore(frame) * placementAt(moved, frame);
            const bool last = frame == frames - 1;  // says how many frames there are
            if (keys.empty() || last || keys.back().placement != place) {
                keys.push_back({frame, place});
            }
        }
        moved.placements = std::move(keys);
        moved.glides = false;
        moved.loopPlacements = false;
    }
    std::erase(nodeOf(scene.nodes, before).children, node);
    moved.parent = parent;
}

}  // namespace voxprite::scene
