// Numbers that tell versions of what lies on the GPU apart.
#pragma once

#include <atomic>
#include <cstdint>

namespace voxprite {

// Never the same twice: equal numbers mean equal voxels whichever object they come from, so that a
// cache may go by the number alone. From any thread.
[[nodiscard]] inline std::uint64_t nextRevision() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace voxprite
