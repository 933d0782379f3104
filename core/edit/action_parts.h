// What each kind of part does to a workspace. Private to core/edit.
#pragma once

#include "core/base/progress.h"
#include "core/edit/history.h"

namespace voxprite {

// Notes in the part what is there now. Does the part change it?
[[nodiscard]] bool recordBefore(Workspace& workspace, ActionPart& part);
// Forth and back; `changed` is told.
void apply(Workspace& workspace, ActionPart& part, Changed& changed);
void revert(Workspace& workspace, ActionPart& part, Changed& changed);
// One after the other, as SceneEdit::nodesAfter.
[[nodiscard]] std::vector<int> nodesAfterBoth(std::vector<int> first,
                                              const std::vector<int>& second);
// Of a part in force.
[[nodiscard]] bool changesNothing(const Workspace& workspace, const ActionPart& part);

// Of a patch, the values before or after; `changed` is told of the model alone. False when stopped
// half-way.
[[nodiscard]] bool setVoxels(Document& document, const VoxelPatch& patch,
                             std::uint8_t VoxelChange::*value, Changed& changed,
                             const Progress& progress);

}  // namespace voxprite
