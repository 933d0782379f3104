// Many rays at once on the GPU: each finds exactly what castQuantised (core/trace/raycast.h) finds
// for the same integers, by the walk that the shaders share (shaders/shared/ray_walk.glsl).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/trace/raycast.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/gpu_octree.h"

namespace voxprite {

class RayBatch {
  public:
    static constexpr std::size_t kMaxRays = std::size_t{1} << 22;  // 128 MiB of rays

    [[nodiscard]] static Result<RayBatch> create();  // needs a current GL 4.5 context

    // At most kMaxRays; replaces those before.
    void upload(std::span<const QuantisedRay> rays);
    // Casts them all. The octree is the one that they were quantised for.
    void cast(const GpuOctree& octree);
    // What was hit, in the order of the rays. Waits for the GPU.
    [[nodiscard]] std::vector<LatticeHit> readHits() const;

  private:
    RayBatch() = default;

    gl::Program program_;
    gl::Buffer rays_;
    gl::Buffer hits_;
    gl::UniformBuffer octreeBlock_;
    std::size_t count_ = 0;
};

}  // namespace voxprite
