#include "core/edit/history.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "core/base/check.h"
#include "core/edit/voxel_changes.h"

namespace voxprite {

namespace {

// Do both look the same in every frame?
bool showsTheSame(const SceneState& a, const SceneState& b) {
    const auto sameLayer = [](const Layer& x, const Layer& y) { return x.hidden == y.hidden; };
    const auto sameNode = [](const SceneNode& x, const SceneNode& y) {
        return x.hidden == y.hidden && x.layer == y.layer && x.parent == y.parent &&
               x.children == y.children && x.placements == y.placements && x.models == y.models &&
               x.loopPlacements == y.loopPlacements && x.loopModels == y.loopModels;
    };
    return std::ranges::equal(a.layers, b.layers, sameLayer) &&
           std::ranges::equal(a.nodes, b.nodes, sameNode);
}

void setScene(Document& document, const SceneState& scene) {
    document.nodes = scene.nodes;
    document.layers = scene.layers;
    document.clips = scene.clips;
}

Model& modelOf(Document& document, int model) {
    VOXPRITE_CHECK(model >= 0 && static_cast<std::size_t>(model) < document.models.size());
    return document.models[static_cast<std::size_t>(model)];
}

void noteVoxels(Changed& changed, const VoxelPatch& patch) {
    auto voxels = std::find_if(
        changed.voxels.begin(), changed.voxels.end(),
        [&](const Changed::Voxels& candidate) { return candidate.model == patch.model; });
    if (voxels == changed.voxels.end()) {
        voxels = changed.voxels.insert(voxels, Changed::Voxels{patch.model, {}});
    }
    for (const VoxelChange& change : patch.changes) voxels->positions.push_back(change.position);
}

// The operations on one kind of part. `recordBefore` notes what is there now and says whether the
// part changes it; `apply` and `revert` go forth and back; `changesNothing` judges a part in force.

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

template <>
void apply(Workspace& workspace, SceneEdit& edit, Changed& changed) {
    std::vector<Model>& models = workspace.document.models;
    VOXPRITE_CHECK(models.size() == edit.modelsBefore);
    noteScene(changed, edit, !edit.addedModels.empty());
    std::move(edit.addedModels.begin(), edit.addedModels.end(), std::back_inserter(models));
    edit.addedModels.clear();
    setScene(workspace.document, edit.after);
}

template <>
void revert(Workspace& workspace, SceneEdit& edit, Changed& changed) {
    std::vector<Model>& models = workspace.document.models;
    const auto firstAdded = models.begin() + static_cast<std::ptrdiff_t>(edit.modelsBefore);
    std::move(firstAdded, models.end(), std::back_inserter(edit.addedModels));
    models.erase(firstAdded, models.end());
    setScene(workspace.document, edit.before);
    noteScene(changed, edit, !edit.addedModels.empty());
}

template <>
bool changesNothing(const Workspace& workspace, const SceneEdit& edit) {
    return edit.before == edit.after && workspace.document.models.size() == edit.modelsBefore;
}

// Do both parts change the same thing, so that one part can say what both did?
bool sameTarget(const ActionPart& a, const ActionPart& b) {
    if (a.index() != b.index()) return false;
    const auto* patch = std::get_if<VoxelPatch>(&a);
    return patch == nullptr || patch->model == std::get<VoxelPatch>(b).model;
}

// `later` was applied after `part`, both with the same target: the first before, the last after.
void mergePart(ActionPart& part, ActionPart&& later) {
    std::visit(
        [&](auto& edit) {
            auto& next = std::get<std::decay_t<decltype(edit)>>(later);
            if constexpr (std::is_same_v<std::decay_t<decltype(edit)>, VoxelPatch>) {
                mergeChanges(edit.changes, next.changes);
            } else {
                edit.after = std::move(next.after);
            }
        },
        part);
}

void mergeAction(const Workspace& workspace, Action& step, Action&& later) {
    for (ActionPart& part : later.parts) {
        const auto same =
            std::find_if(step.parts.begin(), step.parts.end(),
                         [&](const ActionPart& candidate) { return sameTarget(candidate, part); });
        if (same == step.parts.end()) {
            step.parts.push_back(std::move(part));
        } else {
            mergePart(*same, std::move(part));
        }
    }
    std::erase_if(step.parts, [&](const ActionPart& part) {
        return std::visit([&](const auto& edit) { return changesNothing(workspace, edit); }, part);
    });
    step.label = std::move(later.label);
}

}  // namespace

SceneState sceneOf(const Document& document) {
    return {document.nodes, document.layers, document.clips};
}

Changed History::execute(Workspace& workspace, Action action) {
    Changed changed;
    std::erase_if(action.parts, [&](ActionPart& part) {
        return std::visit(
            [&](auto& edit) {
                const bool does = recordBefore(workspace, edit);
                if (does) apply(workspace, edit, changed);
                return !does;
            },
            part);
    });
    if (!action.parts.empty()) {
        dropRedoable();
        record(workspace, std::move(action));
        dropOldest();
    }
    return changed;
}

Changed History::undo(Workspace& workspace) {
    Changed changed;
    if (!canUndo()) return changed;
    Action& step = steps_[--position_];
    bytes_ -= step.bytes();
    for (auto part = step.parts.rbegin(); part != step.parts.rend(); ++part) {
        std::visit([&](auto& edit) { revert(workspace, edit, changed); }, *part);
    }
    bytes_ += step.bytes();
    return changed;
}

Changed History::redo(Workspace& workspace) {
    Changed changed;
    if (!canRedo()) return changed;
    Action& step = steps_[position_++];
    bytes_ -= step.bytes();
    for (ActionPart& part : step.parts) {
        std::visit([&](auto& edit) { apply(workspace, edit, changed); }, part);
    }
    bytes_ += step.bytes();
    return changed;
}

void History::clear() {
    savedPosition_ = isSaved() ? 0 : -1;
    steps_.clear();
    position_ = 0;
    bytes_ = 0;
}

void History::dropRedoable() {
    while (canRedo()) {
        bytes_ -= steps_.back().bytes();
        steps_.pop_back();
    }
    if (savedPosition_ > static_cast<long long>(position_)) savedPosition_ = -1;
}

// `action` has been applied and no redoable step is left.
void History::record(const Workspace& workspace, Action action) {
    const bool merges = action.mergeKey != 0 && canUndo() && !isSaved() &&
                        steps_.back().mergeKey == action.mergeKey;
    if (!merges) {
        bytes_ += action.bytes();
        steps_.push_back(std::move(action));
        ++position_;
        return;
    }
    Action& step = steps_.back();
    bytes_ -= step.bytes();
    mergeAction(workspace, step, std::move(action));
    if (step.parts.empty()) {
        steps_.pop_back();
        --position_;
    } else {
        bytes_ += step.bytes();
    }
}

void History::dropOldest() {
    std::size_t count = 0;
    while (bytes_ > memoryLimitBytes_ && count + 1 < steps_.size()) {
        bytes_ -= steps_[count++].bytes();
    }
    const auto dropped = static_cast<long long>(count);
    steps_.erase(steps_.begin(), steps_.begin() + dropped);
    position_ -= count;
    savedPosition_ = savedPosition_ >= dropped ? savedPosition_ - dropped : -1;
}

}  // namespace voxprite
