// The depth of a sprite by the three rules.
#pragma once

#include "core/sprite/sprite_view.h"

namespace voxprite {

// Metres along the camera's forward. `view` is complete but for its depthMetres.
//   centre       that of the model's centre.
//   groundSafe   pulled toward the eye just so far that no pixel of the sprite falls behind the
//                horizontal plane through the anchor (when the eye is above it).
//   perPixel     the nearest that any pixel may write.
// Never nearer than the near plane or the proxy box's nearest corner.
[[nodiscard]] double spriteDepth(const SpriteView& view, const PlacedEntity& entity,
                                 const Camera& camera, DepthRule rule);

}  // namespace voxprite
