// What edits make of a document, with what must hold for every edit checked on the way.
#pragma once

#include "core/edit/history.h"
#include "tests/support/voxels.h"

namespace voxprite::test {

// The document after an action, which must leave it valid and lead back when undone.
[[nodiscard]] Document after(const Document& document, Action action);
// The voxels of its first model after a patch, which must name what was there before.
[[nodiscard]] VoxelMap afterPatch(const Document& document, const VoxelPatch& patch);

}  // namespace voxprite::test
