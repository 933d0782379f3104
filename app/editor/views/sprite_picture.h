// The sprite of the sprite view as a picture: one pixel a virtual pixel, or magnified, transparent
// outside. Cast on the processor, which gives the very pixels that the view shows.
#pragma once

#include "app/editor/session/session.h"
#include "core/base/image.h"

namespace voxprite::editor {

// Of the document (not of an edit that is only being shown) as the game with this profile shows it,
// cut to what is not transparent. The
// history is that of the view, so that a snapped view gives the picture on the screen; it stays as
// it is. Fails when there is nothing to see, or too much.
[[nodiscard]] Result<Image> spritePicture(const Session& session, const GameProfile& profile,
                                          const Camera& camera, ViewHistory history, int scale);

// The palette index of the document's voxel under a point of the view; 0 where the sprite is empty
// or its outline runs.
[[nodiscard]] std::uint8_t colourUnder(const Session& session, const Camera& camera,
                                       ViewHistory history, glm::dvec2 viewPx);

// Each pixel as a square of `scale` pixels.
[[nodiscard]] Image magnified(const Image& image, int scale);
// Without the transparent rows and columns around it; empty when all of it is transparent.
[[nodiscard]] Image trimmed(const Image& image);

}  // namespace voxprite::editor
