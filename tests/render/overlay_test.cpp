// Lines and triangles over a frame.
#include "render/overlay.h"

#include <algorithm>

#include "render/voxel_view.h"
#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;

constexpr glm::ivec2 kViewport{120, 100};
constexpr Rgba8 kBlack{0, 0, 0, 255};
constexpr Rgba8 kWhite{255, 255, 255, 255};

class Overlays : public test::GlTest {
  protected:
    static Camera front() { return orbitCamera({0, 0, 0}, {0, 0, 0}, 10.0, 45.0, kViewport); }
    static int lit(const Image& image) {
        return static_cast<int>(
            std::ranges::count_if(image.pixels, [](Rgba8 c) { return c.x > 0; }));
    }
    static Image drawn(const OverlayShapes& shapes, const Camera& camera) {
        Overlay overlay;
        Frame frame(kViewport);
        frame.begin(kBlack);
        overlay.draw(frame, shapes, camera, OverlayDepth::test);
        return frame.readColour();
    }
};

TEST_F(Overlays, ALineIsAsWideAsItSays) {
    for (const float width : {1.0f, 3.0f, 6.0f}) {
        OverlayShapes shapes;
        shapes.lines.push_back({{-100.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, kWhite, width});
        const Image image = drawn(shapes, front());
        // The horizon lies between rows 49 and 50. Coverage adds up to the width in every column.
        for (const int x : {0, 31, 60, 119}) {
            int sum = 0;
            for (int y = 0; y < kViewport.y; ++y) sum += image.at(x, y).x;
            EXPECT_NEAR(sum / 255.0, width, 0.1) << "column " << x;
        }
    }
}

TEST_F(Overlays, ALineThroughTheEyeIsCutAtTheNearPlane) {
    OverlayShapes shapes;
    shapes.lines.push_back({{0.5, -0.4, 30.0}, {0.5, -0.4, -30.0}, kWhite, 2.0f});
    const Image image = drawn(shapes, front());
    EXPECT_GT(lit(image), 20);
    // It runs from the vanishing point in the middle toward the lower right.
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            if (image.at(x, y).x > 0) {
                EXPECT_GE(x, 57);
                EXPECT_GE(y, 47);
            }
        }
    }
    OverlayShapes behind;
    behind.lines.push_back({{0.0, 0.0, 11.0}, {1.0, 0.0, 30.0}, kWhite, 2.0f});
    EXPECT_EQ(lit(drawn(behind, front())), 0);
}

TEST_F(Overlays, DepthModes) {
    // A cube, and a line behind it from edge to edge of the picture.
    const test::GpuModel cube(test::solidBox({10, 10, 10}, 40));
    const PlacedEntity placed = cube.placedAt({0.0, -0.5, 0.0}, GameProfile{});
    Camera camera = front();
    camera.eyeMetres = {0.0, 0.0, 4.0};
    VoxelView view = must(VoxelView::create());
    Overlay overlay;
    Frame frame(kViewport);
    OverlayShapes shapes;
    shapes.lines.push_back({{-50.0, 0.1, -2.0}, {50.0, 0.1, -2.0}, {255, 0, 0, 255}, 3.0f});
    VoxelViewOptions options;
    options.ground = false;
    options.edges = false;
    const auto middleRed = [&](std::optional<OverlayDepth> depth) {
        view.draw(frame, cube.gpu, cube.palette, placed, camera, options);
        if (depth) overlay.draw(frame, shapes, camera, *depth);
        const Image image = frame.readColour();
        int reddest = 0;
        for (int y = 0; y < kViewport.y; ++y) {
            const Rgba8 c = image.at(60, y);
            reddest = std::max(reddest, c.x - c.y);
        }
        return reddest;
    };
    const int none = middleRed(std::nullopt);
    const int test = middleRed(OverlayDepth::test);
    const int faint = middleRed(OverlayDepth::faintBehind);
    const int always = middleRed(OverlayDepth::always);
    EXPECT_EQ(test, none);
    EXPECT_GT(faint, test + 30);
    EXPECT_GT(always, faint + 60);
    EXPECT_EQ(always, 255);
}

TEST_F(Overlays, WhatLiesOnASurfaceIsSeenWhole) {
    const test::GpuModel cube(test::solidBox({10, 10, 10}, 40));
    const PlacedEntity placed = cube.placedAt({0.0, -0.5, 0.0}, GameProfile{});
    Camera camera = front();
    camera.eyeMetres = {0.2, 0.1, 4.0};
    VoxelView view = must(VoxelView::create());
    Overlay overlay;
    Frame frame(kViewport);
    view.draw(frame, cube.gpu, cube.palette, placed, camera, VoxelViewOptions{});
    // Two triangles right on the face toward the eye.
    OverlayShapes shapes;
    const glm::dvec3 a{-0.4, -0.4, 0.5};
    const glm::dvec3 b{0.4, -0.4, 0.5};
    const glm::dvec3 c{0.4, 0.4, 0.5};
    const glm::dvec3 d{-0.4, 0.4, 0.5};
    shapes.triangles.push_back({a, b, c, {255, 0, 255, 255}});
    shapes.triangles.push_back({c, d, a, {255, 0, 255, 255}});
    overlay.draw(frame, shapes, camera, OverlayDepth::test);
    const Image image = frame.readColour();
    const Camera::Projected low = camera.project(a);
    const Camera::Projected high = camera.project(c);
    const auto inside =
        static_cast<double>(std::ranges::count(image.pixels, Rgba8(255, 0, 255, 255)));
    const double area = (high.screenPx.x - low.screenPx.x) * (low.screenPx.y - high.screenPx.y);
    EXPECT_NEAR(inside, area, 0.04 * area);
}

TEST_F(Overlays, TranslucentTrianglesBlend) {
    OverlayShapes shapes;
    shapes.triangles.push_back(
        {{-50.0, -50.0, 0.0}, {50.0, -50.0, 0.0}, {0.0, 50.0, 0.0}, {200, 100, 0, 128}});
    const Image image = drawn(shapes, front());
    EXPECT_NEAR(image.at(60, 50).x, 100, 1);
    EXPECT_NEAR(image.at(60, 50).y, 50, 1);
    EXPECT_EQ(image.at(60, 50).w, 255);
}

TEST(OverlayShapesTest, ABoxHasTwelveEdges) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t o = 0; o < 8; ++o) {
        corners[o] = glm::dvec3(o & 1, (o >> 1) & 1, (o >> 2) & 1);
    }
    OverlayShapes shapes;
    shapes.addBox(corners, kWhite, 2.0f);
    ASSERT_EQ(shapes.lines.size(), 12U);
    for (const OverlayLine& line : shapes.lines) {
        const glm::dvec3 run = line.b - line.a;
        EXPECT_EQ(run.x + run.y + run.z, 1.0);
        EXPECT_EQ(run.x * run.y + run.y * run.z + run.z * run.x, 0.0);
    }
}

}  // namespace
}  // namespace voxprite
