#include "core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace voxprite {

void parallelFor(int count, int threads, const std::function<void(int first, int last)>& body) {
    if (count <= 0) return;
    if (threads == 1) {
        body(0, count);
        return;
    }
    // TBB has no more workers than cores and would complain about a request for them.
    const int all = hardwareThreads();
    tbb::task_arena arena(threads > 0 ? std::min(threads, all) : all);
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, count),
            [&](const tbb::blocked_range<int>& range) { body(range.begin(), range.end()); });
    });
}

int hardwareThreads() {
    return tbb::info::default_concurrency();
}

}  // namespace voxprite
