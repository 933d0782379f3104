#include "render/sprite_cache.h"

#include <algorithm>

namespace voxprite {

namespace {

constexpr std::uint64_t kFramesKept = 3;
constexpr std::size_t kSparesKept = 16;
constexpr std::int64_t kLargestSpare = std::int64_t{1} << 20;  // pixels

// Sizes grow in steps, so that a turning model finds its textures again.
glm::ivec2 roomySize(glm::ivec2 size) {
    constexpr int kStep = 64;
    return (size + kStep - 1) / kStep * kStep;
}

}  // namespace

SpriteTextures* SpriteCache::find(const SpriteKey& key) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) return nullptr;
    found->second.lastFrame = frame_;
    return found->second.textures.get();
}

SpriteTextures& SpriteCache::add(const SpriteKey& key, glm::ivec2 size) {
    Entry& entry = entries_[key];
    entry.lastFrame = frame_;
    const auto spare =
        std::ranges::find_if(spare_, [&](const auto& textures) { return textures->holds(size); });
    if (spare != spare_.end()) {
        entry.textures = std::move(*spare);
        spare_.erase(spare);
    } else {
        entry.textures = std::make_unique<SpriteTextures>(roomySize(size));
    }
    return *entry.textures;
}

void SpriteCache::forget(const SpriteKey& key) {
    entries_.erase(key);
}

void SpriteCache::endFrame() {
    for (auto item = entries_.begin(); item != entries_.end();) {
        Entry& entry = item->second;
        if (frame_ - entry.lastFrame < kFramesKept) {
            ++item;
            continue;
        }
        const glm::ivec2 capacity = entry.textures->capacity;
        if (std::int64_t{capacity.x} * capacity.y <= kLargestSpare) {
            if (spare_.size() == kSparesKept) spare_.erase(spare_.begin());
            spare_.push_back(std::move(entry.textures));
        }
        item = entries_.erase(item);
    }
    ++frame_;
}

}  // namespace voxprite
