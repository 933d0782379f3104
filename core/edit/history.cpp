#include "core/edit/history.h"

#include <algorithm>
#include <iterator>
#include <thread>
#include <type_traits>

#include "core/base/check.h"
#include "core/edit/action_parts.h"
#include "core/edit/voxel_changes.h"

namespace voxprite {

namespace {

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
            using Edit = std::decay_t<decltype(edit)>;
            if constexpr (std::is_same_v<Edit, VoxelPatch>) {
                mergeChanges(edit.changes, next.changes);
            } else {
                edit.after = std::move(next.after);
            }
            if constexpr (std::is_same_v<Edit, SceneEdit>) {
                edit.nodesAfter = nodesAfterBoth(edit.nodesAfter, next.nodesAfter);
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
    std::erase_if(step.parts,
                  [&](const ActionPart& part) { return changesNothing(workspace, part); });
    step.label = std::move(later.label);
}

void applyAll(Workspace& workspace, std::vector<ActionPart>& parts, Changed& changed) {
    for (ActionPart& part : parts) apply(workspace, part, changed);
}

void revertAll(Workspace& workspace, std::vector<ActionPart>& parts, Changed& changed) {
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        revert(workspace, *part, changed);
    }
}

// Does everybody go along? Else `takeBack(changed)` leads back to where they can.
template <class TakeBack>
bool isFollowed(const History::Follow& follow, const Changed& changed, const TakeBack& takeBack) {
    if (!follow || follow(changed)) return true;
    Changed back;
    takeBack(back);
    static_cast<void>(follow(back));
    return false;
}

// A step of very many voxels takes long to free: nobody waits for that.
void discard(std::vector<Action> steps) {
    constexpr std::size_t kMuch = std::size_t{8} << 20;
    std::size_t bytes = 0;
    for (const Action& step : steps) bytes += step.bytes();
    if (bytes > kMuch) std::thread([steps = std::move(steps)] {}).detach();
}

}  // namespace

SceneState sceneOf(const Document& document) {
    return {document.nodes, document.layers, document.clips};
}

Result<std::vector<VoxelPatch>> onePatch(Result<VoxelPatch> patch) {
    if (!patch) return Failure(patch.error());
    std::vector<VoxelPatch> patches;
    patches.push_back(std::move(*patch));
    return patches;
}

Status makeParts(Action& action, const Document& document) {
    const auto make = std::exchange(action.makePatches, {});
    if (!make) return {};
    Result<std::vector<VoxelPatch>> patches = make(document);
    if (!patches) return Failure(patches.error());
    for (VoxelPatch& patch : *patches) action.parts.emplace_back(std::move(patch));
    return {};
}

int Changed::nodeNow(int before) const {
    const auto index = static_cast<std::size_t>(before);
    if (before < 0 || nodesAfter.empty()) return before;
    return index < nodesAfter.size() ? nodesAfter[index] : -1;
}

Changed History::execute(Workspace& workspace, Action action, const Follow& follow) {
    VOXPRITE_CHECK(!action.makePatches);
    Changed changed;
    std::erase_if(action.parts, [&](ActionPart& part) {
        const bool does = recordBefore(workspace, part);
        if (does) apply(workspace, part, changed);
        return !does;
    });
    if (action.parts.empty()) return changed;
    const auto takeBack = [&](Changed& back) { revertAll(workspace, action.parts, back); };
    if (!isFollowed(follow, changed, takeBack)) return {};
    dropRedoable();
    record(workspace, std::move(action));
    dropOldest();
    return changed;
}

Changed History::undo(Workspace& workspace, const Follow& follow) {
    Changed changed;
    if (!canUndo()) return changed;
    Action& step = steps_[position_ - 1];
    bytes_ -= step.bytes();
    revertAll(workspace, step.parts, changed);
    const auto takeBack = [&](Changed& back) { applyAll(workspace, step.parts, back); };
    const bool followed = isFollowed(follow, changed, takeBack);
    bytes_ += step.bytes();
    if (!followed) return {};
    --position_;
    return changed;
}

Changed History::redo(Workspace& workspace, const Follow& follow) {
    Changed changed;
    if (!canRedo()) return changed;
    Action& step = steps_[position_];
    bytes_ -= step.bytes();
    applyAll(workspace, step.parts, changed);
    const auto takeBack = [&](Changed& back) { revertAll(workspace, step.parts, back); };
    const bool followed = isFollowed(follow, changed, takeBack);
    bytes_ += step.bytes();
    if (!followed) return {};
    ++position_;
    return changed;
}

bool History::differsFromSaved(const std::function<bool(const ActionPart&)>& counts) const {
    if (savedPosition_ < 0) return true;
    const auto position = static_cast<long long>(position_);
    const auto [first, last] = std::minmax(savedPosition_, position);
    return std::any_of(steps_.begin() + first, steps_.begin() + last, [&](const Action& step) {
        return std::ranges::any_of(step.parts, std::cref(counts));
    });
}

void History::clear() {
    savedPosition_ = isSaved() ? 0 : -1;
    steps_.clear();
    position_ = 0;
    bytes_ = 0;
}

void History::dropRedoable() {
    std::vector<Action> dropped;
    while (canRedo()) {
        bytes_ -= steps_.back().bytes();
        dropped.push_back(std::move(steps_.back()));
        steps_.pop_back();
    }
    discard(std::move(dropped));
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
    discard({std::make_move_iterator(steps_.begin()),
             std::make_move_iterator(steps_.begin() + dropped)});
    steps_.erase(steps_.begin(), steps_.begin() + dropped);
    position_ -= count;
    savedPosition_ = savedPosition_ >= dropped ? savedPosition_ - dropped : -1;
}

}  // namespace voxprite
