#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace voxprite {
namespace {

TEST(Parallel, CoversEveryIndexOnce) {
    for (const int threads : {0, 1, 2, 5}) {
        for (const int count : {1, 2, 7, 1000}) {
            std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
            parallelFor(count, threads, [&](int first, int last) {
                EXPECT_LT(first, last);
                for (int i = first; i < last; ++i) ++visits[static_cast<std::size_t>(i)];
            });
            for (const auto& n : visits) ASSERT_EQ(n, 1);
        }
    }
}

TEST(Parallel, NothingToDoCallsNothing) {
    parallelFor(0, 0, [](int, int) { ADD_FAILURE(); });
    parallelFor(-3, 2, [](int, int) { ADD_FAILURE(); });
}

TEST(Parallel, OneThreadIsTheCallersInOneRange) {
    const auto caller = std::this_thread::get_id();
    int calls = 0;
    parallelFor(100, 1, [&](int first, int last) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_EQ(first, 0);
        EXPECT_EQ(last, 100);
        ++calls;
    });
    EXPECT_EQ(calls, 1);
    EXPECT_GE(hardwareThreads(), 1);
}

TEST(Parallel, MayBeNested) {
    std::atomic<int> sum{0};
    parallelFor(8, 0, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            parallelFor(8, 0, [&](int a, int b) { sum += b - a; });
        }
    });
    EXPECT_EQ(sum, 64);
}

}  // namespace
}  // namespace voxprite
