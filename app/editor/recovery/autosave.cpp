#include "app/editor/recovery/autosave.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace voxprite::editor {

Autosave::Autosave(RecoveryFolder folder, AutosavePace pace)
    : folder_(std::move(folder)), pace_(pace) {}

Autosave::State Autosave::stateOf(const Session& session) {
    return {session.revision(), session.history().position(), session.history().steps().size(),
            session.file(), session.profileFile()};
}

WorkCopy Autosave::copyOf(const Session& session) {
    const auto begin = std::chrono::steady_clock::now();
    WorkCopy copy{
        session.document(),           session.profile(),    session.file(), session.title(),
        session.history().position(), session.profileFile()};
    copyMilliseconds_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return copy;
}

void Autosave::update(const Session& session, double nowSeconds, bool keepsCopy) {
    if (job_.running()) {
        const double took = job_.seconds();
        if (!job_.finish()) return;
        next_ = nowSeconds + std::max(pace_.leastSeconds, pace_.restShare * took);
    }
    if (!session.unsaved() && !session.profileUnsaved()) {
        if (!state_ || keepsCopy) return;
        state_.reset();
        copied_.reset();
        if (const Status cleared = folder_.clear(); !cleared) problem_ = cleared.error();
        return;
    }
    const State state = stateOf(session);
    if (state_ == state || nowSeconds < next_) return;
    state_ = state;
    auto copy = std::make_shared<const WorkCopy>(copyOf(session));
    job_.start("Autosave",
               [this, copy, position = state.position](JobProgress&) -> BackgroundJob::Done {
                   const auto written = std::make_shared<Status>(folder_.write(*copy));
                   return [this, written, position] {
                       if (*written) {
                           copied_ = position;
                       } else {
                           problem_ = written->error();
                       }
                   };
               });
}

Status Autosave::copyNow(const Session& session) {
    if (job_.running()) {
        job_.wait();
        (void)job_.finish();
    }
    state_ = stateOf(session);
    Status written = folder_.write(copyOf(session));
    if (written) copied_ = state_->position;
    return written;
}

void Autosave::finish() {
    if (job_.running()) {
        job_.wait();
        (void)job_.finish();
    }
    folder_.remove();
}

}  // namespace voxprite::editor
