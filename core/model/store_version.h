// Which library keeps the voxels.
#pragma once

#include <string>

namespace voxprite {

[[nodiscard]] std::string storeVersion();  // "OpenVDB 10.0.1"

}  // namespace voxprite
