#include "render/scene_renderer.h"

#include <algorithm>
#include <span>
#include <string>

#include "render/cluster_renderer.h"
#include "render/gl/draw_state.h"
#include "render/palette_texture.h"
#include "render/scene_backdrop.h"
#include "render/scene_look.h"
#include "render/sprite_atlas.h"
#include "render/sprite_caster.h"

namespace voxprite {

namespace {

// 32 MiB of sprites: a quarter of what every driver takes as one buffer.
constexpr std::size_t kMostSprites = std::size_t{1} << 17;

std::uint64_t pixelCount(const LatticeView& lattice) {
    return static_cast<std::uint64_t>(lattice.size.x) * static_cast<std::uint64_t>(lattice.size.y);
}

// Finished sprites know their voxels by ids, which must tell all of a model apart.
Status checkIds(glm::ivec3 modelSize) {
    const double cells = static_cast<double>(modelSize.x) * modelSize.y * modelSize.z;
    if (cells + kIdFirstVoxel <= 0x1p32) return {};
    return fail("a model of " + std::to_string(modelSize.x) + " x " + std::to_string(modelSize.y) +
                " x " + std::to_string(modelSize.z) +
                " cells: sprite buffers have a depth for each pixel of up to 2^32 cells; draw in "
                "a single pass");
}

// Sprites that one draw call puts onto the screen, in the order of the scene.
struct SpriteRun {
    const SpriteSheet* sheet = nullptr;  // where they are finished (spriteBuffer) ...
    std::uint32_t octreeTexture = 0;     // ... or are cast from (singlePass)
    std::int32_t first = 0;
    std::int32_t count = 0;
    bool narrow = true;  // all of them
};

// A sprite to cast with its batch.
struct PendingCast {
    SpriteKey key;
    AtlasPlace place;
    CastJob job;
};

// Sprites that go to the GPU together.
struct Batch {
    std::vector<SpriteBlock> sprites;
    std::vector<glm::vec4> corners;
    std::vector<SpriteRun> runs;
    std::vector<PendingCast> casts;

    void clear() {
        sprites.clear();
        corners.clear();
        runs.clear();
        casts.clear();
    }
    SpriteBlock& add(const SeenSprite& seen, bool boxes) {
        corners.insert(corners.end(), seen.corners.begin(),
                       boxes ? seen.corners.end() : seen.corners.begin() + 4);
        return sprites.emplace_back(seen.block);
    }
    // The run that the next sprite belongs to.
    SpriteRun& runOf(const SpriteSheet* sheet, std::uint32_t octreeTexture) {
        if (runs.empty() || runs.back().sheet != sheet ||
            runs.back().octreeTexture != octreeTexture) {
            runs.push_back({sheet, octreeTexture, static_cast<std::int32_t>(sprites.size())});
        }
        return runs.back();
    }
};

// What is drawn now, and by which rules.
struct Pass {
    Frame& frame;
    const Scene& scene;
    const Camera& camera;
    const GameProfile& profile;
    SpriteMode mode;
    SceneStats& stats;
    int batches = 0;
    bool begun = false;  // the frame is cleared, and what lies behind the sprites is drawn

    [[nodiscard]] bool deep() const { return profile.depth == DepthRule::perPixel; }
    [[nodiscard]] bool boxes() const { return profile.proxy == ProxyShape::box; }
};

}  // namespace

struct SceneRenderer::Impl {
    SpriteCaster caster;
    SceneBackdrop backdrop;
    SpriteAtlas atlas;
    SceneLook look;
    OctreeArena octrees;
    LitRows litRows;
    SpriteProgram blit{"sprite_quad.vert", "sprite_blit.frag"};
    SpriteProgram single{"sprite_quad.vert", "sprite_single.frag"};
    SpriteShapes shapes;
    gl::StorageBuffer sprites, corners;
    OcclusionRays occlusionRays;
    Batch batch;
    std::optional<ClusterRenderer> clusters;  // once there are some
    // The batch, on the GPU too, is all that the look before saw, to be drawn in this way.
    std::optional<SpriteMode> held;

    explicit Impl(const AtlasLimits& limits) : atlas(limits) {}

    void begin(Pass& pass);
    [[nodiscard]] Status drawSprites(Pass& pass);
    [[nodiscard]] Status gather(Pass& pass);
    [[nodiscard]] Status addFinished(Pass& pass, const SeenSprite& sprite);
    [[nodiscard]] Result<std::optional<AtlasPlace>> placeOf(Pass& pass, const SeenSprite& sprite);
    [[nodiscard]] Status addToCast(Pass& pass, const SeenSprite& sprite);
    [[nodiscard]] Result<int> litRowOf(Pass& pass, const SeenSprite& sprite);
    [[nodiscard]] Status castBatch(Pass& pass);
    [[nodiscard]] Status finish(Pass& pass);
    [[nodiscard]] Status flush(Pass& pass);
    [[nodiscard]] Status drawRuns(Pass& pass);
    [[nodiscard]] Status drawClusters(Pass& pass);
};

// The rows of the sprite's palette. What is gathered is drawn first if that makes room.
Result<int> SceneRenderer::Impl::litRowOf(Pass& pass, const SeenSprite& sprite) {
    const LitPalettes::Numbered lit = look.litOf(sprite, pass.profile);
    std::optional<int> row = litRows.rowOf(lit.number, *lit.lit);
    if (!row) {
        if (const Status drawn = flush(pass); !drawn) return tl::unexpected(drawn.error());
        litRows.forgetAll();
        row = litRows.rowOf(lit.number, *lit.lit);
    }
    return *row;
}

// Where the sprite lies, or will when the batch is cast; nothing when the batch has to be drawn
// first to make room.
Result<std::optional<AtlasPlace>> SceneRenderer::Impl::placeOf(Pass& pass,
                                                               const SeenSprite& sprite) {
    const LatticeView& lattice = sprite.key.lattice;
    if (const std::optional<AtlasPlace> known = atlas.find(sprite.key)) {
        ++pass.stats.castsReused;
        return known;
    }
    if (const Status fits = SpriteCaster::checkSize(lattice.size); !fits) {
        return tl::unexpected(fits.error());
    }
    if (const Status known = checkIds(sprite.entity.octree->size()); pass.deep() && !known) {
        return tl::unexpected(known.error());
    }
    const Result<int> row = litRowOf(pass, sprite);
    if (!row) return tl::unexpected(row.error());
    const std::optional<AtlasPlace> place = atlas.add(sprite.key, lattice.size);
    if (!place) return place;
    const OctreePlace octree = octrees.placeOf(*sprite.entity.octree);
    PendingCast& cast = batch.casts.emplace_back(PendingCast{sprite.key, *place, {}});
    cast.job = {sprite.block, 0, octree.texture, sprite.narrow};
    cast.job.block.atlas_place = place->corner;
    placeInputs(cast.job.block, octree, *row);
    ++pass.stats.casts;
    pass.stats.rays += pixelCount(lattice);
    return place;
}

Status SceneRenderer::Impl::addFinished(Pass& pass, const SeenSprite& sprite) {
    Result<std::optional<AtlasPlace>> place = placeOf(pass, sprite);
    if (place && !*place) {
        if (const Status drawn = flush(pass); !drawn) return drawn;
        place = placeOf(pass, sprite);
    }
    if (!place) return tl::unexpected(place.error());
    if (!*place) return fail("a page of the sprite atlas holds no sprite at all");
    SpriteRun& run = batch.runOf((*place)->sheet, 0);
    run.narrow = run.narrow && sprite.narrow;
    ++run.count;
    batch.add(sprite, pass.boxes()).atlas_place = (*place)->corner;
    return {};
}

Status SceneRenderer::Impl::addToCast(Pass& pass, const SeenSprite& sprite) {
    const Result<int> row = litRowOf(pass, sprite);
    if (!row) return tl::unexpected(row.error());
    const OctreePlace octree = octrees.placeOf(*sprite.entity.octree);
    SpriteRun& run = batch.runOf(nullptr, octree.texture);
    run.narrow = run.narrow && sprite.narrow;
    ++run.count;
    placeInputs(batch.add(sprite, pass.boxes()), octree, *row);
    pass.stats.rays += sprite.fragments;
    return {};
}

Status SceneRenderer::Impl::castBatch(Pass& pass) {
    std::vector<CastJob> jobs;
    jobs.reserve(batch.casts.size());
    for (PendingCast& cast : batch.casts) {
        // Not before: the atlas may have grown since the place was given.
        cast.job.framebuffer = cast.place.framebuffer();
        jobs.push_back(cast.job);
    }
    return caster.cast(jobs, litRows.texture(), SpriteLook(pass.profile), pass.deep());
}

// Casts and draws what is gathered.
Status SceneRenderer::Impl::finish(Pass& pass) {
    const Status cast = castBatch(pass);
    if (!cast) return cast;
    batch.casts.clear();
    atlas.endBatch();
    if (batch.sprites.empty()) return {};
    sprites.set(BufferBinding::sprites, std::span<const SpriteBlock>(batch.sprites));
    corners.set(BufferBinding::spriteCorners, std::span<const glm::vec4>(batch.corners));
    const Status drawn = drawRuns(pass);
    ++pass.batches;
    return drawn;
}

// The same, and makes room.
Status SceneRenderer::Impl::flush(Pass& pass) {
    if (const Status drawn = finish(pass); !drawn) return drawn;
    batch.clear();
    return {};
}

// As late as possible: what is cast goes elsewhere, and rasterisers that work tile by tile clear
// and draw a tile at one go where nothing comes between.
void SceneRenderer::Impl::begin(Pass& pass) {
    if (pass.begun) return;
    pass.begun = true;
    if (SceneBackdrop::isEmpty(pass.scene)) {
        pass.frame.beginWords(pass.scene.background);
    } else {
        pass.frame.begin(pass.scene.background);
        backdrop.draw(pass.scene, pass.camera);
    }
}

Status SceneRenderer::Impl::drawRuns(Pass& pass) {
    begin(pass);
    pass.frame.bindWords();
    sprites.bind(BufferBinding::sprites);
    corners.bind(BufferBinding::spriteCorners);
    const bool buffered = pass.mode == SpriteMode::spriteBuffer;
    if (!buffered) bindTexture(TextureUnit::palette, litRows.texture());
    gl::apply({.depthTest = gl::DepthTest::nearer,
               .depthWrite = true,
               .cull = pass.boxes() ? gl::Cull::frontFaces : gl::Cull::none});
    const SpriteLook spriteLook(pass.profile);
    SpriteDrawBlock block = drawBlock(spriteLook);
    const bool shaded = !buffered && spriteLook.castsFromFaces();
    if (shaded) occlusionRays.bind();
    block.depth_from_metres = glm::vec4(depthFromMetres(pass.camera));
    for (const SpriteRun& run : batch.runs) {
        SpriteVariants variants = kPlain;
        if (pass.boxes()) variants |= kProxyBox;
        if (pass.deep()) variants |= kPerPixelDepth;
        if (shaded) variants |= kFaceShade;
        // What is finished looks at the lattice only for the depth of a pixel of its own.
        if (!run.narrow && (pass.deep() || !buffered)) variants |= kWideLattice;
        if (const Status ready = (buffered ? blit : single).use(variants); !ready) return ready;
        if (buffered) {
            bindImage(ImageUnit::sprites, run.sheet->colours.id());
            if (pass.deep()) bindTexture(TextureUnit::spriteIds, run.sheet->ids.id());
        } else {
            bindTexture(TextureUnit::svo, run.octreeTexture);
        }
        block.first_sprite = run.first;
        block.sprite_count = run.count;
        shapes.draw(block, pass.boxes());
        ++pass.stats.drawCalls;
    }
    return {};
}

Status SceneRenderer::Impl::drawClusters(Pass& pass) {
    std::vector<ClusterInstance> instances;
    for (const SceneEntity& entity : pass.scene.entities) {
        if (entity.representation != Representation::clusters) continue;
        instances.push_back({entity.clusters, entity.palette, entity.placed});
    }
    if (instances.empty()) return {};
    if (!clusters) {
        Result<ClusterRenderer> created = ClusterRenderer::create();
        if (!created) return tl::unexpected(created.error());
        clusters = std::move(*created);
    }
    ClusterOptions options;
    options.budgetPx = pass.scene.clusterBudgetPx;
    const Result<ClusterStats> drawn =
        clusters->draw(pass.frame, pass.camera, pass.profile, instances, options);
    if (!drawn) return tl::unexpected(drawn.error());
    pass.stats.drawCalls += drawn->drawCalls;
    return {};
}

Status SceneRenderer::Impl::gather(Pass& pass) {
    batch.clear();
    if (pass.mode == SpriteMode::spriteBuffer) atlas.keepIds(pass.deep());
    octrees.arrange(look.octrees());
    for (const SeenSprite* sprite : look.seen()) {
        // Before one more comes: a frame that fills it to the last is held whole.
        if (batch.sprites.size() == kMostSprites) {
            if (const Status drawn = flush(pass); !drawn) return drawn;
        }
        const Status added = pass.mode == SpriteMode::spriteBuffer ? addFinished(pass, *sprite)
                                                                   : addToCast(pass, *sprite);
        if (!added) return added;
    }
    return {};
}

Status SceneRenderer::Impl::drawSprites(Pass& pass) {
    if (held == pass.mode && !look.changed()) {
        if (pass.mode == SpriteMode::spriteBuffer) {
            pass.stats.castsReused = look.seen().size();
        } else {
            for (const SeenSprite* sprite : look.seen()) pass.stats.rays += sprite->fragments;
        }
        return drawRuns(pass);
    }
    held.reset();
    Status drawn = gather(pass);
    if (drawn) drawn = finish(pass);
    if (!drawn) {
        // Room was taken for sprites that were not cast.
        for (const PendingCast& cast : batch.casts) atlas.forget(cast.key);
    }
    atlas.endFrame();
    if (drawn && pass.batches <= 1) held = pass.mode;
    return drawn;
}

Result<SceneStats> SceneRenderer::draw(Frame& frame, const Scene& scene, const Camera& camera,
                                       const GameProfile& profile, SpriteMode mode) {
    SceneStats stats;
    if (const Status fits = Frame::checkSize(camera.viewportPx); !fits) {
        return tl::unexpected(fits.error());
    }
    if (camera.viewportPx != frame.sizePx()) return fail("the camera is not one of this frame");
    if (const Status seen = impl_->look.update(scene, camera, profile); !seen) {
        return tl::unexpected(seen.error());
    }
    const std::vector<const SeenSprite*>& sprites = impl_->look.seen();
    for (const SeenSprite* sprite : sprites) {
        ++stats.drawnBy[static_cast<std::size_t>(sprite->entity.representation)];
    }
    // Which of the meshes are in view is the GPU's to know.
    const auto meshes =
        std::ranges::count(scene.entities, Representation::clusters, &SceneEntity::representation);
    stats.drawnBy[static_cast<std::size_t>(Representation::clusters)] = static_cast<int>(meshes);
    stats.drawn = static_cast<int>(sprites.size() + static_cast<std::size_t>(meshes));
    stats.unseen = impl_->look.unseen() - static_cast<int>(meshes);
    if (!sprites.empty()) {
        stats.sigmaInForce = sprites.front()->sigmaInForce;
        stats.screenPxPerPx = sprites.front()->screenPxPerPx;
    }
    Pass pass{frame, scene, camera, profile, mode, stats};
    if (const Status drawn = impl_->drawSprites(pass); !drawn) {
        return tl::unexpected(drawn.error());
    }
    impl_->begin(pass);
    if (const Status drawn = impl_->drawClusters(pass); !drawn) {
        return tl::unexpected(drawn.error());
    }
    stats.atlasBytes = impl_->atlas.bytes();
    return stats;
}

Result<SpriteBuffer> SceneRenderer::castBuffer(const GpuOctree& octree, const LatticeView& lattice,
                                               const LitPalette& lit, SpriteMode mode) {
    return impl_->caster.castBuffer(octree, lattice, lit, mode);
}

Result<SceneRenderer> SceneRenderer::create(const AtlasLimits& limits) {
    if (const Status fits = SpriteAtlas::checkLimits(limits); !fits) {
        return tl::unexpected(fits.error());
    }
    return SceneRenderer(std::make_unique<Impl>(limits));
}

SceneRenderer::SceneRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

}  // namespace voxprite
