// The edit view shows the voxels that picking finds, at their true depth.
#include "render/voxel_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/sprite/voxel_placement.h"
#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::GpuModel;
using test::must;

constexpr glm::ivec2 kViewport{200, 180};

class VoxelViews : public test::GlTest {
  protected:
    // Nothing on the faces but their own colour, at full light.
    static VoxelViewOptions plain() {
        VoxelViewOptions options;
        options.edges = false;
        options.occlusion = VoxelOcclusion::off;
        options.ground = false;
        options.light.ambient = 1.0;
        return options;
    }
    static Camera camera(const PlacedEntity& placed, const OrbitAngles& angles, double distance) {
        return orbitCamera(angles, placed.centreMetres(), distance * placed.radiusMetres(), 45.0,
                           kViewport);
    }

    struct Expected {
        std::uint8_t material = 0;
        float depth = 0.0f;
    };
    static Expected pick(const GpuModel& model, const PlacedEntity& placed, const Camera& camera,
                         glm::dvec2 screenPx, int maxDepth) {
        const Camera::Ray ray = camera.rayThrough(screenPx);
        const RaycastHit hit = raycast(model.octree.view(), voxelPlacement(placed),
                                       {ray.origin, ray.direction}, {.maxDepth = maxDepth});
        if (!hit.hit) return {};
        const double metres = hit.t * glm::dot(ray.direction, camera.forward);
        return {hit.value, camera.reversedDepth(metres)};
    }

    // Compares a picture with picking; silhouettes and edges between two voxels are where single
    // precision may fall on the other side.
    static void expectAgreement(const GpuModel& model, const PlacedEntity& placed,
                                const Camera& camera, int maxDepth = kMaxOctreeDepth) {
        VoxelView view = must(VoxelView::create());
        Frame frame(kViewport);
        VoxelViewOptions options = plain();
        options.maxDepth = maxDepth;
        view.draw(frame, model.gpu, model.palette, placed, camera, options);
        const Image colour = frame.readColour();
        const std::vector<float> depth = frame.readDepth();
        int hits = 0;
        int wrong = 0;
        for (int y = 0; y < kViewport.y; ++y) {
            for (int x = 0; x < kViewport.x; ++x) {
                const auto at = static_cast<std::size_t>(y * kViewport.x + x);
                const Expected expected =
                    pick(model, placed, camera, glm::dvec2(x, y) + 0.5, maxDepth);
                hits += expected.material != 0;
                const bool sameColour =
                    expected.material == 0
                        ? depth[at] == 0.0f
                        : colour.at(x, y) == model.palette.colours[expected.material];
                const bool sameDepth =
                    std::abs(depth[at] - expected.depth) <= 1e-4f * expected.depth;
                wrong += !sameColour || !sameDepth;
            }
        }
        EXPECT_GT(hits, 1500);
        EXPECT_LE(wrong, kViewport.x * kViewport.y / 1000);
    }
};

TEST_F(VoxelViews, EveryPixelShowsTheVoxelThatPickingFinds) {
    GpuModel letters(test::asymmetric());
    GpuModel noise(test::randomVoxels(3, {17, 30, 23}, 0.2, 200));
    const GameProfile profile;
    for (GpuModel* model : {&letters, &noise}) {
        for (auto& colour : model->palette.colours) colour.w = 255;
        const PlacedEntity placed = model->placedAt({3.0, 1.0, -2.0}, profile, 20.0);
        for (const OrbitAngles& angles :
             {OrbitAngles{35, 25, 0}, OrbitAngles{0, 0, 0}, OrbitAngles{200, -40, 10},
              OrbitAngles{90, 90, 0}, OrbitAngles{-45, 35.264389682754654, 0}}) {
            expectAgreement(*model, placed, camera(placed, angles, 3.0));
        }
        Camera parallel = camera(placed, {20, 30, 0}, 3.0);
        parallel.orthographic = true;
        parallel.orthographicHeightMetres = 2.4 * placed.radiusMetres();
        expectAgreement(*model, placed, parallel);
    }
}

// Also where cubes reach beyond the model's box, whose edges are no multiples of theirs.
TEST_F(VoxelViews, ADepthLimitShowsTheCubesThatRaysMeet) {
    GpuModel noise(test::randomVoxels(5, {17, 30, 23}, 0.01, 200));
    const PlacedEntity placed = noise.placedAt({3.0, 1.0, -2.0}, GameProfile{}, 20.0);
    ASSERT_EQ(noise.octree.maxDepth, 5);
    for (int depth = 0; depth <= 5; ++depth) {
        expectAgreement(noise, placed, camera(placed, {35, 25, 0}, 3.0), depth);
        expectAgreement(noise, placed, camera(placed, {180, -10, 0}, 2.0), depth);
    }
}

TEST_F(VoxelViews, TheEyeMayBeInsideTheModelsBox) {
    VoxelGrid room;
    room.fill(IBox{{0, 0, 0}, {40, 40, 40}}, 1);
    room.fill(IBox{{2, 2, 2}, {38, 38, 38}}, 0);
    room.fill(IBox{{20, 20, 5}, {24, 23, 30}}, 40);
    GpuModel model(room);
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    expectAgreement(model, placed, camera(placed, {15, 10, 0}, 0.4));
}

TEST_F(VoxelViews, SolidSurfacesHaveNoCracks) {
    // All the viewport is one large wall of many bricks, seen at a slant.
    VoxelGrid wall = test::randomVoxels(4, {128, 4, 128}, 1.0, 2);
    GpuModel model(wall);
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    for (const OrbitAngles& angles : {OrbitAngles{0, 0, 0}, OrbitAngles{12, 7, 3},
                                      OrbitAngles{30, 30, 0}, OrbitAngles{45, 0, 0}}) {
        view.draw(frame, model.gpu, model.palette, placed, camera(placed, angles, 0.3), plain());
        const std::vector<float> depth = frame.readDepth();
        EXPECT_EQ(std::ranges::count(depth, 0.0f), 0);
    }
}

TEST_F(VoxelViews, LiveBoundsBeyondTheRoot) {
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(test::figure()));
    const IBox bounds{{-30, -30, -30}, {60, 60, 60}};
    GpuModel model(test::figure());
    model.gpu.upload(live.view(bounds));
    Entity entity;
    const PlacedEntity placed = placeEntity(entity, bounds, GameProfile{});
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    view.draw(frame, model.gpu, model.palette, placed, camera(placed, {30, 20, 0}, 1.2), plain());
    const std::vector<float> depth = frame.readDepth();
    EXPECT_GT(std::ranges::count_if(depth, [](float d) { return d > 0.0f; }), 500);
}

TEST_F(VoxelViews, NothingButBackgroundWithoutVoxels) {
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    const GpuOctree empty;
    view.draw(frame, empty, Palette::standard(), PlacedEntity{}, Camera{}, VoxelViewOptions{});
    const std::vector<float> depth = frame.readDepth();
    EXPECT_EQ(std::ranges::count(depth, 0.0f), static_cast<std::ptrdiff_t>(depth.size()));
    Octree none = must(bake(VoxelGrid{}));
    GpuOctree baked;
    baked.upload(none.view());
    view.draw(frame, baked, Palette::standard(), PlacedEntity{}, Camera{}, VoxelViewOptions{});
    for (const Rgba8 pixel : frame.readColour().pixels) EXPECT_EQ(pixel.w, 255);
}

TEST_F(VoxelViews, EdgesAndGridAreSeenAndFacesDiffer) {
    const GpuModel model(test::solidBox({4, 4, 4}, 40));
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    const Camera view = camera(placed, {30, 30, 0}, 3.0);
    VoxelView renderer = must(VoxelView::create());
    Frame frame(kViewport);
    const auto colours = [&](const VoxelViewOptions& options) {
        renderer.draw(frame, model.gpu, model.palette, placed, view, options);
        return frame.readColour();
    };
    VoxelViewOptions options;
    options.edges = false;
    options.occlusion = VoxelOcclusion::off;
    options.ground = false;
    const Image bare = colours(options);
    std::vector<Rgba8> faces;
    const std::vector<float> depth = frame.readDepth();
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] > 0.0f && std::ranges::find(faces, bare.pixels[i]) == faces.end()) {
            faces.push_back(bare.pixels[i]);
        }
    }
    EXPECT_EQ(faces.size(), 3U);
    options.edges = true;
    const Image edged = colours(options);
    options.ground = true;
    const Image grounded = colours(options);
    int darker = 0;
    int gridded = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        darker += depth[i] > 0.0f && edged.pixels[i].y < bare.pixels[i].y;
        EXPECT_LE(edged.pixels[i].y, bare.pixels[i].y);
        gridded += depth[i] == 0.0f && grounded.pixels[i] != edged.pixels[i];
    }
    EXPECT_GT(darker, 300);
    EXPECT_GT(gridded, 300);
}

// Marched in steps too small to jump a voxel's corner that matters, nothing like the shader's walk.
bool marchesIntoVoxel(const VoxelGrid::Reader& voxels, glm::dvec3 from, glm::dvec3 toward) {
    for (double t = 5e-3; t < 20.0; t += 5e-3) {
        if (voxels.get(glm::ivec3(glm::floor(from + toward * t))) != 0) return true;
    }
    return false;
}

TEST_F(VoxelViews, TheSunsShadowFallsWhereAMarchTowardItIsStopped) {
    VoxelGrid voxels = test::solidBox({24, 24, 1}, 40);
    voxels.fill(IBox{{8, 9, 1}, {10, 11, 9}}, 40);
    voxels.fill(IBox{{6, 14, 5}, {15, 19, 6}}, 40);
    const GpuModel model(voxels);
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    const Camera eye = camera(placed, {25, 50, 0}, 2.6);
    VoxelViewOptions options = plain();
    options.light.towardLight = {0.45, 1.0, 0.3};
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    view.draw(frame, model.gpu, model.palette, placed, eye, options);
    const Image bright = frame.readColour();
    options.shadow = true;
    view.draw(frame, model.gpu, model.palette, placed, eye, options);
    const Image shaded = frame.readColour();
    const std::vector<float> depth = frame.readDepth();

    const glm::dvec3 sun = glm::normalize(voxelFromWorld(options.light.towardLight));
    const VoxelGrid::Reader reader(voxels);
    int inShade = 0, inSun = 0, wrong = 0;
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            const bool darker = shaded.at(x, y).y < bright.at(x, y).y;
            EXPECT_LE(shaded.at(x, y).y, bright.at(x, y).y);
            if (depth[static_cast<std::size_t>(y * kViewport.x + x)] == 0.0f) continue;
            const Camera::Ray ray = eye.rayThrough(glm::dvec2(x, y) + 0.5);
            const glm::dvec3 from =
                voxelFromWorld(ray.origin - placed.anchorMetres) / placed.metresPerVoxel() +
                placed.anchor;
            const glm::dvec3 direction = voxelFromWorld(ray.direction);
            const RaycastHit hit = raycast(model.octree.view(), {from, direction});
            if (!hit.hit) continue;
            // Of this light all faces that the eye sees from above look toward it or away.
            if (glm::dot(sun, hit.normal) <= 0.0) {
                wrong += darker;
                continue;
            }
            const glm::dvec3 at = hit.point + hit.normal * 1e-6;
            const bool stopped = marchesIntoVoxel(reader, at, sun);
            inShade += stopped;
            inSun += !stopped;
            wrong += darker != stopped;
        }
    }
    EXPECT_GT(inShade, 200);
    EXPECT_GT(inSun, 2000);
    // Single precision falls on the other side along a shadow's edge.
    EXPECT_LE(wrong, 25);
}

TEST_F(VoxelViews, TheModelsShadowFallsOnTheGround) {
    const GpuModel model(test::solidBox({4, 4, 16}, 40));
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    VoxelViewOptions options = plain();
    options.light.towardLight = {1.0, 1.0, 0.2};
    VoxelView view = must(VoxelView::create());
    Frame frame(kViewport);
    const Camera eye = camera(placed, {0, 50, 0}, 4.0);
    view.draw(frame, model.gpu, model.palette, placed, eye, options);
    const Image bright = frame.readColour();
    options.shadow = true;
    view.draw(frame, model.gpu, model.palette, placed, eye, options);
    const Image shaded = frame.readColour();
    const std::vector<float> depth = frame.readDepth();
    // The sun is on the right: the shadow lies on the left of the model's middle, all of it.
    int left = 0, right = 0;
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            if (depth[static_cast<std::size_t>(y * kViewport.x + x)] != 0.0f) continue;
            const bool darker = shaded.at(x, y).y < bright.at(x, y).y;
            (x < kViewport.x / 2 ? left : right) += darker;
        }
    }
    EXPECT_GT(left, 200);
    EXPECT_EQ(right, 0);
}

TEST_F(VoxelViews, CornersBetweenVoxelsAreShaded) {
    // A floor with a wall on it: shade along the foot of the wall, none in the open.
    VoxelGrid voxels = test::solidBox({16, 16, 1}, 40);
    voxels.fill(IBox{{0, 15, 1}, {16, 16, 8}}, 40);
    const GpuModel model(voxels);
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    Camera above = camera(placed, {0, 90, 0}, 3.0);
    VoxelView renderer = must(VoxelView::create());
    Frame frame(kViewport);
    VoxelViewOptions options;
    options.edges = false;
    const auto greenAt = [&](double y) {
        const glm::dvec3 point = placed.worldFromVoxel({8.5, y, 1.0});
        return frame.readColour()
            .at(static_cast<int>(above.project(point).screenPx.x),
                static_cast<int>(above.project(point).screenPx.y))
            .y;
    };
    renderer.draw(frame, model.gpu, model.palette, placed, above, options);
    const int open = greenAt(7.5);
    const int foot = greenAt(14.9);
    const int nearFoot = greenAt(14.3);
    EXPECT_EQ(open, greenAt(3.5));
    EXPECT_LT(foot, nearFoot);
    EXPECT_LT(nearFoot, open);
    options.occlusion = VoxelOcclusion::off;
    renderer.draw(frame, model.gpu, model.palette, placed, above, options);
    EXPECT_EQ(greenAt(14.9), open);
}

// Short rays see farther than corners, and their shade has no steps: neither between faces nor
// within one.
TEST_F(VoxelViews, ShortRaysShadeSmoothly) {
    VoxelGrid voxels = test::solidBox({16, 16, 1}, 40);
    voxels.fill(IBox{{0, 15, 1}, {16, 16, 8}}, 40);
    const GpuModel model(voxels);
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{});
    const Camera above = camera(placed, {0, 90, 0}, 3.0);
    VoxelView renderer = must(VoxelView::create());
    Frame frame(kViewport);
    const auto greensToward = [&](VoxelOcclusion occlusion) {
        VoxelViewOptions options;
        options.edges = false;
        options.occlusion = occlusion;
        renderer.draw(frame, model.gpu, model.palette, placed, above, options);
        const Image image = frame.readColour();
        std::vector<int> greens;
        const glm::ivec2 from(above.project(placed.worldFromVoxel({8.3, 6.0, 1.0})).screenPx);
        const glm::ivec2 to(above.project(placed.worldFromVoxel({8.3, 14.8, 1.0})).screenPx);
        for (int y = from.y; y >= to.y; --y) greens.push_back(image.at(from.x, y).y);
        return greens;
    };
    const std::vector<int> rays = greensToward(VoxelOcclusion::rays);
    const std::vector<int> corners = greensToward(VoxelOcclusion::corners);
    const int open = greensToward(VoxelOcclusion::off).front();
    ASSERT_GT(rays.size(), 40U);
    EXPECT_EQ(rays.front(), open);
    EXPECT_LT(rays.back(), open * 4 / 5);
    int raysReach = 0, cornersReach = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        raysReach += rays[k] < open ? 1 : 0;
        cornersReach += corners[k] < open ? 1 : 0;
        if (k > 0) {
            EXPECT_LE(rays[k], rays[k - 1]) << k;
            EXPECT_LE(rays[k - 1] - rays[k], open / 16) << k;
        }
    }
    EXPECT_GT(raysReach, 2 * cornersReach);
}

TEST_F(VoxelViews, SpriteLightGivesFacesTheSpritesOwnColours) {
    const GpuModel model(test::solidBox({6, 6, 6}, 40));
    const PlacedEntity placed = model.placedAt({0, 0, 0}, GameProfile{}, 70.0);
    VoxelView renderer = must(VoxelView::create());
    Frame frame(kViewport);
    VoxelViewOptions options;
    options.edges = false;
    options.occlusion = VoxelOcclusion::off;
    options.spriteLight = true;
    for (const OrbitAngles& angles : {OrbitAngles{30, 30, 0}, OrbitAngles{200, -25, 0}}) {
        const Camera view = camera(placed, angles, 3.0);
        renderer.draw(frame, model.gpu, model.palette, placed, view, options);
        const Image image = frame.readColour();
        const std::vector<float> depth = frame.readDepth();
        GameProfile profile;
        profile.light = options.light;
        const SpriteView sprite = *must(viewSprite(placed, view, profile)).view;
        const LitPalette lit = litPalette(model.palette, sprite.light8, Outline{});
        std::array<int, 3> pixels{};
        for (std::size_t i = 0; i < depth.size(); ++i) {
            if (depth[i] == 0.0f) continue;
            bool known = false;
            for (std::uint8_t axis = 0; axis < 3; ++axis) {
                if (image.pixels[i] != lit.shade(40, axis)) continue;
                known = true;
                ++pixels[axis];
            }
            ASSERT_TRUE(known);
        }
        for (const int count : pixels) EXPECT_GT(count, 100);
    }
}

}  // namespace
}  // namespace voxprite
