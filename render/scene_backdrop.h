// What lies behind and under the sprites of a scene: sky, ground, grid and shadow blobs.
#pragma once

#include "core/base/result.h"
#include "core/sprite/camera.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/scene_renderer.h"

namespace voxprite {

class SceneBackdrop {
  public:
    [[nodiscard]] static Result<SceneBackdrop> create();
    // Onto the bound frame, which is clear. Only the ground writes depth.
    void draw(const Scene& scene, const Camera& camera);
    [[nodiscard]] static bool isEmpty(const Scene& scene) { return !scene.sky && !scene.ground; }

  private:
    void drawPlane(const Scene& scene, const Camera& camera);
    void drawBlobs(const Scene& scene, const Camera& camera);

    gl::Program plane_;
    gl::Program blob_;
    gl::VertexArray nothing_ = gl::createVertexArray();
    gl::UniformBuffer cameraBlock_, backdropBlock_;
    gl::StorageBuffer blobs_;
};

}  // namespace voxprite
