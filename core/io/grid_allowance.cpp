#include "core/io/grid_budget.h"

namespace voxprite {

const std::uint64_t kGridAllowanceBytes = std::uint64_t{1} << 30;

}  // namespace voxprite
