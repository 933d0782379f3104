// Work behind the window, and opening and saving in their two halves.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"
#include "core/base/file.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

TEST(EditorBackgroundJob, WorksElsewhereAndEndsHere) {
    BackgroundJob job;
    EXPECT_FALSE(job.running());
    const auto here = std::this_thread::get_id();
    std::thread::id worked, ended;
    job.start("Thinking", [&](JobProgress& progress) -> BackgroundJob::Done {
        worked = std::this_thread::get_id();
        progress.enter("half-way", 0.5);
        return [&] { ended = std::this_thread::get_id(); };
    });
    EXPECT_TRUE(job.running());
    EXPECT_EQ(job.title(), "Thinking");
    job.wait();
    EXPECT_TRUE(job.running()) << "until what came of it has been handed over";
    EXPECT_EQ(job.stage(), "half-way");
    EXPECT_EQ(job.share(), 0.5);
    EXPECT_TRUE(job.finish());
    EXPECT_FALSE(job.running());
    EXPECT_NE(worked, here);
    EXPECT_EQ(ended, here);
    EXPECT_FALSE(job.finish());
}

TEST(EditorBackgroundJob, WhatIsCancelledNeverEnds) {
    bool ended = false;
    std::atomic<bool> stopped = false;
    {
        BackgroundJob job;
        job.start("Waiting", [&](JobProgress& progress) -> BackgroundJob::Done {
            while (!progress.stopToken().stop_requested()) std::this_thread::yield();
            stopped = true;
            return [&] { ended = true; };
        });
        EXPECT_FALSE(job.finish());
        job.cancel();
        EXPECT_FALSE(job.running());
        // Another can start while the cancelled one is still on its way out.
        int value = 0;
        job.start("Next", [&](JobProgress&) -> BackgroundJob::Done { return [&] { value = 7; }; });
        job.wait();
        EXPECT_TRUE(job.finish());
        EXPECT_EQ(value, 7);
    }
    EXPECT_TRUE(stopped);
    EXPECT_FALSE(ended);
}

TEST(EditorBackgroundJob, AnEndMayStartTheNext) {
    BackgroundJob job;
    int steps = 0;
    job.start("One", [&](JobProgress&) -> BackgroundJob::Done {
        return [&] {
            ++steps;
            job.start("Two", [&](JobProgress&) -> BackgroundJob::Done { return [&] { ++steps; }; });
        };
    });
    job.wait();
    EXPECT_TRUE(job.finish());
    EXPECT_TRUE(job.running());
    job.wait();
    EXPECT_TRUE(job.finish());
    EXPECT_EQ(steps, 2);
}

Action dab(const Session& session, glm::ivec3 at) {
    const std::vector positions{at};
    return makeAction("Dab", patchVoxels(session.document(), 0, positions, EditMode::attach, 9));
}

TEST(EditorSession, WhatIsDrawnWhileSavingIsUnsaved) {
    const test::TemporaryFolder folder;
    Session session;
    ASSERT_TRUE(session.perform(dab(session, {1, 2, 3})));
    const Result<Session::Saving> saving = session.beginSaving(folder / "a.voxprite");
    ASSERT_TRUE(saving);
    ASSERT_TRUE(session.perform(dab(session, {4, 5, 6})));
    const Session::Written written = Session::write(*saving);
    ASSERT_TRUE(written);
    session.endSaving(*saving, written);
    EXPECT_TRUE(session.unsaved());
    EXPECT_EQ(session.path(), folder / "a.voxprite");
    ASSERT_TRUE(session.undo());
    EXPECT_FALSE(session.unsaved());

    Session again;
    ASSERT_TRUE(again.open(folder / "a.voxprite"));
    EXPECT_EQ(again.octree().solidCount(), 1u);
}

// Between the end of the writing and the window's news of it.
TEST(EditorSession, WhatAnotherProgramWritesAtOnceIsNotItsOwn) {
    const test::TemporaryFolder folder;
    Session session;
    ASSERT_TRUE(session.perform(dab(session, {1, 2, 3})));
    const Result<Session::Saving> saving = session.beginSaving(folder / "a.voxprite");
    ASSERT_TRUE(saving);
    const Session::Written written = Session::write(*saving);
    ASSERT_TRUE(written);
    ASSERT_TRUE(writeFileAtomically(folder / "a.voxprite", std::string("another program's")));
    session.endSaving(*saving, written);
    EXPECT_TRUE(session.changedOutside());
}

TEST(EditorSession, ACancelledSaveWritesNothingAndSavesNothing) {
    const test::TemporaryFolder folder;
    Session session;
    ASSERT_TRUE(session.perform(dab(session, {1, 2, 3})));
    const Result<Session::Saving> saving = session.beginSaving(folder / "a.voxprite");
    ASSERT_TRUE(saving);
    std::stop_source stop;
    stop.request_stop();
    const Session::Written written = Session::write(*saving, stop.get_token());
    EXPECT_FALSE(written);
    session.endSaving(*saving, written);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.voxprite"));
    EXPECT_TRUE(session.unsaved());
    EXPECT_FALSE(session.path());
}

TEST(EditorSession, AFileThatCannotBeReadLeavesTheDocument) {
    const test::TemporaryFolder folder;
    Session session;
    ASSERT_TRUE(session.perform(dab(session, {1, 2, 3})));
    EXPECT_FALSE(Session::read(folder / "none.vox"));
    EXPECT_FALSE(session.open(folder / "none.vox"));
    EXPECT_EQ(session.octree().solidCount(), 1u);
    EXPECT_TRUE(session.history().canUndo());
}

}  // namespace
}  // namespace voxprite::editor
