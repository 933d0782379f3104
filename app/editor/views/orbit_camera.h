// A camera that turns about a target: how both views are looked around in. Double precision.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"

namespace voxprite::editor {

struct OrbitCamera {
    glm::dvec3 target{0.0};  // world; in the unit of its view
    double yawDegrees = 30.0;
    double pitchDegrees = 20.0;  // -90 ... 90
    double distance = 10.0;      // from the target, 1e-4 ... 1e9
    // Without perspective; what lies at the target's depth is as large as with it.
    bool orthographic = false;

    bool operator==(const OrbitCamera&) const = default;

    [[nodiscard]] Camera camera(glm::ivec2 viewportPx) const;
    // The picture follows the pointer, moved by so many pixels.
    void orbit(glm::dvec2 movedPx);
    void pan(glm::dvec2 movedPx, glm::ivec2 viewportPx);
    // So that the eye is at `toward` from the target, in voxel axes; straight from above or below
    // the yaw stays as near to what it is as a picture with level edges allows.
    void lookFrom(glm::dvec3 toward);
    // Positive notches come nearer. What lies under the pointer at the target's depth stays there.
    void zoom(double notches, glm::dvec2 pointerPx, glm::ivec2 viewportPx);
    // Looks at an entity that stands `here` as `other` does at the same one `there`: at the same
    // voxel, from the same direction, as large, with perspective or without.
    void lookLike(const OrbitCamera& other, const PlacedEntity& there, const PlacedEntity& here);
    // What the points enclose fills the view, but for a share of air; the direction stays.
    void frame(std::span<const glm::dvec3> points, double air, glm::ivec2 viewportPx);
};

inline constexpr double kViewFovDegrees = 40.0;

}  // namespace voxprite::editor
