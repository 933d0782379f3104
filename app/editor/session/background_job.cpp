#include "app/editor/session/background_job.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <utility>

namespace voxprite::editor {

struct JobProgress::State {
    mutable std::mutex mutex;
    std::string stage;
    double share = 0.0;
    std::stop_source stop;
};

JobProgress::JobProgress() : state_(std::make_unique<State>()) {}
JobProgress::~JobProgress() = default;

void JobProgress::enter(std::string stage, double share) {
    const std::scoped_lock lock(state_->mutex);
    state_->stage = std::move(stage);
    state_->share = share;
}

std::string JobProgress::stage() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->stage;
}

double JobProgress::share() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->share;
}

std::stop_token JobProgress::stopToken() const {
    return state_->stop.get_token();
}

Progress JobProgress::as(std::string stage) {
    return {[this, stage = std::move(stage)](double share) { enter(stage, share); }, stopToken()};
}

struct BackgroundJob::Run {
    JobProgress progress;
    Done done;
    std::atomic<bool> ended = false;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::jthread thread;  // last: joined before what it uses goes
};

BackgroundJob::BackgroundJob() = default;

BackgroundJob::~BackgroundJob() {
    cancel();
}

void BackgroundJob::start(std::string title, Work work) {
    dropEnded();
    title_ = std::move(title);
    current_ = std::make_unique<Run>();
    Run& run = *current_;
    run.thread = std::jthread([&run, work = std::move(work)] {
        run.done = work(run.progress);
        run.ended = true;
    });
}

void BackgroundJob::cancel() {
    if (!current_) return;
    current_->progress.state_->stop.request_stop();
    abandoned_.push_back(std::move(current_));
    dropEnded();
}

void BackgroundJob::stop() {
    if (current_) current_->progress.state_->stop.request_stop();
}

bool BackgroundJob::stopping() const {
    return current_ && current_->progress.stopToken().stop_requested();
}

bool BackgroundJob::finish() {
    dropEnded();
    if (!current_ || !current_->ended) return false;
    // What it does may start the next job.
    const std::unique_ptr<Run> run = std::move(current_);
    if (run->done) run->done();
    return true;
}

void BackgroundJob::wait() {
    if (current_ && current_->thread.joinable()) current_->thread.join();
}

std::string BackgroundJob::stage() const {
    return current_ ? current_->progress.stage() : std::string();
}

double BackgroundJob::share() const {
    return current_ ? current_->progress.share() : 0.0;
}

double BackgroundJob::seconds() const {
    if (!current_) return 0.0;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - current_->begin)
        .count();
}

void BackgroundJob::dropEnded() {
    std::erase_if(abandoned_, [](const auto& run) { return run->ended.load(); });
}

}  // namespace voxprite::editor
