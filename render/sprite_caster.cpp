#include "render/sprite_caster.h"

#include <glad/gl.h>

#include <algorithm>
#include <glm/common.hpp>
#include <span>
#include <string>
#include <tuple>

#include "render/gl/draw_state.h"
#include "render/palette_texture.h"

namespace voxprite {

namespace {

// Larger buffers are cast in tiles of this edge: drivers bound the size of a texture.
constexpr int kTileEdge = 2048;
// The scratch buffer keeps growing with what it is asked for up to this many pixels.
constexpr std::int64_t kRoomyPixels = std::int64_t{1} << 22;

// Groups of sprite_cast.comp: their pixels, and how many lie in a row of the dispatch.
constexpr glm::ivec2 kTilePx{16, 4};
constexpr std::size_t kGroupsAcross = 32'768;

// CastTile
struct CastTile {
    glm::ivec2 corner{0};
    std::int32_t sprite = 0;
    std::int32_t unused = 0;
};
static_assert(sizeof(CastTile) == 16);

std::int64_t area(glm::ivec2 size) {
    return std::int64_t{size.x} * size.y;
}

gl::Texture dataTexture(glm::ivec2 size) {
    gl::Texture texture = gl::createTexture2d();
    glTextureStorage2D(texture.id(), 1, GL_R32UI, size.x, size.y);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

SpriteVariants castVariants(const CastJob& job, const SpriteDrawBlock& block) {
    SpriteVariants variants = job.narrow ? kPlain : kWideLattice;
    if (block.occlusion_shown != 0 || block.shadows_shown != 0) variants |= kFaceShade;
    return variants;
}

void beginTarget(std::uint32_t framebuffer, glm::ivec2 size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
}

void bindImage(std::uint32_t unit, const gl::Texture& texture) {
    glBindImageTexture(unit, texture.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32UI);
}

// Copies a rectangle of the textures to where its pixels belong in `buffer`, turned over.
void readTile(const SpriteTextures& textures, glm::ivec2 corner, glm::ivec2 size, glm::ivec2 place,
              SpriteBuffer& buffer) {
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<Rgba8> colours(count);
    std::vector<std::uint32_t> ids(count);
    const auto bytes = static_cast<GLsizei>(4 * count);
    glGetTextureSubImage(textures.colours.id(), 0, corner.x, corner.y, 0, size.x, size.y, 1,
                         GL_RED_INTEGER, GL_UNSIGNED_INT, bytes, colours.data());
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

SpriteTextures::SpriteTextures(glm::ivec2 size, bool withIds)
    : colours(dataTexture(size)), capacity(size) {
    if (withIds) ids = dataTexture(size);
}

SpriteTarget::SpriteTarget(glm::ivec2 size)
    : textures(size, true), framebuffer(gl::createFramebuffer()) {
    const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT0, textures.colours.id(), 0);
    glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT1, textures.ids.id(), 0);
    glNamedFramebufferDrawBuffers(framebuffer.id(), 2, targets);
}

Status SpriteCaster::checkSize(glm::ivec2 size) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (size.x <= limit && size.y <= limit) return {};
    return fail("a sprite of " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                " virtual pixels on the screen; textures of this driver end at " +
                std::to_string(limit));
}

void SpriteCaster::needScratch(glm::ivec2 size, bool withIds) {
    const glm::ivec2 both = glm::max(scratch_.capacity, size);
    if (both == scratch_.capacity && (scratch_.ids || !withIds)) return;
    scratch_ = SpriteTextures(area(both) <= kRoomyPixels ? both : size, withIds);
}

Status SpriteCaster::cast(std::vector<CastJob>& jobs, std::uint32_t litRows, const SpriteLook& look,
                          bool withIds) {
    if (jobs.empty()) return {};
    const auto order = [](const CastJob& job) {
        return std::tuple(job.framebuffer, job.octreeTexture, job.narrow);
    };
    std::ranges::stable_sort(jobs, {}, order);
    std::vector<SpriteBlock> blocks;
    blocks.reserve(jobs.size());
    for (const CastJob& job : jobs) blocks.push_back(job.block);
    sprites_.set(BufferBinding::sprites, std::span<const SpriteBlock>(blocks));
    gl::apply({});
    const SpriteDrawBlock block = drawBlock(look);
    if (look.castsFromFaces()) occlusionRays_.bind();
    for (Run run{0, 0}; run.first < jobs.size(); run.first = run.end) {
        const std::uint32_t target = jobs[run.first].framebuffer;
        while (run.end < jobs.size() && jobs[run.end].framebuffer == target) ++run.end;
        bindTexture(TextureUnit::palette, litRows);
        if (Status done = castInto(jobs, run, block, withIds); !done) return done;
    }
    return {};
}

Status SpriteCaster::castInto(const std::vector<CastJob>& jobs, Run run, SpriteDrawBlock block,
                              bool withIds) {
    glm::ivec2 extent(0);
    for (std::size_t k = run.first; k < run.end; ++k) {
        const SpriteBlock& sprite = jobs[k].block;
        extent = glm::max(extent, glm::ivec2(sprite.atlas_place) + sprite.region_size);
    }
    needScratch(extent, withIds);
    block.target_size = glm::vec2(extent);
    for (Run part{run.first, run.first}; part.first < run.end; part.first = part.end) {
        const CastJob& first = jobs[part.first];
        while (part.end < run.end && jobs[part.end].octreeTexture == first.octreeTexture &&
               jobs[part.end].narrow == first.narrow) {
            ++part.end;
        }
        if (Status done = castRays(jobs, part, block, withIds); !done) return done;
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    if (Status ready = outline_.use(withIds ? kSpriteIds : kPlain); !ready) return ready;
    beginTarget(jobs[run.first].framebuffer, extent);
    bindTexture(TextureUnit::spriteColours, scratch_.colours.id());
    if (withIds) bindTexture(TextureUnit::spriteIds, scratch_.ids.id());
    block.first_sprite = static_cast<std::int32_t>(run.first);
    block.sprite_count = static_cast<std::int32_t>(run.end - run.first);
    shapes_.draw(block);
    return {};
}

Status SpriteCaster::castRays(const std::vector<CastJob>& jobs, Run part, SpriteDrawBlock block,
                              bool withIds) {
    const CastJob& first = jobs[part.first];
    const SpriteVariants ids = withIds ? kSpriteIds : kPlain;
    if (Status ready = cast_.use(castVariants(first, block) | ids); !ready) return ready;
    bindTexture(TextureUnit::svo, first.octreeTexture);
    castBlock_.set(BlockBinding::spriteDraw, block);
    std::vector<CastTile> tiles;
    for (std::size_t k = part.first; k < part.end; ++k) {
        const glm::ivec2 size = jobs[k].block.region_size;
        for (int y = 0; y < size.y; y += kTilePx.y)
            for (int x = 0; x < size.x; x += kTilePx.x)
                tiles.push_back({glm::ivec2(x, y), static_cast<std::int32_t>(k)});
    }
    if (tiles.empty()) return {};
    tiles_.set(BufferBinding::castTiles, std::span<const CastTile>(tiles));
    bindImage(0, scratch_.colours);
    if (withIds) bindImage(1, scratch_.ids);
    const std::size_t across = std::min(tiles.size(), kGroupsAcross);
    // Outlines drawn before may still read what is cast over now.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glDispatchCompute(static_cast<GLuint>(across),
                      static_cast<GLuint>((tiles.size() + across - 1) / across), 1);
    return {};
}

Status SpriteCaster::castSinglePass(const CastJob& job, std::uint32_t litRows,
                                    const SpriteLook& look, const SpriteTarget& target) {
    // A rectangle over all of the target.
    const std::array<glm::vec4, 4> corners{glm::vec4(-1, -1, 0, 1), glm::vec4(1, -1, 0, 1),
                                           glm::vec4(-1, 1, 0, 1), glm::vec4(1, 1, 0, 1)};
    sprites_.set(BufferBinding::sprites, std::span(&job.block, 1));
    corners_.set(BufferBinding::spriteCorners, std::span<const glm::vec4>(corners));
    bindTexture(TextureUnit::palette, litRows);
    bindTexture(TextureUnit::svo, job.octreeTexture);
    gl::apply({});
    SpriteDrawBlock block = drawBlock(look);
    if (look.castsFromFaces()) occlusionRays_.bind();
    if (Status ready = single_.use(castVariants(job, block)); !ready) return ready;
    beginTarget(target.framebuffer.id(), job.block.region_size);
    const glm::uvec4 empty(kIdEmpty);
    glClearNamedFramebufferuiv(target.framebuffer.id(), GL_COLOR, 0, &empty.x);
    glClearNamedFramebufferuiv(target.framebuffer.id(), GL_COLOR, 1, &empty.x);
    block.sprite_count = 1;
    shapes_.draw(block);
    return {};
}

Result<SpriteBuffer> SpriteCaster::castBuffer(const GpuOctree& octree, const LatticeView& lattice,
                                              const LitPalette& lit, SpriteMode mode) {
    if (!octree.status()) return tl::unexpected(octree.status().error());
    SpriteBuffer buffer;
    buffer.first = lattice.first;
    buffer.size = lattice.size;
    const auto count = static_cast<std::size_t>(area(lattice.size));
    buffer.colours.assign(count, Rgba8(0));
    buffer.ids.assign(count, kIdEmpty);
    if (count == 0 || octree.texture() == 0) return buffer;

    SpriteTarget target(glm::min(lattice.size, glm::ivec2(kTileEdge + 2)));
    bufferLit_.forgetAll();
    const std::optional<int> litRow = bufferLit_.rowOf(1, lit);
    std::vector<CastJob> jobs(1);
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
            CastJob& job = jobs.front();
            job = {castBlock(tile, octree, lit.rays.towardLight), target.framebuffer.id(),
                   octree.texture(), castsNarrow(tile, octree.size())};
            placeInputs(job.block, {octree.texture(), 0, octree.payloadOffset()}, *litRow);
            const Status done =
                mode == SpriteMode::spriteBuffer
                    ? cast(jobs, bufferLit_.texture(), SpriteLook(lit), true)
                    : castSinglePass(job, bufferLit_.texture(), SpriteLook(lit), target);
            if (!done) return tl::unexpected(done.error());
            readTile(target.textures, low - paddedLow, high - low, low, buffer);
        }
    }
    return buffer;
}

}  // namespace voxprite
