#include "app/editor/views/camera_turn.h"

#include <algorithm>
#include <cmath>

namespace voxprite::editor {

void CameraTurn::start(const OrbitCamera& camera, const OrbitCamera& wanted) {
    toYaw_ = wanted.yawDegrees;
    toPitch_ = wanted.pitchDegrees;
    // A whole turn apart it is the same direction.
    fromYaw_ = toYaw_ + std::remainder(camera.yawDegrees - toYaw_, 360.0);
    fromPitch_ = camera.pitchDegrees;
    yaw_ = camera.yawDegrees;
    pitch_ = camera.pitchDegrees;
    left_ = kTurnSeconds;
}

void CameraTurn::advance(OrbitCamera& camera, double seconds) {
    if (camera.yawDegrees != yaw_ || camera.pitchDegrees != pitch_) left_ = 0.0;
    if (!running()) return;
    left_ = std::max(0.0, left_ - seconds);
    // Slows down as it arrives.
    const double rest = std::pow(left_ / kTurnSeconds, 2.0);
    yaw_ = camera.yawDegrees = toYaw_ + (fromYaw_ - toYaw_) * rest;
    pitch_ = camera.pitchDegrees = toPitch_ + (fromPitch_ - toPitch_) * rest;
}

}  // namespace voxprite::editor
