#include "app/cli/bench/programs.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/cli/stopwatch.h"

namespace voxprite::bench {

namespace {

// The most memory that a running program has had so far, as Linux counts it; 0 when it has ended.
// (What wait4() tells would be no less than this program's own peak, from before the other began.)
std::uint64_t peakOf(pid_t program) {
    std::ifstream status("/proc/" + std::to_string(program) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) return 1024 * std::stoull(line.substr(6));
    }
    return 0;
}

}  // namespace

ProgramRun runProgram(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    }
    ProgramRun run;
    const cli::Stopwatch watch;
    pid_t child = 0;
    run.started = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    if (!run.started) return run;
    int status = 0;
    rusage usage{};
    while (true) {
        const pid_t ended = wait4(child, &status, WNOHANG, &usage);
        if (ended == child || (ended < 0 && errno != EINTR)) break;
        run.peakBytes = std::max(run.peakBytes, peakOf(child));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    run.ms = watch.milliseconds();
    run.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    const auto ms = [](const timeval& time) {
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    run.cpuMs = ms(usage.ru_utime) + ms(usage.ru_stime);
    return run;
}

std::string ownProgram() {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? "voxprite" : self.string();
}

}  // namespace voxprite::bench
