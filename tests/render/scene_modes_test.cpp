// The two modes against each other in every pixel, against the CPU's composite, and the depths that
// they write.
#include "tests/render/scene_support.h"

namespace voxprite {
namespace {

using test::composed;
using test::kBackground;
using test::kViewport;
using test::mismatches;
using test::must;
using test::plainProfile;

class SceneModes : public test::Scenes {};

// All cameras and choices that change what reaches the screen.
struct Variant {
    std::string name;
    Camera camera;
    GameProfile profile;
    bool ground = true;
};

std::vector<Variant> variants(const std::vector<Camera>& cameras) {
    std::vector<Variant> all;
    std::size_t next = 0;
    for (const DepthRule depth : {DepthRule::centre, DepthRule::groundSafe, DepthRule::perPixel}) {
        for (const ViewRule view : {ViewRule::towardEntity, ViewRule::cameraForward}) {
            for (const double sigma : {4.0, 1.0, 7.5}) {
                Variant v;
                v.camera = cameras[next % cameras.size()];
                v.profile = plainProfile();
                v.profile.depth = depth;
                v.profile.view = view;
                v.profile.sigma = sigma;
                v.profile.registration =
                    next % 2 == 0 ? Registration::modelCentre : Registration::anchor;
                v.profile.proxy = next % 5 == 3 ? ProxyShape::box : ProxyShape::quad;
                v.ground = next % 4 != 1;
                v.name = "variant " + std::to_string(next++);
                all.push_back(v);
            }
        }
    }
    return all;
}

TEST_F(SceneModes, BothModesAgreeInEveryPixelOfColourAndDepth) {
    const std::vector<Camera> cameras{camera(0, 0),         camera(45, 35.264389682754654),
                                      camera(90, 90),       camera(31, 17, 4.0, 9.0),
                                      camera(200, -12, 14), parallel(0, 0),
                                      parallel(45, 30),     parallel(123.4, 56.7),
                                      camera(10, 8, 2.6)};
    for (const Variant& variant : variants(cameras)) {
        Scene scene = crowd(variant.profile);
        if (variant.ground) scene.ground = Ground{};
        const Picture buffered =
            draw(scene, variant.camera, variant.profile, SpriteMode::spriteBuffer);
        const Picture single = draw(scene, variant.camera, variant.profile, SpriteMode::singlePass);
        EXPECT_EQ(mismatches(buffered.colour, single.colour), 0U) << variant.name;
        EXPECT_TRUE(buffered.depth == single.depth) << variant.name;
        EXPECT_EQ(buffered.stats.drawn, single.stats.drawn) << variant.name;
    }
}

// The GL maps a screen position to its virtual pixel in single precision, the CPU in double. With a
// sprite of a few hundred pixels the single-precision result is off by less than 1e-4 pixels, so a
// screen pixel differs only where its centre comes that near to an edge between two virtual pixels:
// on two axes that is 4e-4 of the pixels if all neighbours differed. Depth rules add the pixels
// where ground or another voxel lies at the same depth to a few units in the last place.
TEST_F(SceneModes, AgreesWithTheCpuComposite) {
    constexpr double kTolerance = 4e-4;
    const std::vector<Camera> cameras{camera(13, 21), camera(31, 17, 4.0, 9.0), camera(200, 12, 14),
                                      parallel(123.4, 36.7), camera(301, 44, 5)};
    std::uint64_t all = 0;
    std::uint64_t different = 0;
    for (const Variant& variant : variants(cameras)) {
        Scene scene = crowd(variant.profile);
        if (variant.ground) scene.ground = Ground{};
        const Image gl = draw(scene, variant.camera, variant.profile).colour;
        const Image cpu = composed(scene, crowdModels(), variant.camera, variant.profile);
        const std::uint64_t count = mismatches(gl, cpu);
        EXPECT_LE(static_cast<double>(count), kTolerance * static_cast<double>(gl.pixels.size()))
            << variant.name;
        all += gl.pixels.size();
        different += count;
    }
    RecordProperty("mismatch_per_million", static_cast<int>(different * 1'000'000 / all));
}

TEST_F(SceneModes, OneSpriteWritesExactlyOneDepth) {
    for (const DepthRule rule : {DepthRule::centre, DepthRule::groundSafe}) {
        for (const Camera& view : {camera(0, 0), camera(77, 31, 5.0, 12.0), parallel(20, 15)}) {
            GameProfile profile = plainProfile();
            profile.depth = rule;
            Scene scene;
            scene.background = kBackground;
            scene.entities = {entity(*figure_, {0.3, 0.0, 0.1}, profile, 10.0)};
            const SpriteView sprite =
                *must(viewSprite(scene.entities[0].placed, view, profile)).view;
            const Picture picture = draw(scene, view, profile);
            const float expected = view.reversedDepth(sprite.depthMetres);
            std::size_t covered = 0;
            for (std::size_t i = 0; i < picture.depth.size(); ++i) {
                const bool drawn = picture.colour.pixels[i] != kBackground;
                EXPECT_EQ(picture.depth[i], drawn ? expected : 0.0f);
                covered += drawn;
            }
            EXPECT_GT(covered, 1000U);
        }
    }
}

TEST_F(SceneModes, PerPixelDepthIsThatOfTheVoxelsFace) {
    GameProfile profile = plainProfile();
    profile.depth = DepthRule::perPixel;
    for (const Camera& view : {camera(33, 24), parallel(20, 15)}) {
        Scene scene;
        scene.background = kBackground;
        scene.entities = {entity(*figure_, {0.0, 0.0, 0.0}, profile)};
        const SpriteView sprite = *must(viewSprite(scene.entities[0].placed, view, profile)).view;
        const OctreeView octree = figure_->octree.view();
        const SpriteBuffer buffer = castSprite(
            octree, sprite.lattice, litPalette(figure_->palette, sprite.light8, profile.outline));
        const std::vector<float> depths = pixelDepths(sprite, octree, buffer);
        const Picture picture = draw(scene, view, profile);
        int checked = 0;
        for (int y = 0; y < kViewport.y; ++y) {
            for (int x = 0; x < kViewport.x; ++x) {
                if (picture.colour.at(x, y) == kBackground) continue;
                const auto pixel = pixelUnder(sprite, view, glm::dvec2(x, y) + 0.5);
                ASSERT_TRUE(pixel);
                const int column = pixel->x - buffer.first.x;
                const int row = buffer.first.y + buffer.size.y - 1 - pixel->y;
                const auto at = static_cast<std::size_t>(row * buffer.size.x + column);
                const float expected = view.reversedDepth(depths[at]);
                const float seen = picture.depth[static_cast<std::size_t>(y * kViewport.x + x)];
                // A micrometre in ten metres.
                if (std::abs(seen - expected) <= 1e-6f * expected) ++checked;
            }
        }
        const auto drawn =
            std::ranges::count_if(picture.colour.pixels, [](Rgba8 c) { return c != kBackground; });
        EXPECT_GT(checked, 1000);
        EXPECT_GE(checked, drawn * 999 / 1000);
    }
}

// Beyond 2^32 cells ids are no more unique: a single pass needs none, sprite buffers say so.
TEST_F(SceneModes, PerPixelDepthOfAModelOfMoreCellsThanIdsTellApart) {
    constexpr glm::ivec3 kSize(1700, 1700, 1500);
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 1);
    voxels.set(kSize - 1, 1);
    for (int y = 700; y < 1000; ++y) {
        for (int x = 700; x < 1000; ++x) voxels.set({x, y, kSize.z - 1}, 2);
    }
    const test::GpuModel model(voxels);
    GameProfile profile = plainProfile();
    profile.sigma = 1.0;
    profile.depth = DepthRule::perPixel;
    profile.outline.enabled = false;
    Scene scene;
    scene.background = kBackground;
    scene.entities = {entity(model, {0.0, 0.0, 0.0}, profile)};
    const PlacedEntity& placed = scene.entities[0].placed;
    const Camera view = orbitCamera({20, 50, 0}, placed.centreMetres(), 400.0, 45.0, kViewport);
    const SpriteView sprite = *must(viewSprite(placed, view, profile)).view;
    const Picture picture = draw(scene, view, profile, SpriteMode::singlePass);
    int checked = 0;
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            if (picture.colour.at(x, y) == kBackground) continue;
            const auto pixel = pixelUnder(sprite, view, glm::dvec2(x, y) + 0.5);
            ASSERT_TRUE(pixel);
            SpriteBuffer one;
            one.first = *pixel;
            one.size = {1, 1};
            one.ids = {kIdFirstVoxel};
            const float metres = pixelDepths(sprite, model.octree.view(), one, 1).front();
            const float expected = view.reversedDepth(metres);
            const float seen = picture.depth[static_cast<std::size_t>(y * kViewport.x + x)];
            EXPECT_NEAR(seen, expected, 1e-5f * expected);
            ++checked;
        }
    }
    EXPECT_GT(checked, 200);
    Frame frame(view.viewportPx);
    const auto refused = renderer_->draw(frame, scene, view, profile, SpriteMode::spriteBuffer);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("1700 x 1700 x 1500"), std::string::npos)
        << refused.error().message;
}

}  // namespace
}  // namespace voxprite
