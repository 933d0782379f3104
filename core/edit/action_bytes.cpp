// How much memory a step holds, for the history's limit: what lies on the heap, about.
#include "core/edit/history.h"

namespace voxprite {

namespace {

std::size_t heapBytes(const std::string& text) {
    return text.capacity() > 15 ? text.capacity() : 0;  // short ones lie in the object itself
}

std::size_t heapBytes(const Properties& properties) {
    constexpr std::size_t kTreeNode = 32;
    std::size_t bytes = 0;
    for (const auto& [key, value] : properties) {
        bytes += kTreeNode + 2 * sizeof(std::string) + heapBytes(key) + heapBytes(value);
    }
    return bytes;
}

std::size_t heapBytes(const Boxed<Palette>& palette) {
    std::size_t bytes = sizeof(Palette);
    for (const std::string& name : palette->names) bytes += heapBytes(name);
    for (const Properties& material : palette->materials) bytes += heapBytes(material);
    for (const PaletteRamp& ramp : palette->ramps) {
        bytes += sizeof(ramp) + heapBytes(ramp.name) + ramp.indices.capacity();
    }
    for (const PaletteVariant& variant : palette->variants) {
        constexpr std::size_t kOverride = 48;  // a tree's node with its pair
        bytes += sizeof(variant) + heapBytes(variant.name) + variant.overrides.size() * kOverride;
    }
    return bytes;
}

std::size_t heapBytes(const SceneNode& node) {
    return sizeof(node) + heapBytes(node.name) + heapBytes(node.attributes) +
           node.children.capacity() * sizeof(int) +
           node.placements.capacity() * sizeof(PlacementKey) +
           node.models.capacity() * sizeof(ModelKey);
}

std::size_t heapBytes(const SceneState& scene) {
    std::size_t bytes = 0;
    for (const SceneNode& node : scene.nodes) bytes += heapBytes(node);
    for (const Layer& layer : scene.layers) {
        bytes += sizeof(layer) + heapBytes(layer.name) + heapBytes(layer.attributes);
    }
    for (const Clip& clip : scene.clips) {
        bytes += sizeof(clip) + heapBytes(clip.name) +
                 clip.durationsMilliseconds.capacity() * sizeof(int);
    }
    return bytes;
}

std::size_t heapBytes(const std::vector<Socket>& sockets) {
    std::size_t bytes = 0;
    for (const Socket& socket : sockets) {
        bytes += sizeof(socket) + heapBytes(socket.name) +
                 socket.positions.capacity() * sizeof(SocketKey);
    }
    return bytes;
}

std::size_t heapBytes(const VoxelPatch& patch) {
    return patch.changes.capacity() * sizeof(VoxelChange);
}

std::size_t heapBytes(const PaletteEdit& edit) {
    return heapBytes(edit.before) + heapBytes(edit.after);
}

std::size_t heapBytes(const EntityEdit& edit) {
    return heapBytes(edit.before.name) + heapBytes(edit.after.name);
}

std::size_t heapBytes(const ProfileEdit&) {
    return 0;
}

std::size_t heapBytes(const SocketsEdit& edit) {
    return heapBytes(edit.before) + heapBytes(edit.after);
}

std::size_t heapBytes(const SceneEdit& edit) {
    std::size_t bytes =
        heapBytes(edit.before) + heapBytes(edit.after) + edit.nodesAfter.capacity() * sizeof(int);
    for (const Model& model : edit.addedModels) bytes += sizeof(model) + model.voxels.bytes();
    return bytes;
}

}  // namespace

std::size_t Action::bytes() const {
    std::size_t bytes = sizeof(Action) + heapBytes(label) + parts.capacity() * sizeof(ActionPart);
    for (const ActionPart& part : parts) {
        bytes += std::visit([](const auto& edit) { return heapBytes(edit); }, part);
    }
    return bytes;
}

}  // namespace voxprite
