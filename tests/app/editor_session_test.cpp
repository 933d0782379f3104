// The session without a window: whatever is done to it, what is derived agrees with the document.
#include "app/editor/session/session.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/file.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/edit/scene_edits.h"
#include "core/io/formats.h"
#include "core/io/profile_json.h"
#include "core/io/svo_set.h"
#include "core/svo/bake.h"
#include "tests/support/must.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

using test::Random;

// One model seen twice, the second time turned, mirrored and moved, and shown differently from
// frame 3 on; a second model over it.
Document twistedDocument() {
    Document document = Document::withEmptyModel();
    document.models[0].voxels.fill({{0, 0, 0}, {4, 3, 2}}, 7);
    document.models.emplace_back();
    document.models[1].voxels.fill({{-1, -1, -1}, {1, 1, 1}}, 9);
    SceneNode mirrored = document.nodes[1];
    mirrored.placements = {PlacementKey{0, {{{1, 0, 2}, {-1, 1, 1}}, {9, -4, 2}}},
                           PlacementKey{3, {{{2, 1, 0}, {1, -1, 1}}, {-8, 6, 5}}}};
    SceneNode over = document.nodes[1];
    over.models = {ModelKey{0, 1}};
    over.placements = {PlacementKey{0, {{}, {2, 1, 1}}}};
    for (SceneNode* node : {&mirrored, &over}) {
        node->parent = 0;
        document.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
        document.nodes.push_back(*node);
    }
    return document;
}

void expectConsistent(const Session& session) {
    const Document& document = session.document();
    ASSERT_EQ(session.bounds(), entityBounds(document));
    const Result<Octree> baked = bake(flatten(document, session.frame()), session.bounds());
    ASSERT_TRUE(baked) << baked.error().describe();
    const Result<Octree> live = session.octree().canonical(session.bounds());
    ASSERT_TRUE(live) << live.error().describe();
    ASSERT_EQ(*live, *baked);
}

void open(Session& session, const Document& document, const test::TemporaryFolder& folder) {
    ASSERT_TRUE(saveDocument(folder / "start.voxprite", document, GameProfile{}));
    const Status opened = session.open(folder / "start.voxprite");
    ASSERT_TRUE(opened) << opened.error().describe();
}

Action randomEdit(const Session& session, Random& random) {
    const int model = random.between(0, 1);
    const auto mode = static_cast<EditMode>(random.between(0, 2));
    const auto colour = static_cast<std::uint8_t>(random.between(1, 255));
    if (random.chance(0.3)) {
        const IBox box = IBox::around(random.voxel(-6, 6), random.voxel(-6, 6));
        return makeAction("box", patchBox(session.document(), model, box, mode, colour));
    }
    std::vector<glm::ivec3> positions;
    for (int i = random.between(1, 9); i > 0; --i) positions.push_back(random.voxel(-6, 6));
    return makeAction("voxels", patchVoxels(session.document(), model, positions, mode, colour));
}

TEST(EditorSession, StartsEmptyAndSaved) {
    const Session session;
    EXPECT_TRUE(session.bounds().empty());
    EXPECT_EQ(session.octree().solidCount(), 0u);
    EXPECT_FALSE(session.unsaved());
    EXPECT_EQ(session.title(), "Untitled");
    EXPECT_TRUE(session.activeInstance().has_value());
}

TEST(EditorSession, LiveOctreeAndBoundsFollowRandomEditsOfSharedMirroredModels) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    ASSERT_EQ(session.frames(), 4);
    const Document start = session.document();
    Random random(41);
    for (int i = 0; i < 150; ++i) {
        if (random.chance(0.15)) {
            ASSERT_TRUE(session.setFrame(random.between(0, 3)));
        } else if (random.chance(0.2)) {
            ASSERT_TRUE(random.chance(0.5) ? session.undo() : session.redo());
        } else {
            ASSERT_TRUE(session.perform(randomEdit(session, random)));
        }
        ASSERT_NO_FATAL_FAILURE(expectConsistent(session)) << "step " << i;
    }
    while (session.history().canUndo()) ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.document().models, start.models);
    expectConsistent(session);
}

TEST(EditorSession, SceneEditsKeepTheDocumentValidAndUndo) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    const Document start = session.document();
    ASSERT_TRUE(session.perform(addObject(session.document(), "hat")));
    ASSERT_TRUE(session.perform(duplicateNode(session.document(), 2, Copy::own)));
    ASSERT_TRUE(session.perform(setHidden(session.document(), 1, true)));
    ASSERT_TRUE(session.perform(moveObject(session.document(), 3, {5, 5, 5}, 0)));
    ASSERT_TRUE(session.perform(deleteNodes(session.document(), std::array{1})));
    ASSERT_TRUE(session.perform(rename(session.document(), 1, "left")));
    const Status valid = validate(session.document());
    EXPECT_TRUE(valid) << valid.error().describe();
    EXPECT_EQ(session.document().nodes.size(), start.nodes.size() + 1);
    expectConsistent(session);
    while (session.history().canUndo()) {
        ASSERT_TRUE(session.undo());
        expectConsistent(session);
    }
    EXPECT_EQ(session.document(), start);
}

TEST(EditorSession, ActiveObjectIsAlwaysAnObjectWhileThereIsOne) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    session.setActiveNode(3);
    EXPECT_EQ(session.activeNode(), 3);
    session.setActiveNode(0);  // the root is a group
    EXPECT_FALSE(
        session.document().nodes[static_cast<std::size_t>(session.activeNode())].isGroup());
    for (int left = 3; left > 0; --left) {
        ASSERT_TRUE(session.perform(deleteNodes(session.document(), std::array{1})));
    }
    EXPECT_EQ(session.activeNode(), -1);
    EXPECT_FALSE(session.activeInstance().has_value());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.activeNode(), 1);
}

TEST(EditorSession, TopmostObjectOwnsAVoxel) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    EXPECT_EQ(session.nodeAt({0, 0, 0}), 1);
    EXPECT_EQ(session.nodeAt({2, 1, 1}), 3);  // drawn over object 1
    EXPECT_EQ(session.nodeAt({100, 0, 0}), -1);
    ASSERT_TRUE(session.perform(setHidden(session.document(), 3, true)));
    EXPECT_EQ(session.nodeAt({2, 1, 1}), 1);
}

TEST(EditorSession, WhatNoOctreeHoldsIsRefusedAndLeavesEverythingAsItWas) {
    Session session;
    const std::vector<glm::ivec3> near{{0, 0, 0}}, far{{200'000, 0, 0}};
    const auto attach = [&](const std::vector<glm::ivec3>& where) {
        return session.perform(
            makeAction("a", patchVoxels(session.document(), 0, where, EditMode::attach, 3)));
    };
    ASSERT_TRUE(attach(near));
    const Status refused = attach(far);
    ASSERT_FALSE(refused);
    EXPECT_FALSE(refused.error().message.empty());
    EXPECT_EQ(session.document().models[0].voxels.solidCount(), 1u);
    expectConsistent(session);
    // But what is small in the end may have come from anywhere.
    const VoxelPatch moved{0, {{near[0], 3, 0}, {far[0], 0, 3}}};
    ASSERT_TRUE(session.perform(makeAction("moved", moved)));
    EXPECT_EQ(session.document().models[0].voxels.get(far[0]), 3);
    expectConsistent(session);
    ASSERT_TRUE(session.undo());
    expectConsistent(session);
}

TEST(EditorSession, EditSpaceStandsStillWhileTheModelGrows) {
    Session session;
    const std::vector<glm::ivec3> first{{3, 4, 5}}, second{{-20, 4, 5}};
    const auto attach = [&](const std::vector<glm::ivec3>& where) {
        return session.perform(
            makeAction("a", patchVoxels(session.document(), 0, where, EditMode::attach, 3)));
    };
    // The corner of entity voxel (3,4,5), wherever the bounds begin.
    const auto place = [&] {
        return session.placedForEditing().worldFromVoxel(
            glm::dvec3(glm::ivec3(3, 4, 5) - session.bounds().min));
    };
    ASSERT_TRUE(attach(first));
    const glm::dvec3 before = place();
    EXPECT_EQ(before, worldFromVoxel(glm::dvec3(3, 4, 5)));
    ASSERT_TRUE(attach(second));
    EXPECT_EQ(place(), before);
}

TEST(EditorSession, RevisionsTellModelChangesFromOthers) {
    Session session;
    const auto model = session.modelRevision(), all = session.revision();
    GameProfile profile = session.profile();
    profile.sigma = 7.0;
    ASSERT_TRUE(session.perform(makeAction("sigma", ProfileEdit{session.profile(), profile})));
    EXPECT_EQ(session.modelRevision(), model);
    EXPECT_GT(session.revision(), all);
    Palette palette = session.document().palette;
    palette.colours[5] = Rgba8(1, 2, 3, 255);
    ASSERT_TRUE(session.perform(makeAction("p", PaletteEdit{session.document().palette, palette})));
    EXPECT_GT(session.modelRevision(), model);
}

// What is made of all frames stays while they are stepped through.
TEST(EditorSession, ContentsAreTheSameWhateverIsShownOfThem) {
    const test::TemporaryFolder folder;
    Document document = test::animationOf({test::solidBox({2, 2, 2}), test::solidBox({3, 1, 1})});
    document.palette.variants.push_back({"red", {{1, Rgba8(200, 0, 0, 255)}}});
    Session session;
    const std::uint64_t before = session.contentsRevision();
    open(session, document, folder);
    const std::uint64_t opened = session.contentsRevision(), model = session.modelRevision();
    EXPECT_GT(opened, before);
    ASSERT_TRUE(session.setFrame(1));
    session.showVariant(0);
    EXPECT_EQ(session.contentsRevision(), opened);
    EXPECT_GT(session.modelRevision(), model);
    const std::vector<glm::ivec3> where{{5, 5, 5}};
    ASSERT_TRUE(session.perform(
        makeAction("a", patchVoxels(session.document(), 0, where, EditMode::attach, 6))));
    EXPECT_GT(session.contentsRevision(), opened);
}

TEST(EditorSession, SavesNativelyAndKnowsWhatIsUnsaved) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    EXPECT_TRUE(session.hasNativePath());
    const std::vector<glm::ivec3> where{{30, 30, 30}};
    ASSERT_TRUE(session.perform(
        makeAction("a", patchVoxels(session.document(), 0, where, EditMode::attach, 6))));
    EXPECT_TRUE(session.unsaved());
    ASSERT_TRUE(session.saveAs(folder / "other.voxprite"));
    EXPECT_FALSE(session.unsaved());
    EXPECT_EQ(session.title(), "other");
    ASSERT_TRUE(session.undo());
    EXPECT_TRUE(session.unsaved());
    ASSERT_TRUE(session.redo());
    EXPECT_FALSE(session.unsaved());

    Session again;
    ASSERT_TRUE(again.open(folder / "other.voxprite"));
    EXPECT_EQ(again.document(), session.document());
}

TEST(EditorSession, NoticesWhatAnotherProgramDidToItsFile) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    EXPECT_FALSE(session.file()->changedOutside());
    const std::filesystem::path path = *session.path();
    const Bytes bytes = readFile(path).value();

    ASSERT_TRUE(writeFileAtomically(path, bytes));  // the same bytes in another file
    EXPECT_TRUE(session.file()->changedOutside());
    ASSERT_TRUE(session.saveAs(path));
    EXPECT_FALSE(session.file()->changedOutside());
    ASSERT_TRUE(session.open(path));
    EXPECT_FALSE(session.file()->changedOutside());
    std::filesystem::remove(path);  // nothing is there to be lost
    EXPECT_FALSE(session.file()->changedOutside());
}

TEST(EditorSession, ExportsHoldTheEditAndDoNotCountAsSaved) {
    const test::TemporaryFolder folder;
    Session session;
    const std::vector<glm::ivec3> where{{1, 2, 3}, {4, 2, 3}};
    ASSERT_TRUE(session.perform(
        makeAction("a", patchVoxels(session.document(), 0, where, EditMode::attach, 6))));
    ASSERT_TRUE(session.saveAs(folder / "out.svo"));
    EXPECT_TRUE(session.unsaved());
    EXPECT_FALSE(session.path().has_value());
    const Result<LoadedDocument> loaded = loadDocument(folder / "out.svo");
    ASSERT_TRUE(loaded) << loaded.error().describe();
    const VoxelGrid voxels = flatten(loaded->document, 0);
    EXPECT_EQ(voxels.solidCount(), 2u);
    const glm::ivec3 corner = voxels.bounds().min;
    EXPECT_EQ(voxels.get(corner), 6);
    EXPECT_EQ(voxels.get(corner + glm::ivec3(3, 0, 0)), 6);
}

TEST(EditorSession, ABrokenFileLeavesTheOpenDocumentAlone) {
    const test::TemporaryFolder folder;
    Session session;
    open(session, twistedDocument(), folder);
    const Document before = session.document();
    const Status missing = session.open(folder / "none.vox");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().describe().find("none.vox"), std::string::npos);
    EXPECT_EQ(session.document(), before);
    expectConsistent(session);
}

TEST(EditorSession, TheGamesProfileWinsOverAuthoredValues) {
    const test::TemporaryFolder folder;
    GameProfile authored;
    authored.sigma = 6.0;
    Document document = twistedDocument();
    document.authored = {0.25, 6.0};
    ASSERT_TRUE(saveDocument(folder / "a.voxprite", document, authored));

    Session free;
    ASSERT_TRUE(free.open(folder / "a.voxprite"));
    EXPECT_EQ(free.profile().sigma, 6.0);
    EXPECT_FALSE(free.profileUnsaved());

    GameProfile game;
    game.sigma = 3.0;
    ASSERT_TRUE(writeProfileFile(folder / "game.json", game));
    Session bound;
    ASSERT_TRUE(bound.openProfile(folder / "game.json"));
    EXPECT_FALSE(bound.unsaved());
    ASSERT_TRUE(bound.open(folder / "a.voxprite"));
    EXPECT_EQ(bound.profile().sigma, 3.0);
}

TEST(EditorSession, OneOfSeveralEntitiesHasItsOwnNameUntilItHasAFile) {
    const test::TemporaryFolder folder;
    const Document document = twistedDocument();
    const GameProfile profile;
    std::string longName(79, 'x');
    longName += "\u00e9";  // its second byte would be the 81st
    const std::vector<SetMember> members{{document, profile, std::nullopt, "knight"},
                                         {document, profile, std::nullopt, "../a:b"},
                                         {document, profile, std::nullopt, longName}};
    const std::filesystem::path set = folder / "set.svo";
    ASSERT_TRUE(writeFileAtomically(set, test::must(exportSvoSet(members))));
    const auto titleOf = [&](std::size_t entity) {
        Session session;
        ReadOptions options;
        options.entity = entity;
        const Status opened = session.open(set, options);
        EXPECT_TRUE(opened) << opened.error().describe();
        return session.title();
    };
    // A file can be called so.
    EXPECT_EQ(titleOf(1), "_._a_b");
    EXPECT_EQ(titleOf(2), std::string(79, 'x'));

    Session session;
    ReadOptions first;
    first.entity = 0;
    EXPECT_FALSE(session.open(set));  // which one?
    ASSERT_TRUE(session.open(set, first));
    EXPECT_EQ(session.title(), "knight");
    EXPECT_EQ(session.path(), set);
    EXPECT_FALSE(session.hasNativePath());
    ASSERT_TRUE(session.saveAs(folder / "mine.voxprite"));
    EXPECT_EQ(session.title(), "mine");
    // What a crash left of it is called as it was.
    Session recovered;
    ASSERT_TRUE(recovered.recover(folder / "mine.voxprite", profile, KnownFile{set}));
    EXPECT_EQ(recovered.title(), "knight");
    ASSERT_TRUE(recovered.startNew());
    EXPECT_EQ(recovered.title(), "Untitled");
}

}  // namespace
}  // namespace voxprite::editor
