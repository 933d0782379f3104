// Work behind the window, and opening and saving in their two halves.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "app/editor/panels/overlays.h"
#include "app/editor/panels/palette_editor.h"
#include "app/editor/panels/toasts.h"
#include "app/editor/session/background_job.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/session/playback.h"
#include "app/editor/session/selection_edits.h"
#include "app/editor/session/session.h"
#include "app/editor/session/trade_study.h"
#include "app/editor/views/sprite_viewport.h"
#include "app/editor/views/voxel_viewport.h"
#include "core/base/file.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/edit/scene_edits.h"
#include "render/gl/context.h"
#include "tests/support/must.h"
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
    EXPECT_TRUE(session.file()->changedOutside());
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

// The file flow with all that it reaches, without a window.
class EditorFileFlow : public testing::Test {
  protected:
    // So many cubes of 8 have a voxel that changes of the scene take long.
    void makeLarge() {
        std::vector<glm::ivec3> positions;
        for (int i = 0; i < 20 * 20 * 20; ++i) {
            positions.emplace_back(i / 400 * 8, i / 20 % 20 * 8, i % 20 * 8);
        }
        ASSERT_TRUE(session.perform(makeAction(
            "Many", patchVoxels(session.document(), 0, positions, EditMode::attach, 5))));
    }
    void dragTo(int x, std::uint64_t key) {
        context.perform(moveObject(session.document(), 1, {x, 0, 0}, key));
    }
    [[nodiscard]] const SceneNode& object() const { return session.document().nodes.at(1); }
    [[nodiscard]] int place() const { return object().placements.at(0).placement.translation.x; }
    void draw() {
        Ui ui{theme, session, settings, edits, commands, context, probe, figures, {}};
        files.draw(ui);
    }

    std::unique_ptr<ImGuiContext, decltype(&ImGui::DestroyContext)> imgui{ImGui::CreateContext(),
                                                                          &ImGui::DestroyContext};
    gl::HeadlessContext driver = test::must(gl::HeadlessContext::create());
    EditorSettings settings;
    Session session;
    VoxelViewport voxels = test::must(VoxelViewport::create());
    SpriteViewport sprite = test::must(SpriteViewport::create());
    Toasts toasts;
    Dialogs dialogs;
    PaletteEditor palette{session, settings};
    ObjectSelection objects;
    Playback playback;
    TradeStudy study;
    Overlays overlays;
    CommandContext context{session, settings, voxels,  sprite,   files,   dialogs,
                           toasts,  overlays, objects, playback, palette, study};
    FileFlow files{context};
    EditQueue edits;
    CommandQueue commands;
    Theme theme;
    LayoutProbe probe{std::nullopt};
    ViewFigures figures;
};

TEST_F(EditorFileFlow, ADragBackToItsStartEndsThere) {
    makeLarge();
    const std::uint64_t key = session.newMergeKey();
    dragTo(3, key);
    ASSERT_TRUE(files.drags());
    draw();  // begins to make that step
    dragTo(0, key);
    files.finishWork();
    EXPECT_EQ(place(), 0);
    EXPECT_EQ(session.history().position(), 1u);
}

TEST_F(EditorFileFlow, EditsOfTheSceneComeAfterTheDragAndKeepIt) {
    makeLarge();
    dragTo(3, session.newMergeKey());
    edits.pushScene([](const Document& now) { return setHidden(now, 1, true); });
    edits.pushScene([](const Document& now) { return setLocked(now, 1, true); });
    context.perform(edits);
    EXPECT_EQ(session.history().position(), 1u) << "none comes before it";
    while (files.isWorking()) {
        files.finishWork();
        context.perform(edits);
    }
    EXPECT_EQ(place(), 3);
    EXPECT_TRUE(object().hidden);
    EXPECT_TRUE(object().locked);
    EXPECT_EQ(session.history().position(), 4u);
}

// The X of the window's frame, and files dropped on it, reach an editor that is busy.
TEST_F(EditorFileFlow, NothingComesDownUnderAStepThatTakesLong) {
    ASSERT_TRUE(session.perform(dab(session, {1, 2, 3})));
    ASSERT_TRUE(lift(session, settings.tool, Floating::Kind::move));
    session.selection().changeFloating([](Floating& floating) { floating.moveBy({5, 0, 0}); });
    context.perform(makeActionLater("Paint", [](const Document& document) {
        const std::vector positions{glm::ivec3(9)};
        return onePatch(patchVoxels(document, 0, positions, EditMode::attach, 4));
    }));
    ASSERT_TRUE(files.blocks());
    EXPECT_FALSE(context.settle());
    EXPECT_TRUE(session.selection().floating());
    files.quit();
    files.finishWork();
    draw();
    // It came down before the question was asked.
    EXPECT_FALSE(session.selection().floating());
    EXPECT_EQ(dialogs.openName(), "unsaved");
    EXPECT_EQ(session.history().position(), 3u);
    EXPECT_EQ(session.octree().at({1, 2, 3}), 0);
    EXPECT_EQ(session.octree().at({6, 2, 3}), 9);
    EXPECT_EQ(session.octree().at({9, 9, 9}), 4);
}

// The step of the drag is put in force as soon as it is there, whoever reads the document then.
TEST_F(EditorFileFlow, NothingComesDownBesideADrag) {
    makeLarge();
    ASSERT_TRUE(lift(session, settings.tool, Floating::Kind::move));
    session.selection().changeFloating([](Floating& floating) { floating.moveBy({0, 0, 5}); });
    dragTo(3, session.newMergeKey());
    ASSERT_TRUE(files.drags());
    EXPECT_FALSE(context.settle());
    EXPECT_TRUE(session.selection().floating());
    files.quit();
    files.finishWork();
    EXPECT_EQ(session.history().position(), 2u);
    draw();
    // It came down before the question was asked.
    EXPECT_FALSE(session.selection().floating());
    EXPECT_EQ(dialogs.openName(), "unsaved");
    EXPECT_EQ(session.history().position(), 3u);
    EXPECT_EQ(place(), 3);
}

// What writes goes on until it has stopped: nothing is written beside it.
TEST_F(EditorFileFlow, WhatIsCancelledEndsBeforeTheNextBegins) {
    std::atomic<bool> stops = false;
    bool ended = false;
    ASSERT_TRUE(files.work("Writing", [&](JobProgress& progress) -> BackgroundJob::Done {
        while (!stops) std::this_thread::yield();
        EXPECT_TRUE(progress.stopToken().stop_requested());
        return [&] { ended = true; };
    }));
    files.cancelWork();
    EXPECT_TRUE(files.isWorking());
    EXPECT_FALSE(files.work("Writing again", {}));
    stops = true;
    files.finishWork();
    EXPECT_TRUE(ended);
}

TEST_F(EditorFileFlow, ACancelledSaveTellsWhetherItWasWritten) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(session.perform(dab(session, {1, 2, 3})));
    ASSERT_TRUE(session.saveAs(folder / "a.voxprite"));
    ASSERT_TRUE(session.perform(dab(session, {4, 5, 6})));
    files.save();
    files.cancelWork();  // perhaps too late
    files.finishWork();
    EXPECT_EQ(toasts.newest(),
              session.unsaved() ? "Cancelled: Saving a.voxprite" : "Saved a.voxprite");
    EXPECT_EQ(dialogs.openName(), "") << "cancelled is no failure";
    EXPECT_FALSE(session.file()->changedOutside());
    Session again;
    ASSERT_TRUE(again.open(folder / "a.voxprite"));
    EXPECT_EQ(again.octree().solidCount(), session.unsaved() ? 1u : 2u);
}

}  // namespace
}  // namespace voxprite::editor
