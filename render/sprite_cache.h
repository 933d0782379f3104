// Finished sprites kept from frame to frame: a scene that stands still casts nothing, and entities
// that show the same sprite share it.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/sprite/sprite_key.h"
#include "render/sprite_caster.h"

namespace voxprite {

class SpriteCache {
  public:
    // The sprite of this key, if it is held; it stays for this frame.
    [[nodiscard]] SpriteTextures* find(const SpriteKey& key);
    // Textures of at least this size to fill with the sprite of a key that is not held.
    [[nodiscard]] SpriteTextures& add(const SpriteKey& key, glm::ivec2 size);
    void forget(const SpriteKey& key);
    // Lets go of what has not been used for a few frames; its textures are used again.
    void endFrame();

  private:
    struct Entry {
        std::unique_ptr<SpriteTextures> textures;
        std::uint64_t lastFrame = 0;
    };
    std::unordered_map<SpriteKey, Entry> entries_;
    std::vector<std::unique_ptr<SpriteTextures>> spare_;
    std::uint64_t frame_ = 0;
};

}  // namespace voxprite
