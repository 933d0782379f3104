#include "render/sprite_atlas.h"

#include <glad/gl.h>

#include <algorithm>
#include <glm/common.hpp>
#include <string>

namespace voxprite {

namespace {

constexpr std::uint64_t kBytesPerTexel = 4;  // of both textures
// Sprites that are not shown are kept for as many frames: large ones no longer, others until the
// room is needed.
constexpr std::uint64_t kFramesKept = 5;  // four pictures side by side are four frames

gl::Texture pageArray(glm::ivec3 size) {
    gl::Texture texture = gl::createTexture2dArray();
    glTextureStorage3D(texture.id(), 1, GL_R32UI, size.x, size.y, size.z);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void copyPages(const gl::Texture& from, const gl::Texture& to, glm::ivec3 size) {
    glCopyImageSubData(from.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D_ARRAY, 0,
                       0, 0, 0, size.x, size.y, size.z);
}

// Sizes grow in steps, so that a turning model finds its textures again.
glm::ivec2 roomySize(glm::ivec2 size) {
    constexpr int kStep = 64;
    return (size + kStep - 1) / kStep * kStep;
}

}  // namespace

SpriteSheet::SpriteSheet(glm::ivec3 pagesSize, bool withIds)
    : colours(pageArray(pagesSize)), size(pagesSize) {
    if (withIds) ids = pageArray(pagesSize);
    const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    for (int page = 0; page < size.z; ++page) {
        const gl::Framebuffer& framebuffer = framebuffers.emplace_back(gl::createFramebuffer());
        const GLuint id = framebuffer.id();
        glNamedFramebufferTextureLayer(id, GL_COLOR_ATTACHMENT0, colours.id(), 0, page);
        if (withIds) glNamedFramebufferTextureLayer(id, GL_COLOR_ATTACHMENT1, ids.id(), 0, page);
        glNamedFramebufferDrawBuffers(id, withIds ? 2 : 1, targets);
    }
}

std::uint64_t SpriteSheet::bytesOf(glm::ivec3 size, bool withIds) {
    return (withIds ? 2 : 1) * kBytesPerTexel * static_cast<std::uint64_t>(size.x) *
           static_cast<std::uint64_t>(size.y) * static_cast<std::uint64_t>(size.z);
}

std::uint32_t AtlasPlace::framebuffer() const {
    return sheet->framebuffers[static_cast<std::size_t>(corner.z)].id();
}

SpriteAtlas::SpriteAtlas(const AtlasLimits& limits)
    : limits_(limits), packer_(glm::ivec2(limits.pageEdgePx)) {}

Status SpriteAtlas::checkLimits(const AtlasLimits& limits) {
    GLint edge = 0;
    GLint pages = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &edge);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &pages);
    if (limits.pageEdgePx >= 1 && limits.pageEdgePx <= edge && limits.pages >= 1 &&
        limits.pages <= pages) {
        return {};
    }
    return fail("an atlas of " + std::to_string(limits.pages) + " pages of " +
                std::to_string(limits.pageEdgePx) + " pixels; this driver has up to " +
                std::to_string(pages) + " of up to " + std::to_string(edge));
}

void SpriteAtlas::keepIds(bool ids) {
    if (ids == ids_) return;
    ids_ = ids;
    entries_.clear();
    large_.clear();
    pages_ = {};
    packer_ = ShelfPacker(glm::ivec2(limits_.pageEdgePx));
}

AtlasPlace SpriteAtlas::placeOf(const Entry& entry) const {
    return {entry.own ? entry.own.get() : &pages_, entry.corner};
}

std::optional<AtlasPlace> SpriteAtlas::find(const SpriteKey& key) {
    for (Entries* entries : {&entries_, &large_}) {
        const auto found = entries->find(key);
        if (found == entries->end()) continue;
        found->second.lastBatch = batch_;
        found->second.lastFrame = frame_;
        return placeOf(found->second);
    }
    return std::nullopt;
}

std::optional<AtlasPlace> SpriteAtlas::add(const SpriteKey& key, glm::ivec2 size) {
    if (size.x > limits_.pageEdgePx || size.y > limits_.pageEdgePx) return addLarge(key, size);
    std::optional<glm::ivec3> corner = packer_.take(size);
    while (!corner) {
        if (!evictOld() && !addPages() && !evictHalf()) return std::nullopt;
        corner = packer_.take(size);
    }
    const auto entry = entries_.emplace(key, Entry{*corner, size, nullptr, batch_, frame_}).first;
    return placeOf(entry->second);
}

std::optional<AtlasPlace> SpriteAtlas::addLarge(const SpriteKey& key, glm::ivec2 size) {
    Entry entry{glm::ivec3(0), size, nullptr, batch_, frame_};
    // One that a sprite has left will do.
    const auto spare = std::ranges::find_if(large_, [&](const auto& item) {
        const Entry& old = item.second;
        return old.lastFrame + 1 < frame_ && old.own->size.x >= size.x && old.own->size.y >= size.y;
    });
    if (spare != large_.end()) {
        entry.own = std::move(spare->second.own);
        large_.erase(spare);
    } else {
        const glm::ivec3 sheet(roomySize(size), 1);
        while (!large_.empty() &&
               largeBytes() + SpriteSheet::bytesOf(sheet, ids_) > limits_.largeBytes) {
            if (!evictLarge()) return std::nullopt;
        }
        entry.own = std::make_unique<SpriteSheet>(sheet, ids_);
    }
    return placeOf(large_.emplace(key, std::move(entry)).first->second);
}

// Twice as many as there are, within the limit; what they hold stays where it is.
bool SpriteAtlas::addPages() {
    const int before = packer_.pages();
    const int after = std::min(std::max(2 * before, 1), limits_.pages);
    if (after <= before) return false;
    SpriteSheet more(glm::ivec3(glm::ivec2(limits_.pageEdgePx), after), ids_);
    if (before > 0) {
        copyPages(pages_.colours, more.colours, pages_.size);
        if (ids_) copyPages(pages_.ids, more.ids, pages_.size);
    }
    pages_ = std::move(more);
    while (packer_.pages() < after) packer_.addPage();
    return true;
}

// What was not shown for a few frames.
bool SpriteAtlas::evictOld() {
    const std::size_t before = entries_.size();
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const bool old = frame_ - entry->second.lastFrame > kFramesKept;
        if (old) packer_.giveBack(entry->second.corner, entry->second.size);
        entry = old ? entries_.erase(entry) : std::next(entry);
    }
    return entries_.size() < before;
}

// Of the sprites that this batch does not show, the half that was shown longest ago.
bool SpriteAtlas::evictHalf() {
    std::vector<Entries::iterator> idle;
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
        if (entry->second.lastBatch != batch_) idle.push_back(entry);
    }
    const auto middle = idle.begin() + static_cast<std::ptrdiff_t>((idle.size() + 1) / 2);
    std::nth_element(idle.begin(), middle, idle.end(), [](const auto& a, const auto& b) {
        return a->second.lastBatch < b->second.lastBatch;
    });
    for (auto entry = idle.begin(); entry != middle; ++entry) {
        packer_.giveBack((*entry)->second.corner, (*entry)->second.size);
        entries_.erase(*entry);
    }
    return !idle.empty();
}

// Of the large sprites that this batch does not show, the one that was shown longest ago.
bool SpriteAtlas::evictLarge() {
    const auto lastBatch = [](const auto& item) { return item.second.lastBatch; };
    const auto oldest = std::ranges::min_element(large_, {}, lastBatch);
    if (oldest == large_.end() || oldest->second.lastBatch == batch_) return false;
    large_.erase(oldest);
    return true;
}

void SpriteAtlas::forget(const SpriteKey& key) {
    large_.erase(key);
    const auto found = entries_.find(key);
    if (found == entries_.end()) return;
    packer_.giveBack(found->second.corner, found->second.size);
    entries_.erase(found);
}

void SpriteAtlas::endFrame() {
    endBatch();
    std::erase_if(large_,
                  [&](const auto& item) { return frame_ - item.second.lastFrame >= kFramesKept; });
    ++frame_;
}

std::uint64_t SpriteAtlas::largeBytes() const {
    std::uint64_t sum = 0;
    for (const auto& [key, entry] : large_) sum += entry.own->bytes();
    return sum;
}

std::uint64_t SpriteAtlas::bytes() const {
    return pages_.bytes() + largeBytes();
}

}  // namespace voxprite
