#include "render/occlusion_rays.h"

#include <array>
#include <glm/vec4.hpp>

#include "core/base/check.h"
#include "core/sprite/face_shade.h"
#include "render/gpu_blocks.h"

namespace voxprite {

void OcclusionRays::bind() {
    std::array<glm::ivec4, 64> block{};
    const std::span<const OcclusionStep> steps = occlusionSteps();
    VOXPRITE_CHECK(steps.size() < block.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
        block[k] = glm::ivec4(steps[k].offset, steps[k].rays | steps[k].next << 8);
    }
    steps_.set(BlockBinding::occlusionRays, block);
}

}  // namespace voxprite
