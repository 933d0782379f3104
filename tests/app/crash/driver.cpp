// An editor without a window that edits and saves until it is killed: the other half of
// crash_test.cpp, which starts it.
//
//   crash_driver RECOVERY DOCUMENT SEED
//
// The k-th edit attaches the k-th voxel (crash_voxels.h), so that a document says how many edits it
// holds. On standard output, a line each, unbuffered:
//   e K MS   K edits are made, at this time      s K   K edits are in the saved file
//   c K      K edits are in the copy
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <random>
#include <string>
#include <thread>

#include "app/editor/recovery/autosave.h"
#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "tests/app/crash/crash_voxels.h"

namespace {

using namespace voxprite;
using Clock = std::chrono::steady_clock;

void say(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) std::_Exit(3);
}

[[noreturn]] void give(const Error& error) {
    std::fprintf(stderr, "%s\n", error.describe().c_str());
    std::exit(1);
}

double secondsNow() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 4) return 2;
    const std::filesystem::path document = arguments[2];
    std::mt19937 random(static_cast<unsigned>(std::stoul(arguments[3])));

    editor::Session session;
    if (std::filesystem::exists(document)) {
        if (const Status opened = session.open(document); !opened) give(opened.error());
    }
    Result<editor::RecoveryFolder> folder = editor::RecoveryFolder::create(arguments[1]);
    if (!folder) give(folder.error());
    editor::Autosave autosave(std::move(*folder), {.leastSeconds = 0.1, .restShare = 1.0});

    const auto editsAtStart = session.document().models[0].voxels.solidCount();
    std::uint64_t edits = editsAtStart;
    std::optional<std::size_t> copied;
    for (;;) {
        const glm::ivec3 at = test::crashVoxel(edits);
        VoxelPatch patch = patchVoxels(session.document(), 0, std::span(&at, 1), EditMode::attach,
                                       test::crashColour(edits));
        const Status done = session.perform(makeAction("Attach", std::move(patch)));
        if (!done) give(done.error());
        ++edits;
        say("e " + std::to_string(edits) + " " +
            std::to_string(static_cast<long long>(secondsNow() * 1000.0)));
        autosave.update(session, secondsNow());
        if (const auto problem = autosave.takeProblem()) give(*problem);
        if (copied != autosave.copiedPosition()) {
            copied = autosave.copiedPosition();
            if (copied) say("c " + std::to_string(editsAtStart + *copied));
        }
        if (random() % 100 == 0) {
            if (const Status saved = session.saveAs(document); !saved) give(saved.error());
            say("s " + std::to_string(edits));
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    }
}
