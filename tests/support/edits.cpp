#include "tests/support/edits.h"

#include <gtest/gtest.h>

namespace voxprite::test {

Document after(const Document& document, Action action) {
    Workspace workspace{document, {}};
    History history;
    static_cast<void>(history.execute(workspace, std::move(action)));
    const Status valid = validate(workspace.document);
    EXPECT_TRUE(valid) << valid.error().message;
    const Document result = workspace.document;
    static_cast<void>(history.undo(workspace));
    EXPECT_EQ(workspace.document, document);
    return result;
}

VoxelMap afterPatch(const Document& document, const VoxelPatch& patch) {
    VoxelGrid voxels = document.models[0].voxels;
    for (const VoxelChange& change : patch.changes) {
        EXPECT_EQ(voxels.get(change.position), change.before);
        voxels.set(change.position, change.after);
    }
    return mapOf(voxels);
}

}  // namespace voxprite::test
