#include "core/edit/action_parts.h"

#include <algorithm>
#include <iterator>

#include "core/base/check.h"
#include "core/edit/voxel_changes.h"

namespace voxprite {

namespace {

// So that stopping takes no longer than a few milliseconds.
constexpr std::size_t kVoxelsBetweenReports = 1 << 16;

void setScene(Document& document, const SceneState& scene) {
    document.nodes = scene.nodes;
    document.layers = scene.layers;
    document.clips = scene.clips;
}

Model& modelOf(Document& document, int model) {
    VOXPRITE_CHECK(model >= 0 && static_cast<std::size_t>(model) < document.models.size());
    return document.models[static_cast<std::size_t>(model)];
}

Changed::Voxels& voxelsOf(Changed& changed, const VoxelPatch& patch) {
    auto voxels = std::find_if(
        changed.voxels.begin(), changed.voxels.end(),
        [&](const Changed::Voxels& candidate) { return candidate.model == patch.model; });
    if (voxels == changed.voxels.end()) {
        voxels = changed.voxels.insert(voxels, Changed::Voxels{patch.model, {}});
    }
    return *voxels;
}

void noteVoxels(Changed& changed, const VoxelPatch& patch) {
    auto& positions = voxelsOf(changed, patch).positions;
    positions.reserve(positions.size() + patch.changes.size());
    for (const VoxelChange& change : patch.changes) positions.push_back(change.position);
}

// The operations, kind by kind.

bool recordBefore(Workspace& workspace, VoxelPatch& patch) {
    const VoxelGrid::Reader reader(modelOf(workspace.document, patch.model).voxels);
    patch.changes = uniqueChanges(std::move(patch.changes));
    for (VoxelChange& change : patch.changes) change.before = reader.get(change.position);
    dropUnchanged(patch.changes);
    return !patch.changes.empty();
}

void apply(Workspace& workspace, VoxelPatch& patch, Changed& changed) {
    VoxelGrid& voxels = modelOf(workspace.document, patch.model).voxels;
    for (const VoxelChange& change : patch.changes) voxels.set(change.position, change.after);
    noteVoxels(changed, patch);
}

void revert(Workspace& workspace, VoxelPatch& patch, Changed& changed) {
    VoxelGrid& voxels = modelOf(workspace.document, patch.model).voxels;
    for (const VoxelChange& change : patch.changes) voxels.set(change.position, change.before);
    noteVoxels(changed, patch);
}

bool changesNothing(const Workspace&, const VoxelPatch& patch) {
    return patch.changes.empty();
}

// Palette, entity, profile and sockets are each one value in the workspace, with one mark in
// Changed.
Palette& valueOf(Workspace& workspace, Changed& changed, const PaletteEdit&) {
    changed.palette = true;
    return workspace.document.palette;
}
Entity& valueOf(Workspace& workspace, Changed& changed, const EntityEdit&) {
    changed.entity = true;
    return workspace.document.entity;
}
GameProfile& valueOf(Workspace& workspace, Changed& changed, const ProfileEdit&) {
    changed.profile = true;
    return workspace.profile;
}
std::vector<Socket>& valueOf(Workspace& workspace, Changed& changed, const SocketsEdit&) {
    changed.sockets = true;
    return workspace.document.sockets;
}
const Palette& contentOf(const Boxed<Palette>& palette) {
    return *palette;
}
template <class Value>
const Value& contentOf(const Value& value) {
    return value;
}

template <class Edit>
bool recordBefore(Workspace& workspace, Edit& edit) {
    Changed unused;
    edit.before = valueOf(workspace, unused, edit);
    return !(edit.before == edit.after);
}

template <class Edit>
void apply(Workspace& workspace, Edit& edit, Changed& changed) {
    valueOf(workspace, changed, edit) = contentOf(edit.after);
}

template <class Edit>
void revert(Workspace& workspace, Edit& edit, Changed& changed) {
    valueOf(workspace, changed, edit) = contentOf(edit.before);
}

template <class Edit>
bool changesNothing(const Workspace&, const Edit& edit) {
    return edit.before == edit.after;
}

template <>
bool recordBefore(Workspace& workspace, SceneEdit& edit) {
    edit.before = sceneOf(workspace.document);
    edit.modelsBefore = workspace.document.models.size();
    return !(edit.before == edit.after) || !edit.addedModels.empty();
}

void noteScene(Changed& changed, const SceneEdit& edit, bool modelsChange) {
    const bool seen = modelsChange || !showsTheSame(edit.before, edit.after);
    (seen ? changed.scene : changed.notes) = true;
}

// The way back; nodes that the edit adds are gone.
std::vector<int> nodesBefore(const SceneEdit& edit) {
    if (edit.nodesAfter.empty()) return {};
    std::vector<int> before(edit.after.nodes.size(), -1);
    for (std::size_t i = 0; i < edit.nodesAfter.size(); ++i) {
        if (edit.nodesAfter[i] >= 0) {
            before[static_cast<std::size_t>(edit.nodesAfter[i])] = static_cast<int>(i);
        }
    }
    return before;
}

template <>
void apply(Workspace& workspace, SceneEdit& edit, Changed& changed) {
    std::vector<Model>& models = workspace.document.models;
    VOXPRITE_CHECK(models.size() == edit.modelsBefore);
    noteScene(changed, edit, !edit.addedModels.empty());
    std::move(edit.addedModels.begin(), edit.addedModels.end(), std::back_inserter(models));
    edit.addedModels.clear();
    changed.nodesAfter = nodesAfterBoth(std::move(changed.nodesAfter), edit.nodesAfter);
    setScene(workspace.document, edit.after);
}

template <>
void revert(Workspace& workspace, SceneEdit& edit, Changed& changed) {
    std::vector<Model>& models = workspace.document.models;
    const auto firstAdded = models.begin() + static_cast<std::ptrdiff_t>(edit.modelsBefore);
    std::move(firstAdded, models.end(), std::back_inserter(edit.addedModels));
    models.erase(firstAdded, models.end());
    changed.nodesAfter = nodesAfterBoth(std::move(changed.nodesAfter), nodesBefore(edit));
    setScene(workspace.document, edit.before);
    noteScene(changed, edit, !edit.addedModels.empty());
}

template <>
bool changesNothing(const Workspace& workspace, const SceneEdit& edit) {
    return edit.before == edit.after && workspace.document.models.size() == edit.modelsBefore;
}

}  // namespace

bool showsTheSame(const SceneState& a, const SceneState& b) {
    const auto sameLayer = [](const Layer& x, const Layer& y) { return x.hidden == y.hidden; };
    const auto sameNode = [](const SceneNode& x, const SceneNode& y) {
        return x.hidden == y.hidden && x.layer == y.layer && x.parent == y.parent &&
               x.children == y.children && x.placements == y.placements && x.models == y.models &&
               x.glides == y.glides && x.loopPlacements == y.loopPlacements &&
               x.loopModels == y.loopModels;
    };
    return std::ranges::equal(a.layers, b.layers, sameLayer) &&
           std::ranges::equal(a.nodes, b.nodes, sameNode);
}

std::vector<int> nodesAfterBoth(std::vector<int> first, const std::vector<int>& second) {
    if (first.empty()) return second;
    if (second.empty()) return first;
    for (int& node : first) {
        if (node < 0) continue;
        const auto index = static_cast<std::size_t>(node);
        node = index < second.size() ? second[index] : -1;
    }
    return first;
}

bool recordBefore(Workspace& workspace, ActionPart& part) {
    return std::visit([&](auto& edit) { return recordBefore(workspace, edit); }, part);
}

void apply(Workspace& workspace, ActionPart& part, Changed& changed) {
    std::visit([&](auto& edit) { apply(workspace, edit, changed); }, part);
}

void revert(Workspace& workspace, ActionPart& part, Changed& changed) {
    std::visit([&](auto& edit) { revert(workspace, edit, changed); }, part);
}

bool changesNothing(const Workspace& workspace, const ActionPart& part) {
    return std::visit([&](const auto& edit) { return changesNothing(workspace, edit); }, part);
}

bool setVoxels(Document& document, const VoxelPatch& patch, std::uint8_t VoxelChange::*value,
               Changed& changed, const Progress& progress) {
    static_cast<void>(voxelsOf(changed, patch));
    VoxelGrid& voxels = modelOf(document, patch.model).voxels;
    for (std::size_t i = 0; i < patch.changes.size(); ++i) {
        const VoxelChange& change = patch.changes[i];
        voxels.set(change.position, change.*value);
        const double share = static_cast<double>(i) / static_cast<double>(patch.changes.size());
        if (i % kVoxelsBetweenReports == 0 && !progress.reached(share)) return false;
    }
    return true;
}

}  // namespace voxprite
