#include "render/snapshot_renderer.h"

#include <glad/gl.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <string>

#include "core/sprite/sprite_key.h"
#include "render/gl/draw_state.h"
#include "render/gl/program.h"
#include "render/palette_texture.h"
#include "render/snapshot_layers.h"
#include "render/sprite_blocks.h"
#include "render/voxel_view.h"

namespace voxprite {

namespace {

constexpr double kNearVoxels = 0.01;  // of a snapshot's eye

// The structs of shaders/shared/snapshot.glsl.
struct LayerBlock {
    std::array<glm::vec4, 3> pixel_from_screen{};
    glm::vec4 metres_from_pixel{0.0f};
    glm::vec2 screen_reference{0.0f};
    float weight = 1.0f;
    std::int32_t layer = 0;
};
static_assert(sizeof(LayerBlock) == 80);

struct SnapshotBlock {
    std::array<glm::vec4, 4> corners{};
    std::array<LayerBlock, 3> layers{};
    std::int32_t layer_count = 0;
    float nearest_metres = 0.0f;
    float near_voxels = 0.0f;
    float eye_voxels = 0.0f;
};
static_assert(sizeof(SnapshotBlock) == 320);

struct SnapshotDrawBlock {
    glm::vec4 snapshot_depth_from_metres{0.0f};
    std::int32_t snapshot_size_px = 0;
    std::int32_t depth_per_pixel = 0;
    std::array<std::int32_t, 2> padding{};
};
static_assert(sizeof(SnapshotDrawBlock) == 32);

// The model by itself, its voxels a metre wide and its centre at the origin.
PlacedEntity alone(glm::ivec3 modelSize) {
    PlacedEntity placed;
    placed.modelSize = modelSize;
    placed.anchor = glm::dvec3(modelSize) * 0.5;
    placed.worldFromVoxelAxes = {worldFromVoxel({1, 0, 0}), worldFromVoxel({0, 1, 0}),
                                 worldFromVoxel({0, 0, 1})};
    placed.voxelSizeMetres = 1.0;
    return placed;
}

Camera cameraFrom(const SnapshotCamera& eye) {
    Camera camera;
    camera.right = worldFromVoxel(eye.axes[0]);
    camera.up = worldFromVoxel(eye.axes[1]);
    camera.forward = worldFromVoxel(eye.axes[2]);
    camera.eyeMetres = worldFromVoxel(eye.eye - eye.centre);
    camera.verticalFovDegrees = 2.0 * glm::degrees(std::atan(1.0 / kSnapshotDistance));
    camera.nearMetres = kNearVoxels;
    camera.viewportPx = glm::ivec2(eye.sizePx);
    return camera;
}

glm::dvec3 towardLightOf(const SnapshotEntity& entity, const Light& light) {
    return glm::transpose(entity.placed.worldFromVoxelAxes) * light.towardLight;
}

LayerBlock layerBlock(const ShownSnapshot& shown, const SnapshotEntity& entity, int layer,
                      const Camera& camera) {
    const SpriteView& plane = shown.plane;
    const SpriteBlock mapping =
        screenBlock(plane, plane.lattice, entity.placed, *entity.octree, camera);
    const glm::dvec3 forward = camera.forward * glm::dmat3(plane.right, plane.up, plane.forward);
    const glm::dvec2 perPixel = glm::dvec2(forward) * plane.metresPerPx;
    LayerBlock block;
    block.pixel_from_screen = mapping.pixel_from_screen;
    block.screen_reference = mapping.screen_reference;
    block.metres_from_pixel =
        glm::vec4(perPixel.x, perPixel.y, forward.z * entity.placed.metresPerVoxel(),
                  plane.planeDepthMetres + glm::dot(perPixel, 0.5 - plane.pixelFromCentre));
    block.weight = static_cast<float>(shown.weight);
    block.layer = layer;
    return block;
}

// Where the snapshots are drawn: their common square, or one that holds it however it is turned.
// All corners lie ahead, on one plane across the camera's forward.
std::array<glm::vec4, 4> cornersOf(const SeenSnapshots& seen, const Camera& camera) {
    SpriteView plane = seen.shown.front().plane;
    if (seen.shown.size() > 1) plane.metresPerPx *= std::sqrt(2.0);
    const float depth = camera.reversedDepth(plane.depthMetres);
    const glm::dmat4 clipFromEye = camera.clipFromCameraRelative();
    std::array<glm::vec4, 4> corners{};
    const auto quad = quadFromEye(plane, plane.lattice.first, plane.lattice.size);
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec4 clip = clipFromEye * glm::dvec4(quad[k], 1.0);
        corners[k] = glm::vec4(glm::vec2(clip / clip.w), depth, 1.0f);
    }
    return corners;
}

}  // namespace

struct SnapshotRenderer::Impl {
    // What is held was made by these.
    struct Made {
        Light light;
        Shading shading = Shading::multiply;
        std::string views;
        int sizePx = 0;
        bool operator==(const Made&) const = default;
    };

    VoxelView voxels;
    gl::Program program;
    std::uint64_t mostBytes;
    gl::VertexArray nothing = gl::createVertexArray();
    gl::StorageBuffer snapshots;
    gl::UniformBuffer drawBlock;
    Frame frame{glm::ivec2(1)};
    SnapshotLayers layers;
    LitPalettes palettes;
    Made made;
    std::vector<SnapshotBlock> batch;

    Impl(VoxelView view, gl::Program blit, std::uint64_t most)
        : voxels(std::move(view)), program(std::move(blit)), mostBytes(most) {}

    [[nodiscard]] Status prepare(const GameProfile& profile, const SnapshotRules& rules);
    void castInto(Frame& target, const SnapshotEntity& entity, const GameProfile& profile,
                  const SnapshotRules& rules, int view);
    [[nodiscard]] std::optional<int> layerOf(const SnapshotEntity& entity,
                                             const GameProfile& profile, const SnapshotRules& rules,
                                             int view, SnapshotStats& stats);
    [[nodiscard]] bool add(const SnapshotEntity& entity, const SeenSnapshots& seen,
                           const Camera& camera, const GameProfile& profile,
                           const SnapshotRules& rules, SnapshotStats& stats);
    void flush(Frame& target, const Camera& camera, const SnapshotRules& rules,
               SnapshotStats& stats);
};

Status SnapshotRenderer::Impl::prepare(const GameProfile& profile, const SnapshotRules& rules) {
    if (rules.sizePx < 1 || rules.sizePx > kMostSnapshotPx) {
        return fail("a snapshot is 1 ... " + std::to_string(kMostSnapshotPx) +
                    " pixels wide, not " + std::to_string(rules.sizePx));
    }
    if (Status fits = Frame::checkSize(glm::ivec2(rules.sizePx)); !fits) return fits;
    const Made now{profile.light, profile.shading, rules.views.name(), rules.sizePx};
    if (now != made) {
        layers.reset(rules.sizePx, mostBytes);
        frame.resize(glm::ivec2(rules.sizePx));
        made = now;
    }
    palettes.beginFrame();
    return {};
}

void SnapshotRenderer::Impl::castInto(Frame& target, const SnapshotEntity& entity,
                                      const GameProfile& profile, const SnapshotRules& rules,
                                      int view) {
    const SnapshotCamera eye(rules.views, view, entity.octree->size(), rules.sizePx);
    VoxelViewOptions options;
    options.edges = false;
    options.occlusion = VoxelOcclusion::off;
    options.ground = false;
    options.spriteLight = true;
    options.shading = profile.shading;
    options.light = profile.light;
    options.light.towardLight = worldFromVoxel(towardLightOf(entity, profile.light));
    voxels.draw(target, *entity.octree, *entity.palette, alone(entity.octree->size()),
                cameraFrom(eye), options);
}

std::optional<int> SnapshotRenderer::Impl::layerOf(const SnapshotEntity& entity,
                                                   const GameProfile& profile,
                                                   const SnapshotRules& rules, int view,
                                                   SnapshotStats& stats) {
    const SnapshotLayers::Key key{entity.octree->revision(), palettes.contentOf(*entity.palette),
                                  towardLightOf(entity, profile.light), view};
    if (const std::optional<int> known = layers.find(key)) return known;
    const std::optional<int> layer = layers.add(key);
    if (!layer) return layer;
    castInto(frame, entity, profile, rules, view);
    layers.copyFrom(frame, *layer);
    ++stats.cast;
    return layer;
}

// False when there is no room for its snapshots before the batch is drawn.
bool SnapshotRenderer::Impl::add(const SnapshotEntity& entity, const SeenSnapshots& seen,
                                 const Camera& camera, const GameProfile& profile,
                                 const SnapshotRules& rules, SnapshotStats& stats) {
    SnapshotBlock block;
    for (const ShownSnapshot& shown : seen.shown) {
        const std::optional<int> layer = layerOf(entity, profile, rules, shown.view, stats);
        if (!layer) return false;
        block.layers[static_cast<std::size_t>(block.layer_count++)] =
            layerBlock(shown, entity, *layer, camera);
    }
    const SnapshotCamera eye(rules.views, seen.shown.front().view, entity.octree->size(),
                             rules.sizePx);
    block.corners = cornersOf(seen, camera);
    block.nearest_metres = static_cast<float>(seen.shown.front().plane.depthMetres);
    block.near_voxels = static_cast<float>(kNearVoxels);
    block.eye_voxels = static_cast<float>(eye.distance);
    batch.push_back(block);
    return true;
}

void SnapshotRenderer::Impl::flush(Frame& target, const Camera& camera, const SnapshotRules& rules,
                                   SnapshotStats& stats) {
    layers.endBatch();
    if (batch.empty()) return;
    SnapshotDrawBlock block;
    block.snapshot_depth_from_metres = glm::vec4(depthFromMetres(camera));
    block.snapshot_size_px = rules.sizePx;
    block.depth_per_pixel = rules.choice.depth == SnapshotDepth::perPixel ? 1 : 0;
    snapshots.set(BufferBinding::snapshots, std::span<const SnapshotBlock>(batch));
    drawBlock.set(BlockBinding::snapshotDraw, block);
    target.bind();
    gl::apply({.depthTest = gl::DepthTest::nearer, .depthWrite = true});
    bindTexture(TextureUnit::snapshotColours, layers.colours());
    bindTexture(TextureUnit::snapshotDepths, layers.depths());
    gl::useProgram(program);
    glBindVertexArray(nothing.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.size()));
    ++stats.drawCalls;
    batch.clear();
}

Result<SnapshotStats> SnapshotRenderer::draw(Frame& frame, std::span<const SnapshotEntity> entities,
                                             const Camera& camera, const GameProfile& profile,
                                             const SnapshotRules& rules) {
    if (camera.viewportPx != frame.sizePx()) return fail("the camera is not one of this frame");
    if (const Status ready = impl_->prepare(profile, rules); !ready) return Failure(ready.error());
    SnapshotStats stats;
    for (const SnapshotEntity& entity : entities) {
        if (entity.octree->texture() == 0) return Failure(entity.octree->status().error());
        const Result<SeenSnapshots> seen = seeSnapshots(entity.placed, camera, rules.views,
                                                        rules.sizePx, rules.choice, entity.history);
        if (!seen) return Failure(seen.error());
        ++(seen->unseen ? stats.unseen : stats.drawn);
        if (seen->unseen) continue;
        if (impl_->add(entity, *seen, camera, profile, rules, stats)) continue;
        impl_->flush(frame, camera, rules, stats);
        // Now there is room for a blend's three.
        if (!impl_->add(entity, *seen, camera, profile, rules, stats))
            return fail("there is no room for a snapshot");
    }
    impl_->flush(frame, camera, rules, stats);
    stats.held = impl_->layers.held();
    stats.bytes = impl_->layers.bytes();
    return stats;
}

Result<Snapshot> SnapshotRenderer::cast(const SnapshotEntity& entity, const GameProfile& profile,
                                        const SnapshotRules& rules, int view) {
    if (const Status ready = impl_->prepare(profile, rules); !ready) return Failure(ready.error());
    impl_->castInto(impl_->frame, entity, profile, rules, view);
    const Image colours = impl_->frame.readColour();
    Snapshot snapshot{view, {}, impl_->frame.readDepth()};
    snapshot.buffer.size = glm::ivec2(rules.sizePx);
    snapshot.buffer.colours.assign(colours.pixels.begin(), colours.pixels.end());
    snapshot.buffer.ids.assign(colours.pixels.size(), kIdFirstVoxel);
    const SnapshotCamera eye(rules.views, view, entity.octree->size(), rules.sizePx);
    for (int row = 0; row < rules.sizePx; ++row) {
        for (int column = 0; column < rules.sizePx; ++column) {
            const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(rules.sizePx) +
                            static_cast<std::size_t>(column);
            float& depth = snapshot.depth[at];
            if (depth == 0.0f) {
                snapshot.buffer.colours[at] = Rgba8(0);
                snapshot.buffer.ids[at] = kIdEmpty;
                depth = std::numeric_limits<float>::infinity();
            } else {
                const double ahead = kNearVoxels / depth;
                depth =
                    static_cast<float>(ahead * glm::length(eye.rayThrough(column, row).direction));
            }
        }
    }
    return snapshot;
}

Result<SnapshotRenderer> SnapshotRenderer::create(std::uint64_t mostBytes) {
    Result<VoxelView> voxels = VoxelView::create();
    if (!voxels) return Failure(voxels.error());
    Result<gl::Program> program = gl::compileProgram("snapshot.vert", "snapshot.frag");
    if (!program) return Failure(program.error());
    return SnapshotRenderer(
        std::make_unique<Impl>(std::move(*voxels), std::move(*program), mostBytes));
}

SnapshotRenderer::SnapshotRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SnapshotRenderer::~SnapshotRenderer() = default;
SnapshotRenderer::SnapshotRenderer(SnapshotRenderer&&) noexcept = default;
SnapshotRenderer& SnapshotRenderer::operator=(SnapshotRenderer&&) noexcept = default;

}  // namespace voxprite
