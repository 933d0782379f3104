// The game profile beside the document: what is saved with which of them.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "core/edit/make_action.h"
#include "core/io/formats.h"
#include "core/io/profile_json.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

class ProfileBeside : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(saveDocument(folder / "hut.voxprite", test::documentOf(test::figure()), {}));
        ASSERT_TRUE(session.open(folder / "hut.voxprite"));
    }
    template <class Change>
    void change(const Change& change) {
        GameProfile after = session.profile();
        change(after);
        ASSERT_TRUE(session.perform(makeAction("p", ProfileEdit{session.profile(), after})));
    }
    void changeLight() {
        change([](GameProfile& profile) { profile.light.ambient *= 0.5; });
    }
    void changeSigma() {
        change([](GameProfile& profile) { profile.sigma += 1.0; });
    }

    test::TemporaryFolder folder;
    Session session;
};

TEST_F(ProfileBeside, ADocumentsFileKeepsVoxelSizeAndSigmaAlone) {
    changeSigma();
    EXPECT_TRUE(session.profileUnsaved());
    EXPECT_FALSE(session.profileHasUnsavedOfItsOwn());
    ASSERT_TRUE(session.saveAs(folder / "hut.voxprite"));
    EXPECT_FALSE(session.profileUnsaved());

    changeLight();
    ASSERT_TRUE(session.saveAs(folder / "hut.voxprite"));
    EXPECT_FALSE(session.unsaved());
    EXPECT_TRUE(session.profileHasUnsavedOfItsOwn());
    // Nor does another document bring the light along.
    ASSERT_TRUE(session.open(folder / "hut.voxprite"));
    EXPECT_TRUE(session.profileHasUnsavedOfItsOwn());
    ASSERT_TRUE(session.saveProfile(folder / "game.json"));
    EXPECT_FALSE(session.profileUnsaved());
}

TEST_F(ProfileBeside, LightAloneLeavesTheDocumentSaved) {
    changeLight();
    EXPECT_FALSE(session.unsaved());
    EXPECT_TRUE(session.profileUnsaved());
    // Nor does a save that comes to nothing change that.
    const auto saving = session.beginSaving(folder / "hut.voxprite");
    ASSERT_TRUE(saving);
    session.endSaving(*saving, fail("cancelled"));
    EXPECT_FALSE(session.unsaved());

    changeSigma();
    EXPECT_TRUE(session.unsaved()) << "it is in the document's file alone";
    ASSERT_TRUE(session.saveProfile(folder / "game.json"));
    EXPECT_FALSE(session.unsaved());
}

TEST_F(ProfileBeside, AnOpenedProfileLeavesTheDocumentSaved) {
    GameProfile game;
    game.sigma = 3.0;
    ASSERT_TRUE(writeProfileFile(folder / "game.json", game));
    ASSERT_TRUE(session.openProfile(folder / "game.json"));
    EXPECT_FALSE(session.unsaved());
    EXPECT_FALSE(session.profileUnsaved());
    ASSERT_TRUE(session.undo());
    EXPECT_FALSE(session.unsaved());
    EXPECT_TRUE(session.profileUnsaved());
}

TEST_F(ProfileBeside, NoticesWhatAnotherEditorDidToItsFile) {
    ASSERT_TRUE(session.saveProfile(folder / "game.json"));
    Session other;
    ASSERT_TRUE(other.openProfile(folder / "game.json"));
    EXPECT_FALSE(session.profileFile()->changedOutside());
    EXPECT_FALSE(other.profileFile()->changedOutside());
    changeLight();
    ASSERT_TRUE(session.saveProfile(folder / "game.json"));
    EXPECT_FALSE(session.profileFile()->changedOutside());
    EXPECT_TRUE(other.profileFile()->changedOutside());
    ASSERT_TRUE(other.openProfile(folder / "game.json"));
    EXPECT_FALSE(other.profileFile()->changedOutside());
}

TEST_F(ProfileBeside, AProfileWithAFileIsSavedThere) {
    ASSERT_TRUE(session.saveProfile(folder / "game.json"));
    changeSigma();
    ASSERT_TRUE(session.saveAs(folder / "hut.voxprite"));
    EXPECT_TRUE(session.profileHasUnsavedOfItsOwn());
}

TEST_F(ProfileBeside, IsRecoveredWithItsFile) {
    ASSERT_TRUE(session.saveProfile(folder / "game.json"));
    changeLight();
    Session other;
    ASSERT_TRUE(other.recover(folder / "hut.voxprite", session.profile(), session.file(),
                              session.profileFile()));
    EXPECT_EQ(other.profileFile(), session.profileFile());
    EXPECT_TRUE(other.profileUnsaved());
    ASSERT_TRUE(other.saveProfile(folder / "game.json"));
    Session same;
    ASSERT_TRUE(same.recover(folder / "hut.voxprite", session.profile(), std::nullopt,
                             session.profileFile()));
    EXPECT_FALSE(same.profileUnsaved());
}

}  // namespace
}  // namespace voxprite::editor
