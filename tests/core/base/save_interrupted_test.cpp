// A save that is killed at any of its system calls, or in which any of them fails, leaves the old
// file or the new one, whole. The saving process is stopped by ptrace on its way into and out of
// every system call.
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/reg.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <functional>

#include "core/base/file.h"
#include "tests/support/temporary_folder.h"

namespace voxprite {
namespace {

using test::TemporaryFolder;

constexpr int kSaved = 0;
constexpr int kRefused = 3;  // with an error that names the file
constexpr int kBadError = 4;

const std::string kOld(30'000, 'o');
const std::string kNew(100'000, 'n');

// A child that saves kNew over `path`, stopped before it begins.
pid_t startSaving(const std::filesystem::path& path) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    ::raise(SIGSTOP);
    const Status saved = writeFileAtomically(path, kNew);
    if (saved) ::_exit(kSaved);
    const bool named = saved.error().file == path.string() && !saved.error().message.empty();
    ::_exit(named ? kRefused : kBadError);
}

bool stopped(pid_t child, int& status) {
    return ::waitpid(child, &status, 0) == child && WIFSTOPPED(status);
}

bool begin(pid_t child) {
    int status = 0;
    return stopped(child, status) && ::ptrace(PTRACE_SETOPTIONS, child, nullptr,
                                              PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL) == 0;
}

// On to the next stop at a system call; false when the child has ended.
bool nextStop(pid_t child, int& status) {
    do {
        if (::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr) != 0) return false;
        if (!stopped(child, status)) return false;
    } while (WSTOPSIG(status) != (SIGTRAP | 0x80));
    return true;
}

std::string contentOf(const std::filesystem::path& path) {
    return readTextFile(path).value_or("(not to be read)");
}

long entriesIn(const std::filesystem::path& folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
}

TEST(InterruptedSave, KilledAtAnySystemCallLeavesTheOldFileOrTheNew) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "model";
    int old = 0, replaced = 0;
    bool ended = false;
    for (int stops = 1; !ended; ++stops) {
        ASSERT_LT(stops, 500);
        ASSERT_TRUE(writeFileAtomically(path, kOld));
        const pid_t child = startSaving(path);
        ASSERT_TRUE(begin(child));
        int status = 0;
        for (int k = 0; k < stops && !ended; ++k) ended = !nextStop(child, status);
        if (!ended) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
        }
        const std::string content = contentOf(path);
        ASSERT_TRUE(content == kOld || content == kNew) << "killed at stop " << stops;
        ++(content == kOld ? old : replaced);
    }
    // Both sides of the rename were met.
    EXPECT_GT(old, 5);
    EXPECT_GT(replaced, 3);
}

#ifdef __x86_64__
// The calls that a save makes of files: what a full or vanished disk refuses.
bool isOfFiles(unsigned long call) {
    constexpr std::array<unsigned long, 9> calls{SYS_open,   SYS_openat,    SYS_write,
                                                 SYS_fsync,  SYS_close,     SYS_fchmod,
                                                 SYS_rename, SYS_renameat2, SYS_renameat};
    return std::find(calls.begin(), calls.end(), call) != calls.end();
}

// Saves with the n-th call of files failing with `error`; the child's exit status, or -1 when there
// were fewer.
int saveWithFailure(const std::filesystem::path& path, int n, long error) {
    const pid_t child = startSaving(path);
    if (!begin(child)) return kBadError;
    int status = 0;
    bool entering = true, failing = false, failed = false;
    for (int seen = 0; nextStop(child, status); entering = !entering) {
        user_regs_struct registers{};
        ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
        if (entering && isOfFiles(registers.orig_rax) && ++seen == n) {
            registers.orig_rax = static_cast<unsigned long long>(-1);  // no call at all
            failing = failed = true;
        } else if (!entering && failing) {
            registers.rax = static_cast<unsigned long long>(-error);
            failing = false;
        } else {
            continue;
        }
        ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
    }
    if (!failed) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : kBadError;
}

TEST(InterruptedSave, AFailureOfAnySystemCallIsToldAndLosesNothing) {
    for (const long error : {ENOSPC, EROFS, ENOENT, EIO}) {
        int refused = 0, saved = 0;
        for (int n = 1;; ++n) {
            const TemporaryFolder folder;
            const std::filesystem::path path = folder / "model";
            ASSERT_TRUE(writeFileAtomically(path, kOld));
            ASSERT_EQ(::chmod(path.c_str(), 0640), 0);  // not those of a new file
            const int outcome = saveWithFailure(path, n, error);
            if (outcome < 0) break;
            ASSERT_LT(n, 100);
            ASSERT_TRUE(outcome == kSaved || outcome == kRefused) << outcome << ", call " << n;
            EXPECT_TRUE(contentOf(path) == (outcome == kSaved ? kNew : kOld)) << "call " << n;
            EXPECT_EQ(entriesIn(folder.path()), 1) << "left behind, call " << n;
            ++(outcome == kSaved ? saved : refused);
        }
        // Opening, permissions, writing, syncing, closing, renaming; what follows (the folder's
        // own sync) is no reason to call a save failed.
        EXPECT_GE(refused, 6);
        EXPECT_GE(saved, 1);
    }
}

// Network shares may take no permissions from anybody, not even those that a file has.
TEST(InterruptedSave, PermissionsAreSetOnlyWhereTheyDiffer) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "model";
    const auto timesSet = [&] {
        const pid_t child = startSaving(path);
        EXPECT_TRUE(begin(child));
        int status = 0, times = 0;
        for (bool entering = true; nextStop(child, status); entering = !entering) {
            user_regs_struct registers{};
            ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
            times += entering && registers.orig_rax == SYS_fchmod ? 1 : 0;
        }
        return times;
    };
    ASSERT_TRUE(writeFileAtomically(path, kOld));
    EXPECT_EQ(timesSet(), 0);
    EXPECT_EQ(contentOf(path), kNew);
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    EXPECT_EQ(timesSet(), 1);
}
#endif

}  // namespace
}  // namespace voxprite
