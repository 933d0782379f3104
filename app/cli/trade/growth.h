// Costs that grow: with the model, the crowd, sigma and the screen.
#pragma once

#include <functional>

#include "app/cli/trade/report.h"

namespace voxprite::trade {

// Measures one after the other; `progress` is told the share done and ends it early. What needs
// OpenGL (entities) is left out where `gl` is false; then a context must not be current.
[[nodiscard]] Result<std::vector<Growth>> measureGrowth(bool quick, bool gl,
                                                        const Progress& progress);

// The surface of a ball of `size` voxels across, one or two thick.
[[nodiscard]] Result<Octree> shellOctree(int size);

}  // namespace voxprite::trade
