#include "core/billboard/snapshot.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/sprite/face_shade.h"
#include "core/sprite/sprite_view.h"
#include "core/trace/ray_packet.h"

namespace voxprite {

namespace {

constexpr float kSky = std::numeric_limits<float>::infinity();

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

std::size_t Snapshot::bytes() const {
    return sizeof(Snapshot) + buffer.colours.size() * sizeof(Rgba8) +
           buffer.ids.size() * sizeof(std::uint32_t) + depth.size() * sizeof(float);
}

SnapshotCamera::SnapshotCamera(const ViewSet& views, int view, glm::ivec3 modelSize, int size)
    : centre(glm::dvec3(modelSize) * 0.5),
      radius(std::max(1.0, glm::length(centre))),
      distance(kSnapshotDistance * radius),
      eye(centre + views.direction(view) * distance),
      axes(views.axes(view)),
      sizePx(size),
      focalPx(size * distance / (2.0 * radius)) {}

Ray SnapshotCamera::rayThrough(int column, int row) const {
    const double x = column + 0.5 - 0.5 * sizePx;
    const double y = 0.5 * sizePx - row - 0.5;
    return {eye, axes[2] + (axes[0] * x + axes[1] * y) / focalPx};
}

glm::dvec2 SnapshotCamera::project(glm::dvec3 voxel) const {
    const glm::dvec3 seen = (voxel - eye) * axes;
    return glm::dvec2(seen.x, -seen.y) * (focalPx / seen.z) + 0.5 * sizePx;
}

SnapshotLight::SnapshotLight(const Palette& palette, const Light& light,
                             const glm::dmat3& voxelFromWorldAxes, const Outline& outline,
                             Shading shading) {
    PaletteShader shader(palette);
    for (int octant = 0; octant < 8; ++octant) {
        const glm::ivec3 direction = 1 - 2 * octantCorner(static_cast<unsigned>(octant));
        lit_.push_back(
            litPalette(shader, faceLights(direction, voxelFromWorldAxes, light), outline, shading));
    }
}

const LitPalette& SnapshotLight::along(glm::dvec3 direction) const {
    return lit_[(direction.x < 0.0 ? 1u : 0u) | (direction.y < 0.0 ? 2u : 0u) |
                (direction.z < 0.0 ? 4u : 0u)];
}

SnapshotPixels castSnapshotPixels(const OctreeView& octree, const SnapshotLight& light,
                                  const SnapshotCamera& camera, PixelRect rect, int threads) {
    SnapshotPixels pixels;
    if (rect.empty()) return pixels;
    const glm::ivec2 size = rect.max - rect.min;
    pixels.colours.assign(area(size), Rgba8(0));
    pixels.ids.assign(area(size), kIdEmpty);
    pixels.depth.assign(area(size), kSky);
    const FaceShader shader(octree, light.along(camera.axes[2]).rays);
    raycastPicture(
        octree, size, kMaxOctreeDepth, threads,
        [&](glm::ivec2 pixel) {
            return camera.rayThrough(rect.min.x + pixel.x, rect.min.y + pixel.y);
        },
        [&] {
            return [&](glm::ivec2 pixel, const Ray& ray, const RaycastHit& hit) {
                const auto at =
                    static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(pixel.x);
                const LitPalette& lit = light.along(ray.direction);
                FaceShade shade;
                if (lit.rays.any()) {
                    const int side = hit.normal[hit.axis] > 0.0 ? 1 : -1;
                    shade = shader.shadeOf({hit.voxel, hit.axis, side});
                }
                pixels.colours[at] = lit.shade(hit.value, hit.axis, shade);
                pixels.ids[at] = voxelId(hit.voxel, octree.size);
                pixels.depth[at] = static_cast<float>(hit.t);
            };
        });
    return pixels;
}

Snapshot castSnapshot(const OctreeView& octree, const SnapshotLight& light, const ViewSet& views,
                      int view, int sizePx, int threads) {
    const SnapshotCamera camera(views, view, octree.size, sizePx);
    SnapshotPixels pixels =
        castSnapshotPixels(octree, light, camera, {{0, 0}, {sizePx, sizePx}}, threads);
    Snapshot snapshot{view, {}, std::move(pixels.depth)};
    snapshot.buffer.size = glm::ivec2(sizePx);
    snapshot.buffer.colours = std::move(pixels.colours);
    snapshot.buffer.ids = std::move(pixels.ids);
    return snapshot;
}

Result<LatticeView> snapshotLattice(const ViewSet& views, int view, double sigmaInForce,
                                    glm::ivec3 modelSize) {
    const glm::dmat3 axes = views.axes(view);
    return quantiseView({axes[0], axes[1], axes[2], sigmaInForce}, modelSize);
}

Result<Snapshot> castSpriteSnapshot(const OctreeView& octree, const SnapshotLight& light,
                                    const ViewSet& views, int view, double sigmaInForce,
                                    int threads) {
    const Result<LatticeView> lattice = snapshotLattice(views, view, sigmaInForce, octree.size);
    if (!lattice) return Failure(lattice.error());
    Snapshot snapshot{view, {}, {}};
    snapshot.buffer = castSprite(octree, *lattice, light.along(glm::dvec3(lattice->D)), threads);
    // A plane through the centre, and depths along forward in voxels.
    SpriteView plane;
    plane.lattice = *lattice;
    plane.centreVoxels = glm::dvec3(octree.size) * 0.5;
    plane.planeDepthMetres = 0.0;
    plane.depthMetres = -std::numeric_limits<double>::infinity();
    plane.depthPerVoxelMetres = views.axes(view)[2];
    snapshot.depth = pixelDepths(plane, octree, snapshot.buffer, threads);
    return snapshot;
}

}  // namespace voxprite
