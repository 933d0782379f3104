// What the views show first. A driver takes long to make the programs of a view ready, a software
// rasteriser a second: until then the processor casts what matters in the picture, the voxels and
// the sprite itself, at the very place and in the very pixels that they will have.
#pragma once

#include "app/editor/session/session.h"
#include "app/editor/views/backdrop.h"
#include "core/base/image.h"
#include "core/sprite/camera.h"

namespace voxprite::editor {

// The voxels in their soft light before the backdrop; without grid, edges and shade.
[[nodiscard]] Image firstVoxelPicture(const Session& session, const Camera& camera,
                                      const BackdropColours& behind);
// The sprite, pixel by pixel the one that follows, before sky and ground; no copies, no shadow.
[[nodiscard]] Image firstSpritePicture(const Session& session, const Camera& camera);

}  // namespace voxprite::editor
