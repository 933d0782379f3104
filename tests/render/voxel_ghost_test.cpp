// A ghost over the edit view, pixel by pixel against what the two models look like alone.
#include <cmath>

#include "render/voxel_view.h"
#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::GpuModel;
using test::must;

constexpr glm::ivec2 kViewport{220, 180};
constexpr Rgba8 kTint(235, 92, 20, 102);

class VoxelGhosts : public test::GlTest {};

// Both fill the same box, so that they are placed alike.
GpuModel solid() {
    return GpuModel(test::solidBox({12, 12, 12}, 40));
}
GpuModel beside() {
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 7);
    voxels.set({11, 11, 11}, 7);
    voxels.fill({{0, 0, 0}, {12, 12, 5}}, 90);  // its surface is the other's, too
    voxels.fill({{4, 4, 5}, {8, 8, 12}}, 130);
    return GpuModel(voxels);
}

struct Picture {
    Image colour;
    std::vector<float> depth;
};

void expectGhost(const GpuModel& model, const GpuModel& other, bool hidden) {
    const PlacedEntity placed = model.placedAt(glm::dvec3(0), GameProfile{});
    const Camera camera = orbitCamera({35, 25, 0}, placed.centreMetres(),
                                      3.5 * placed.radiusMetres(), 40.0, kViewport);
    VoxelViewOptions options;
    options.ground = false;
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    const auto picture = [&] { return Picture{frame.readColour(), frame.readDepth()}; };
    view.draw(frame, other.gpu, other.palette, placed, camera, options);
    const Picture alone = picture();
    view.draw(frame, model.gpu, model.palette, placed, camera, options);
    const Picture before = picture();
    view.drawGhost(frame, other.gpu, other.palette, placed, camera, options, kTint);
    const Picture after = picture();

    EXPECT_EQ(after.depth, before.depth);
    int ghosts = 0, wrong = 0;
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            const auto at = static_cast<std::size_t>(y * kViewport.x + x);
            const bool nearer = alone.depth[at] > before.depth[at] * (1.0f + 3e-5f);
            ghosts += nearer ? 1 : 0;
            for (int channel = 0; channel < 3; ++channel) {
                const double was = before.colour.at(x, y)[channel];
                const double own = alone.colour.at(x, y)[channel];
                const double tinted = own + (kTint[channel] - own) * 0.7;
                const double share = nearer ? kTint.w / 255.0 : 0.0;
                const double expected = was + (tinted - was) * share;
                wrong += std::abs(after.colour.at(x, y)[channel] - expected) > 2.0 ? 1 : 0;
            }
        }
    }
    EXPECT_LE(wrong, 12);  // where single precision falls on the other side of an edge
    if (hidden) {
        EXPECT_LE(ghosts, 4);
    } else {
        EXPECT_GT(ghosts, 1000);
    }
}

TEST_F(VoxelGhosts, ShowWhereTheyAreNearerAndNowhereElse) {
    expectGhost(beside(), solid(), false);
}

TEST_F(VoxelGhosts, GiveWayToTheModelsOwnSurface) {
    expectGhost(solid(), beside(), true);
    expectGhost(solid(), solid(), true);
}

TEST_F(VoxelGhosts, TheNextPictureHasNone) {
    const GpuModel model = beside(), other = solid();
    const PlacedEntity placed = model.placedAt(glm::dvec3(0), GameProfile{});
    const Camera camera = orbitCamera({35, 25, 0}, placed.centreMetres(),
                                      3.5 * placed.radiusMetres(), 40.0, kViewport);
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    view.draw(frame, model.gpu, model.palette, placed, camera, {});
    const Image before = frame.readColour();
    view.drawGhost(frame, other.gpu, other.palette, placed, camera, {}, kTint);
    EXPECT_NE(frame.readColour().pixels, before.pixels);
    view.draw(frame, model.gpu, model.palette, placed, camera, {});
    EXPECT_EQ(frame.readColour().pixels, before.pixels);
}

// Marked voxels of the model itself: tinted where they are in sight, faintly where something nearer
// hides them, with a line around them; nothing else changes.
TEST_F(VoxelGhosts, MarkedVoxelsCoverTheModelsOwnSurface) {
    VoxelGrid voxels = test::solidBox({12, 12, 12}, 40);
    VoxelGrid some;
    some.set({0, 0, 0}, 1);  // so that both fill the same box
    some.set({11, 11, 11}, 1);
    some.fill({{3, 0, 3}, {9, 12, 9}}, 1);  // through to the side that is hidden
    const GpuModel model(voxels), marked(some);
    const PlacedEntity placed = model.placedAt(glm::dvec3(0), GameProfile{});
    const Camera camera = orbitCamera({35, 25, 0}, placed.centreMetres(),
                                      3.5 * placed.radiusMetres(), 40.0, kViewport);
    VoxelViewOptions options;
    options.ground = false;
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    view.draw(frame, marked.gpu, marked.palette, placed, camera, options);
    const std::vector<float> alone = frame.readDepth();
    view.draw(frame, model.gpu, model.palette, placed, camera, options);
    const Picture before{frame.readColour(), frame.readDepth()};
    view.drawMarked(frame, marked.gpu, placed, camera, kTint, 1.0f);
    const Picture after{frame.readColour(), frame.readDepth()};

    EXPECT_EQ(after.depth, before.depth);
    int inSight = 0, hidden = 0, plain = 0, lines = 0, elsewhere = 0;
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            const auto at = static_cast<std::size_t>(y * kViewport.x + x);
            const bool changed = after.colour.at(x, y) != before.colour.at(x, y);
            if (alone[at] == 0.0f) {
                elsewhere += changed ? 1 : 0;
                continue;
            }
            const bool seen = alone[at] >= before.depth[at] * (1.0f - 1e-5f);
            (seen ? inSight : hidden) += 1;
            const double share = kTint.w / 255.0 * (seen ? 1.0 : 0.35);
            bool tinted = true;
            for (int channel = 0; channel < 3; ++channel) {
                const double was = before.colour.at(x, y)[channel];
                const double expected = was + (kTint[channel] - was) * share;
                tinted = tinted && std::abs(after.colour.at(x, y)[channel] - expected) <= 2.0;
            }
            (tinted ? plain : lines) += 1;
        }
    }
    EXPECT_EQ(elsewhere, 0);
    EXPECT_GT(inSight, 800);
    EXPECT_GT(hidden, 300);
    EXPECT_GT(plain, lines);
    EXPECT_GT(lines, 200);
}

}  // namespace
}  // namespace voxprite
