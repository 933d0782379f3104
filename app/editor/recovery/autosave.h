// Keeps the copy of unsaved work up to date, behind the window. The window's thread only copies the
// document (10 ms for a solid 256 cubed of noise); baking, packing and writing go on elsewhere.
//
// A copy is made at the first change and then as often as changes come, but not more often than the
// pace allows. This is well within "every two minutes and every fifty edits": what a crash costs is
// the last seconds.
#pragma once

#include <optional>

#include "app/editor/recovery/recovery_folder.h"
#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"

namespace voxprite::editor {

struct AutosavePace {
    double leastSeconds = 2.0;  // between two copies
    // Between two copies passes this many times what the last one took, so that large models do not
    // keep a core busy.
    double restShare = 4.0;
};

class Autosave {
  public:
    explicit Autosave(RecoveryFolder folder, AutosavePace pace = {});

    // Once a frame. `keepsCopy`: even when all is saved, as the writing may not be done yet.
    void update(const Session& session, double nowSeconds, bool keepsCopy = false);
    // Makes the copy now and waits for it.
    [[nodiscard]] Status copyNow(const Session& session);
    // The end of an orderly run: nothing is left to recover.
    void finish();

    // History steps in force in the copy last finished; nothing while there is none.
    [[nodiscard]] std::optional<std::size_t> copiedPosition() const { return copied_; }
    // What went wrong last, once.
    [[nodiscard]] std::optional<Error> takeProblem() { return std::exchange(problem_, {}); }
    // How long the window's thread took for the last copy.
    [[nodiscard]] double copyMilliseconds() const { return copyMilliseconds_; }

  private:
    // What tells one state of the work from another: also where it is kept, which the copy says.
    struct State {
        std::uint64_t revision = 0;
        std::size_t position = 0, steps = 0;
        std::optional<KnownFile> file{}, profileFile{};
        bool operator==(const State&) const = default;
    };
    [[nodiscard]] static State stateOf(const Session& session);
    [[nodiscard]] WorkCopy copyOf(const Session& session);

    RecoveryFolder folder_;
    AutosavePace pace_;
    std::optional<State> state_;  // of the copy, made or in the making
    std::optional<std::size_t> copied_;
    double next_ = 0.0;
    double copyMilliseconds_ = 0.0;
    std::optional<Error> problem_;
    BackgroundJob job_;  // last: it has ended before the folder goes
};

}  // namespace voxprite::editor
