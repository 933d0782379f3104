// The coming edit of very many voxels, shown as soon as it has been worked out behind the window:
// what it would make of the document is made of a copy, octree included.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"

namespace voxprite::editor {

// Called once it is worth to begin; what it returns, if anything, is called on another thread.
using PlanPreview = std::function<MakePatches(const Session&)>;

class LargePreview {
  public:
    // Instead of what was asked for before. Begins when nothing else is asked for in a moment: a
    // hand on its way wants to see none of what it passes.
    void ask(PlanPreview plan);
    // Nothing is wanted any more.
    void drop();
    // Once a frame: begins, or shows what is ready, unless the document has changed meanwhile.
    void update(Session& session);
    // Until what was asked for is shown, or turned out to be impossible.
    [[nodiscard]] bool working() const { return plan_ || job_.running(); }
    // Why what was asked for last cannot be done; told once.
    [[nodiscard]] std::optional<Error> takeProblem() { return std::exchange(problem_, {}); }
    // For scripts, which do one thing after another.
    void finish(Session& session);

  private:
    struct Picture {
        LiveOctree octree;
        IBox filled;
        std::uint64_t revision = 0;
    };
    void begin(Session& session);

    PlanPreview plan_;
    std::chrono::steady_clock::time_point asked_;
    BackgroundJob job_;
    std::shared_ptr<Picture> ready_;
    std::optional<Error> problem_;
};

}  // namespace voxprite::editor
