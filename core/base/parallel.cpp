#include "core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace voxprite {

void parallelFor(int count, int threads, const std::function<void(int first, int last)>& body) {
    if (count <= 0) return;
    if (threads == 1) {
        body(0, count);
        return;
    }
    const auto spread = [&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, count),
            [&](const tbb::blocked_range<int>& range) { body(range.begin(), range.end()); });
    };
    if (threads <= 0 || threads >= hardwareThreads()) {
        // In the arena that the calling thread has anyway: its workers are still awake from the
        // last call, where those of a new arena wake up when a millisecond's work is done.
        // Isolated: who waits takes up no work from outside.
        tbb::this_task_arena::isolate(spread);
    } else {
        tbb::task_arena(threads).execute(spread);
    }
}

int hardwareThreads() {
    return tbb::info::default_concurrency();
}

}  // namespace voxprite
