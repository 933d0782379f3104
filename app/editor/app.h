// The editor without its window: the session, the settings, all panels and both views, frame by
// frame.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/panels/layout.h"
#include "app/editor/panels/overlays.h"
#include "app/editor/panels/palette_panel.h"
#include "app/editor/panels/toasts.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/recovery/recovery_dialog.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/session/playback.h"
#include "app/editor/session/trade_study.h"
#include "app/editor/views/sprite_viewport.h"
#include "app/editor/views/voxel_viewport.h"
#include "app/editor/window/frame_clock.h"
#include "app/editor/window/input.h"

namespace voxprite::editor {

class App {
  public:
    // Needs the window's GL context.
    [[nodiscard]] static Result<std::unique_ptr<App>> create(
        EditorSettings settings, std::optional<std::filesystem::path> layoutDump);

    // What the command line names; a failure is the caller's to report. `entity`: of several in the
    // file.
    [[nodiscard]] Status openAtStart(const std::filesystem::path& file,
                                     std::optional<std::size_t> entity);
    [[nodiscard]] Status openProfileAtStart(const std::filesystem::path& file);

    // One frame: `events` are those that ImGui was fed. Between ImGui's NewFrame and Render.
    void frame(const Theme& theme, const std::vector<InputEvent>& events);
    // Asks about unsaved changes first.
    void requestOpen(const std::filesystem::path& file, std::optional<std::size_t> entity = {}) {
        keepToolsWork();
        files_.open(file, entity);
    }
    void requestQuit() {
        keepToolsWork();
        files_.quit();
    }
    // A script waits for what goes on behind the window; an artist never does.
    void finishWork() {
        files_.finishWork();
        voxels_.finishWork(session_);
        overlays_.sheet.finishWork();
        sprite_.finishWork();
        study_.wait();
    }
    // Of the frames since a document was opened; whoever runs them begins and finishes each.
    [[nodiscard]] FrameClock& clock() { return clock_; }
    // From now on unsaved work is copied into this folder, in the background; what an editor that
    // crashed has left there is offered.
    [[nodiscard]] Status keepCopiesIn(const std::filesystem::path& recovery);
    // The end of an orderly run: no copy is left.
    void dropCopies() {
        if (autosave_) autosave_->finish();
    }
    void say(std::string text) { toasts_.info(std::move(text)); }
    // Of several files that were named or dropped, that only the first is opened.
    void sayOneAtATime(const std::filesystem::path& first) {
        say("One document at a time: " + first.filename().string() + " is opened");
    }

    [[nodiscard]] bool quits() const { return files_.quits(); }
    // Something moves by itself, so that the next frame must not wait for input.
    [[nodiscard]] bool animates() const;
    [[nodiscard]] bool hasToasts() const { return toasts_.any(); }
    [[nodiscard]] const EditorSettings& settings() const { return settings_; }
    [[nodiscard]] std::string windowTitle() const;

  private:
    App(EditorSettings settings, std::optional<std::filesystem::path> layoutDump,
        VoxelViewport voxels, SpriteViewport sprite)
        : settings_(std::move(settings)),
          probe_(std::move(layoutDump)),
          voxels_(std::move(voxels)),
          sprite_(std::move(sprite)) {}

    // Parts of the window (app.cpp).
    void buildUi(Ui& ui);
    void drawDock(Ui& ui);
    void drawOverlays(Ui& ui, const Layout& layout);
    void placeCameras();
    void renderViews();
    void followTrade();
    [[nodiscard]] bool looksAtTrade() const;
    void lockCameras();
    void dumpLayout();
    [[nodiscard]] std::string openDialog() const;

    void drop(const std::vector<std::filesystem::path>& files);
    // What a tool is still making, and what is in the air, becomes part of the document.
    void keepToolsWork();
    // What the user interface has asked for this frame.
    void runCommands();
    void recover(const LostWork& work);
    void keepCopy();
    // Another document is open: nothing of the last one's is remembered.
    void startOver();

    EditorSettings settings_;
    Session session_;
    GpuOctree octree_;
    LayoutProbe probe_;
    VoxelViewport voxels_;
    SpriteViewport sprite_;
    EditQueue edits_;
    CommandQueue commands_;
    ViewFigures figures_;
    Toasts toasts_;
    Dialogs dialogs_;
    PaletteEditor paletteEditor_{session_, settings_};
    PalettePanel palettePanel_{paletteEditor_};
    ObjectSelection objects_;
    Playback playback_;
    TradeStudy study_;
    Overlays overlays_;
    CommandContext context_{session_, settings_, voxels_,  sprite_,   files_,         dialogs_,
                            toasts_,  overlays_, objects_, playback_, paletteEditor_, study_};
    FileFlow files_{context_};
    RecoveryDialog recovery_;
    std::unique_ptr<Autosave> autosave_;
    double seconds_ = 0.0;  // by the pace of the frames, which is one for every replay
    bool framed_ = false;   // the cameras have been placed for this document
    glm::dvec2 pointer_{0.0};
    // When the input that this frame answers arrived.
    std::optional<double> editStart_;
    std::uint64_t shownModel_ = 0;
    FrameClock clock_;
    // How many of both views OpenGL draws: none until the first document is on the screen, then one
    // more each frame, as their programs are made ready one after the other.
    int viewsByGl_ = 0;
    struct CameraPair {
        OrbitCamera edit, sprite;
    } before_;                             // of the frame before, to see which one was moved
    std::optional<OrbitCamera> unlocked_;  // the sprite's when the two were locked together
};

}  // namespace voxprite::editor
