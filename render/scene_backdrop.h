// What lies behind and under the sprites of a scene: sky, ground, grid and shadow blobs.
#pragma once

#include <glm/vec4.hpp>

#include "core/sprite/camera.h"
#include "render/gl/handles.h"
#include "render/gl/lazy_program.h"
#include "render/scene_renderer.h"

namespace voxprite {

inline const glm::vec4 kSkyZenith(0.36f, 0.55f, 0.78f, 1.0f);
inline const glm::vec4 kSkyHorizon(0.80f, 0.86f, 0.88f, 1.0f);
inline constexpr float kHazeMetres = 90.0f;  // where the ground has mostly become sky

class SceneBackdrop {
  public:
    // Onto the bound frame, which is clear. Only the ground writes depth.
    void draw(const Scene& scene, const Camera& camera);
    [[nodiscard]] static bool isEmpty(const Scene& scene) { return !scene.sky && !scene.ground; }

  private:
    void drawPlane(const Scene& scene, const Camera& camera);
    void drawBlobs(const Scene& scene, const Camera& camera);

    gl::LazyProgram plane_{"fullscreen.vert", "scene_backdrop.frag"};
    gl::LazyProgram blob_{"shadow_blob.vert", "shadow_blob.frag"};
    gl::VertexArray nothing_ = gl::createVertexArray();
    gl::UniformBuffer cameraBlock_, backdropBlock_;
    gl::StorageBuffer blobs_;
};

}  // namespace voxprite
