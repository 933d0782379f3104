#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "core/svo/live_octree.h"
#include "core/svo/validate.h"
#include "tests/support/corpus.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using Edit = LiveOctree::Edit;

void expectIsBakeOf(const LiveOctree& live, const VoxelGrid& voxels) {
    const IBox bounds = voxels.bounds();
    const Status safe = validateOctree(live.view(bounds));
    EXPECT_TRUE(safe.has_value()) << safe.error().describe();
    EXPECT_EQ(live.canonical(bounds).value(), bake(voxels).value());
    EXPECT_EQ(live.solidCount(), voxels.solidCount());
}

// Real models, edited in and around their bounds and put back.
TEST(LiveOctreeCorpus, EditsAndTheirUndoKeepTheBake) {
    if (test::corpusNotice()) return;
    test::Random random(11);
    int models = 0;
    for (const auto& path : test::corpusFiles()) {
        const Result<VoxImport> import = readVox(readFile(path).value());
        if (!import) continue;
        SCOPED_TRACE(path.string());
        VoxelGrid voxels = flatten(import->document, 0);
        if (voxels.empty()) continue;
        ++models;
        const Octree start = bake(voxels).value();
        const Status valid = validateCanonical(start);
        EXPECT_TRUE(valid.has_value()) << valid.error().describe();
        EXPECT_EQ(toVoxels(start), voxels);
        LiveOctree live;
        ASSERT_TRUE(live.rebuild(voxels));

        const IBox around{voxels.bounds().min - 3, voxels.bounds().max + 3};
        std::vector<Edit> edits;
        std::vector<Edit> undo;
        for (int i = 0; i < 3000; ++i) {
            const glm::ivec3 v{random.between(around.min.x, around.max.x),
                               random.between(around.min.y, around.max.y),
                               random.between(around.min.z, around.max.z)};
            edits.push_back({v, static_cast<std::uint8_t>(random.between(0, 3))});
            undo.insert(undo.begin(), {v, voxels.get(v)});
            voxels.set(v, edits.back().material);
        }
        ASSERT_TRUE(live.apply(edits));
        expectIsBakeOf(live, voxels);
        ASSERT_TRUE(live.apply(undo));
        EXPECT_EQ(live.canonical({start.origin, start.origin + start.size}).value(), start);
    }
    EXPECT_GT(models, 10);
}

}  // namespace
}  // namespace voxprite
