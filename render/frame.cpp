#include "render/frame.h"

#include <glad/gl.h>

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace voxprite {

namespace {

constexpr float kFarthest = 0.0f;

// Words of RGBA8 have red in their lowest byte.
static_assert(std::endian::native == std::endian::little);

void allowClearing() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
}

template <class T>
void flipRows(std::vector<T>& values, int width) {
    const auto stride = static_cast<std::ptrdiff_t>(width);
    auto top = values.begin();
    auto bottom = values.end();
    while (bottom - top >= 2 * stride) {
        bottom -= stride;
        std::swap_ranges(top, top + stride, bottom);
        top += stride;
    }
}

}  // namespace

Status Frame::checkSize(glm::ivec2 sizePx) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (sizePx.x <= most && sizePx.y <= most) return {};
    return fail("a picture of " + std::to_string(sizePx.x) + " x " + std::to_string(sizePx.y) +
                " pixels; textures of this driver end at " + std::to_string(most));
}

Frame::Frame(glm::ivec2 sizePx) {
    resize(sizePx);
}

void Frame::resize(glm::ivec2 sizePx) {
    sizePx = glm::max(sizePx, glm::ivec2(1));
    if (!checkSize(sizePx)) sizePx = glm::ivec2(1);  // draws onto it fail, by its size
    if (sizePx == sizePx_) return;
    sizePx_ = sizePx;
    colour_ = gl::createTexture2d();
    depth_ = gl::createTexture2d();
    glTextureStorage2D(colour_.id(), 1, GL_RGBA8, sizePx.x, sizePx.y);
    glTextureStorage2D(depth_.id(), 1, GL_DEPTH_COMPONENT32F, sizePx.x, sizePx.y);
    for (const std::uint32_t texture : {colour_.id(), depth_.id()}) {
        glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    framebuffer_ = gl::createFramebuffer();
    glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, colour_.id(), 0);
    glNamedFramebufferTexture(framebuffer_.id(), GL_DEPTH_ATTACHMENT, depth_.id(), 0);
    words_ = gl::createTextureView(colour_, GL_R32UI);
    wordsFramebuffer_ = gl::createFramebuffer();
    glNamedFramebufferTexture(wordsFramebuffer_.id(), GL_COLOR_ATTACHMENT0, words_.id(), 0);
    glNamedFramebufferTexture(wordsFramebuffer_.id(), GL_DEPTH_ATTACHMENT, depth_.id(), 0);
}

void Frame::bind() {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, sizePx_.x, sizePx_.y);
}

void Frame::bindWords() {
    glBindFramebuffer(GL_FRAMEBUFFER, wordsFramebuffer_.id());
    glViewport(0, 0, sizePx_.x, sizePx_.y);
}

void Frame::begin(Rgba8 background) {
    bind();
    allowClearing();
    const glm::vec4 colour = glm::vec4(background) / 255.0f;
    glClearBufferfv(GL_COLOR, 0, &colour.x);
    glClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

void Frame::beginWords(Rgba8 background) {
    bindWords();
    allowClearing();
    const glm::uvec4 colour(std::bit_cast<std::uint32_t>(background), 0, 0, 0);
    glClearBufferuiv(GL_COLOR, 0, &colour.x);
    glClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

void Frame::set(const Image& picture) {
    if (glm::ivec2(picture.width, picture.height) != sizePx_) return;
    std::vector<Rgba8> rows = picture.pixels;
    flipRows(rows, sizePx_.x);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(colour_.id(), 0, 0, 0, sizePx_.x, sizePx_.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        rows.data());
}

Image Frame::readColour() const {
    Image image(sizePx_.x, sizePx_.y);
    const auto bytes = static_cast<GLsizei>(image.pixels.size() * sizeof(Rgba8));
    glGetTextureImage(colour_.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes, image.pixels.data());
    flipRows(image.pixels, sizePx_.x);
    return image;
}

std::vector<float> Frame::readDepth() const {
    std::vector<float> depth(static_cast<std::size_t>(sizePx_.x) *
                             static_cast<std::size_t>(sizePx_.y));
    const auto bytes = static_cast<GLsizei>(depth.size() * sizeof(float));
    glGetTextureImage(depth_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, bytes, depth.data());
    flipRows(depth, sizePx_.x);
    return depth;
}

}  // namespace voxprite
