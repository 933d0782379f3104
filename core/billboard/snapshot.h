// A snapshot: one view of a model, cast once and drawn many times.
//
// Two kinds. `seed` is the snapshot cache's own: a square picture in perspective, from eight radii
// away. `sprite` is the very sprite of that view (core/sprite/sprite_view.h, viewSnapshot), on the
// sigma grid and with its outline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/sprite/lit_palette.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/view_set.h"
#include "core/svo/octree.h"
#include "core/trace/raycast.h"

namespace voxprite {

enum class SnapshotKind : std::uint8_t { seed, sprite };

struct Snapshot {
    int view = 0;  // of its set
    // Kind seed: first (0, 0), no outline, and size N x N. Empty pixels are the sky: colour
    // 0,0,0,0, id kIdEmpty.
    SpriteBuffer buffer;
    // Of each pixel, in voxels; infinity where it is empty. Kind seed: the distance from the
    // snapshot's eye along the pixel's ray. Kind sprite: along the view's forward, from the plane
    // through the model's centre; of an outline pixel that of its nearest neighbour.
    std::vector<float> depth;

    [[nodiscard]] std::size_t bytes() const;
};

// The eye of a `seed` snapshot, in voxels from the model's minimum corner: kSnapshotDistance radii
// from the centre of its box, radius that of the sphere around the box (at least one voxel), framed
// so that this sphere's width at the centre is the picture's: hz = N D / 2R, an opening of 14
// degrees. Neither size nor centre are rounded to anything.
inline constexpr double kSnapshotDistance = 8.0;
inline constexpr int kUsualSnapshotPx = 128;
inline constexpr int kMostSnapshotPx = 4096;
struct SnapshotCamera {
    glm::dvec3 centre{0.0};
    double radius = 1.0;
    double distance = kSnapshotDistance;  // of the eye from the centre
    glm::dvec3 eye{0.0};
    glm::dmat3 axes{1.0};  // right, up, forward
    int sizePx = kUsualSnapshotPx;
    double focalPx = 4.0 * kUsualSnapshotPx;  // hz

    SnapshotCamera(const ViewSet& views, int view, glm::ivec3 modelSize, int sizePx);
    [[nodiscard]] double voxelsPerPx() const { return 2.0 * radius / sizePx; }  // at the centre
    // Through the middle of a pixel; rows count from the top.
    [[nodiscard]] Ray rayThrough(int column, int row) const;
    // Columns and rows, of a point ahead of the eye.
    [[nodiscard]] glm::dvec2 project(glm::dvec3 voxel) const;
};

// The light on every face that a perspective ray can meet, for rays of each octant of directions.
class SnapshotLight {
  public:
    // `voxelFromWorldAxes` turns light.towardLight into voxel space.
    SnapshotLight(const Palette& palette, const Light& light, const glm::dmat3& voxelFromWorldAxes,
                  const Outline& outline, Shading shading);
    // For rays along `direction`; its outline is that of the sprite.
    [[nodiscard]] const LitPalette& along(glm::dvec3 direction) const;
    bool operator==(const SnapshotLight&) const = default;

  private:
    std::vector<LitPalette> lit_;  // bit a of the index: the direction's component a is negative
};

// A rectangle of a picture, half open; rows count from the top.
struct PixelRect {
    glm::ivec2 min{0};
    glm::ivec2 max{0};
    [[nodiscard]] bool empty() const { return min.x >= max.x || min.y >= max.y; }
};

// The pixels of a `seed` snapshot within `rect`, row by row: what the whole one has there.
struct SnapshotPixels {
    UnfilledVector<Rgba8> colours;
    UnfilledVector<std::uint32_t> ids;
    std::vector<float> depth;
};
[[nodiscard]] SnapshotPixels castSnapshotPixels(const OctreeView& octree,
                                                const SnapshotLight& light,
                                                const SnapshotCamera& camera, PixelRect rect,
                                                int threads = 0);

// threads <= 0: all cores. An empty model gives an empty picture. 1 <= sizePx <= kMostSnapshotPx.
[[nodiscard]] Snapshot castSnapshot(const OctreeView& octree, const SnapshotLight& light,
                                    const ViewSet& views, int view, int sizePx, int threads = 0);

// The sprite of a view; `sigmaInForce` is sigma times the entity's scale. Fails as quantiseView
// does.
[[nodiscard]] Result<LatticeView> snapshotLattice(const ViewSet& views, int view,
                                                  double sigmaInForce, glm::ivec3 modelSize);
[[nodiscard]] Result<Snapshot> castSpriteSnapshot(const OctreeView& octree,
                                                  const SnapshotLight& light, const ViewSet& views,
                                                  int view, double sigmaInForce, int threads = 0);

}  // namespace voxprite
