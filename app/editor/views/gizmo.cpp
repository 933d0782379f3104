#include "app/editor/views/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace voxprite::editor {
namespace {

constexpr double kArmPx = 84.0;
constexpr double kGizmoReachPx = 8.0;
constexpr int kRingPoints = 72;
constexpr int kGroundHandle = 3;
constexpr double kPlaneNear = 0.22, kPlaneFar = 0.48;  // the ground handle's square, in arms
constexpr double kDegrees = 57.29577951308232;
constexpr std::array<glm::dvec3, 3> kAxes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                          glm::dvec3(0, 0, 1)};

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double length2 = std::max(glm::dot(ab, ab), 1e-12);
    const double t = std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0);
    return glm::length(p - (a + ab * t));
}

// The axis about which yaw, pitch or roll turns the entity now, in world space.
glm::dvec3 turnAxis(const Entity& entity, int angle) {
    if (angle == 0) return worldFromVoxel(glm::dvec3(0, 0, 1));
    Entity before;
    before.yawDegrees = entity.yawDegrees;
    if (angle == 1) return worldFromVoxel(entityRotation(before) * glm::dvec3(1, 0, 0));
    before.pitchDegrees = entity.pitchDegrees;
    return worldFromVoxel(entityRotation(before) * glm::dvec3(0, 1, 0));
}

struct Plane {
    glm::dvec3 u, v;  // right-handed about the axis
};

Plane planeAcross(glm::dvec3 axis) {
    const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, axis));
    return {u, glm::cross(axis, u)};
}

// Angle of the pointer about `axis` through `origin`, in degrees. Seen edge-on there is no such
// angle on the plane, so the nearest point of the view ray to the origin stands for the pointer.
double angleUnder(const Camera& camera, glm::dvec2 px, glm::dvec3 origin, glm::dvec3 axis) {
    const Camera::Ray ray = camera.rayThrough(px);
    const double slope = glm::dot(ray.direction, axis);
    const double t = std::abs(slope) > 0.12 ? glm::dot(origin - ray.origin, axis) / slope
                                            : glm::dot(origin - ray.origin, ray.direction);
    const glm::dvec3 point = ray.origin + ray.direction * t - origin;
    const Plane plane = planeAcross(axis);
    return std::atan2(glm::dot(point, plane.v), glm::dot(point, plane.u)) * kDegrees;
}

// Where on the line origin + s * axis the pointer is nearest.
double alongAxis(const Camera& camera, glm::dvec2 px, glm::dvec3 origin, glm::dvec3 axis) {
    const Camera::Ray ray = camera.rayThrough(px);
    const glm::dvec3 between = origin - ray.origin;
    const double b = glm::dot(axis, ray.direction);
    const double denominator = 1.0 - b * b;
    if (denominator < 1e-4) return 0.0;
    return (b * glm::dot(ray.direction, between) - glm::dot(axis, between)) / denominator;
}

std::optional<glm::dvec3> onGroundPlane(const Camera& camera, glm::dvec2 px, double height) {
    const Camera::Ray ray = camera.rayThrough(px);
    if (std::abs(ray.direction.y) < 1e-4) return std::nullopt;
    const double t = (height - ray.origin.y) / ray.direction.y;
    if (t <= 0.0) return std::nullopt;
    return ray.origin + ray.direction * t;
}

std::vector<glm::dvec3> ringPoints(glm::dvec3 origin, glm::dvec3 axis, double radius) {
    const Plane plane = planeAcross(axis);
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = 2.0 * 3.141592653589793 * i / kRingPoints;
        points.push_back(origin + (plane.u * std::cos(angle) + plane.v * std::sin(angle)) * radius);
    }
    return points;
}

std::array<glm::dvec3, 4> groundSquare(glm::dvec3 origin, double arm) {
    const auto at = [&](double x, double z) { return origin + glm::dvec3(x, 0, z) * arm; };
    return {at(kPlaneNear, kPlaneNear), at(kPlaneFar, kPlaneNear), at(kPlaneFar, kPlaneFar),
            at(kPlaneNear, kPlaneFar)};
}

bool insideSquare(const Camera& camera, glm::dvec2 px, glm::dvec3 origin, double arm) {
    const auto hit = onGroundPlane(camera, px, origin.y);
    if (!hit) return false;
    const glm::dvec3 at = (*hit - origin) / arm;
    return at.x >= kPlaneNear && at.x <= kPlaneFar && at.z >= kPlaneNear && at.z <= kPlaneFar;
}

// The nearest handle within reach of the pointer, or -1.
int handleUnder(const GizmoTarget& target, const Camera& camera, glm::dvec2 px, double arm,
                double reachPx) {
    const glm::dvec3 origin = target.placed.anchorMetres;
    int nearest = -1;
    double least = reachPx;
    const auto offer = [&](int handle, double distance) {
        if (distance < least) {
            least = distance;
            nearest = handle;
        }
    };
    const auto screen = [&](glm::dvec3 world) { return camera.project(world).screenPx; };
    switch (target.kind) {
        case GizmoKind::none:
            break;
        case GizmoKind::move:
            if (insideSquare(camera, px, origin, arm)) return kGroundHandle;
            for (int i = 0; i < 3; ++i) {
                const glm::dvec3 axis = kAxes[static_cast<std::size_t>(i)];
                offer(i, distanceToSegment(px, screen(origin + axis * (0.12 * arm)),
                                           screen(origin + axis * arm)));
            }
            break;
        case GizmoKind::rotate:
            for (int i = 0; i < 3; ++i) {
                const auto ring = ringPoints(origin, turnAxis(target.entity, i), arm);
                for (std::size_t p = 1; p < ring.size(); ++p) {
                    offer(i, distanceToSegment(px, screen(ring[p - 1]), screen(ring[p])));
                }
            }
            break;
        case GizmoKind::scale: {
            const auto corners = proxyCorners(target.placed, target.sigmaInForce);
            for (int i = 0; i < 8; ++i) {
                offer(i, glm::length(px - screen(corners[static_cast<std::size_t>(i)])));
            }
            break;
        }
    }
    return nearest;
}

double snapped(double value, double step, bool snap) {
    return snap && step > 0.0 ? std::round(value / step) * step : value;
}

}  // namespace

Entity Gizmo::moved(const GizmoTarget& target, const Camera& camera, glm::dvec2 px,
                    bool snap) const {
    Entity entity = drag_->before;
    const glm::dvec3 origin = drag_->placedBefore.anchorMetres;
    glm::dvec3 step(0.0);
    if (drag_->handle == kGroundHandle) {
        const auto hit = onGroundPlane(camera, px, origin.y);
        if (!hit) return entity;
        step = *hit - drag_->start;
    } else {
        const glm::dvec3 axis = kAxes[static_cast<std::size_t>(drag_->handle)];
        step = axis * alongAxis(camera, px, origin, axis) - (drag_->start - origin);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (step[axis] == 0.0) continue;
        entity.positionMetres[axis] =
            snapped(entity.positionMetres[axis] + step[axis], target.voxelMetres, snap);
    }
    return entity;
}

Entity Gizmo::turned(const Camera& camera, glm::dvec2 px, bool snap) const {
    Entity entity = drag_->before;
    const double angle = angleUnder(camera, px, drag_->placedBefore.anchorMetres,
                                    turnAxis(drag_->before, drag_->handle));
    const double by = std::remainder(angle - drag_->startAngle, 360.0);
    double* const angles[3] = {&entity.yawDegrees, &entity.pitchDegrees, &entity.rollDegrees};
    double& value = *angles[drag_->handle];
    value = std::remainder(snapped(value + by, snap ? 15.0 : 1.0, true), 360.0);
    return entity;
}

Entity Gizmo::scaled(const Camera& camera, glm::dvec2 px, bool snap) const {
    Entity entity = drag_->before;
    const glm::dvec2 centre = camera.project(drag_->placedBefore.anchorMetres).screenPx;
    const double from = std::max(glm::length(drag_->pressPx - centre), 4.0);
    const double to = std::max(glm::length(px - centre), 1.0);
    entity.scale = std::clamp(snapped(entity.scale * to / from, 0.1, snap), 1e-2, 1e2);
    return entity;
}

std::optional<Entity> Gizmo::update(const GizmoTarget& target, const Camera& camera,
                                    const ViewInput& input, float uiScale, bool snap) {
    const glm::dvec3 origin = target.placed.anchorMetres;
    const double depth = camera.project(origin).depthMetres;
    const double scale = static_cast<double>(uiScale);
    // A key may change the kind under the hand, and a hand may let go while no handle is shown.
    if (drag_ && (drag_->kind != target.kind || !(input.held || input.released))) drag_.reset();
    if (!drag_) {
        hovered_ = -1;
        if (depth <= camera.nearMetres) return std::nullopt;
        armMetres_ = camera.metresPerScreenPx(depth) * kArmPx * scale;
        if (input.hovered && !input.moving) {
            hovered_ =
                handleUnder(target, camera, input.pointerPx, armMetres_, kGizmoReachPx * scale);
        }
        if (!input.pressed || hovered_ < 0) return std::nullopt;
        Drag drag{target.kind,   hovered_, input.pointerPx, target.entity,
                  target.placed, 0.0,      origin,          false};
        if (target.kind == GizmoKind::rotate) {
            drag.startAngle =
                angleUnder(camera, drag.pressPx, origin, turnAxis(target.entity, drag.handle));
        } else if (target.kind == GizmoKind::move && drag.handle == kGroundHandle) {
            drag.start = onGroundPlane(camera, drag.pressPx, origin.y).value_or(origin);
        } else if (target.kind == GizmoKind::move) {
            const glm::dvec3 axis = kAxes[static_cast<std::size_t>(drag.handle)];
            drag.start = origin + axis * alongAxis(camera, drag.pressPx, origin, axis);
        }
        drag_ = drag;
        return std::nullopt;
    }
    std::optional<Entity> result;
    // A click must not round the entity to the steps of a drag.
    drag_->left = drag_->left || input.pointerPx != drag_->pressPx;
    if (drag_->left) {
        const glm::dvec2 px = input.pointerPx;
        const Entity entity = target.kind == GizmoKind::move     ? moved(target, camera, px, snap)
                              : target.kind == GizmoKind::rotate ? turned(camera, px, snap)
                                                                 : scaled(camera, px, snap);
        if (entity != target.entity) result = entity;
    }
    if (!input.held) drag_.reset();
    return result;
}

void Gizmo::draw(const GizmoTarget& target, const Camera& camera, const ViewDrawing& drawing,
                 const Theme& theme) const {
    constexpr std::array<ImU32, 3> kColours{IM_COL32(226, 88, 88, 255), IM_COL32(122, 190, 84, 255),
                                            IM_COL32(80, 142, 236, 255)};
    const glm::dvec3 origin = target.placed.anchorMetres;
    const int lit = drag_ ? drag_->handle : hovered_;
    // Yaw turns about the world's y, pitch about x, roll about z at rest.
    const bool turns = target.kind == GizmoKind::rotate;
    const auto colour = [&](int handle) {
        const int axis = turns && handle < 2 ? 1 - handle : handle % 3;
        return handle == lit ? theme.accent : kColours[static_cast<std::size_t>(axis)];
    };
    const auto width = [&](int handle) { return theme.px(handle == lit ? 3.0f : 2.0f); };
    const auto middle = drawing.project(origin);
    if (!middle) return;
    if (target.kind == GizmoKind::move) {
        const auto square = groundSquare(origin, armMetres_);
        std::array<ImVec2, 4> points{};
        bool visible = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto point = drawing.project(square[i]);
            visible = visible && point.has_value();
            if (point) points[i] = *point;
        }
        const ImU32 fill = lit == kGroundHandle ? theme.accent : kColours[1];
        if (visible) {
            drawing.list().AddConvexPolyFilled(points.data(), 4, withAlpha(fill, 0.4f));
            drawing.list().AddPolyline(points.data(), 4, fill, ImDrawFlags_Closed, theme.px(1.5f));
        }
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 axis = kAxes[static_cast<std::size_t>(i)];
            const auto tip = drawing.project(origin + axis * armMetres_);
            if (!tip) continue;
            drawing.list().AddLine(*middle, *tip, colour(i), width(i));
            drawing.list().AddCircleFilled(*tip, theme.px(i == lit ? 7.0f : 5.5f), colour(i));
        }
    } else if (target.kind == GizmoKind::rotate) {
        for (int i = 0; i < 3; ++i) {
            const auto ring = ringPoints(origin, turnAxis(target.entity, i), armMetres_);
            for (std::size_t p = 1; p < ring.size(); ++p) {
                // The far half is faint.
                const bool far = glm::dot(ring[p] - origin, camera.forward) > 0.0;
                drawing.line(ring[p - 1], ring[p], withAlpha(colour(i), far ? 0.3f : 1.0f),
                             width(i));
            }
        }
    } else if (target.kind == GizmoKind::scale) {
        const auto corners = proxyCorners(target.placed, target.sigmaInForce);
        for (int i = 0; i < 8; ++i) {
            const auto at = drawing.project(corners[static_cast<std::size_t>(i)]);
            if (!at) continue;
            const float half = theme.px(i == lit ? 6.0f : 4.5f);
            const ImVec2 min(at->x - half, at->y - half), max(at->x + half, at->y + half);
            drawing.list().AddRectFilled(min, max, i == lit ? theme.accent : IM_COL32_WHITE,
                                         theme.px(1.5f));
            drawing.list().AddRect(min, max, IM_COL32(20, 21, 23, 220), theme.px(1.5f));
        }
    }
}

}  // namespace voxprite::editor
