// Long work on a thread of its own, so that the window never waits for it.
//
//   job.start("Opening hut.vox", [path](JobProgress& progress) -> BackgroundJob::Done {
//       auto loaded = std::make_shared<...>(load(path, progress.stopToken()));
//       return [&session, loaded] { session.adopt(std::move(*loaded)); };
//   });
//
// The work runs on the other thread and touches nothing of the editor's; what it returns runs on
// the window's thread, in finish(). What is cancelled never gets there.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/base/progress.h"

namespace voxprite::editor {

// What the work says of itself while it runs. Safe from both threads.
class JobProgress {
  public:
    JobProgress();
    ~JobProgress();
    // From here on it does this: "Building the octree". `share` of the whole is done, 0 ... 1.
    void enter(std::string stage, double share);
    [[nodiscard]] std::string stage() const;
    [[nodiscard]] double share() const;
    // Work that can stop half-way looks at this now and then.
    [[nodiscard]] std::stop_token stopToken() const;
    // For work that knows no stages, under one name. Must not outlive this.
    [[nodiscard]] Progress as(std::string stage);

  private:
    friend class BackgroundJob;
    struct State;
    std::unique_ptr<State> state_;
};

class BackgroundJob {
  public:
    using Done = std::function<void()>;  // may be empty
    using Work = std::function<Done(JobProgress&)>;

    BackgroundJob();
    // Cancels what runs, and waits for it to end.
    ~BackgroundJob();
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    // One at a time: not while running().
    void start(std::string title, Work work);
    // From start() until finish() has handed over what came of it, or cancel().
    [[nodiscard]] bool running() const { return current_ != nullptr; }
    void cancel();
    // Asks what runs to end early; it goes on running() until it does.
    void stop();
    [[nodiscard]] bool stopping() const;
    // Once it has ended: true, and then its Done has run.
    bool finish();
    // Waits for the end of what runs; finish() then succeeds.
    void wait();

    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] std::string stage() const;
    [[nodiscard]] double share() const;
    // Since start().
    [[nodiscard]] double seconds() const;

  private:
    struct Run;
    void dropEnded();

    std::string title_;
    std::unique_ptr<Run> current_;
    // Cancelled, but not yet at a place where it can stop.
    std::vector<std::unique_ptr<Run>> abandoned_;
};

}  // namespace voxprite::editor
