#include "app/cli/bench/counters.h"

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace voxprite::bench {
namespace {

constexpr std::array<std::uint64_t, 4> kEvents{PERF_COUNT_HW_INSTRUCTIONS, PERF_COUNT_HW_CPU_CYCLES,
                                               PERF_COUNT_HW_BRANCH_MISSES,
                                               PERF_COUNT_HW_CACHE_MISSES};

int openCounter(std::uint64_t event, int group) {
    perf_event_attr wanted{};
    wanted.type = PERF_TYPE_HARDWARE;
    wanted.size = sizeof(wanted);
    wanted.config = event;
    if (group < 0) wanted.disabled = 1;
    wanted.exclude_kernel = 1;
    wanted.exclude_hv = 1;
    return static_cast<int>(
        ::syscall(SYS_perf_event_open, &wanted, 0, -1, group, PERF_FLAG_FD_CLOEXEC));
}

}  // namespace

HardwareCounters::Counts& HardwareCounters::Counts::operator+=(const Counts& other) {
    instructions += other.instructions;
    cycles += other.cycles;
    branchMisses += other.branchMisses;
    cacheMisses += other.cacheMisses;
    return *this;
}

HardwareCounters::HardwareCounters() {
    for (std::size_t k = 0; k < files_.size(); ++k) {
        files_[k] = openCounter(kEvents[k], k == 0 ? -1 : files_[0]);
        if (files_[k] >= 0) continue;
        whyNone_ = std::string("perf_event_open: ") + std::strerror(errno);
        return;
    }
}

HardwareCounters::~HardwareCounters() {
    for (const int file : files_)
        if (file >= 0) ::close(file);
}

void HardwareCounters::start() {
    if (!whyNone_.empty()) return;
    ::ioctl(files_[0], PERF_EVENT_IOC_RESET, PERF_IOC_FLAG_GROUP);
    ::ioctl(files_[0], PERF_EVENT_IOC_ENABLE, PERF_IOC_FLAG_GROUP);
}

HardwareCounters::Counts HardwareCounters::stop() {
    if (!whyNone_.empty()) return {};
    ::ioctl(files_[0], PERF_EVENT_IOC_DISABLE, PERF_IOC_FLAG_GROUP);
    std::array<std::uint64_t, 4> values{};
    for (std::size_t k = 0; k < files_.size(); ++k)
        if (::read(files_[k], &values[k], sizeof(values[k])) != sizeof(values[k])) values[k] = 0;
    return {values[0], values[1], values[2], values[3]};
}

Json describe(const HardwareCounters& counters) {
    if (counters.whyNone().empty()) return true;
    return "none (" + counters.whyNone() + ")";
}

void addCounts(Json& figure, const HardwareCounters::Counts& counts, double units,
               const std::string& unit) {
    if (counts.instructions == 0) return;
    const auto add = [&](const char* name, std::uint64_t count) {
        figure[std::string(name) + "_per_" + unit] = static_cast<double>(count) / units;
    };
    add("instructions", counts.instructions);
    add("cycles", counts.cycles);
    add("branch_misses", counts.branchMisses);
    add("cache_misses", counts.cacheMisses);
}

}  // namespace voxprite::bench
