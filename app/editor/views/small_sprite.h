// A small sprite of a model, as the game casts its own: what stands for a document or a palette in
// a list.
#pragma once

#include <optional>

#include "core/base/box.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"
#include "core/sprite/sprite_buffer.h"

namespace voxprite::editor {

struct SmallSubject {
    OctreeView octree;
    const IBox& bounds;
    const Entity& entity;
    const GameProfile& profile;
    const Palette& palette;
};

// The sprite that fits a square of `edgePx`, from a little above and to the side: sigma is the
// profile's, or halved until it fits. Nothing for an empty model.
[[nodiscard]] std::optional<SpriteBuffer> smallSprite(const SmallSubject& subject, int edgePx);

}  // namespace voxprite::editor
