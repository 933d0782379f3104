#include "core/model/entity_voxels.h"

#include <algorithm>

namespace voxprite {

namespace {

template <class Key>
int periodOf(const std::vector<Key>& keys) {
    return keys.back().frame - keys.front().frame + 1;
}

// The frame between the first key and the last that a looping track shows at `frame`.
template <class Key>
int frameInTrack(const std::vector<Key>& keys, int frame, bool loop) {
    if (!loop) return frame;
    const int first = keys.front().frame;
    const int period = periodOf(keys);
    return first + ((frame - first) % period + period) % period;
}

// The key in force at `frame` of the track: the last one not after it. Before the first key that
// one holds.
template <class Key>
auto keyAt(const std::vector<Key>& keys, int frameInTrack) {
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), frameInTrack,
                         [](int value, const Key& key) { return value < key.frame; });
    return after == keys.begin() ? after : std::prev(after);
}

bool movesUntil(const PlacementKey& key, const PlacementKey& next) {
    return next.frame - key.frame > 1 && key.placement.translation != next.placement.translation;
}

glm::ivec3 between(const PlacementKey& key, const PlacementKey& next, int frame) {
    const std::int64_t length = next.frame - key.frame;
    glm::ivec3 place = key.placement.translation;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t way =
            (std::int64_t{next.placement.translation[axis]} - place[axis]) * (frame - key.frame);
        place[axis] += static_cast<int>(way / length - (way % length < 0 ? 1 : 0));
    }
    return place;
}

bool isHidden(const Document& document, const SceneNode& node) {
    return node.hidden ||
           (node.layer >= 0 && document.layers[static_cast<std::size_t>(node.layer)].hidden);
}

// Marks the frames at which a track may change.
template <class Key>
void markChanges(std::vector<bool>& changes, const std::vector<Key>& keys, bool loop) {
    if (keys.size() < 2) return;
    const int period = periodOf(keys);
    for (const Key& key : keys) {
        const int first = loop ? key.frame % period : key.frame;
        for (auto f = static_cast<std::size_t>(first); f < changes.size();
             f += static_cast<std::size_t>(period)) {
            changes[f] = true;
            if (!loop) break;
        }
    }
}

// The frames that may differ from the one before; frame 0 always.
std::vector<int> distinctFrames(const Document& document) {
    std::vector<bool> changes(static_cast<std::size_t>(frameCount(document)), false);
    changes[0] = true;
    for (const SceneNode& node : document.nodes) {
        if (movesBetweenKeys(node)) changes.assign(changes.size(), true);
        markChanges(changes, node.placements, node.loopPlacements);
        markChanges(changes, node.models, node.loopModels);
    }
    std::vector<int> frames;
    for (std::size_t f = 0; f < changes.size(); ++f) {
        if (changes[f]) frames.push_back(static_cast<int>(f));
    }
    return frames;
}

// Bounds of each model, looked up once however many instances show it.
class ModelBounds {
  public:
    explicit ModelBounds(const Document& document)
        : document_(document), bounds_(document.models.size()) {}

    const IBox& of(int model) {
        const auto index = static_cast<std::size_t>(model);
        if (!bounds_[index]) bounds_[index] = document_.models[index].voxels.bounds();
        return *bounds_[index];
    }

    IBox ofFrame(int frame) {
        IBox box;
        for (const Instance& instance : instancesOf(document_, frame)) {
            box = box.united(instance.entityFromModel.applyToBox(of(instance.model)));
        }
        return box;
    }

  private:
    const Document& document_;
    std::vector<std::optional<IBox>> bounds_;
};

}  // namespace

int frameCount(const Document& document) {
    int last = 0;
    for (const SceneNode& node : document.nodes) {
        if (!node.placements.empty()) last = std::max(last, node.placements.back().frame);
        if (!node.models.empty()) last = std::max(last, node.models.back().frame);
    }
    return last + 1;
}

Placement placementAt(const SceneNode& node, int frame) {
    const int inTrack = frameInTrack(node.placements, frame, node.loopPlacements);
    const auto key = keyAt(node.placements, inTrack);
    Placement placement = key->placement;
    if (node.glides && key->frame < inTrack && key + 1 != node.placements.end()) {
        placement.translation = between(*key, *(key + 1), inTrack);
    }
    return placement;
}

bool movesBetweenKeys(const SceneNode& node) {
    return node.glides &&
           std::ranges::adjacent_find(node.placements, movesUntil) != node.placements.end();
}

int modelAt(const SceneNode& object, int frame) {
    return keyAt(object.models, frameInTrack(object.models, frame, object.loopModels))->model;
}

glm::dvec3 positionAt(const Socket& socket, int frame) {
    return keyAt(socket.positions, frame)->positionVoxels;
}

std::vector<Instance> instancesOf(const Document& document, int frame, bool includeHidden) {
    struct Open {
        int node;
        Placement entityFromParent;
    };
    std::vector<Instance> instances;
    std::vector<Open> open{{0, Placement{}}};  // a stack of its own: trees may be very deep
    while (!open.empty()) {
        const auto [index, entityFromParent] = open.back();
        open.pop_back();
        const SceneNode& node = document.nodes[static_cast<std::size_t>(index)];
        if (!includeHidden && isHidden(document, node)) continue;
        const Placement entityFromNode = entityFromParent * placementAt(node, frame);
        if (!node.isGroup()) instances.push_back({index, modelAt(node, frame), entityFromNode});
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
            open.push_back({*child, entityFromNode});
        }
    }
    return instances;
}

IBox frameBounds(const Document& document, int frame) {
    return ModelBounds(document).ofFrame(frame);
}

IBox entityBounds(const Document& document) {
    ModelBounds bounds(document);
    IBox box;
    for (const int frame : distinctFrames(document)) box = box.united(bounds.ofFrame(frame));
    return box;
}

IBox nodeBounds(const Document& document, int node, int frame) {
    struct Open {
        int node;
        Placement topFromParent;
    };
    IBox box;
    std::vector<Open> open{{node, Placement{}}};
    while (!open.empty()) {
        const auto [index, topFromParent] = open.back();
        open.pop_back();
        const SceneNode& next = document.nodes[static_cast<std::size_t>(index)];
        const Placement topFromNode = topFromParent * placementAt(next, frame);
        if (!next.isGroup()) {
            const auto model = static_cast<std::size_t>(modelAt(next, frame));
            box = box.united(topFromNode.applyToBox(document.models[model].voxels.bounds()));
        }
        for (const int child : next.children) open.push_back({child, topFromNode});
    }
    return box;
}

glm::dvec3 anchorVoxels(const Entity& entity, const IBox& bounds) {
    if (entity.anchorVoxels) return *entity.anchorVoxels;
    if (bounds.empty()) return glm::dvec3(0.0);
    const glm::dvec3 low(bounds.min);
    const glm::dvec3 high(bounds.max);
    return {(low.x + high.x) / 2.0, (low.y + high.y) / 2.0, low.z};
}

VoxelGrid flatten(const Document& document, int frame) {
    const std::vector<Instance> instances = instancesOf(document, frame);
    const auto voxelsOf = [&](const Instance& instance) -> const VoxelGrid& {
        return document.models[static_cast<std::size_t>(instance.model)].voxels;
    };
    VoxelGrid flat;
    auto next = instances.begin();
    if (next != instances.end() && next->entityFromModel == Placement{}) {
        flat = voxelsOf(*next++);  // nothing lies below it and it stays where it is
    }
    for (; next != instances.end(); ++next) {
        const Placement& entityFromModel = next->entityFromModel;
        voxelsOf(*next).forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            flat.set(entityFromModel.applyToVoxel(v), value);
        });
    }
    return flat;
}

EntitySampler::EntitySampler(const Document& document, int frame)
    : document_(&document), instances_(instancesOf(document, frame)) {
    for (const Instance& instance : instances_) {
        modelFromEntity_.push_back(instance.entityFromModel.inverse());
    }
}

std::uint8_t EntitySampler::at(glm::ivec3 entityVoxel) const {
    for (std::size_t i = instances_.size(); i-- > 0;) {
        const auto model = static_cast<std::size_t>(instances_[i].model);
        const std::uint8_t value =
            document_->models[model].voxels.get(modelFromEntity_[i].applyToVoxel(entityVoxel));
        if (value != 0) return value;
    }
    return 0;
}

}  // namespace voxprite
