// Steps in two halves: worked out on a copy of the workspace, and put in force at once.
#include <utility>

#include "core/base/check.h"
#include "core/edit/action_parts.h"

namespace voxprite {

namespace {

Failure stopped() {
    return fail("stopped");
}

// Voxels are by far the most of what takes long; each part of `count` counts alike.
Progress shareOf(const Progress& progress, std::size_t part, std::size_t count) {
    const auto all = static_cast<double>(count);
    return progress.part(static_cast<double>(part) / all, static_cast<double>(part + 1) / all);
}

bool isVoxels(const ActionPart& part) {
    return std::holds_alternative<VoxelPatch>(part);
}

}  // namespace

Result<PreparedStep> History::prepare(const Workspace& workspace, Action action,
                                      const Progress& progress) {
    if (Status made = makeParts(action, workspace.document); !made) return Failure(made.error());
    if (!progress.reached(0.0)) return stopped();
    PreparedStep step{.way = PreparedStep::Way::execute, .workspace = workspace};
    std::vector<ActionPart> recorded;
    for (std::size_t i = 0; i < action.parts.size(); ++i) {
        ActionPart& part = action.parts[i];
        if (!recordBefore(step.workspace, part)) continue;
        if (!isVoxels(part)) {
            apply(step.workspace, part, step.changed);
        } else if (!setVoxels(step.workspace.document, std::get<VoxelPatch>(part),
                              &VoxelChange::after, step.changed,
                              shareOf(progress, i, action.parts.size()))) {
            return stopped();
        }
        recorded.push_back(std::move(part));
    }
    action.parts = std::move(recorded);
    step.action = std::move(action);
    return step;
}

Result<PreparedStep> History::prepareUndo(const Workspace& workspace,
                                          const Progress& progress) const {
    VOXPRITE_CHECK(canUndo());
    PreparedStep step{.way = PreparedStep::Way::undo, .workspace = workspace};
    const std::vector<ActionPart>& parts = steps_[position_ - 1].parts;
    for (std::size_t i = parts.size(); i-- > 0;) {
        const Progress share = shareOf(progress, parts.size() - 1 - i, parts.size());
        if (!isVoxels(parts[i])) {
            auto& [number, part] = step.parts.emplace_back(i, parts[i]);
            revert(step.workspace, part, step.changed);
        } else if (!setVoxels(step.workspace.document, std::get<VoxelPatch>(parts[i]),
                              &VoxelChange::before, step.changed, share)) {
            return stopped();
        }
    }
    return step;
}

Result<PreparedStep> History::prepareRedo(const Workspace& workspace,
                                          const Progress& progress) const {
    VOXPRITE_CHECK(canRedo());
    PreparedStep step{.way = PreparedStep::Way::redo, .workspace = workspace};
    const std::vector<ActionPart>& parts = steps_[position_].parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!isVoxels(parts[i])) {
            auto& [number, part] = step.parts.emplace_back(i, parts[i]);
            apply(step.workspace, part, step.changed);
        } else if (!setVoxels(step.workspace.document, std::get<VoxelPatch>(parts[i]),
                              &VoxelChange::after, step.changed,
                              shareOf(progress, i, parts.size()))) {
            return stopped();
        }
    }
    return step;
}

Changed History::commit(Workspace& workspace, PreparedStep step) {
    if (step.way == PreparedStep::Way::execute) {
        if (step.action.parts.empty()) return {};
        workspace = std::move(step.workspace);
        dropRedoable();
        record(workspace, std::move(step.action));
        dropOldest();
        return std::move(step.changed);
    }
    workspace = std::move(step.workspace);
    Action& recorded = steps_[step.way == PreparedStep::Way::undo ? --position_ : position_++];
    bytes_ -= recorded.bytes();
    for (auto& [number, part] : step.parts) recorded.parts[number] = std::move(part);
    bytes_ += recorded.bytes();
    return std::move(step.changed);
}

}  // namespace voxprite
