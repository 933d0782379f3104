#include <gtest/gtest.h>

#include <fstream>

#include "app/editor/recovery/autosave.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

using test::must;
namespace fs = std::filesystem;

WorkCopy someWork() {
    WorkCopy copy;
    copy.document = test::busyDocument();
    copy.profile.sigma = 7.5;
    copy.file = KnownFile{"/somewhere/h\xFCt.voxprite",  // file names are bytes
                          FileStamp{66306, ~std::uint64_t{0}, 3, -4}};
    copy.title = "h\xFCt";
    copy.edits = 41;
    copy.profileFile = KnownFile{"/somewhere/g\xE4me.json"};
    return copy;
}

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(RecoveryFolder, WhatACrashLeavesComesBack) {
    const test::TemporaryFolder recovery;
    const WorkCopy copy = someWork();
    {
        RecoveryFolder folder = must(RecoveryFolder::create(recovery.path()));
        ASSERT_TRUE(folder.write(copy));
        EXPECT_TRUE(findLostWork(recovery.path()).empty()) << "its editor still runs";
    }
    const std::vector<LostWork> lost = findLostWork(recovery.path());
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(must(loadDocument(lost[0].document)).document.models, copy.document.models);
    EXPECT_EQ(must(readProfileFile(lost[0].profile)), copy.profile);
    EXPECT_EQ(lost[0].file, copy.file);
    EXPECT_EQ(lost[0].profileFile, copy.profileFile);
    EXPECT_EQ(lost[0].title, copy.title);
    EXPECT_EQ(lost[0].edits, copy.edits);
    const Image picture = must(readPngFile(lost[0].picture));
    EXPECT_GT(picture.width, 0);
    EXPECT_LE(std::max(picture.width, picture.height), kRecoveryPictureEdgePx);
    discard(lost[0]);
    EXPECT_TRUE(fs::is_empty(recovery.path()));
}

TEST(RecoveryFolder, HoldsOneCopyAndNoneOnceAllIsSaved) {
    const test::TemporaryFolder recovery;
    RecoveryFolder folder = must(RecoveryFolder::create(recovery.path()));
    const fs::path inside = fs::directory_iterator(recovery.path())->path();
    WorkCopy copy = someWork();
    ASSERT_TRUE(folder.write(copy));
    const std::size_t once = filesIn(inside);
    copy.edits = 42;
    ASSERT_TRUE(folder.write(copy));
    EXPECT_EQ(filesIn(inside), once);
    // The picture cannot be written over this: the copy before stays, and goes with the next.
    fs::create_directory(inside / "3.png");
    ASSERT_FALSE(folder.write(copy));
    EXPECT_EQ(filesIn(inside), once);
    ASSERT_TRUE(folder.write(copy));
    EXPECT_EQ(filesIn(inside), once);
    ASSERT_TRUE(folder.clear());
    EXPECT_EQ(filesIn(inside), 1U) << "the lock";
    folder.remove();
    EXPECT_TRUE(fs::is_empty(recovery.path()));
}

TEST(RecoveryFolder, RemainsWithoutAWholeCopyAreClearedAway) {
    const test::TemporaryFolder recovery;
    { const RecoveryFolder empty = must(RecoveryFolder::create(recovery.path())); }
    {
        RecoveryFolder folder = must(RecoveryFolder::create(recovery.path()));
        ASSERT_TRUE(folder.write(someWork()));
        for (const auto& entry : fs::recursive_directory_iterator(recovery.path())) {
            if (entry.path().filename() == "note.json") {
                std::ofstream(entry.path()) << "{\"number\": ";
            }
        }
    }
    EXPECT_TRUE(findLostWork(recovery.path()).empty());
    EXPECT_TRUE(fs::is_empty(recovery.path()));
    EXPECT_TRUE(findLostWork(recovery.path() / "nothing").empty());
}

TEST(RecoveryFolder, AnUnusableFolderIsAnError) {
    const test::TemporaryFolder recovery;
    std::ofstream(recovery.path() / "file") << "x";
    EXPECT_FALSE(RecoveryFolder::create(recovery.path() / "file"));
}

void attach(Session& session, int x) {
    const glm::ivec3 at{x, 0, 0};
    ASSERT_TRUE(session.perform(makeAction(
        "Attach", patchVoxels(session.document(), 0, std::span(&at, 1), EditMode::attach, 5))));
}

class AutosaveTest : public testing::Test {
  protected:
    // Time as the test says; until what runs behind it has ended.
    void pass(double seconds) {
        now_ += seconds;
        autosave_.update(session_, now_);
    }
    void waitForCopy(std::size_t position) {
        while (autosave_.copiedPosition() != position) {
            pass(0.0);
            ASSERT_FALSE(autosave_.takeProblem());
            std::this_thread::yield();
        }
    }

    test::TemporaryFolder recovery_;
    Session session_;
    Autosave autosave_{must(RecoveryFolder::create(recovery_.path())),
                       {.leastSeconds = 2.0, .restShare = 0.0}};
    double now_ = 100.0;
};

TEST_F(AutosaveTest, CopiesTheFirstChangeAtOnceAndTheNextAfterAWhile) {
    pass(1.0);
    EXPECT_FALSE(autosave_.copiedPosition()) << "nothing is unsaved";
    attach(session_, 0);
    pass(0.0);
    waitForCopy(1);
    attach(session_, 1);
    pass(1.9);
    pass(0.0);
    EXPECT_EQ(autosave_.copiedPosition(), 1U) << "too early";
    pass(0.2);
    waitForCopy(2);
    pass(60.0);
    EXPECT_EQ(autosave_.copiedPosition(), 2U);
}

TEST_F(AutosaveTest, WhatIsSavedNeedsNoCopy) {
    attach(session_, 0);
    pass(0.0);
    waitForCopy(1);
    ASSERT_TRUE(session_.saveAs(recovery_.path() / "work.voxprite"));
    pass(5.0);
    EXPECT_FALSE(autosave_.copiedPosition());
    autosave_.finish();
    EXPECT_EQ(filesIn(recovery_.path()), 1U) << "the saved file alone";
}

// It counts as saved from its beginning on.
TEST_F(AutosaveTest, WhatIsBeingWrittenKeepsItsCopy) {
    attach(session_, 0);
    pass(0.0);
    waitForCopy(1);
    const Session::Saving saving = must(session_.beginSaving(recovery_.path() / "work.voxprite"));
    ASSERT_FALSE(session_.unsaved());
    autosave_.update(session_, now_ += 5.0, true);
    EXPECT_EQ(autosave_.copiedPosition(), 1U);
    // What is changed meanwhile is copied.
    attach(session_, 1);
    autosave_.update(session_, now_ += 5.0, true);
    waitForCopy(2);
    session_.endSaving(saving, fail("disk full"));
    pass(5.0);
    EXPECT_EQ(autosave_.copiedPosition(), 2U);
}

TEST_F(AutosaveTest, RecoveredWorkIsUnsavedUnderItsOwnName) {
    attach(session_, 0);
    attach(session_, 3);
    ASSERT_TRUE(autosave_.copyNow(session_));
    const Document before = session_.document();
    Session other;
    const fs::path inside = [&] {
        for (const auto& entry : fs::recursive_directory_iterator(recovery_.path())) {
            if (entry.path().extension() == ".voxprite") return entry.path();
        }
        return fs::path();
    }();
    GameProfile profile;
    profile.sigma = 3.0;
    ASSERT_TRUE(other.recover(inside, profile, KnownFile{"/home/me/hut.voxprite"}));
    EXPECT_EQ(other.document().models, before.models);
    EXPECT_EQ(other.profile(), profile);
    EXPECT_TRUE(other.unsaved());
    EXPECT_EQ(other.path(), fs::path("/home/me/hut.voxprite"));
    EXPECT_EQ(other.title(), "hut");
}

// An editor with files of its own that crashes.
class AutosaveOfFiles : public testing::Test {
  protected:
    void SetUp() override {
        attach(session_, 0);
        ASSERT_TRUE(session_.saveAs(hut_));
        ASSERT_TRUE(session_.saveProfile(game_));
    }
    void changeLight() {
        GameProfile after = session_.profile();
        after.light.ambient *= 0.5;
        ASSERT_TRUE(session_.perform(makeAction("Light", ProfileEdit{{}, after})));
    }
    [[nodiscard]] Autosave newAutosave() const {
        return Autosave(must(RecoveryFolder::create(recovery_.path())));
    }
    [[nodiscard]] LostWork lost() const { return findLostWork(recovery_.path()).at(0); }

    test::TemporaryFolder recovery_, folder_;
    fs::path hut_ = folder_ / "hut.voxprite", game_ = folder_ / "game.json";
    Session session_;
};

TEST_F(AutosaveOfFiles, RecoveredWorkNoticesWhatBecameOfItsFiles) {
    attach(session_, 1);
    ASSERT_TRUE(newAutosave().copyNow(session_));
    const LostWork work = lost();
    const auto recover = [&](Session& session) {
        return session.recover(work.document, must(readProfileFile(work.profile)), work.file,
                               work.profileFile);
    };
    Session same;
    ASSERT_TRUE(recover(same));
    EXPECT_FALSE(same.file()->changedOutside());
    EXPECT_FALSE(same.profileFile()->changedOutside());

    for (const fs::path& path : {hut_, game_}) {
        ASSERT_TRUE(writeFileAtomically(path, must(readFile(path))));
    }
    Session later;
    ASSERT_TRUE(recover(later));
    EXPECT_TRUE(later.file()->changedOutside());
    EXPECT_TRUE(later.profileFile()->changedOutside());
}

// The document is saved under another name, and something is still unsaved.
TEST_F(AutosaveOfFiles, TheCopyFollowsTheWorkIntoAnotherFile) {
    changeLight();
    {
        Autosave autosave = newAutosave();
        ASSERT_TRUE(autosave.copyNow(session_));
        ASSERT_TRUE(session_.saveAs(folder_ / "other.voxprite"));
        ASSERT_TRUE(session_.profileUnsaved());
        autosave.update(session_, 100.0);
    }
    EXPECT_EQ(lost().file, session_.file());
    EXPECT_EQ(lost().profileFile, session_.profileFile());
}

}  // namespace
}  // namespace voxprite::editor
