#include "render/sprite_caster.h"

#include <glad/gl.h>

#include <algorithm>
#include <glm/common.hpp>
#include <span>

#include "render/gl/draw_state.h"
#include "render/sprite_blocks.h"

namespace voxprite {

namespace {

// Larger buffers are cast in tiles of this edge: drivers bound the size of a texture.
constexpr int kTileEdge = 2048;
// The scratch buffer keeps growing with what it is asked for up to this many pixels.
constexpr std::int64_t kRoomyPixels = std::int64_t{1} << 22;

std::int64_t area(glm::ivec2 size) {
    return std::int64_t{size.x} * size.y;
}

gl::Texture dataTexture(GLenum format, glm::ivec2 size) {
    gl::Texture texture = gl::createTexture2d();
    glTextureStorage2D(texture.id(), 1, format, size.x, size.y);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void beginTarget(std::uint32_t framebuffer, glm::ivec2 corner, glm::ivec2 size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(corner.x, corner.y, size.x, size.y);
    gl::apply({});
}

// Copies a rectangle of the textures to where its pixels belong in `buffer`, turned over.
void readTile(const SpriteTextures& textures, glm::ivec2 corner, glm::ivec2 size, glm::ivec2 place,
              SpriteBuffer& buffer) {
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<Rgba8> colours(count);
    std::vector<std::uint32_t> ids(count);
    const auto bytes = static_cast<GLsizei>(4 * count);
    glGetTextureSubImage(textures.colours.id(), 0, corner.x, corner.y, 0, size.x, size.y, 1,
                         GL_RGBA, GL_UNSIGNED_BYTE, bytes, colours.data());
    glGetTextureSubImage(textures.ids.id(), 0, corner.x, corner.y, 0, size.x, size.y, 1,
                         GL_RED_INTEGER, GL_UNSIGNED_INT, bytes, ids.data());
    for (int y = 0; y < size.y; ++y) {
        const int row = buffer.size.y - 1 - (place.y + y);
        const auto to = static_cast<std::ptrdiff_t>(row) * buffer.size.x + place.x;
        const auto from = static_cast<std::ptrdiff_t>(y) * size.x;
        std::copy_n(colours.begin() + from, size.x, buffer.colours.begin() + to);
        std::copy_n(ids.begin() + from, size.x, buffer.ids.begin() + to);
    }
}

}  // namespace

SpriteTextures::SpriteTextures(glm::ivec2 size)
    : colours(dataTexture(GL_RGBA8, size)),
      ids(dataTexture(GL_R32UI, size)),
      framebuffer(gl::createFramebuffer()),
      capacity(size) {
    glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT0, colours.id(), 0);
    glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT1, ids.id(), 0);
    const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferDrawBuffers(framebuffer.id(), 2, targets);
}

Status LatticePrograms::use(bool narrow) {
    gl::Program& program = narrow ? narrow_ : wide_;
    if (!program) {
        std::vector<std::string> defines = defines_;
        if (!narrow) defines.emplace_back("LATTICE_WIDE");
        Result<gl::Program> compiled = gl::compileProgram(vertex_, fragment_, defines);
        if (!compiled) return tl::unexpected(compiled.error());
        program = std::move(*compiled);
    }
    gl::useProgram(program);
    return {};
}

Result<SpriteCaster> SpriteCaster::create() {
    SpriteCaster caster;
    if (const Status compiled = caster.cast_.use(true); !compiled) {
        return tl::unexpected(compiled.error());
    }
    Result<gl::Program> outline = gl::compileProgram("sprite_quad.vert", "sprite_outline.frag");
    if (!outline) return tl::unexpected(outline.error());
    caster.outline_ = std::move(*outline);
    return caster;
}

Status SpriteCaster::checkSize(glm::ivec2 size) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (size.x <= limit && size.y <= limit) return {};
    return fail("a sprite of " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                " virtual pixels on the screen; textures of this driver end at " +
                std::to_string(limit));
}

void SpriteCaster::bindInputs(const GpuOctree& octree, const LatticeView& lattice,
                              const LitPalette& lit) {
    octreeBlock_.set(BlockBinding::octree, octree.block());
    latticeBlock_.set(BlockBinding::lattice, latticeBlock(lattice, octree));
    palette_.set(lit);
    bindTexture(TextureUnit::svo, octree.texture());
    bindTexture(TextureUnit::palette, palette_.texture());
    glBindVertexArray(nothing_.id());
}

Status SpriteCaster::cast(const GpuOctree& octree, const LatticeView& lattice,
                          const LitPalette& lit, std::uint32_t framebuffer, glm::ivec2 corner) {
    if (!scratch_.holds(lattice.size)) {
        const glm::ivec2 both = glm::max(scratch_.capacity, lattice.size);
        scratch_ = SpriteTextures(area(both) <= kRoomyPixels ? both : lattice.size);
    }
    bindInputs(octree, lattice, lit);
    if (const Status ready = cast_.use(castsNarrow(lattice, octree.size())); !ready) return ready;
    beginTarget(scratch_.framebuffer.id(), glm::ivec2(0), lattice.size);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    SpriteBlock block = bufferBlock(lattice, lit.outline);
    block.atlas_place = glm::ivec3(corner, 0);
    sprite_.set(BlockBinding::sprite, std::span<const SpriteBlock>(&block, 1));
    bindTexture(TextureUnit::spriteColours, scratch_.colours.id());
    bindTexture(TextureUnit::spriteIds, scratch_.ids.id());
    gl::useProgram(outline_);
    beginTarget(framebuffer, corner, lattice.size);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    return {};
}

Status SpriteCaster::castSinglePass(const GpuOctree& octree, const LatticeView& lattice,
                                    const LitPalette& lit, SpriteTextures& target) {
    bindInputs(octree, lattice, lit);
    const SpriteBlock block = bufferBlock(lattice, lit.outline);
    sprite_.set(BlockBinding::sprite, std::span<const SpriteBlock>(&block, 1));
    if (const Status ready = single_.use(castsNarrow(lattice, octree.size())); !ready) return ready;
    beginTarget(target.framebuffer.id(), glm::ivec2(0), lattice.size);
    const glm::vec4 noColour(0.0f);
    const glm::uvec4 noId(kIdEmpty);
    glClearNamedFramebufferfv(target.framebuffer.id(), GL_COLOR, 0, &noColour.x);
    glClearNamedFramebufferuiv(target.framebuffer.id(), GL_COLOR, 1, &noId.x);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    return {};
}

Result<SpriteBuffer> SpriteCaster::castBuffer(const GpuOctree& octree, const LatticeView& lattice,
                                              const LitPalette& lit, SpriteMode mode) {
    SpriteBuffer buffer;
    buffer.first = lattice.first;
    buffer.size = lattice.size;
    const auto count = static_cast<std::size_t>(area(lattice.size));
    buffer.colours.assign(count, Rgba8(0));
    buffer.ids.assign(count, kIdEmpty);
    if (count == 0 || octree.texture() == 0) return buffer;

    SpriteTextures target(glm::min(lattice.size, glm::ivec2(kTileEdge + 2)));
    for (int y = 0; y < lattice.size.y; y += kTileEdge) {
        for (int x = 0; x < lattice.size.x; x += kTileEdge) {
            // One pixel more all round: the outline looks at its neighbours.
            const glm::ivec2 low(x, y);
            const glm::ivec2 high = glm::min(low + kTileEdge, lattice.size);
            const glm::ivec2 paddedLow = glm::max(low - 1, glm::ivec2(0));
            const glm::ivec2 paddedHigh = glm::min(high + 1, lattice.size);
            LatticeView tile = lattice;
            tile.first = lattice.first + paddedLow;
            tile.size = paddedHigh - paddedLow;
            const Status done = mode == SpriteMode::spriteBuffer
                                    ? cast(octree, tile, lit, target.framebuffer.id())
                                    : castSinglePass(octree, tile, lit, target);
            if (!done) return tl::unexpected(done.error());
            readTile(target, low - paddedLow, high - low, low, buffer);
        }
    }
    return buffer;
}

}  // namespace voxprite
