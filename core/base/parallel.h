// Work spread over all cores (oneTBB, which OpenVDB brings along). Results never depend on the
// number of threads: every index writes only its own output.
#pragma once

#include <functional>

namespace voxprite {

// Calls body(first, last) for disjoint ranges that cover [0, count), in any order, and waits.
// threads <= 0 means all cores, as does more than there are; 1 runs on the calling thread.
void parallelFor(int count, int threads, const std::function<void(int first, int last)>& body);

[[nodiscard]] int hardwareThreads();

}  // namespace voxprite
