// Frames of crowds, for benchFrame.
#pragma once

#include "app/cli/bench/bench.h"
#include "render/scene_renderer.h"

namespace voxprite::bench {

// Adds the figures of scenes of 1 to 100,000 entities of 16 models (10,000 with `quick`): both
// views, a still and a moving camera, with views snapped and not, both modes, and the
// specification's own way (`seed`; it knows camera_forward alone). Where a frame would take too
// long the scene is left out, with the reason in its figure. Rays and casts are means over the
// timed frames, `ms` is their median, beside `meanMs` and `mostMs`. Needs a current GL context.
[[nodiscard]] Status benchCrowds(SceneRenderer& renderer, const Effort& effort, Json& out);

// Adds one sprite that fills the picture, 8 screen pixels a virtual pixel, seen anew in every
// frame: `timesFaster` is the time of single_pass over that of the sprite buffer (cast, outline
// and blit together), by the fastest frames of each and without what clearing the frame takes. The
// pictures of both modes are compared first: a difference is a failure. With `quick` only the last
// two models.
[[nodiscard]] Status benchOneSprite(SceneRenderer& renderer, const std::vector<BenchModel>& models,
                                    const Effort& effort, Json& out);

}  // namespace voxprite::bench
