#include "render/sprite_programs.h"

#include <glad/gl.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace voxprite {

namespace {

constexpr int kGroupSize = 32;  // as in shaders/shared/sprite_outputs.glsl

constexpr std::array<std::uint16_t, 6> kQuad{0, 1, 2, 2, 1, 3};
// Octant order, counter-clockwise seen from outside.
constexpr std::array<std::uint16_t, 36> kBox{0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,   // -x +x
                                             0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,   // -y +y
                                             0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};  // -z +z

// The indices of a group: those of one sprite again and again.
gl::Buffer groupIndices(std::span<const std::uint16_t> sprite, int corners) {
    std::vector<std::uint16_t> indices;
    for (int k = 0; k < kGroupSize; ++k) {
        for (const std::uint16_t index : sprite) {
            indices.push_back(static_cast<std::uint16_t>(index + k * corners));
        }
    }
    gl::Buffer buffer = gl::createBuffer();
    glNamedBufferStorage(buffer.id(),
                         static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint16_t)),
                         indices.data(), 0);
    return buffer;
}

}  // namespace

Status SpriteProgram::use(SpriteVariants variants) {
    gl::Program& program = programs_.at(variants);
    if (!program) {
        std::vector<std::string> defines;
        if ((variants & kWideLattice) != 0) defines.emplace_back("LATTICE_WIDE");
        if ((variants & kPerPixelDepth) != 0) defines.emplace_back("PER_PIXEL_DEPTH");
        if ((variants & kProxyBox) != 0) defines.emplace_back("PROXY_BOX");
        if ((variants & kSpriteIds) != 0) defines.emplace_back("SPRITE_IDS");
        if ((variants & kFaceShade) != 0) defines.emplace_back("FACE_SHADE");
        Result<gl::Program> compiled = compute_.empty()
                                           ? gl::compileProgram(vertex_, fragment_, defines)
                                           : gl::compileCompute(compute_, defines);
        if (!compiled) return tl::unexpected(compiled.error());
        program = std::move(*compiled);
    }
    gl::useProgram(program);
    return {};
}

SpriteShapes::SpriteShapes()
    : quads_{groupIndices(kQuad, 4), gl::createVertexArray()},
      boxes_{groupIndices(kBox, 8), gl::createVertexArray()} {
    for (const Shape* shape : {&quads_, &boxes_}) {
        glVertexArrayElementBuffer(shape->vertices.id(), shape->indices.id());
    }
}

void SpriteShapes::draw(const SpriteDrawBlock& block, bool boxes) {
    drawBlock_.set(BlockBinding::spriteDraw, block);
    glBindVertexArray((boxes ? boxes_ : quads_).vertices.id());
    const auto each = static_cast<int>(boxes ? kBox.size() : kQuad.size());
    glDrawElementsInstanced(GL_TRIANGLES, each * std::min(block.sprite_count, kGroupSize),
                            GL_UNSIGNED_SHORT, nullptr,
                            (block.sprite_count + kGroupSize - 1) / kGroupSize);
}

}  // namespace voxprite
