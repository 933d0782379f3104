// The rays of core/sprite/face_shade.h for the shaders: OcclusionRays of shaders/shared/face_shade.
#pragma once

#include "render/gl/program.h"

namespace voxprite {

class OcclusionRays {
  public:
    void bind();

  private:
    gl::UniformBuffer steps_;
};

}  // namespace voxprite
