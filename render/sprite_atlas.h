// Finished sprites kept from frame to frame: a scene that stands still casts nothing, and entities
// that show the same sprite share it. The least recently shown go when room is needed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/sprite/sprite_key.h"
#include "render/gl/handles.h"
#include "render/scene_renderer.h"
#include "render/shelf_packer.h"

namespace voxprite {

// Pages of finished sprites: texture arrays, and a framebuffer for each page.
struct SpriteSheet {
    gl::Texture colours;  // R32UI: words of RGBA8
    gl::Texture ids;      // R32UI; only a depth for each pixel needs them
    std::vector<gl::Framebuffer> framebuffers;
    glm::ivec3 size{0};  // of a page, and how many

    SpriteSheet() = default;
    SpriteSheet(glm::ivec3 size, bool withIds);
    [[nodiscard]] static std::uint64_t bytesOf(glm::ivec3 size, bool withIds);
    [[nodiscard]] std::uint64_t bytes() const { return bytesOf(size, static_cast<bool>(ids)); }
};

// Where a finished sprite lies. Stays until the atlas is told that its batch has been drawn.
struct AtlasPlace {
    const SpriteSheet* sheet = nullptr;
    glm::ivec3 corner{0};  // lower left, and the page
    [[nodiscard]] std::uint32_t framebuffer() const;
};

class SpriteAtlas {
  public:
    explicit SpriteAtlas(const AtlasLimits& limits);
    // Does the driver have textures of that size?
    [[nodiscard]] static Status checkLimits(const AtlasLimits& limits);

    // Whether sprites are kept with their ids. A change forgets all that is held.
    void keepIds(bool ids);

    // The sprite of this key, if it is held.
    [[nodiscard]] std::optional<AtlasPlace> find(const SpriteKey& key);
    // Room to fill with the sprite of a key that is not held. Nothing when all room is taken by
    // sprites of this batch; a new batch always has room for one.
    [[nodiscard]] std::optional<AtlasPlace> add(const SpriteKey& key, glm::ivec2 size);
    void forget(const SpriteKey& key);
    // What was found or added so far has been drawn, and may go.
    void endBatch() { ++batch_; }
    void endFrame();
    [[nodiscard]] std::uint64_t bytes() const;

  private:
    struct Entry {
        glm::ivec3 corner{0};
        glm::ivec2 size{0};
        std::unique_ptr<SpriteSheet> own;  // of a large sprite
        std::uint64_t lastBatch = 0;
        std::uint64_t lastFrame = 0;
    };
    using Entries = std::unordered_map<SpriteKey, Entry>;

    [[nodiscard]] AtlasPlace placeOf(const Entry& entry) const;
    [[nodiscard]] std::optional<AtlasPlace> addLarge(const SpriteKey& key, glm::ivec2 size);
    [[nodiscard]] bool addPages();
    [[nodiscard]] bool evictOld();
    [[nodiscard]] bool evictHalf();
    [[nodiscard]] bool evictLarge();
    [[nodiscard]] std::uint64_t largeBytes() const;

    AtlasLimits limits_;
    bool ids_ = false;
    ShelfPacker packer_;
    SpriteSheet pages_;
    Entries entries_;
    Entries large_;  // larger than a page
    std::uint64_t batch_ = 0;
    std::uint64_t frame_ = 0;
};

}  // namespace voxprite
