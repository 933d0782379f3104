#include "render/scene_renderer.h"

#include <glad/gl.h>

#include <algorithm>

#include "render/gl/draw_state.h"
#include "render/scene_backdrop.h"
#include "render/sprite_blocks.h"
#include "render/sprite_cache.h"
#include "render/sprite_caster.h"

namespace voxprite {

namespace {

// A sprite that is on the screen this frame.
struct SeenSprite {
    const SceneEntity* entity = nullptr;
    SpriteView view;
    LatticeView visible;  // the part of the lattice that can show
    LitPalette lit;
    const SpriteTextures* textures = nullptr;  // mode spriteBuffer
};

// The screen pixels of the region's rectangle: how many fragments a single pass casts for.
std::uint64_t fragmentCount(const SeenSprite& sprite, const Camera& camera) {
    const double scale =
        sprite.view.metresPerPx / camera.metresPerScreenPx(sprite.view.planeDepthMetres);
    const double area =
        scale * scale * static_cast<double>(sprite.visible.size.x) * sprite.visible.size.y;
    const double screen = static_cast<double>(camera.viewportPx.x) * camera.viewportPx.y;
    return static_cast<std::uint64_t>(std::min(area, screen));
}

std::uint64_t pixelCount(const LatticeView& lattice) {
    return static_cast<std::uint64_t>(lattice.size.x) * static_cast<std::uint64_t>(lattice.size.y);
}

}  // namespace

struct SceneRenderer::Impl {
    SpriteCaster caster;
    SceneBackdrop backdrop;
    SpriteCache cache;
    gl::Program blit;
    // Deep: with a depth for each pixel.
    LatticePrograms blitDeep{"sprite_quad.vert", "sprite_blit.frag", {"PER_PIXEL_DEPTH"}};
    LatticePrograms single{"sprite_quad.vert", "sprite_single.frag"};
    LatticePrograms singleDeep{"sprite_quad.vert", "sprite_single.frag", {"PER_PIXEL_DEPTH"}};
    gl::UniformBuffer spriteBlock;
    gl::VertexArray nothing = gl::createVertexArray();

    Impl(SpriteCaster spriteCaster, SceneBackdrop sceneBackdrop)
        : caster(std::move(spriteCaster)), backdrop(std::move(sceneBackdrop)) {}

    [[nodiscard]] Result<std::vector<SeenSprite>> look(const Scene& scene, const Camera& camera,
                                                       const GameProfile& profile,
                                                       SceneStats& stats) const;
    [[nodiscard]] Status castMissing(std::vector<SeenSprite>& sprites, SceneStats& stats);
    [[nodiscard]] Status paint(const SeenSprite& sprite, const Camera& camera,
                               const GameProfile& profile, SpriteMode mode);
};

Result<std::vector<SeenSprite>> SceneRenderer::Impl::look(const Scene& scene, const Camera& camera,
                                                          const GameProfile& profile,
                                                          SceneStats& stats) const {
    std::vector<SeenSprite> seen;
    for (const SceneEntity& entity : scene.entities) {
        if (entity.octree->texture() == 0) {
            ++stats.unseen;
            continue;
        }
        const Result<SpriteViewResult> result =
            viewSprite(entity.placed, camera, profile, entity.history);
        if (!result) return tl::unexpected(result.error());
        LatticeView visible;
        if (result->view) visible = visibleLattice(*result->view, camera);
        if (!result->view || visible.size.x <= 0 || visible.size.y <= 0) {
            ++stats.unseen;
            continue;
        }
        SeenSprite sprite{&entity, *result->view, visible,
                          litPalette(*entity.palette, result->view->light8, profile.outline),
                          nullptr};
        if (stats.drawn++ == 0) {
            stats.sigmaInForce = sprite.view.sigmaInForce;
            stats.screenPxPerPx = sprite.view.screenPxPerPx;
        }
        seen.push_back(std::move(sprite));
    }
    return seen;
}

Status SceneRenderer::Impl::castMissing(std::vector<SeenSprite>& sprites, SceneStats& stats) {
    for (SeenSprite& sprite : sprites) {
        const GpuOctree& octree = *sprite.entity->octree;
        SpriteKey key;
        key.modelRevision = octree.revision();
        key.lattice = sprite.visible;
        key.lit = sprite.lit;
        if (const SpriteTextures* held = cache.find(key)) {
            sprite.textures = held;
            ++stats.castsReused;
            continue;
        }
        if (const Status fits = SpriteCaster::checkSize(sprite.visible.size); !fits) return fits;
        SpriteTextures& target = cache.add(key, sprite.visible.size);
        if (const Status done = caster.cast(octree, sprite.visible, sprite.lit, target); !done) {
            cache.forget(key);
            return done;
        }
        sprite.textures = &target;
        stats.rays += pixelCount(sprite.visible);
    }
    return {};
}

Status SceneRenderer::Impl::paint(const SeenSprite& sprite, const Camera& camera,
                                  const GameProfile& profile, SpriteMode mode) {
    const GpuOctree& octree = *sprite.entity->octree;
    const bool deep = profile.depth == DepthRule::perPixel;
    const SpriteBlock block =
        screenBlock(sprite.view, sprite.visible, sprite.entity->placed, camera, profile);
    spriteBlock.set(BlockBinding::sprite, block);
    glBindVertexArray(nothing.id());
    const bool buffered = mode == SpriteMode::spriteBuffer;
    if (buffered) {
        bindTexture(TextureUnit::spriteColours, sprite.textures->colours.id());
        bindTexture(TextureUnit::spriteIds, sprite.textures->ids.id());
    }
    if (buffered && !deep) {
        gl::useProgram(blit);
    } else {
        caster.bindInputs(octree, sprite.visible, sprite.lit);
        LatticePrograms& programs = buffered ? blitDeep : deep ? singleDeep : single;
        const bool narrow = castsNarrow(sprite.visible, octree.size());
        if (const Status ready = programs.use(narrow); !ready) return ready;
    }
    const bool box = block.proxy_is_box != 0;
    gl::apply({.depthTest = gl::DepthTest::nearer,
               .depthWrite = true,
               .cull = box ? gl::Cull::frontFaces : gl::Cull::none});
    glDrawArrays(GL_TRIANGLES, 0, box ? 36 : 6);
    return {};
}

Result<SceneStats> SceneRenderer::draw(Frame& frame, const Scene& scene, const Camera& camera,
                                       const GameProfile& profile, SpriteMode mode) {
    SceneStats stats;
    Result<std::vector<SeenSprite>> sprites = impl_->look(scene, camera, profile, stats);
    if (!sprites) return tl::unexpected(sprites.error());
    if (mode == SpriteMode::spriteBuffer) {
        if (const Status cast = impl_->castMissing(*sprites, stats); !cast) {
            return tl::unexpected(cast.error());
        }
    }
    frame.begin(scene.background);
    impl_->backdrop.draw(scene, camera);
    for (const SeenSprite& sprite : *sprites) {
        if (mode == SpriteMode::singlePass) stats.rays += fragmentCount(sprite, camera);
        if (const Status painted = impl_->paint(sprite, camera, profile, mode); !painted) {
            return tl::unexpected(painted.error());
        }
    }
    impl_->cache.endFrame();
    return stats;
}

Result<SpriteBuffer> SceneRenderer::castBuffer(const GpuOctree& octree, const LatticeView& lattice,
                                               const LitPalette& lit, SpriteMode mode) {
    return impl_->caster.castBuffer(octree, lattice, lit, mode);
}

Result<SceneRenderer> SceneRenderer::create() {
    Result<SpriteCaster> caster = SpriteCaster::create();
    if (!caster) return tl::unexpected(caster.error());
    Result<SceneBackdrop> backdrop = SceneBackdrop::create();
    if (!backdrop) return tl::unexpected(backdrop.error());
    Result<gl::Program> blit = gl::compileProgram("sprite_quad.vert", "sprite_blit.frag");
    if (!blit) return tl::unexpected(blit.error());
    auto impl = std::make_unique<Impl>(std::move(*caster), std::move(*backdrop));
    impl->blit = std::move(*blit);
    return SceneRenderer(std::move(impl));
}

SceneRenderer::SceneRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

}  // namespace voxprite
