// The scene that the sprite view draws: who is in it, and with whose voxels.
#include "app/editor/views/sprite_scene.h"

#include <algorithm>
#include <set>

#include "core/base/file.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/io/formats.h"
#include "core/io/svo_set.h"
#include "tests/render/gl_test.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

class EditorSpriteScene : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        ASSERT_TRUE(saveDocument(folder_ / "m.vox", test::documentOf(test::figure()), {}));
        ASSERT_TRUE(session_.open(folder_ / "m.vox"));
        edited_.emplace();
        scene_.emplace();
        settings_.copies.pattern = CopyPattern::grid;
        settings_.copies.count = 24;
    }
    void TearDown() override {
        scene_.reset();
        edited_.reset();
        GlTest::TearDown();
    }
    Scene made() {
        for (const Error& error : scene_->follow(session_, settings_)) {
            ADD_FAILURE() << error.describe();
        }
        histories_.resize(scene_->entityCount());
        return scene_->make(session_, *edited_, ViewSettings{}, session_.profile(), histories_);
    }
    std::set<const GpuOctree*> octrees() {
        std::set<const GpuOctree*> all;
        for (const SceneEntity& entity : made().entities) all.insert(entity.octree);
        return all;
    }
    void add(const VoxelGrid& voxels, const char* name) {
        ASSERT_TRUE(saveDocument(folder_ / name, test::documentOf(voxels), {}));
        settings_.extras.push_back({folder_ / name, true});
    }

    test::TemporaryFolder folder_;
    Session session_;
    SceneSettings settings_;
    std::optional<GpuOctree> edited_;
    std::optional<SpriteScene> scene_;
    std::vector<ViewHistory> histories_;
};

TEST_F(EditorSpriteScene, CopiesAreTheEditedModelAndFollowIt) {
    ASSERT_EQ(made().entities.size(), 25u);
    EXPECT_EQ(octrees(), std::set<const GpuOctree*>{&*edited_});
    const glm::ivec3 before = session_.bounds().size();
    const std::vector<glm::ivec3> far{session_.bounds().max + 3};
    ASSERT_TRUE(session_.perform(
        makeAction("a", patchVoxels(session_.document(), 0, far, EditMode::attach, 3))));
    const Scene after = made();
    for (const SceneEntity& entity : after.entities) {
        EXPECT_EQ(entity.placed.modelSize, before + 4);
        EXPECT_TRUE(validate(entity.placed));
    }
    // No two share what a view remembers.
    std::set<const ViewHistory*> histories;
    for (const SceneEntity& entity : after.entities) histories.insert(entity.history);
    EXPECT_EQ(histories.size(), after.entities.size());
}

TEST_F(EditorSpriteScene, ShadowsStayWhileAnEditIsOnlyShown) {
    const glm::ivec3 size = session_.bounds().size();
    const std::vector<glm::ivec3> far{session_.bounds().max + 3};
    ASSERT_TRUE(session_.preview({patchVoxels(session_.document(), 0, far, EditMode::attach, 3)}));
    const Scene scene = made();
    for (const SceneEntity& entity : scene.entities) {
        EXPECT_EQ(entity.placed.modelSize, size + 4);
        ASSERT_NE(entity.shadow, nullptr);
        EXPECT_EQ(entity.shadow->modelSize, size);
    }
}

TEST_F(EditorSpriteScene, ExtraModelsJoinPlayAndLeave) {
    ASSERT_NO_FATAL_FAILURE(add(test::asymmetric(), "letters.vox"));
    EXPECT_EQ(octrees().size(), 2u);
    settings_.copies.editedUsed = false;
    const Scene extras = made();
    EXPECT_EQ(extras.entities[0].octree, &*edited_);  // the edited model itself stays
    EXPECT_EQ(std::ranges::count(extras.entities, &*edited_, &SceneEntity::octree), 1);
    settings_.extras[0].used = false;  // nothing is left to copy but the edited model
    EXPECT_EQ(octrees(), std::set<const GpuOctree*>{&*edited_});

    // An animation shows its frames one after the other, and nothing else changes the picture.
    const Document animation = test::animationOf({test::figure(), test::asymmetric()});
    ASSERT_TRUE(saveDocument(folder_ / "moves.voxprite", animation, {}));
    settings_.extras = {{folder_ / "moves.voxprite", true}};
    const GpuOctree* first = made().entities.back().octree;
    EXPECT_TRUE(scene_->moves(settings_));
    const std::uint64_t revision = scene_->revision();
    scene_->advance(0.001, session_, settings_);
    EXPECT_EQ(scene_->revision(), revision);
    std::set<const GpuOctree*> seen{first};
    for (int step = 0; step < 40; ++step) {
        scene_->advance(0.05, session_, settings_);
        seen.insert(made().entities.back().octree);
    }
    EXPECT_EQ(seen.size(), 2u);
    EXPECT_GT(scene_->revision(), revision);

    settings_.copies.pattern = CopyPattern::none;
    EXPECT_EQ(made().entities.size(), 1u);
    EXPECT_FALSE(scene_->moves(settings_));
}

TEST_F(EditorSpriteScene, EntitiesOfOneFileJoinEachByItself) {
    const Document letters = test::documentOf(test::asymmetric());
    const Document box = test::documentOf(test::solidBox({2, 3, 4}));
    const GameProfile profile;
    const auto write = [&](const std::vector<SetMember>& members) {
        ASSERT_TRUE(writeFileAtomically(folder_ / "set.svo", test::must(exportSvoSet(members))));
    };
    const SetMember first{letters, profile, std::nullopt, "letters"};
    const SetMember second{box, profile, std::nullopt, "box"};
    write({first, second});
    const std::filesystem::path set = folder_ / "set.svo";
    settings_.extras = {{set, true, 0, "letters"}, {set, true, 1, "box"}};
    EXPECT_EQ(octrees().size(), 3u);
    settings_.extras.pop_back();
    EXPECT_EQ(octrees().size(), 2u);
    // Exported anew, the file has another entity there: that one is not taken for it.
    write({second, first});
    settings_.extras = {{set, true, 1, "box"}};
    const std::vector<Error> problems = scene_->follow(session_, settings_);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].describe().find("\"letters\" where \"box\" was"), std::string::npos)
        << problems[0].describe();
    settings_.extras = {{set, true, 0, "box"}};
    EXPECT_EQ(octrees().size(), 2u);
}

TEST_F(EditorSpriteScene, AFileThatCannotBeReadIsToldOnceAndOnlyWhenItIsWanted) {
    settings_.extras = {{folder_ / "none.vox", true}};
    settings_.copies.pattern = CopyPattern::none;
    EXPECT_TRUE(scene_->follow(session_, settings_).empty());
    settings_.copies.pattern = CopyPattern::crowd;
    const std::vector<Error> problems = scene_->follow(session_, settings_);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].describe().find("none.vox"), std::string::npos);
    EXPECT_TRUE(scene_->follow(session_, settings_).empty());
    EXPECT_EQ(octrees(), std::set<const GpuOctree*>{&*edited_});
}

TEST_F(EditorSpriteScene, OthersInTheSamePlacesAreAnotherArrangement) {
    settings_.copies.pattern = CopyPattern::crowd;
    static_cast<void>(made());
    const std::uint64_t first = scene_->arrangement();
    static_cast<void>(made());
    EXPECT_EQ(scene_->arrangement(), first);
    ++settings_.copies.seed;
    static_cast<void>(made());
    EXPECT_GT(scene_->arrangement(), first);
    settings_.copies.pattern = CopyPattern::march;
    static_cast<void>(made());
    const std::uint64_t march = scene_->arrangement();
    scene_->advance(0.25, session_, settings_);
    static_cast<void>(made());
    EXPECT_EQ(scene_->arrangement(), march);
}

TEST_F(EditorSpriteScene, TheMarchGoesOnAtItsPace) {
    settings_.copies.pattern = CopyPattern::march;
    const Scene before = made();
    const glm::dvec3 start = before.entities[1].placed.anchorMetres;
    const double height = session_.bounds().size().z * session_.profile().voxelSizeMetres;
    scene_->advance(0.25, session_, settings_);
    const Scene after = made();
    // The front is the -Y side: +Z of the world.
    EXPECT_NEAR(after.entities[1].placed.anchorMetres.z - start.z, 0.8 * height * 0.25, 1e-9);
    EXPECT_EQ(after.entities[1].placed.anchorMetres.x, start.x);
    EXPECT_EQ(after.entities[0].placed.anchorMetres, before.entities[0].placed.anchorMetres);
}

}  // namespace
}  // namespace voxprite::editor
