#include "render/snapshot_layers.h"

#include <glad/gl.h>

#include <algorithm>

namespace voxprite {

namespace {

constexpr int kFirstLayers = 8;
constexpr int kLeastLayers = 3;  // a blend's

gl::Texture layersOf(GLenum format, int edge, int count) {
    gl::Texture texture = gl::createTexture2dArray();
    glTextureStorage3D(texture.id(), 1, format, edge, edge, count);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void copy(std::uint32_t from, GLenum target, std::uint32_t to, int toLayer, glm::ivec3 size) {
    glCopyImageSubData(from, target, 0, 0, 0, 0, to, GL_TEXTURE_2D_ARRAY, 0, 0, 0, toLayer, size.x,
                       size.y, size.z);
}

}  // namespace

std::uint64_t SnapshotLayers::bytesPerLayer() const {
    return 8u * static_cast<std::uint64_t>(sizePx_) * static_cast<std::uint64_t>(sizePx_);
}

void SnapshotLayers::reset(int sizePx, std::uint64_t mostBytes) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &limit);
    sizePx_ = sizePx;
    const std::uint64_t fitting = mostBytes / bytesPerLayer();
    mostLayers_ = std::max(kLeastLayers,
                           static_cast<int>(std::min(fitting, static_cast<std::uint64_t>(limit))));
    capacity_ = 0;
    colours_.reset();
    depths_.reset();
    entries_.clear();
}

std::optional<int> SnapshotLayers::find(const Key& key) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) return std::nullopt;
    found->second.lastUse = ++uses_;
    return found->second.layer;
}

std::optional<int> SnapshotLayers::add(const Key& key) {
    int layer = held();
    if (layer >= capacity_ && !grow()) {
        const auto oldest = std::ranges::min_element(
            entries_, {}, [](const auto& item) { return item.second.lastUse; });
        if (oldest->second.lastUse > batchBegan_) return std::nullopt;
        layer = oldest->second.layer;
        entries_.erase(oldest);
    }
    entries_.emplace(key, Entry{layer, ++uses_});
    return layer;
}

// Twice as many, within the limit.
bool SnapshotLayers::grow() {
    const int more = std::min(std::max(2 * capacity_, kFirstLayers), mostLayers_);
    if (more <= capacity_) return false;
    gl::Texture colours = layersOf(GL_RGBA8, sizePx_, more);
    gl::Texture depths = layersOf(GL_DEPTH_COMPONENT32F, sizePx_, more);
    if (capacity_ > 0) {
        const glm::ivec3 all(sizePx_, sizePx_, capacity_);
        copy(colours_.id(), GL_TEXTURE_2D_ARRAY, colours.id(), 0, all);
        copy(depths_.id(), GL_TEXTURE_2D_ARRAY, depths.id(), 0, all);
    }
    colours_ = std::move(colours);
    depths_ = std::move(depths);
    capacity_ = more;
    return true;
}

void SnapshotLayers::copyFrom(const Frame& frame, int layer) {
    const glm::ivec3 size(sizePx_, sizePx_, 1);
    copy(frame.colourTexture(), GL_TEXTURE_2D, colours_.id(), layer, size);
    copy(frame.depthTexture(), GL_TEXTURE_2D, depths_.id(), layer, size);
}

}  // namespace voxprite
