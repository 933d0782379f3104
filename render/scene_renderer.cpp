#include "render/scene_renderer.h"

#include <glad/gl.h>

#include <algorithm>
#include <span>

#include "core/sprite/lattice_memo.h"
#include "render/gl/draw_state.h"
#include "render/scene_backdrop.h"
#include "render/sprite_atlas.h"
#include "render/sprite_blocks.h"
#include "render/sprite_caster.h"

namespace voxprite {

namespace {

// A sprite that is on the screen this frame.
struct SeenSprite {
    const SceneEntity* entity = nullptr;
    SpriteView view;
    LatticeView shown;          // the part of the lattice to cast and to draw
    glm::ivec2 visibleSize{0};  // of that, the part that is on the screen
    LitPalettes::Numbered lit;
};

// The whole sprite where most of it is on the screen: it then stays the same while it moves across
// the edge, and others show it too. Of a sprite seen close only what is on the screen.
LatticeView shownLattice(const LatticeView& whole, const LatticeView& visible) {
    constexpr int kLargestWhole = 4096;  // less than any driver's limit
    const auto area = [](glm::ivec2 size) { return std::int64_t{size.x} * size.y; };
    const bool small = whole.size.x <= kLargestWhole && whole.size.y <= kLargestWhole;
    return small && 2 * area(visible.size) >= area(whole.size) ? whole : visible;
}

// The screen pixels of the region's rectangle: how many fragments a single pass casts for.
std::uint64_t fragmentCount(const SeenSprite& sprite, const Camera& camera) {
    const double scale =
        sprite.view.metresPerPx / camera.metresPerScreenPx(sprite.view.planeDepthMetres);
    const double area =
        scale * scale * static_cast<double>(sprite.visibleSize.x) * sprite.visibleSize.y;
    const double screen = static_cast<double>(camera.viewportPx.x) * camera.viewportPx.y;
    return static_cast<std::uint64_t>(std::min(area, screen));
}

std::uint64_t pixelCount(const LatticeView& lattice) {
    return static_cast<std::uint64_t>(lattice.size.x) * static_cast<std::uint64_t>(lattice.size.y);
}

// Sprites that one draw call puts onto the screen, in the order of the scene.
struct Batch {
    const SpriteSheet* sheet = nullptr;
    std::vector<SpriteBlock> sprites;
    bool narrow = true;  // all of them

    void clear() {
        sheet = nullptr;
        sprites.clear();
        narrow = true;
    }
};

}  // namespace

struct SceneRenderer::Impl {
    SpriteCaster caster;
    SceneBackdrop backdrop;
    SpriteAtlas atlas;
    LatticeMemo lattices;
    LitPalettes litPalettes;
    LatticePrograms blit{"sprite_quad.vert", "sprite_blit.frag"};
    // Deep: with a depth for each pixel.
    LatticePrograms blitDeep{"sprite_quad.vert", "sprite_blit.frag", {"PER_PIXEL_DEPTH"}};
    LatticePrograms single{"sprite_quad.vert", "sprite_single.frag"};
    LatticePrograms singleDeep{"sprite_quad.vert", "sprite_single.frag", {"PER_PIXEL_DEPTH"}};
    gl::StorageBuffer sprites;
    gl::VertexArray nothing = gl::createVertexArray();
    Batch batch;  // kept for its memory

    Impl(SpriteCaster spriteCaster, SceneBackdrop sceneBackdrop, const AtlasLimits& limits)
        : caster(std::move(spriteCaster)), backdrop(std::move(sceneBackdrop)), atlas(limits) {}

    [[nodiscard]] Result<std::vector<SeenSprite>> look(const Scene& scene, const Camera& camera,
                                                       const GameProfile& profile,
                                                       SceneStats& stats);
    [[nodiscard]] Status drawBuffered(Frame& frame, std::span<const SeenSprite> seen,
                                      const Camera& camera, const GameProfile& profile,
                                      SceneStats& stats);
    [[nodiscard]] Status drawSingle(std::span<const SeenSprite> seen, const Camera& camera,
                                    const GameProfile& profile, SceneStats& stats);
    [[nodiscard]] Result<std::optional<AtlasPlace>> placeOf(const SeenSprite& sprite,
                                                            SceneStats& stats);
    [[nodiscard]] Status drawBatch(Frame& frame, const GameProfile& profile, SceneStats& stats);
    void drawSprites(std::span<const SpriteBlock> blocks, SceneStats& stats);
};

Result<std::vector<SeenSprite>> SceneRenderer::Impl::look(const Scene& scene, const Camera& camera,
                                                          const GameProfile& profile,
                                                          SceneStats& stats) {
    litPalettes.beginFrame();
    std::vector<SeenSprite> seen;
    seen.reserve(scene.entities.size());
    for (const SceneEntity& entity : scene.entities) {
        if (entity.octree->texture() == 0) {
            ++stats.unseen;
            continue;
        }
        const Result<SpriteViewResult> result =
            viewSprite(entity.placed, camera, profile, entity.history, &lattices);
        if (!result) return tl::unexpected(result.error());
        LatticeView visible;
        if (result->view) visible = visibleLattice(*result->view, camera);
        if (!result->view || visible.size.x <= 0 || visible.size.y <= 0) {
            ++stats.unseen;
            continue;
        }
        const SpriteView& view = *result->view;
        if (stats.drawn++ == 0) {
            stats.sigmaInForce = view.sigmaInForce;
            stats.screenPxPerPx = view.screenPxPerPx;
        }
        seen.push_back({&entity, view, shownLattice(view.lattice, visible), visible.size,
                        litPalettes.of(*entity.palette, view.light8, profile.outline)});
    }
    return seen;
}

// Where the finished sprite lies, cast now if it is not held; nothing when the batch has to be
// drawn first to make room.
Result<std::optional<AtlasPlace>> SceneRenderer::Impl::placeOf(const SeenSprite& sprite,
                                                               SceneStats& stats) {
    const GpuOctree& octree = *sprite.entity->octree;
    const SpriteKey key{octree.revision(), 0, sprite.shown, sprite.lit.number};
    if (const std::optional<AtlasPlace> held = atlas.find(key)) {
        ++stats.castsReused;
        return held;
    }
    if (const Status fits = SpriteCaster::checkSize(sprite.shown.size); !fits) {
        return tl::unexpected(fits.error());
    }
    const std::optional<AtlasPlace> place = atlas.add(key, sprite.shown.size);
    if (!place) return place;
    const Status done = caster.cast(octree, sprite.shown, *sprite.lit.lit, place->framebuffer(),
                                    glm::ivec2(place->corner));
    if (!done) {
        atlas.forget(key);
        return tl::unexpected(done.error());
    }
    ++stats.casts;
    stats.rays += pixelCount(sprite.shown);
    return place;
}

void SceneRenderer::Impl::drawSprites(std::span<const SpriteBlock> blocks, SceneStats& stats) {
    sprites.set(BlockBinding::sprite, blocks);
    glBindVertexArray(nothing.id());
    const bool box = blocks.front().proxy_is_box != 0;
    gl::apply({.depthTest = gl::DepthTest::nearer,
               .depthWrite = true,
               .cull = box ? gl::Cull::frontFaces : gl::Cull::none});
    glDrawArraysInstanced(GL_TRIANGLES, 0, box ? 36 : 6, static_cast<GLsizei>(blocks.size()));
    ++stats.drawCalls;
}

Status SceneRenderer::Impl::drawBatch(Frame& frame, const GameProfile& profile, SceneStats& stats) {
    if (batch.sprites.empty()) return {};
    // Only the depth of a pixel of its own looks at the lattice; the wide way is right for all.
    const bool deep = profile.depth == DepthRule::perPixel;
    LatticePrograms& programs = deep ? blitDeep : blit;
    if (const Status ready = programs.use(!deep || batch.narrow); !ready) return ready;
    frame.bind();
    bindTexture(TextureUnit::spriteColours, batch.sheet->colours.id());
    bindTexture(TextureUnit::spriteIds, batch.sheet->ids.id());
    drawSprites(batch.sprites, stats);
    batch.clear();
    return {};
}

Status SceneRenderer::Impl::drawBuffered(Frame& frame, std::span<const SeenSprite> seen,
                                         const Camera& camera, const GameProfile& profile,
                                         SceneStats& stats) {
    batch.clear();
    batch.sprites.reserve(seen.size());
    for (const SeenSprite& sprite : seen) {
        Result<std::optional<AtlasPlace>> place = placeOf(sprite, stats);
        if (place && !*place) {
            if (const Status drawn = drawBatch(frame, profile, stats); !drawn) return drawn;
            atlas.endBatch();
            place = placeOf(sprite, stats);
        }
        if (!place) return tl::unexpected(place.error());
        if (!*place) return fail("a page of the sprite atlas holds no sprite at all");
        const AtlasPlace& at = **place;
        if (at.sheet != batch.sheet) {
            if (const Status drawn = drawBatch(frame, profile, stats); !drawn) return drawn;
            batch.sheet = at.sheet;
        }
        batch.narrow = batch.narrow && castsNarrow(sprite.shown, sprite.entity->octree->size());
        batch.sprites.push_back(
            screenBlock(sprite.view, sprite.shown, sprite.entity->placed, camera, profile));
        batch.sprites.back().atlas_place = at.corner;
    }
    return drawBatch(frame, profile, stats);
}

Status SceneRenderer::Impl::drawSingle(std::span<const SeenSprite> seen, const Camera& camera,
                                       const GameProfile& profile, SceneStats& stats) {
    LatticePrograms& programs = profile.depth == DepthRule::perPixel ? singleDeep : single;
    for (const SeenSprite& sprite : seen) {
        const GpuOctree& octree = *sprite.entity->octree;
        stats.rays += fragmentCount(sprite, camera);
        caster.bindInputs(octree, sprite.shown, *sprite.lit.lit);
        const Status ready = programs.use(castsNarrow(sprite.shown, octree.size()));
        if (!ready) return ready;
        const SpriteBlock block =
            screenBlock(sprite.view, sprite.shown, sprite.entity->placed, camera, profile);
        drawSprites(std::span(&block, 1), stats);
    }
    return {};
}

Result<SceneStats> SceneRenderer::draw(Frame& frame, const Scene& scene, const Camera& camera,
                                       const GameProfile& profile, SpriteMode mode) {
    SceneStats stats;
    const Result<std::vector<SeenSprite>> seen = impl_->look(scene, camera, profile, stats);
    if (!seen) return tl::unexpected(seen.error());
    frame.begin(scene.background);
    impl_->backdrop.draw(scene, camera);
    const Status drawn = mode == SpriteMode::spriteBuffer
                             ? impl_->drawBuffered(frame, *seen, camera, profile, stats)
                             : impl_->drawSingle(*seen, camera, profile, stats);
    impl_->atlas.endFrame();
    if (!drawn) return tl::unexpected(drawn.error());
    stats.atlasBytes = impl_->atlas.bytes();
    return stats;
}

Result<SpriteBuffer> SceneRenderer::castBuffer(const GpuOctree& octree, const LatticeView& lattice,
                                               const LitPalette& lit, SpriteMode mode) {
    return impl_->caster.castBuffer(octree, lattice, lit, mode);
}

Result<SceneRenderer> SceneRenderer::create(const AtlasLimits& limits) {
    Result<SpriteCaster> caster = SpriteCaster::create();
    if (!caster) return tl::unexpected(caster.error());
    Result<SceneBackdrop> backdrop = SceneBackdrop::create();
    if (!backdrop) return tl::unexpected(backdrop.error());
    auto impl = std::make_unique<Impl>(std::move(*caster), std::move(*backdrop), limits);
    if (const Status ready = impl->blit.use(true); !ready) return tl::unexpected(ready.error());
    return SceneRenderer(std::move(impl));
}

SceneRenderer::SceneRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

}  // namespace voxprite
