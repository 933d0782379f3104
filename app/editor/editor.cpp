#include "app/editor/editor.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "app/editor/app.h"
#include "app/editor/window/frame_report.h"
#include "app/editor/window/imgui_host.h"
#include "app/editor/window/play_script.h"
#include "app/editor/window/start_times.h"
#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/io/svo_set.h"

namespace voxprite {
namespace editor {
namespace {

constexpr double kIdleWaitSeconds = 0.5;  // a text cursor blinks
constexpr double kToastWaitSeconds = 0.05;
constexpr int kFramesToSettle = 3;  // a user interface shows an effect a frame later

// Input that comes from a file, and what else the file asks for.
class Replay {
  public:
    [[nodiscard]] static Result<Replay> read(const std::filesystem::path& path) {
        Result<std::string> text = readTextFile(path);
        if (!text) return Failure(text.error());
        Result<std::vector<ScriptLine>> lines = readPlayScript(*text);
        if (!lines) return Failure(inFile(std::move(lines), path.string()).error());
        Replay replay;
        replay.lines_ = std::move(*lines);
        return replay;
    }
    [[nodiscard]] bool done() const { return next_ == lines_.size(); }
    // What happens in `frame`.
    [[nodiscard]] std::vector<ScriptLine> take(long long frame) {
        std::vector<ScriptLine> now;
        while (!done() && lines_[next_].frame <= frame) now.push_back(lines_[next_++]);
        return now;
    }

  private:
    std::vector<ScriptLine> lines_;
    std::size_t next_ = 0;
};

class Editor {
  public:
    Editor(const EditorOptions& options, Window& window, ImGuiHost& host, App& app,
           StartTimes& startTimes)
        : options_(options), window_(window), host_(host), app_(app), startTimes_(startTimes) {}

    [[nodiscard]] Status run();
    [[nodiscard]] Status startReplay();

  private:
    [[nodiscard]] Status oneFrame();
    [[nodiscard]] std::vector<InputEvent> eventsOfFrame();
    [[nodiscard]] Status saveScreenshot(const std::filesystem::path& path) const;
    [[nodiscard]] double waitSeconds() const;
    [[nodiscard]] bool automatic() const { return replay_ || options_.screenshot; }

    const EditorOptions& options_;
    Window& window_;
    ImGuiHost& host_;
    App& app_;
    StartTimes& startTimes_;
    std::optional<Replay> replay_;
    std::ofstream recording_;
    ScriptFrames recordedFrames_;
    FrameReport times_;
    std::vector<std::filesystem::path> screenshots_;  // of this frame
    long long frame_ = 0;
    int unsettled_ = kFramesToSettle;
    double lastSeconds_ = 0.0;
    double passedSeconds_ = 0.0;  // by the pace of the frames, since the first
    bool quits_ = false;
};

Status Editor::startReplay() {
    if (options_.playScript) {
        Result<Replay> replay = Replay::read(*options_.playScript);
        if (!replay) return Failure(replay.error());
        replay_ = std::move(*replay);
    }
    if (options_.record) {
        recording_.open(*options_.record);
        if (!recording_) return failInFile(options_.record->string(), "cannot be written");
    }
    return {};
}

double Editor::waitSeconds() const {
    if (automatic() || unsettled_ > 0 || app_.animates()) return 0.0;
    return app_.hasToasts() ? kToastWaitSeconds : kIdleWaitSeconds;
}

std::vector<InputEvent> Editor::eventsOfFrame() {
    std::vector<InputEvent> events = window_.input().takeFrame();
    if (automatic()) events.clear();  // nobody else's hand
    if (replay_) {
        for (ScriptLine& line : replay_->take(frame_)) {
            if (auto* event = std::get_if<InputEvent>(&line.what)) {
                event->seconds = Window::seconds();
                events.push_back(std::move(*event));
            } else if (auto* shot = std::get_if<ScriptScreenshot>(&line.what)) {
                screenshots_.push_back(std::move(shot->path));
            } else if (auto* mark = std::get_if<ScriptMark>(&line.what)) {
                times_.begin(std::move(mark->name), app_.clock());
            } else {
                quits_ = true;
            }
        }
        if (replay_->done() && !quits_) replay_.reset();
    }
    if (recording_.is_open() && !events.empty()) {
        const long long frame = recordedFrames_.next(passedSeconds_);
        for (const InputEvent& event : events) {
            const std::string line = writeScriptLine(frame, event);
            if (!line.empty()) recording_ << line << std::endl;
        }
    }
    return events;
}

Status Editor::saveScreenshot(const std::filesystem::path& path) const {
    return writePngFile(path, window_.readBackBuffer());
}

Status Editor::oneFrame() {
    app_.clock().begin();
    const double now = Window::seconds();
    // A replay runs at one pace on every machine.
    const double delta = automatic() ? 1.0 / kScriptFramesPerSecond : now - lastSeconds_;
    lastSeconds_ = now;
    if (frame_ > 0) passedSeconds_ += delta;
    const std::vector<InputEvent> events = eventsOfFrame();
    if (!events.empty()) unsettled_ = kFramesToSettle;

    if (automatic()) app_.finishWork();
    const Theme& theme = host_.updateTheme(app_.settings().window);
    host_.beginFrame(events, delta);
    app_.frame(theme, events);
    host_.applyCursor();
    host_.endFrame(theme.window);
    if (options_.screenshot && frame_ + 1 >= options_.frames) {
        screenshots_.push_back(*options_.screenshot);
        quits_ = true;
    }
    for (const auto& path : screenshots_) {
        if (Status saved = saveScreenshot(path); !saved) return saved;
    }
    screenshots_.clear();
    window_.swapBuffers();
    constexpr std::array kFirstFrames{"first frame", "second frame", "third frame"};
    if (frame_ < std::ssize(kFirstFrames)) {
        startTimes_.mark(kFirstFrames[static_cast<std::size_t>(frame_)]);
    }
    app_.clock().finish();
    // The first frame sets up fonts and shaders, whatever is to be seen.
    if (frame_ == 0) app_.clock().forget();
    window_.setTitle(app_.windowTitle());
    return {};
}

Status Editor::run() {
    lastSeconds_ = Window::seconds();
    glm::ivec2 sizePx = window_.framebufferPx();
    while (!quits_ && !app_.quits()) {
        window_.pollEvents(window_.input().empty() ? waitSeconds() : 0.0);
        if (window_.takeCloseRequest()) {
            app_.requestQuit();
            unsettled_ = kFramesToSettle;
        }
        if (window_.framebufferPx() != sizePx) {
            sizePx = window_.framebufferPx();
            unsettled_ = kFramesToSettle;
        }
        if (sizePx.x <= 0 || sizePx.y <= 0) {  // minimised
            window_.pollEvents(kIdleWaitSeconds);
            continue;
        }
        if (Status drawn = oneFrame(); !drawn) return drawn;
        ++frame_;
        unsettled_ = std::max(0, unsettled_ - 1);
    }
    if (options_.startTimes) {
        if (Status written = startTimes_.write(*options_.startTimes); !written) return written;
    }
    return options_.frameTimes ? times_.write(*options_.frameTimes, app_.clock()) : Status();
}

// For a hand the window is there at once and reads the file behind itself; what could not be a
// model is refused before. Which entity of several is meant is asked in the window.
Status openFirst(App& app, const EditorOptions& options, bool automatic) {
    const std::filesystem::path& file = options.files.front();
    const bool asks = automatic && !options.entity && entitiesAt(file) > 1;
    if (automatic && !asks) return app.openAtStart(file, options.entity);
    if (const Result<Format> format = formatOf(file); !format) return Failure(format.error());
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(file, unknown)) {
        return app.openAtStart(file, options.entity);
    }
    app.requestOpen(file, options.entity);
    return {};
}

}  // namespace
}  // namespace editor

Status runEditor(const EditorOptions& options) {
    using namespace editor;
    // A run that is not driven by a hand neither uses nor changes what the user chose.
    const bool automatic = options.screenshot || options.playScript;
    EditorSettings settings = automatic ? EditorSettings{} : loadSettings(settingsPath());
    // What a script shows must not depend on how fast the machine is.
    if (automatic) settings.view.drawBy = DrawBy::rays;
    if (automatic) settings.window.tourSeen = true;

    WindowPlace place = settings.window.place;
    if (options.windowPx) place = {.width = options.windowPx->x, .height = options.windowPx->y};
    StartTimes startTimes;
    startTimes.mark("program");
    std::optional<Window> window;  // outlives what draws in it
    // Its fonts are laid out while the driver makes the window's context.
    ImGuiHost host(ImGuiHost::scaleOf(options.contentScale.value_or(1.0), settings.window));
    {
        Result<Window> opened = Window::open("voxprite", place, options.contentScale);
        if (!opened) return Failure(opened.error());
        window = std::move(*opened);
    }
    startTimes.mark("window");
    if (Status opened = host.open(*window); !opened) return opened;
    Result<std::unique_ptr<App>> app = App::create(settings, options.layoutDump);
    if (!app) return Failure(app.error());
    startTimes.mark("interface");
    if (options.profile) {
        if (Status opened = (*app)->openProfileAtStart(*options.profile); !opened) return opened;
    }
    if (!options.files.empty()) {
        if (Status opened = openFirst(**app, options, automatic); !opened) {
            return opened;
        }
    }
    if (options.files.size() > 1) {
        (*app)->sayOneAtATime(options.files.front());
    }
    std::optional<std::filesystem::path> recovery = options.recovery;
    if (!recovery && !automatic) recovery = recoveryPath();
    if (recovery) {
        if (Status kept = (*app)->keepCopiesIn(*recovery); !kept) {
            (*app)->say("No copies of unsaved work are kept: " + kept.error().describe());
        }
    }
    startTimes.mark("document");
    Editor editor(options, *window, host, **app, startTimes);
    if (Status started = editor.startReplay(); !started) return started;
    if (Status ran = editor.run(); !ran) return ran;
    if ((*app)->quits()) (*app)->dropCopies();
    if (automatic) return {};
    EditorSettings used = (*app)->settings();
    if (!options.windowPx) used.window.place = window->place(used.window.place);
    return used == settings ? Status() : saveSettings(settingsPath(), used, settings);
}

}  // namespace voxprite
