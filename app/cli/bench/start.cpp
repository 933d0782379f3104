// How long the editor takes from its start to the first useful frame: the whole interface, with the
// model in both views. Each start is a process of its own that finds no shader in a cache.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/programs.h"
#include "core/base/file.h"

namespace voxprite::bench {
namespace {

constexpr std::size_t kStartModels = 3;

// The display at hand, or else a virtual one of this run's own.
class Display {
  public:
    Display() {
        if (std::getenv("DISPLAY") != nullptr) return;
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
        // Xvfb chooses a free number and says it there.
        const std::string number = std::to_string(kNumberEnd);
        const std::array<const char*, 9> argv{"Xvfb",       "-displayfd", number.c_str(),
                                              "-screen",    "0",          "1920x1200x24",
                                              "+extension", "GLX",        nullptr};
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[1], kNumberEnd);
        for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
            posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
        }
        const bool started = posix_spawnp(&server_, "Xvfb", &actions, nullptr,
                                          const_cast<char* const*>(argv.data()), environ) == 0;
        posix_spawn_file_actions_destroy(&actions);
        ::close(ends[1]);
        if (!started) server_ = 0;
        std::string said;
        for (char c = 0; started && ::read(ends[0], &c, 1) == 1 && c != '\n';) said += c;
        ::close(ends[0]);
        if (!said.empty()) ::setenv("DISPLAY", (":" + said).c_str(), 1);
    }
    ~Display() {
        if (server_ <= 0) return;
        ::unsetenv("DISPLAY");
        ::kill(server_, SIGTERM);
        ::waitpid(server_, nullptr, 0);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

  private:
    static constexpr int kNumberEnd = 9;
    pid_t server_ = 0;
};

// Drivers keep compiled shaders between runs.
class NoShaderCache {
  public:
    NoShaderCache() {
        for (const auto& [name, value] : kOff) ::setenv(name, value, 1);
    }
    ~NoShaderCache() {
        for (const auto& [name, value] : kOff) ::unsetenv(name);
    }
    NoShaderCache(const NoShaderCache&) = delete;
    NoShaderCache& operator=(const NoShaderCache&) = delete;

  private:
    static constexpr std::array<std::pair<const char*, const char*>, 2> kOff{
        {{"MESA_SHADER_CACHE_DISABLE", "true"}, {"__GL_SHADER_DISK_CACHE", "0"}}};
};

struct Moment {
    std::string part;
    double ms = 0.0, cpuMs = 0.0;
};

// What `edit --start-times` says, from the moment in which the process was made.
Result<std::vector<Moment>> startOnce(const std::filesystem::path& model,
                                      const std::filesystem::path& folder) {
    const std::filesystem::path times = folder / "times.json";
    const std::chrono::duration<double, std::milli> begin =
        std::chrono::steady_clock::now().time_since_epoch();
    const ProgramRun run = runProgram({ownProgram(), "edit", model.string(), "--window", "1280x800",
                                       "--screenshot", (folder / "window.png").string(), "--frames",
                                       "3", "--start-times", times.string()});
    if (!run.started || !run.succeeded)
        return fail("the editor does not start; it needs a display");
    const Result<std::string> text = readTextFile(times);
    if (!text) return Failure(text.error());
    std::vector<Moment> moments;
    for (const Json& mark : Json::parse(*text)) {
        moments.push_back({mark["part"], mark["at_ms"].get<double>() - begin.count(),
                           mark["cpu_ms"].get<double>()});
    }
    return moments;
}

}  // namespace

Result<Json> benchStart(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    const Display display;
    const NoShaderCache noCache;
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("voxprite-start-" + std::to_string(::getpid()));
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::size_t count = 0;
    for (const BenchModel& model : models) {
        if (model.file.empty() || ++count > (effort.quick ? 1 : kStartModels)) continue;
        progress(effort, "start: " + model.name);
        std::vector<std::string> order;
        std::map<std::string, std::vector<double>> ms, cpuMs;
        std::string reason;
        for (int run = 0; run < effort.minRuns() && reason.empty(); ++run) {
            const Result<std::vector<Moment>> moments = startOnce(model.file, folder);
            if (!moments) {
                reason = moments.error().describe();
                break;
            }
            for (const Moment& moment : *moments) {
                if (run == 0) order.push_back(moment.part);
                ms[moment.part].push_back(moment.ms);
                cpuMs[moment.part].push_back(moment.cpuMs);
            }
        }
        if (!reason.empty()) {
            figures.push_back({{"model", model.name}, {"ms", nullptr}, {"reason", reason}});
            continue;
        }
        for (const std::string& part : order) {
            figures.push_back({{"model", model.name},
                               {"until", part},
                               {"ms", median(ms[part])},
                               {"cpu_ms", median(cpuMs[part])}});
        }
    }
    std::filesystem::remove_all(folder, error);
    return figures;
}

}  // namespace voxprite::bench
