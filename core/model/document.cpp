#include "core/model/document.h"

#include <algorithm>
#include <cmath>

#include "core/model/entity_voxels.h"
#include "core/model/game_profile.h"
#include "core/model/range_check.h"

namespace voxprite {

namespace {

constexpr double kFarthestPoint = 1e7;  // of anchor and sockets, in voxels

std::string nodeName(const Document& document, std::size_t index) {
    const std::string& name = document.nodes[index].name;
    return "node " + std::to_string(index) + (name.empty() ? "" : " (\"" + name + "\")");
}

bool isIndex(int index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
}

std::string outOf(const char* what, int index, std::size_t count) {
    return std::string(what) + " " + std::to_string(index) + " does not exist; there are " +
           std::to_string(count);
}

bool boxIsInRange(const IBox& box) {
    return box.empty() || (isInVoxelRange(box.min) && isInVoxelRange(box.max - 1));
}

Status validateModel(const Model& model, const IBox& bounds, std::size_t index) {
    const std::string name = "model " + std::to_string(index);
    const std::string limit = " reaches beyond +-" + std::to_string(kMaxCoordinate) + " voxels";
    if (!boxIsInRange(bounds)) return fail(name + limit);
    if (!boxIsInRange(model.canvas)) {
        return fail(name + ": its canvas" + limit);
    }
    return {};
}

// The frames of a track: ascending, within 0 ... kMaxFrames - 1.
template <class Key>
Status validateFrames(const std::vector<Key>& keys, const std::string& track) {
    int previous = -1;
    for (const Key& key : keys) {
        if (key.frame < 0 || key.frame >= kMaxFrames) {
            return fail(track + ": frame " + std::to_string(key.frame) + " is outside 0 ... " +
                        std::to_string(kMaxFrames - 1));
        }
        if (key.frame <= previous) {
            return fail(track + ": frame " + std::to_string(key.frame) + " follows frame " +
                        std::to_string(previous) + "; frames must ascend");
        }
        previous = key.frame;
    }
    return {};
}

bool isSignedPermutation(const SignedPermutation& rotation) {
    std::array<bool, 3> used{};
    for (std::size_t row = 0; row < 3; ++row) {
        if (rotation.axis[row] > 2 || std::abs(rotation.sign[row]) != 1) return false;
        used[rotation.axis[row]] = true;
    }
    return used[0] && used[1] && used[2];
}

// A node by itself, its place in the tree aside.
Status validateNode(const Document& document, std::size_t index) {
    const SceneNode& node = document.nodes[index];
    const std::string name = nodeName(document, index);
    if (node.layer != -1 && !isIndex(node.layer, document.layers.size())) {
        return fail(name + ": " + outOf("layer", node.layer, document.layers.size()));
    }
    if (node.placements.empty()) return fail(name + ": it has no placement");
    if (Status s = validateFrames(node.placements, name + ": placements"); !s) return s;
    if (Status s = validateFrames(node.models, name + ": models"); !s) return s;
    for (const PlacementKey& key : node.placements) {
        if (!isSignedPermutation(key.placement.rotation)) {
            return fail(name + ": the rotation at frame " + std::to_string(key.frame) +
                        " is none of the 48 signed permutations");
        }
        if (!isInVoxelRange(key.placement.translation)) {
            return fail(name + ": the translation at frame " + std::to_string(key.frame) +
                        " is beyond +-" + std::to_string(kMaxCoordinate) + " voxels");
        }
    }
    for (const ModelKey& key : node.models) {
        if (!isIndex(key.model, document.models.size())) {
            return fail(name + ": " + outOf("model", key.model, document.models.size()));
        }
    }
    if (!node.isGroup() && !node.children.empty()) {
        return fail(name + ": it is an object and has children; only groups have");
    }
    return {};
}

// Every node but the root is the child of exactly its parent, and all hang on the root.
Status validateTree(const Document& document) {
    const std::vector<SceneNode>& nodes = document.nodes;
    if (nodes[0].parent != -1) return fail("node 0 is the root; its parent must be -1");
    if (!nodes[0].isGroup()) return fail("node 0 is the root and must be a group");
    std::vector<bool> seen(nodes.size(), false);
    std::vector<int> open{0};
    std::size_t reached = 1;
    while (!open.empty()) {
        const int parent = open.back();
        open.pop_back();
        for (const int child : nodes[static_cast<std::size_t>(parent)].children) {
            const std::string name = nodeName(document, static_cast<std::size_t>(parent));
            if (!isIndex(child, nodes.size()) || child == 0) {
                return fail(name + ": " + outOf("child", child, nodes.size()));
            }
            const auto index = static_cast<std::size_t>(child);
            if (seen[index]) return fail(nodeName(document, index) + ": it is a child twice");
            if (nodes[index].parent != parent) {
                return fail(nodeName(document, index) + ": its parent is " +
                            std::to_string(nodes[index].parent) + ", but it is a child of node " +
                            std::to_string(parent));
            }
            seen[index] = true;
            ++reached;
            open.push_back(child);
        }
    }
    if (reached == nodes.size()) return {};
    seen[0] = true;
    const auto lost = std::find(seen.begin(), seen.end(), false);
    return fail(nodeName(document, static_cast<std::size_t>(lost - seen.begin())) +
                ": it does not hang on the root");
}

std::int64_t largestComponent(glm::ivec3 v) {
    return std::max(
        {std::abs(std::int64_t{v.x}), std::abs(std::int64_t{v.y}), std::abs(std::int64_t{v.z})});
}

// Nothing may be placed where a coordinate would not be valid: sums along each path of the tree,
// by the largest component, since rotations may swap the axes.
Status validateReach(const Document& document, const std::vector<IBox>& modelBounds) {
    struct Open {
        int node;
        std::int64_t reach;
    };
    std::vector<Open> open{{0, 0}};
    while (!open.empty()) {
        const auto [index, reachOfParent] = open.back();
        open.pop_back();
        const SceneNode& node = document.nodes[static_cast<std::size_t>(index)];
        std::int64_t translation = 0;
        for (const PlacementKey& key : node.placements) {
            translation = std::max(translation, largestComponent(key.placement.translation));
        }
        std::int64_t model = 0;
        for (const ModelKey& key : node.models) {
            const IBox& box = modelBounds[static_cast<std::size_t>(key.model)];
            model = std::max({model, largestComponent(box.min), largestComponent(box.max)});
        }
        const std::int64_t reach = reachOfParent + translation;
        if (reach + model > kMaxCoordinate) {
            return fail(nodeName(document, static_cast<std::size_t>(index)) +
                        ": its placements reach beyond +-" + std::to_string(kMaxCoordinate) +
                        " voxels");
        }
        for (const int child : node.children) open.push_back({child, reach});
    }
    return {};
}

Status validateClip(const Clip& clip, std::size_t index, int frames) {
    const std::string name = "clip " + std::to_string(index) + " (\"" + clip.name + "\")";
    if (clip.first < 0 || clip.last < clip.first || clip.last >= frames) {
        return fail(name + ": frames " + std::to_string(clip.first) + " ... " +
                    std::to_string(clip.last) + " are not within 0 ... " +
                    std::to_string(frames - 1));
    }
    if (Status s = checkRange(name + ": framesPerSecond", clip.framesPerSecond, 0.001, 1000.0);
        !s) {
        return s;
    }
    if (clip.durationsMilliseconds.empty()) return {};
    if (clip.durationsMilliseconds.size() != static_cast<std::size_t>(clip.last - clip.first) + 1) {
        return fail(name + ": it has not one duration a frame");
    }
    for (const int duration : clip.durationsMilliseconds) {
        if (duration < 1 || duration > kMaxFrameMilliseconds) {
            return fail(name + ": a frame of " + std::to_string(duration) +
                        " ms; it must be 1 ... " + std::to_string(kMaxFrameMilliseconds));
        }
    }
    return {};
}

Status checkPoint(const std::string& field, const glm::dvec3& point, double farthest) {
    for (int axis = 0; axis < 3; ++axis) {
        if (Status s = checkRange(field + "." + "xyz"[axis], point[axis], -farthest, farthest);
            !s) {
            return s;
        }
    }
    return {};
}

Status validateSocket(const Socket& socket, std::size_t index) {
    const std::string name = "socket " + std::to_string(index) + " (\"" + socket.name + "\")";
    if (socket.positions.empty()) return fail(name + ": it has no position");
    if (Status s = validateFrames(socket.positions, name + ": positions"); !s) return s;
    for (const SocketKey& key : socket.positions) {
        if (Status s = checkPoint(name + ": position", key.positionVoxels, kFarthestPoint); !s) {
            return s;
        }
    }
    return {};
}

}  // namespace

Document Document::withEmptyModel() {
    Document document;
    document.models.emplace_back();
    SceneNode object;
    object.name = "Object";
    object.parent = 0;
    object.models = {ModelKey{}};
    document.nodes[0].children = {1};
    document.nodes.push_back(std::move(object));
    return document;
}

Status validate(const Entity& entity) {
    constexpr double kFullTurns = 1e6;
    if (entity.anchorVoxels) {
        if (Status s = checkPoint("entity.anchorVoxels", *entity.anchorVoxels, kFarthestPoint);
            !s) {
            return s;
        }
    }
    if (Status s = checkRange("entity.yawDegrees", entity.yawDegrees, -kFullTurns, kFullTurns);
        !s) {
        return s;
    }
    if (Status s = checkRange("entity.pitchDegrees", entity.pitchDegrees, -kFullTurns, kFullTurns);
        !s) {
        return s;
    }
    if (Status s = checkRange("entity.rollDegrees", entity.rollDegrees, -kFullTurns, kFullTurns);
        !s) {
        return s;
    }
    if (Status s = checkRange("entity.scale", entity.scale, 1e-3, 1e3); !s) return s;
    return checkPoint("entity.positionMetres", entity.positionMetres, 1e12);
}

Status validate(const Document& document) {
    if (document.nodes.empty()) return fail("there is no node; node 0 must be the root");
    if (Status s = validate(document.palette); !s) return s;
    std::vector<IBox> modelBounds;
    for (std::size_t i = 0; i < document.models.size(); ++i) {
        modelBounds.push_back(document.models[i].voxels.bounds());
        if (Status s = validateModel(document.models[i], modelBounds[i], i); !s) return s;
    }
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
        if (Status s = validateNode(document, i); !s) return s;
    }
    if (Status s = validateTree(document); !s) return s;
    if (Status s = validateReach(document, modelBounds); !s) return s;
    const int frames = frameCount(document);
    for (std::size_t i = 0; i < document.clips.size(); ++i) {
        if (Status s = validateClip(document.clips[i], i, frames); !s) return s;
    }
    for (std::size_t i = 0; i < document.sockets.size(); ++i) {
        if (Status s = validateSocket(document.sockets[i], i); !s) return s;
    }
    if (Status s = checkVoxelSize("authored.voxelSizeMetres", document.authored.voxelSizeMetres);
        !s) {
        return s;
    }
    if (Status s = checkSigma("authored.sigma", document.authored.sigma); !s) return s;
    return validate(document.entity);
}

}  // namespace voxprite
