#include "app/editor/views/camera_bookmarks.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace voxprite::editor {
namespace {

constexpr double kEmptyRadiusVoxels = 12.0;

ModelSphere sphereOf(const PlacedEntity& placed, const IBox& bounds) {
    if (bounds.empty()) return {placed.anchorMetres, kEmptyRadiusVoxels * placed.metresPerVoxel()};
    const double radius = 0.5 * glm::length(glm::dvec3(bounds.size()));
    return {placed.centreMetres(), radius * placed.metresPerVoxel()};
}

}  // namespace

ModelSphere sphereInEditView(const Session& session) {
    return sphereOf(session.placedForEditing(), session.bounds());
}

ModelSphere sphereInSpriteView(const Session& session) {
    return sphereOf(session.placedInGame(), session.bounds());
}

SavedCamera savedFrom(const OrbitCamera& camera, const ModelSphere& sphere, std::string name) {
    return {std::move(name),
            camera.yawDegrees,
            camera.pitchDegrees,
            (camera.target - sphere.centre) / sphere.radius,
            camera.distance / sphere.radius,
            camera.orthographic};
}

OrbitCamera cameraFrom(const SavedCamera& saved, const ModelSphere& sphere) {
    OrbitCamera camera;
    camera.yawDegrees = saved.yawDegrees;
    camera.pitchDegrees = saved.pitchDegrees;
    camera.target = sphere.centre + saved.targetRadii * sphere.radius;
    camera.distance = std::clamp(saved.distanceRadii * sphere.radius, 1e-4, 1e9);
    camera.orthographic = saved.orthographic;
    return camera;
}

}  // namespace voxprite::editor
