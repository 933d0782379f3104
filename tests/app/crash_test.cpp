// An editor that is killed (SIGKILL) at any moment, while it edits, copies and saves: the saved
// file is whole, and the copy brings back what it said it held.
//
// Twelve kills as part of the suite; VOXPRITE_KILLS=200 in the environment makes more (`./dev
// crash`).
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "app/editor/recovery/recovery_folder.h"
#include "core/io/formats.h"
#include "tests/app/crash/crash_voxels.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
namespace fs = std::filesystem;

// What the editor said before it died.
struct LastWords {
    std::uint64_t edited = 0;
    std::uint64_t saved = 0;
    std::uint64_t copied = 0;  // since it was saved
    int grown = 0;             // how often a copy took the place of a smaller one since then
    std::map<std::uint64_t, long long> millisecondsOf;
};

LastWords parse(const std::string& text) {
    LastWords words;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        if (lines.eof()) break;  // cut short by the kill
        std::istringstream fields(line);
        char what = 0;
        std::uint64_t edits = 0;
        fields >> what >> edits;
        if (what == 'e') {
            words.edited = edits;
            fields >> words.millisecondsOf[edits];
        } else if (what == 's') {
            words.saved = edits;
            words.copied = 0;
        } else if (what == 'c') {
            if (words.copied > 0 && edits > words.copied) ++words.grown;
            words.copied = edits;
        }
    }
    return words;
}

// Runs the driver for so long after its first word, kills it, and returns all it said.
LastWords runAndKill(const fs::path& recovery, const fs::path& document, unsigned seed,
                     std::chrono::milliseconds life) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe(ends.data()), 0);
    const std::string seedText = std::to_string(seed);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
        ::execl(VOXPRITE_CRASH_DRIVER, "crash_driver", recovery.c_str(), document.c_str(),
                seedText.c_str(), nullptr);
        std::_Exit(127);
    }
    ::close(ends[1]);
    std::string said;
    std::array<char, 4096> buffer{};
    const ssize_t first = ::read(ends[0], buffer.data(), buffer.size());
    EXPECT_GT(first, 0) << "the editor said nothing";
    if (first > 0) said.append(buffer.data(), static_cast<std::size_t>(first));
    // Reads on, so that a full pipe never holds the editor up.
    std::thread reader([&] {
        for (ssize_t n = 0; (n = ::read(ends[0], buffer.data(), buffer.size())) > 0;) {
            said.append(buffer.data(), static_cast<std::size_t>(n));
        }
    });
    std::this_thread::sleep_for(life);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "the editor ended by itself";
    reader.join();
    ::close(ends[0]);
    return parse(said);
}

// How many edits a file holds; fails unless they are the first ones, whole.
std::uint64_t editsIn(const fs::path& file) {
    const Document document = must(loadDocument(file)).document;
    const VoxelGrid& voxels = document.models.at(0).voxels;
    const std::uint64_t edits = voxels.solidCount();
    for (std::uint64_t k = 0; k < edits; ++k) {
        EXPECT_EQ(voxels.get(test::crashVoxel(k)), test::crashColour(k)) << file << ", edit " << k;
        if (testing::Test::HasFailure()) break;
    }
    return edits;
}

TEST(Crash, AKilledEditorLosesSecondsAtMost) {
    const char* wanted = std::getenv("VOXPRITE_KILLS");
    const int kills = wanted != nullptr ? std::stoi(wanted) : 12;
    const test::TemporaryFolder folder;
    const fs::path document = folder.path() / "work.voxprite";
    std::mt19937 random(2026);
    int recovered = 0, savedFiles = 0, grown = 0;
    long long worstMilliseconds = 0;
    for (int kill = 0; kill < kills && !HasFailure(); ++kill) {
        SCOPED_TRACE("kill " + std::to_string(kill));
        const fs::path recovery = folder.path() / ("recovery" + std::to_string(kill));
        const LastWords words = runAndKill(recovery, document, static_cast<unsigned>(random()),
                                           std::chrono::milliseconds(random() % 900));
        grown += words.grown;
        // Everything of it that is on the disk under the document's name is whole.
        std::uint64_t kept = 0;
        if (fs::exists(document)) {
            ++savedFiles;
            kept = editsIn(document);
            EXPECT_GE(kept, words.saved);
        } else {
            EXPECT_EQ(words.saved, 0U);
        }
        const std::vector<editor::LostWork> lost = editor::findLostWork(recovery);
        EXPECT_LE(lost.size(), 1U);
        if (words.copied > 0) {
            EXPECT_EQ(lost.size(), 1U) << "it said that there was a copy";
        }
        for (const editor::LostWork& work : lost) {
            ++recovered;
            const std::uint64_t copy = editsIn(work.document);
            EXPECT_GE(copy, words.copied);
            EXPECT_TRUE(fs::exists(work.picture));
            kept = std::max(kept, copy);
        }
        if (kept < words.edited && words.millisecondsOf.contains(kept + 1)) {
            worstMilliseconds = std::max(worstMilliseconds, words.millisecondsOf.at(words.edited) -
                                                                words.millisecondsOf.at(kept + 1));
        }
    }
    EXPECT_GT(recovered, 0);
    EXPECT_GT(savedFiles, 0);
    EXPECT_GT(grown, 0) << "one copy, and never a newer one";
    std::cout << kills << " kills: " << recovered << " copies recovered, " << savedFiles
              << " saved files whole, at most " << worstMilliseconds << " ms of work lost\n";
}

}  // namespace
}  // namespace voxprite
