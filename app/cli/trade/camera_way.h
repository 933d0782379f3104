// A camera's way as a game records it, a frame each:
//   {"voxprite_way": 1, "frames": [{"yaw": 0, "pitch": 22, "roll": 0}, ...]}
// Degrees, as OrbitAngles (core/sprite/camera.h) has them; pitch is -90 ... 90, roll may be left
// out. The sizes on the screen are the plan's, so that models of any size can be measured along it.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sprite/camera.h"

namespace voxprite::trade {

[[nodiscard]] Result<std::vector<OrbitAngles>> readCameraWay(const std::string& path);

}  // namespace voxprite::trade
