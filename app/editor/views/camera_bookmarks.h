// Views kept under a name: between a camera and what is kept of it.
#pragma once

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "app/editor/views/orbit_camera.h"

namespace voxprite::editor {

// The sphere around a model in the world of a view.
struct ModelSphere {
    glm::dvec3 centre{0.0};
    double radius = 1.0;  // > 0
};
// As the edit view shows it; that of an empty document is small and at the origin.
[[nodiscard]] ModelSphere sphereInEditView(const Session& session);
[[nodiscard]] ModelSphere sphereInSpriteView(const Session& session);

[[nodiscard]] SavedCamera savedFrom(const OrbitCamera& camera, const ModelSphere& sphere,
                                    std::string name);
[[nodiscard]] OrbitCamera cameraFrom(const SavedCamera& saved, const ModelSphere& sphere);

}  // namespace voxprite::editor
