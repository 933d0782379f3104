// The SIMD targets that this machine has, for tests to go through one by one.
#pragma once

#include <hwy/targets.h>
#include <cstdint>
#include <vector>

namespace voxprite::test {

inline void useSimdTarget(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
}
inline void useAllSimdTargets() {
    hwy::SetSupportedTargetsForTest(0);
}

inline std::vector<std::int64_t> simdTargets() {
    useAllSimdTargets();
    std::vector<std::int64_t> targets;
    for (std::int64_t all = hwy::SupportedTargets(); all != 0; all &= all - 1)
        targets.push_back(all & -all);
    return targets;
}

}  // namespace voxprite::test
