#include "render/sprite_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>

namespace voxprite {

namespace {

// Screen positions are taken from the pixel centre nearest to the sprite's own centre and pixels
// from the region's corner, so that single precision is left with small numbers.
void fillMapping(SpriteBlock& block, const SpriteView& view, const LatticeView& visible,
                 const Camera& camera) {
    const double height = camera.viewportPx.y;
    const Camera::Projected centre = camera.projectFromEye(view.centreFromEyeMetres);
    const glm::dvec2 nearby =
        glm::clamp(centre.screenPx, glm::dvec2(0.0), glm::dvec2(camera.viewportPx));
    const double referenceX = std::floor(nearby.x) + 0.5;
    const double referenceY = std::floor(height - nearby.y) + 0.5;
    // (x, y from the reference, upwards) -> (x, y of the screen, downwards)
    const glm::dmat3 screenFromOffset{
        1.0, 0.0, 0.0, 0.0, -1.0, 0.0, referenceX, height - referenceY, 1.0};
    const glm::dmat3 cellFromPixel{1.0,
                                   0.0,
                                   0.0,
                                   0.0,
                                   1.0,
                                   0.0,
                                   -static_cast<double>(visible.first.x),
                                   -static_cast<double>(visible.first.y),
                                   1.0};
    glm::dmat3 map = cellFromPixel * pixelFromScreen(view, camera) * screenFromOffset;
    // Only the ratio counts; its sign stays.
    map /= std::max({std::abs(map[0].z) * camera.viewportPx.x,
                     std::abs(map[1].z) * camera.viewportPx.y, std::abs(map[2].z)});
    block.screen_reference = glm::vec2(referenceX, referenceY);
    block.pixel_from_screen = {toVec4(map[0]), toVec4(map[1]), toVec4(map[2])};
}

// The rectangle of the sprite plane that holds the region, and half a pixel more: which pixel a
// fragment shows, if any, is for the mapping to say.
std::array<glm::dvec3, 4> quadCorners(const SpriteView& view, const LatticeView& visible) {
    std::array<glm::dvec3, 4> corners = quadFromEye(view, visible.first, visible.size);
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = (i & 1) != 0 ? 0.5 : -0.5;
        const double y = (i & 2) != 0 ? 0.5 : -0.5;
        corners[i] += (view.right * x + view.up * y) * view.metresPerPx;
    }
    return corners;
}

std::array<glm::dvec3, 8> boxCorners(const SpriteView& view) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        const glm::dvec3 side((octant & 1) != 0 ? 1.0 : -1.0, (octant & 2) != 0 ? 1.0 : -1.0,
                              (octant & 4) != 0 ? 1.0 : -1.0);
        corners[octant] = view.centreFromEyeMetres + view.boxAxes * (side * view.boxHalfMetres);
    }
    return corners;
}

// Every vertex is given the sprite's one depth. Where all lie before the eye they are divided here
// and carry w = 1, so that every fragment gets exactly that depth: w * (z / w) is not z in floating
// point.
SpriteCorners clipCorners(std::span<const glm::dvec3> cornersFromEye, float depth,
                          const Camera& camera) {
    const glm::dmat4 clipFromEye = camera.clipFromCameraRelative();
    std::array<glm::dvec4, 8> clip{};
    bool allAhead = true;
    for (std::size_t i = 0; i < cornersFromEye.size(); ++i) {
        clip[i] = clipFromEye * glm::dvec4(cornersFromEye[i], 1.0);
        allAhead = allAhead && clip[i].w >= std::min(1.0, camera.nearMetres);
    }
    SpriteCorners corners{};
    for (std::size_t i = 0; i < cornersFromEye.size(); ++i) {
        const double divisor = allAhead ? clip[i].w : 1.0;
        const glm::dvec3 xyw = glm::dvec3(clip[i].x, clip[i].y, clip[i].w) / divisor;
        const auto w = static_cast<float>(allAhead ? 1.0 : xyw.z);
        corners[i] = glm::vec4(static_cast<float>(xyw.x), static_cast<float>(xyw.y), w * depth, w);
    }
    return corners;
}

}  // namespace

bool castsNarrow(const LatticeView& lattice, glm::ivec3 modelSize) {
    if (!fitsNarrow(lattice, modelSize)) return false;
    const glm::i64vec2 first(lattice.first);
    const glm::i64vec2 last = first + glm::i64vec2(lattice.size);
    const glm::i64vec2 farthest = glm::max(glm::abs(first), glm::abs(last));
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t toCentre = std::int64_t{modelSize[axis] / 2} << lattice.positionBits;
        const std::int64_t start =
            std::abs(lattice.C[axis] - toCentre) +
            ((farthest.x * std::abs(lattice.U[axis]) + farthest.y * std::abs(lattice.V[axis])) >>
             kStepShift);
        const std::int64_t box = (std::int64_t{modelSize[axis]} + 1) << lattice.positionBits;
        if (start + box >= std::int64_t{1} << 22) return false;
    }
    return true;
}

SpriteBlock castBlock(const LatticeView& lattice, const GpuOctree& octree, glm::ivec3 towardLight) {
    const glm::ivec3 centre = octree.size() / 2;
    SpriteBlock block;
    block.region_size = lattice.size;
    block.lattice_origin = lattice.C - centre * (1 << lattice.positionBits);
    block.position_bits = lattice.positionBits;
    block.lattice_right = lattice.U;
    block.first_x = lattice.first.x;
    block.lattice_up = lattice.V;
    block.first_y = lattice.first.y;
    block.lattice_direction = lattice.D;
    block.svo_max_depth = static_cast<std::uint32_t>(octree.maxDepth());
    block.svo_model_size = glm::uvec3(octree.size());
    block.tree_from_voxel = octree.treeFromVoxel();
    block.light_dir = glm::vec3(towardLight);
    // On a target of the buffer's own size each fragment is a cell.
    block.pixel_from_screen = {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0)};
    return block;
}

void placeInputs(SpriteBlock& block, const OctreePlace& octree, int paletteRow) {
    block.node_offset = octree.nodeOffset;
    block.payload_offset = octree.payloadOffset;
    block.palette_row = paletteRow;
}

SpriteBlock screenBlock(const SpriteView& view, const LatticeView& visible,
                        const PlacedEntity& placed, const GpuOctree& octree, const Camera& camera) {
    SpriteBlock block = castBlock(visible, octree, view.light8.rays.towardLight);
    block.billboard_depth = camera.reversedDepth(view.depthMetres);
    block.camera_distance = static_cast<float>(view.planeDepthMetres);
    fillMapping(block, view, visible, camera);

    const glm::dvec3 cornerFromCentre = glm::dvec3(octree.size() / 2) - view.centreVoxels;
    const double stepsPerVoxel = std::ldexp(1.0, view.lattice.positionBits);
    block.depth_per_step =
        toVec4(view.depthPerVoxelMetres / stepsPerVoxel,
               view.planeDepthMetres + glm::dot(view.depthPerVoxelMetres, cornerFromCentre));

    block.ray_dir_local = glm::vec3(view.ortho.forward);
    block.camera_up_local = glm::vec3(view.ortho.up);
    block.voxel_size = static_cast<float>(placed.voxelSizeMetres);
    block.sigma = static_cast<float>(view.sigmaInForce);
    block.anchor_to_center = glm::vec3(placed.centreVoxels() - placed.anchor);
    return block;
}

SpriteCorners screenCorners(const SpriteView& view, const LatticeView& visible,
                            const Camera& camera) {
    const float depth = camera.reversedDepth(view.depthMetres);
    if (view.proxy == ProxyShape::box) return clipCorners(boxCorners(view), depth, camera);
    return clipCorners(quadCorners(view, visible), depth, camera);
}

SpriteDrawBlock drawBlock(const SpriteLook& look) {
    SpriteDrawBlock block;
    block.outline_enabled = look.outline.enabled ? 1 : 0;
    block.outline_colour = std::bit_cast<std::uint32_t>(look.outline.colour) | 0xFF00'0000u;
    block.occlusion_shown = look.occlusion ? 1 : 0;
    block.shadows_shown = look.shadows ? 1 : 0;
    return block;
}

}  // namespace voxprite
