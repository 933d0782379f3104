// An off-screen picture: RGBA8 colour and 32-bit float depth, reversed (1 near, 0 far).
// Everything is drawn into a Frame; the editor shows its texture, tests read it back.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/base/image.h"
#include "core/base/result.h"
#include "render/gl/handles.h"

namespace voxprite {

class Frame {
  public:
    // Has the driver textures of this size?
    [[nodiscard]] static Status checkSize(glm::ivec2 sizePx);
    // Within that size, or what is drawn onto it fails.
    explicit Frame(glm::ivec2 sizePx);
    void resize(glm::ivec2 sizePx);  // keeps nothing; no-op when equal
    // Binds it, sets the viewport and clears colour and depth.
    void begin(Rgba8 background);
    void bind();  // to draw more onto it
    // The same with the colours as words of RGBA8 (R32UI, red lowest): for what moves colours and
    // does not compute with them.
    void beginWords(Rgba8 background);
    void bindWords();
    // Shows a picture of its very size, top row first; depths stay as they are.
    void set(const Image& picture);
    [[nodiscard]] glm::ivec2 sizePx() const { return sizePx_; }
    // Rows bottom first, as GL has them: show it flipped.
    [[nodiscard]] std::uint32_t colourTexture() const { return colour_.id(); }
    [[nodiscard]] std::uint32_t depthTexture() const { return depth_.id(); }  // the same way up
    [[nodiscard]] Image readColour() const;                                   // top row first
    [[nodiscard]] std::vector<float> readDepth() const;                       // top row first

  private:
    glm::ivec2 sizePx_{0};
    gl::Texture colour_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    gl::Texture words_;  // a view of colour_
    gl::Framebuffer wordsFramebuffer_;
};

}  // namespace voxprite
