// The coming edit is shown without being made: the shown octree is always what the document's would
// be with the patches in it, and never touches the document's own.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "app/editor/views/onion_skin.h"
#include "core/edit/frame_edits.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/edit/scene_edits.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "tests/render/gl_test.h"
#include "tests/support/must.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace voxprite::editor {
namespace {

void expectShows(const Session& session, const VoxelGrid& expected) {
    const IBox bounds = session.shownBounds();
    const Result<Octree> shown = session.shownOctree().canonical(bounds);
    const Result<Octree> baked = bake(expected, bounds);
    ASSERT_TRUE(shown && baked);
    EXPECT_EQ(shown->nodes, baked->nodes);
    EXPECT_EQ(shown->payloads, baked->payloads);
}

VoxelPatch randomPatch(const Document& document, int model, test::Random& random) {
    std::vector<glm::ivec3> positions;
    for (int n = random.between(1, 60); n > 0; --n) positions.push_back(random.voxel(-6, 9));
    const auto mode = static_cast<EditMode>(random.between(0, 2));
    return patchVoxels(document, model, positions, mode,
                       static_cast<std::uint8_t>(random.between(1, 9)));
}

VoxelGrid flattenWith(Document document, const std::vector<VoxelPatch>& patches, int frame) {
    for (const VoxelPatch& patch : patches) {
        VoxelGrid& voxels = document.models[static_cast<std::size_t>(patch.model)].voxels;
        for (const VoxelChange& change : patch.changes) voxels.set(change.position, change.after);
    }
    return flatten(document, frame);
}

TEST(EditorPreview, ShownIsWhatTheDocumentWouldBe) {
    // Two models under three objects that overlap, one of them shared and mirrored.
    Session session;
    test::Random random(11);
    ASSERT_TRUE(session.perform(addObject(session.document(), "second")));
    SceneEdit edit{sceneOf(session.document()), sceneOf(session.document()), 2, {}};
    SceneNode copy = edit.after.nodes[1];
    copy.placements[0].placement = {{{0, 1, 2}, {-1, 1, 1}}, {4, 2, 1}};
    edit.after.nodes.push_back(copy);
    edit.after.nodes[0].children.push_back(static_cast<int>(edit.after.nodes.size()) - 1);
    ASSERT_TRUE(session.perform(makeAction("share", edit)));

    const std::size_t firstEdit = session.history().position();
    for (int round = 0; round < 200; ++round) {
        const Document before = session.document();
        std::vector<VoxelPatch> patches;
        for (int model = 0; model < 2; ++model) {
            if (random.between(0, 3) != 0) {
                patches.push_back(randomPatch(session.document(), model, random));
            }
        }
        ASSERT_TRUE(session.preview(patches));
        ASSERT_NO_FATAL_FAILURE(expectShows(session, flattenWith(before, patches, 0)));
        ASSERT_EQ(session.document(), before);
        ASSERT_EQ(session.bounds(), entityBounds(before));

        switch (random.between(0, 4)) {
            case 0:
                session.clearPreview();
                break;
            case 1:  // what was shown is done
                for (VoxelPatch& patch : patches) {
                    ASSERT_TRUE(session.perform(makeAction("done", std::move(patch))));
                }
                break;
            case 2:  // something else is done
                ASSERT_TRUE(session.perform(
                    makeAction("other", randomPatch(session.document(), 1, random))));
                break;
            case 3:
                if (session.history().position() > firstEdit) {
                    ASSERT_TRUE(session.undo());
                }
                break;
            default:  // straight to the next preview
                continue;
        }
        if (session.previews()) continue;  // nothing was changed, so it goes on
        ASSERT_NO_FATAL_FAILURE(expectShows(session, flatten(session.document(), 0)));
        ASSERT_EQ(session.shownBounds(), session.bounds());
    }
}

TEST(EditorPreview, TheSpriteStaysOnItsAnchor) {
    Session session;
    const std::vector<glm::ivec3> first{{3, 4, 5}, {4, 4, 5}}, second{{-20, 4, 1}};
    ASSERT_TRUE(session.perform(
        makeAction("a", patchVoxels(session.document(), 0, first, EditMode::attach, 3))));
    // The corner of entity voxel (3,4,5), wherever the bounds begin.
    const auto place = [&](const PlacedEntity& placed) {
        return placed.worldFromVoxel(glm::dvec3(glm::ivec3(3, 4, 5) - session.shownBounds().min));
    };
    const glm::dvec3 inGame = place(session.placedInGame());
    const glm::dvec3 edited = place(session.placedForEditing());
    ASSERT_TRUE(session.preview({patchVoxels(session.document(), 0, second, EditMode::attach, 3)}));
    EXPECT_EQ(session.shownBounds(), (IBox{{-20, 4, 1}, {5, 5, 6}}));
    EXPECT_LT(glm::length(place(session.placedInGame()) - inGame), 1e-12);
    EXPECT_EQ(place(session.placedForEditing()), edited);
}

TEST(EditorPreview, WhatNoOctreeHoldsIsRefusedAndShowsTheDocument) {
    Session session;
    const std::vector<glm::ivec3> near{{0, 0, 0}}, next{{1, 0, 0}}, far{{200'000, 0, 0}};
    const auto patch = [&](const std::vector<glm::ivec3>& where) {
        return patchVoxels(session.document(), 0, where, EditMode::attach, 3);
    };
    ASSERT_TRUE(session.perform(makeAction("a", patch(near))));
    ASSERT_TRUE(session.preview({patch(next)}));
    const Status refused = session.preview({patch(far)});
    ASSERT_FALSE(refused);
    EXPECT_FALSE(refused.error().message.empty());
    EXPECT_FALSE(session.previews());
    expectShows(session, flatten(session.document(), 0));
}

TEST(EditorPreview, UploadsOnlyWhatDiffers) {
    Session session;
    ASSERT_TRUE(session.perform(makeAction(
        "a", patchBox(session.document(), 0, {{0, 0, 0}, {40, 40, 40}}, EditMode::attach, 3))));
    static_cast<void>(session.takeOctreeChanges());
    const std::vector<glm::ivec3> where{{7, 7, 40}};
    ASSERT_TRUE(session.preview({patchVoxels(session.document(), 0, where, EditMode::attach, 3)}));
    const OctreeChanges changes = session.takeOctreeChanges();
    EXPECT_FALSE(changes.everything);
    std::uint64_t words = 0;
    for (const ArrayRange& range : changes.nodes) words += range.count;
    EXPECT_GT(words, 0u);
    EXPECT_LT(words, 200u);
    // The same again is no change at all.
    ASSERT_TRUE(session.preview({patchVoxels(session.document(), 0, where, EditMode::attach, 3)}));
    EXPECT_FALSE(session.takeOctreeChanges().any());
}

class EditorPreviewOverOnionSkin : public test::GlTest {};

TEST_F(EditorPreviewOverOnionSkin, LeavesTheFramesBesideAsTheyAre) {
    Session session;
    const auto attach = [&](const IBox& box) {
        return patchBox(session.document(), 0, box, EditMode::attach, 5);
    };
    ASSERT_TRUE(session.perform(makeAction("a box", attach({{0, 0, 0}, {4, 4, 4}}))));
    ASSERT_TRUE(session.perform(test::must(addFrame(session.document(), 1, 0, NewFrame::copy))));
    OnionSkin skin;
    const auto beside = [&] { return test::must(skin.ghosts(session, true)).at(0).octree; };
    const std::uint64_t before = beside()->revision();

    ASSERT_TRUE(session.preview({attach({{6, 0, 0}, {9, 4, 4}})}));
    ASSERT_NE(session.shownBounds(), session.bounds());
    EXPECT_EQ(beside()->revision(), before);
    EXPECT_EQ(beside()->size(), session.bounds().size());
    // Until it is made.
    ASSERT_TRUE(session.perform(makeAction("more", attach({{6, 0, 0}, {9, 4, 4}}))));
    EXPECT_NE(beside()->revision(), before);
    EXPECT_EQ(beside()->size(), session.bounds().size());
}

}  // namespace
}  // namespace voxprite::editor
