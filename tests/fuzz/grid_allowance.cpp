// In place of core/io/grid_allowance.cpp, which the linker then leaves out: 1 GiB of blocks takes
// seconds to fill, and a run of one colour fills it from 50 bytes.
#include "core/io/grid_budget.h"

namespace voxprite {

const std::uint64_t kGridAllowanceBytes = std::uint64_t{1} << 21;

}  // namespace voxprite
