// The sprite specification's own renderer, to measure ours against: one draw an entity (its proxy
// box), one ray a fragment in floating point, four more on a miss, the depth written by each
// fragment. It knows only the camera's forward as view, and no minification.
//
// Two of its readings are corrected, so that it draws the same scene: the grid stands on the
// model's centre, at the depth of the sprite plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/cli/bench/crowd_scene.h"
#include "core/sprite/camera.h"
#include "render/frame.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"

namespace voxprite::bench {

class SeedRenderer {
  public:
    // Needs a current GL context. The palette is lit as from straight ahead.
    [[nodiscard]] static Result<SeedRenderer> create(std::span<const Octree> models,
                                                     const Palette& palette);

    struct Drawn {
        int entities = 0;  // draws: what is outside the picture, or around the eye, is left out
        std::uint64_t rays = 0;  // counted only by countRays
    };
    Drawn draw(Frame& frame, std::span<const CrowdMember> scene, const Camera& camera,
               const GameProfile& profile);
    // The same, counting the rays: slower.
    Drawn countRays(Frame& frame, std::span<const CrowdMember> scene, const Camera& camera,
                    const GameProfile& profile);

  private:
    struct Model {
        gl::Texture svo;
        glm::ivec3 size{0};
        std::uint32_t maxDepth = 1;
        std::uint32_t payloadOffset = 0;  // texels
    };
    SeedRenderer() = default;
    int drawAll(Frame& frame, std::span<const CrowdMember> scene, const Camera& camera,
                const GameProfile& profile);

    std::vector<Model> models_;
    gl::Texture palette_;
    gl::Program program_, counting_;
    gl::UniformBuffer block_;
    gl::Buffer count_;
    gl::VertexArray nothing_;
};

}  // namespace voxprite::bench
