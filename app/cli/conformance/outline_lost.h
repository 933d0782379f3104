// Does the whole outline reach the screen?
#pragma once

#include "core/sprite/composite.h"

namespace voxprite::conformance {

inline constexpr Rgba8 kInk{250, 0, 250, 255};  // an outline that nothing else looks like

// Outline pixels of `buffer` (cast with the outline kInk) whose middle lies on the screen and does
// not show in the picture.
[[nodiscard]] int outlineLost(const SpriteView& view, const SpriteBuffer& buffer,
                              const Camera& camera);

}  // namespace voxprite::conformance
