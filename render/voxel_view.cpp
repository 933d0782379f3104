#include "render/voxel_view.h"

#include <glad/gl.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>

#include "render/cluster_pass.h"
#include "render/gl/draw_state.h"
#include "render/gl/lazy_program.h"
#include "render/gl/program.h"
#include "render/occlusion_rays.h"
#include "render/palette_texture.h"

namespace voxprite {

namespace {

// How much of its light a face loses that the sun does not reach.
constexpr float kShadowStrength = 0.42f;

struct VoxelViewBlock {
    std::array<glm::vec4, 8> box_corners{};
    std::array<glm::vec4, 3> voxel_ray_origin{};
    std::array<glm::vec4, 3> voxel_ray_direction{};
    glm::vec4 view_depth_from_t{0.0f};
    std::array<glm::vec4, 3> face_light{};
    glm::vec4 background_top{0.0f};
    glm::vec4 background_bottom{0.0f};
    glm::vec4 grid_colour{0.0f};
    glm::ivec3 view_box_low{0};
    float near_metres = 0.01f;
    glm::ivec3 view_box_high{0};
    std::int32_t edges_shown = 1;
    glm::vec2 half_viewport_px{0.0f};
    glm::vec2 grid_centre{0.0f};
    glm::vec2 grid_corner{0.0f};
    float grid_height = 0.0f;
    float grid_radius = 1.0f;
    std::int32_t grid_shown = 1;
    std::int32_t occlusion_shown = 1;
    std::int32_t view_leaf_level = 0;
    float padding = 0.0f;
    glm::vec4 ghost_tint{0.0f};
    glm::vec4 sun{0.0f};
    float ghost_nearer = 1.0f;
    float ghost_mixed = 0.0f;
    float ghost_outline_px = 0.0f;
    float ghost_dash_px = 1.0f;
    glm::ivec4 sprite_rays{0};
};
static_assert(sizeof(VoxelViewBlock) == 480);

// How voxels look that lie over the model. Where a ghost has the model's own surface, it gives way
// or it covers it, however the two are rounded.
struct Ghost {
    glm::vec4 tint{0.0f};  // alpha 0: no ghost, but the model itself
    float mixed = 0.7f;
    float nearer = 1.0f - 1e-5f;
    float outlinePx = 0.0f;
    float dashPx = 1.0f;
};

// What is selected, and how it is seen.
struct Marks {
    const GpuOctree& octree;
    const PlacedEntity& placed;
    const Camera& camera;
    Rgba8 tint;
    float scale = 1.0f;  // device pixels a pixel
};

// Voxel coordinates from the middle of the octree's root cube, which shaders compute in.
struct RootSpace {
    glm::dvec3 voxelOfMiddle{0.0};
    glm::dmat3 voxelAxesFromWorld{1.0};
    double voxelsPerMetre = 1.0;
    glm::dvec3 eye{0.0};

    RootSpace(const GpuOctree& octree, const PlacedEntity& placed, const Camera& camera)
        : voxelOfMiddle(glm::dvec3(1 << (octree.maxDepth() - 1)) -
                        glm::dvec3(octree.treeFromVoxel())),
          voxelAxesFromWorld(glm::transpose(placed.worldFromVoxelAxes)),
          voxelsPerMetre(1.0 / placed.metresPerVoxel()),
          eye(vector(camera.eyeMetres - placed.anchorMetres) + placed.anchor - voxelOfMiddle) {}

    // A direction or distance of the world, in voxels.
    [[nodiscard]] glm::dvec3 vector(glm::dvec3 metres) const {
        return voxelAxesFromWorld * metres * voxelsPerMetre;
    }
};

// Else the shaders are those without such rays.
bool facesCastRays(const VoxelViewOptions& options) {
    return options.occlusion == VoxelOcclusion::rays ||
           (options.spriteLight && (hasOcclusion(options.light) || hasShadows(options.light)));
}

int leafLevel(const GpuOctree& octree, const VoxelViewOptions& options) {
    return std::clamp(octree.maxDepth() - options.maxDepth, 0, octree.maxDepth());
}

}  // namespace

float halfLambert(glm::dvec3 normal, glm::dvec3 towardLight, double ambient) {
    const double wrapped = 0.5 + 0.5 * glm::dot(normal, towardLight);
    return static_cast<float>(ambient + (1.0 - ambient) * wrapped * wrapped);
}

namespace {

// What a program is compiled with, as a sum.
using Variants = unsigned;
constexpr Variants kBare = 0;
constexpr Variants kSunShadow = 1;       // voxels stand in the light
constexpr Variants kVoxelFaceShade = 2;  // faces cast rays of their own
constexpr Variants kDepthLimit = 4;      // to a depth above the voxels
constexpr Variants kMarked = 8;          // no light: covered by a tint

// A program in all variants, each compiled when it is first used.
class VariantProgram {
  public:
    VariantProgram(std::string vertex, std::string fragment)
        : vertex_(std::move(vertex)), fragment_(std::move(fragment)) {}
    void useOrSay(Variants variants) {
        const auto found = programs_.find(variants);
        if (found != programs_.end()) return found->second.useOrSay();
        std::vector<std::string> defines;
        if ((variants & kSunShadow) != 0) defines.emplace_back("SUN_SHADOW");
        if ((variants & kVoxelFaceShade) != 0) defines.emplace_back("FACE_SHADE");
        if ((variants & kDepthLimit) != 0) defines.emplace_back("DEPTH_LIMIT");
        if ((variants & kMarked) != 0) defines.emplace_back("MARKED");
        programs_.try_emplace(variants, vertex_, fragment_, std::move(defines))
            .first->second.useOrSay();
    }

  private:
    std::string vertex_, fragment_;
    std::map<Variants, gl::LazyProgram> programs_;
};

Variants lookVariants(const VoxelViewOptions& options) {
    return (options.shadow ? kSunShadow : kBare) |
           (facesCastRays(options) ? kVoxelFaceShade : kBare);
}

}  // namespace

struct VoxelView::Impl {
    VariantProgram voxels{"voxel_view.vert", "voxel_view.frag"};
    VariantProgram backdrop{"fullscreen.vert", "voxel_backdrop.frag"};
    VariantProgram clusterVoxels{"cluster_view.vert", "cluster_view.frag"};
    gl::LazyProgram clusterDepth{"cluster_view.vert", "cluster_depth.frag"};
    std::optional<ClusterPass> clusters;  // once there are some
    bool saidWhyNone = false;
    gl::VertexArray nothing = gl::createVertexArray();
    gl::UniformBuffer octreeBlock;
    gl::UniformBuffer viewBlock;
    PaletteTexture palette;
    OcclusionRays occlusionRays;
    int marksPrepared = 0;  // of the two ways in which they are drawn

    // False where the driver cannot draw them: rays do.
    [[nodiscard]] bool canDrawClusters();
    void fillBox(VoxelViewBlock& block, const GpuOctree& octree, const PlacedEntity& placed,
                 const Camera& camera, const VoxelViewOptions& options) const;
    void fillRays(VoxelViewBlock& block, const RootSpace& space, const Camera& camera) const;
    void fillLook(VoxelViewBlock& block, const RootSpace& space, const GpuOctree& octree,
                  const VoxelViewOptions& options) const;
    void setPalette(const Palette& colours, const RootSpace& space,
                    const VoxelViewOptions& options);
    void setView(const GpuOctree& octree, const PlacedEntity& placed, const Camera& camera,
                 const VoxelViewOptions& options, const Ghost& ghost);
    void drawClusters(const GpuOctree& octree, const Palette& colours, const PlacedEntity& placed,
                      const Camera& camera, const VoxelViewOptions& options);
    void drawVoxels(const GpuOctree& octree, const Palette& colours, const RootSpace& space,
                    const VoxelViewOptions& options, const gl::DrawState& state);
    void drawMarked(const Marks& marks, bool hidden);
};

bool VoxelView::Impl::canDrawClusters() {
    if (clusters || saidWhyNone) return clusters.has_value();
    Result<ClusterPass> created = ClusterPass::create();
    if (created) {
        clusters = std::move(*created);
    } else {
        saidWhyNone = true;
        std::fprintf(stderr, "%s\n", created.error().describe().c_str());
    }
    return clusters.has_value();
}

void VoxelView::Impl::fillBox(VoxelViewBlock& block, const GpuOctree& octree,
                              const PlacedEntity& placed, const Camera& camera,
                              const VoxelViewOptions& options) const {
    const glm::ivec3 edge(1 << octree.maxDepth());
    const int level = leafLevel(octree, options);
    block.view_leaf_level = level;
    // Whole nodes of that level.
    const glm::ivec3 low = glm::clamp(octree.treeFromVoxel(), glm::ivec3(0), edge);
    const glm::ivec3 high = glm::clamp(octree.treeFromVoxel() + octree.size(), glm::ivec3(0), edge);
    block.view_box_low = (low >> level) << level;
    block.view_box_high = ((high + ((1 << level) - 1)) >> level) << level;
    const glm::dmat4 clipFromEye = camera.clipFromCameraRelative();
    const glm::dvec3 lowCorner(block.view_box_low - octree.treeFromVoxel());
    const glm::dvec3 highCorner(block.view_box_high - octree.treeFromVoxel());
    for (int octant = 0; octant < 8; ++octant) {
        const glm::dvec3 voxel((octant & 1) != 0 ? highCorner.x : lowCorner.x,
                               (octant & 2) != 0 ? highCorner.y : lowCorner.y,
                               (octant & 4) != 0 ? highCorner.z : lowCorner.z);
        const glm::dvec3 metres = placed.worldFromVoxel(voxel) - camera.eyeMetres;
        block.box_corners[static_cast<std::size_t>(octant)] =
            glm::vec4(clipFromEye * glm::dvec4(metres, 1.0));
    }
}

void VoxelView::Impl::fillRays(VoxelViewBlock& block, const RootSpace& space,
                               const Camera& camera) const {
    const EyeRays rays = eyeRays(camera);
    block.voxel_ray_origin = {toVec4(space.vector(rays.originPerX)),
                              toVec4(space.vector(rays.originPerY)), toVec4(space.eye)};
    block.voxel_ray_direction = {toVec4(space.vector(rays.directionPerX)),
                                 toVec4(space.vector(rays.directionPerY)),
                                 toVec4(space.vector(rays.direction))};
    block.view_depth_from_t = glm::vec4(depthFromMetres(camera));
    block.near_metres = static_cast<float>(camera.nearMetres);
    block.half_viewport_px = 0.5f * glm::vec2(camera.viewportPx);
}

void VoxelView::Impl::fillLook(VoxelViewBlock& block, const RootSpace& space,
                               const GpuOctree& octree, const VoxelViewOptions& options) const {
    const glm::dvec3 toward = space.voxelAxesFromWorld * glm::normalize(options.light.towardLight);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        glm::vec4& light = block.face_light[static_cast<std::size_t>(axis)];
        light = glm::vec4(1.0f);
        if (options.spriteLight) continue;  // it is in the palette
        light.x = halfLambert(normal, toward, options.light.ambient);
        light.y = halfLambert(-normal, toward, options.light.ambient);
    }
    block.background_top = toVec4(options.backgroundTop);
    block.background_bottom = toVec4(options.backgroundBottom);
    const bool bright = options.backgroundBottom.x + options.backgroundBottom.y > 300;
    block.grid_colour =
        bright ? glm::vec4(0.28f, 0.31f, 0.38f, 0.30f) : glm::vec4(0.72f, 0.76f, 0.84f, 0.30f);
    if (options.shadow && octree.texture() != 0) block.sun = glm::vec4(toward, kShadowStrength);
    block.edges_shown = options.edges ? 1 : 0;
    block.occlusion_shown = static_cast<std::int32_t>(options.occlusion);
    if (options.spriteLight) {
        const FaceRays rays = faceLights({}, space.voxelAxesFromWorld, options.light).rays;
        block.sprite_rays = glm::ivec4(rays.towardLight, rays.occlusion ? 1 : 0);
    }
    const glm::dvec3 low = -space.voxelOfMiddle;
    const glm::dvec3 size(octree.size());
    block.grid_centre = glm::vec2(low.x + size.x / 2, low.y + size.y / 2);
    block.grid_corner = glm::vec2(low.x, low.y);
    block.grid_height = static_cast<float>(low.z);
    block.grid_radius = static_cast<float>(24.0 + 2.0 * std::max(size.x, size.y));
    block.grid_shown = options.ground ? 1 : 0;
}

// One row for each face: +x, +y, +z, -x, -y, -z. In a sprite's light as many again for each shade.
void VoxelView::Impl::setPalette(const Palette& colours, const RootSpace& space,
                                 const VoxelViewOptions& options) {
    PaletteShader shader(colours);
    const Shading shading = options.spriteLight ? options.shading : Shading::multiply;
    std::array<LitPalette, 2> sides;
    for (const int side : {1, -1}) {
        FaceLights lights;
        // Rays that run down an axis see the face that looks up it.
        if (options.spriteLight) {
            lights = faceLights(glm::ivec3(-side), space.voxelAxesFromWorld, options.light);
        }
        sides[side > 0 ? 0 : 1] = litPalette(shader, lights, {}, shading);
    }
    std::vector<Rgba8> rows;
    for (std::size_t state = 0; 3 * state < sides[0].faces.size(); ++state) {
        for (const LitPalette& side : sides) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const ShadedColours& face = side.faces[3 * state + axis];
                rows.insert(rows.end(), face.begin(), face.end());
            }
        }
    }
    palette.set(std::move(rows));
}

void VoxelView::Impl::setView(const GpuOctree& octree, const PlacedEntity& placed,
                              const Camera& camera, const VoxelViewOptions& options,
                              const Ghost& ghost) {
    const RootSpace space(octree, placed, camera);
    VoxelViewBlock block;
    fillBox(block, octree, placed, camera, options);
    fillRays(block, space, camera);
    fillLook(block, space, octree, options);
    block.ghost_tint = ghost.tint;
    block.ghost_nearer = ghost.nearer;
    block.ghost_mixed = ghost.mixed;
    block.ghost_outline_px = ghost.outlinePx;
    block.ghost_dash_px = ghost.dashPx;
    if (ghost.tint.w > 0.0f) block.sun = glm::vec4(0.0f);  // a ghost has no shadow
    viewBlock.set(BlockBinding::voxelView, block);
    occlusionRays.bind();
    octreeBlock.set(BlockBinding::octree, octree.block());
    if (octree.texture() != 0) bindTexture(TextureUnit::svo, octree.texture());
    glBindVertexArray(nothing.id());
}

void VoxelView::Impl::drawVoxels(const GpuOctree& octree, const Palette& colours,
                                 const RootSpace& space, const VoxelViewOptions& options,
                                 const gl::DrawState& state) {
    if (octree.texture() == 0) return;
    setPalette(colours, space, options);
    bindTexture(TextureUnit::palette, palette.texture());
    gl::apply(state);
    // One limited in depth is rare: in all others' shade, it needs no variants of its own.
    const bool limited = leafLevel(octree, options) > 0;
    voxels.useOrSay(lookVariants(options) | (limited ? kDepthLimit | kVoxelFaceShade : kBare));
    glDrawArrays(GL_TRIANGLES, 0, 36);
}

void VoxelView::Impl::drawClusters(const GpuOctree& octree, const Palette& colours,
                                   const PlacedEntity& placed, const Camera& camera,
                                   const VoxelViewOptions& options) {
    if (octree.texture() == 0) return;
    setPalette(colours, RootSpace(octree, placed, camera), options);
    bindTexture(TextureUnit::palette, palette.texture());
    const ClusterPass::Instance instance{options.clusters, placed, {}};
    clusters->choose(
        {&instance, 1}, camera,
        {.budgetPx = options.clusterBudgetPx, .levelTint = options.tintLevels ? kLevelTint : 0.0f});
    // Depth first, so that what is hidden is not shaded.
    gl::apply({.depthTest = gl::DepthTest::nearer,
               .depthWrite = true,
               .colourWrite = false,
               .cull = gl::Cull::backFaces});
    clusterDepth.useOrSay();
    clusters->draw();
    gl::apply({.depthTest = gl::DepthTest::nearerOrEqual, .cull = gl::Cull::backFaces});
    clusterVoxels.useOrSay(lookVariants(options));
    clusters->draw();
}

void VoxelView::draw(Frame& frame, const GpuOctree& octree, const Palette& palette,
                     const PlacedEntity& placed, const Camera& camera,
                     const VoxelViewOptions& options) {
    frame.begin(options.backgroundBottom);
    impl_->setView(octree, placed, camera, options, {});
    gl::apply({});
    impl_->backdrop.useOrSay(options.shadow ? kSunShadow : kBare);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (options.clusters != nullptr && impl_->canDrawClusters()) {
        impl_->drawClusters(octree, palette, placed, camera, options);
        return;
    }
    impl_->drawVoxels(
        octree, palette, RootSpace(octree, placed, camera), options,
        {.depthTest = gl::DepthTest::nearer, .depthWrite = true, .cull = gl::Cull::frontFaces});
}

void VoxelView::drawGhost(Frame& frame, const GpuOctree& octree, const Palette& palette,
                          const PlacedEntity& placed, const Camera& camera,
                          const VoxelViewOptions& options, Rgba8 tint) {
    frame.bind();
    impl_->setView(octree, placed, camera, options, {.tint = toVec4(tint)});
    impl_->drawVoxels(
        octree, palette, RootSpace(octree, placed, camera), options,
        {.depthTest = gl::DepthTest::nearer, .blend = true, .cull = gl::Cull::frontFaces});
}

void VoxelView::Impl::drawMarked(const Marks& marks, bool hidden) {
    if (marks.octree.texture() == 0) return;
    constexpr float kHidden = 0.35f;  // of what is in sight
    VoxelViewOptions flat;
    flat.edges = false;
    flat.occlusion = VoxelOcclusion::off;
    Ghost look{.tint = toVec4(marks.tint),
               .mixed = 1.0f,
               .nearer = 1.0f + 2e-5f,
               .outlinePx = hidden ? 0.0f : 1.25f * marks.scale,
               .dashPx = 5.0f * marks.scale};
    if (hidden) look.tint.w *= kHidden;
    setView(marks.octree, marks.placed, marks.camera, flat, look);
    gl::apply({.depthTest = hidden ? gl::DepthTest::behind : gl::DepthTest::nearer,
               .blend = true,
               .cull = gl::Cull::frontFaces});
    voxels.useOrSay(kMarked);
    glDrawArrays(GL_TRIANGLES, 0, 36);
}

void VoxelView::drawMarked(Frame& frame, const GpuOctree& octree, const PlacedEntity& placed,
                           const Camera& camera, Rgba8 tint, float scale) {
    frame.bind();
    for (const bool hidden : {true, false}) {
        impl_->drawMarked({octree, placed, camera, tint, scale}, hidden);
    }
}

bool VoxelView::prepareMarks(const GpuOctree& octree, const PlacedEntity& placed,
                             const Camera& camera) {
    if (impl_->marksPrepared == 2 || octree.texture() == 0) return false;
    // Drivers make a program when it is first drawn with, anew for each state that it is drawn in.
    Frame unseen({1, 1});
    unseen.begin(Rgba8(0));
    const bool hidden = impl_->marksPrepared++ == 0;
    impl_->drawMarked({octree, placed, camera, Rgba8(255, 255, 255, 1)}, hidden);
    return true;
}

Result<VoxelView> VoxelView::create() {
    auto impl = std::make_unique<Impl>();
    return VoxelView(std::move(impl));
}

VoxelView::VoxelView(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VoxelView::~VoxelView() = default;
VoxelView::VoxelView(VoxelView&&) noexcept = default;
VoxelView& VoxelView::operator=(VoxelView&&) noexcept = default;

}  // namespace voxprite
