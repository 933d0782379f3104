// A camera on its way to another direction: quick enough not to wait for, slow enough to see which
// way it went.
#pragma once

#include "app/editor/views/orbit_camera.h"

namespace voxprite::editor {

inline constexpr double kTurnSeconds = 0.16;

class CameraTurn {
  public:
    // From where `camera` looks now to where `wanted` does, the shorter way round.
    void start(const OrbitCamera& camera, const OrbitCamera& wanted);
    [[nodiscard]] bool running() const { return left_ > 0.0; }
    // The angles of `camera` after so many seconds more; exactly the wanted ones at the end. Ends
    // at once when the camera has been turned otherwise.
    void advance(OrbitCamera& camera, double seconds);

  private:
    double fromYaw_ = 0.0, fromPitch_ = 0.0;
    double toYaw_ = 0.0, toPitch_ = 0.0;
    double yaw_ = 0.0, pitch_ = 0.0;  // as they were left
    double left_ = 0.0;               // seconds
};

}  // namespace voxprite::editor
