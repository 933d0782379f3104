// Frames of crowds, for benchFrame.
#pragma once

#include "app/cli/bench/bench.h"
#include "render/scene_renderer.h"

namespace voxprite::bench {

// Adds the figures of scenes of 1 to 100,000 entities of 16 models (10,000 with `quick`): both
// views, a still and a moving camera, both modes. A scene that would take too long for one frame is
// left out, with the reason in its figure. Needs a current GL context.
[[nodiscard]] Status benchCrowds(SceneRenderer& renderer, const Effort& effort, Json& out);

}  // namespace voxprite::bench
