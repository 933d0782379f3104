#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "app/cli/bench/bench.h"
#include "app/cli/stopwatch.h"
#include "core/base/parallel.h"

namespace voxprite::bench {
namespace {

std::string cpuName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

const char* simdName() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f")) return "avx512";
    if (__builtin_cpu_supports("avx2")) return "avx2";
    return "sse2";
#elif defined(__aarch64__)
    return "neon";
#else
    return "none";
#endif
}

}  // namespace

Json machine() {
    return {{"cpu", cpuName()}, {"cores", hardwareThreads()}, {"simd", simdName()}};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double medianMs(const Effort& effort, const std::function<void()>& run) {
    run();
    std::vector<double> times;
    const cli::Stopwatch total;
    while (static_cast<int>(times.size()) < effort.minRuns() ||
           total.milliseconds() < effort.budgetMs()) {
        const cli::Stopwatch one;
        run();
        times.push_back(one.milliseconds());
    }
    return median(std::move(times));
}

void progress(const Effort& effort, const std::string& what) {
    if (!effort.quick) std::fprintf(stderr, "%s\n", what.c_str());
}

std::uint64_t processBytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t pages = 0, resident = 0;
    statm >> pages >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace voxprite::bench
