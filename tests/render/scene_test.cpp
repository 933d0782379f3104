// Scenes of sprites: the two modes against each other in every pixel, and against the CPU's
// composite; occlusion, depth, and what is cast at all.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/scene_renderer.h"
#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::GpuModel;
using test::must;

constexpr glm::ivec2 kViewport{260, 200};
constexpr Rgba8 kBackground{10, 20, 200, 255};

GameProfile plainProfile() {
    GameProfile profile;
    profile.minification = false;
    return profile;
}

std::uint64_t mismatches(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
    return count;
}

// The scene by the CPU alone.
Image composed(const Scene& scene, const std::vector<const GpuModel*>& models, const Camera& camera,
               const GameProfile& profile) {
    std::vector<SpriteView> views;
    std::vector<SpriteBuffer> buffers;
    std::vector<std::vector<float>> depths;
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const SpriteViewResult seen = must(viewSprite(scene.entities[i].placed, camera, profile));
        if (!seen.view) continue;
        const OctreeView octree = models[i]->octree.view();
        views.push_back(*seen.view);
        buffers.push_back(
            castSprite(octree, seen.view->lattice,
                       litPalette(models[i]->palette, seen.view->light8, profile.outline)));
        depths.push_back(pixelDepths(views.back(), octree, buffers.back()));
    }
    std::vector<CompositeSprite> sprites;
    for (std::size_t i = 0; i < views.size(); ++i) {
        sprites.push_back(
            {&views[i], &buffers[i], profile.depth == DepthRule::perPixel ? &depths[i] : nullptr});
    }
    return composite(sprites, camera, scene.background, scene.ground);
}

class Scenes : public test::GlTest {
  protected:
    void SetUp() override {
        test::GlTest::SetUp();
        renderer_.emplace(must(SceneRenderer::create()));
        figure_ = std::make_unique<GpuModel>(test::figure());
        letters_ = std::make_unique<GpuModel>(test::asymmetric());
        ball_ = std::make_unique<GpuModel>(test::shellSphere(21));
    }
    void TearDown() override {
        figure_.reset();
        letters_.reset();
        ball_.reset();
        renderer_.reset();
        test::GlTest::TearDown();
    }

    struct Picture {
        Image colour;
        std::vector<float> depth;
        SceneStats stats;
    };
    Picture draw(const Scene& scene, const Camera& camera, const GameProfile& profile,
                 SpriteMode mode = SpriteMode::spriteBuffer) {
        Frame frame(camera.viewportPx);
        const SceneStats stats = must(renderer_->draw(frame, scene, camera, profile, mode));
        return {frame.readColour(), frame.readDepth(), stats};
    }

    // Three entities that overlap on the screen.
    Scene crowd(const GameProfile& profile) const {
        Scene scene;
        scene.background = kBackground;
        const double float_ = groundClearanceMetres(profile);
        scene.entities = {entity(*figure_, {-0.9, float_, 0.3}, profile, 20.0),
                          entity(*letters_, {0.2, float_, 0.7}, profile, -75.0),
                          entity(*ball_, {0.7, float_, -0.9}, profile, 33.0)};
        return scene;
    }
    std::vector<const GpuModel*> crowdModels() const {
        return {figure_.get(), letters_.get(), ball_.get()};
    }
    static SceneEntity entity(const GpuModel& model, glm::dvec3 anchorMetres,
                              const GameProfile& profile, double yawDegrees = 0.0) {
        return {&model.gpu, &model.palette, model.placedAt(anchorMetres, profile, yawDegrees),
                nullptr};
    }
    static Camera camera(double yaw, double pitch, double distance = 7.0, double roll = 0.0) {
        return orbitCamera({yaw, pitch, roll}, {0.0, 1.1, 0.0}, distance, 45.0, kViewport);
    }
    static Camera parallel(double yaw, double pitch) {
        Camera result = camera(yaw, pitch);
        result.orthographic = true;
        result.orthographicHeightMetres = 5.3;
        return result;
    }

    std::optional<SceneRenderer> renderer_;
    std::unique_ptr<GpuModel> figure_, letters_, ball_;
};

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

TEST_F(Scenes, BothModesAgreeInEveryPixelOfColourAndDepth) {
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
TEST_F(Scenes, AgreesWithTheCpuComposite) {
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

TEST_F(Scenes, OneSpriteWritesExactlyOneDepth) {
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

TEST_F(Scenes, PerPixelDepthIsThatOfTheVoxelsFace) {
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

TEST_F(Scenes, NearerSpritesHideFartherOnesInAnyOrder) {
    const GameProfile profile = plainProfile();
    Scene scene = crowd(profile);
    const Image forward = draw(scene, camera(15, 10), profile).colour;
    std::ranges::reverse(scene.entities);
    EXPECT_EQ(mismatches(forward, draw(scene, camera(15, 10), profile).colour), 0U);
    for (std::size_t left = 0; left < 3; ++left) {
        Scene fewer = scene;
        fewer.entities.erase(fewer.entities.begin() + static_cast<std::ptrdiff_t>(left));
        EXPECT_GT(mismatches(forward, draw(fewer, camera(15, 10), profile).colour), 200U);
    }
}

TEST_F(Scenes, OfEqualDepthsTheEarlierStays) {
    const GameProfile profile = plainProfile();
    Palette red;
    red.colours.fill({200, 0, 0, 255});
    Palette green;
    green.colours.fill({0, 200, 0, 255});
    for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
        Scene scene;
        SceneEntity first = entity(*ball_, {0, 0, 0}, profile);
        SceneEntity second = first;
        first.palette = &red;
        second.palette = &green;
        scene.entities = {first, second};
        const Image redFirst = draw(scene, camera(15, 10), profile, mode).colour;
        std::swap(scene.entities[0], scene.entities[1]);
        const Image greenFirst = draw(scene, camera(15, 10), profile, mode).colour;
        const auto isGreen = [](Rgba8 c) { return c.y > 0; };
        const auto isRed = [](Rgba8 c) { return c.x > 0; };
        EXPECT_EQ(std::ranges::count_if(redFirst.pixels, isGreen), 0);
        EXPECT_EQ(std::ranges::count_if(greenFirst.pixels, isRed), 0);
        EXPECT_GT(std::ranges::count_if(redFirst.pixels, isRed), 1000);
    }
}

TEST_F(Scenes, TheGroundHidesWhatIsBelowIt) {
    const GameProfile profile = plainProfile();
    Scene scene;
    scene.background = kBackground;
    scene.ground = Ground{0.0, {10, 200, 20, 255}};
    scene.entities = {entity(*ball_, {0.0, -4.0, 0.0}, profile)};
    const Image above = draw(scene, camera(0, 30), profile).colour;
    EXPECT_EQ(std::ranges::count(above.pixels, scene.ground->colour) +
                  std::ranges::count(above.pixels, kBackground),
              static_cast<std::ptrdiff_t>(above.pixels.size()));
    scene.entities = {entity(*ball_, {0.0, groundClearanceMetres(profile), 0.0}, profile)};
    Scene floating = scene;
    floating.ground.reset();
    const Image onGround = draw(scene, camera(0, 30), profile).colour;
    const Image withoutGround = draw(floating, camera(0, 30), profile).colour;
    // The rule groundSafe: the ground takes no pixel from what stands on it.
    for (std::size_t i = 0; i < onGround.pixels.size(); ++i) {
        if (withoutGround.pixels[i] != kBackground) {
            ASSERT_EQ(onGround.pixels[i], withoutGround.pixels[i]);
        }
    }
}

TEST_F(Scenes, SkyGridAndShadowsLeaveTheSpritesAlone) {
    const GameProfile profile = plainProfile();
    Scene scene = crowd(profile);
    const Picture bare = draw(scene, camera(15, 10), profile);
    scene.sky = true;
    scene.ground = Ground{};
    scene.groundGrid = true;
    scene.shadowBlobs = true;
    const Picture full = draw(scene, camera(15, 10), profile);
    for (std::size_t i = 0; i < bare.colour.pixels.size(); ++i) {
        if (bare.depth[i] > 0.0f) {
            ASSERT_EQ(full.colour.pixels[i], bare.colour.pixels[i]);
        } else {
            ASSERT_EQ(full.colour.pixels[i].w, 255);
            ASSERT_NE(full.colour.pixels[i], kBackground);
        }
    }
    Scene noBlobs = scene;
    noBlobs.shadowBlobs = false;
    EXPECT_GT(mismatches(full.colour, draw(noBlobs, camera(15, 10), profile).colour), 300U);
}

TEST_F(Scenes, ACameraInsideTheProxyDrawsNothing) {
    const GameProfile profile = plainProfile();
    Scene scene;
    scene.background = kBackground;
    scene.entities = {entity(*ball_, {0.0, 0.0, 0.0}, profile)};
    Camera inside = camera(0, 0);
    inside.eyeMetres = scene.entities[0].placed.centreMetres() + glm::dvec3(0.1, 0.2, 0.3);
    for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
        const Picture picture = draw(scene, inside, profile, mode);
        EXPECT_EQ(picture.stats.drawn, 0);
        EXPECT_EQ(picture.stats.unseen, 1);
        EXPECT_EQ(std::ranges::count(picture.colour.pixels, kBackground),
                  static_cast<std::ptrdiff_t>(picture.colour.pixels.size()));
    }
}

TEST_F(Scenes, AStillSceneCastsNothingAndEqualSpritesAreShared) {
    const GameProfile profile = plainProfile();
    GpuModel& figure = *figure_;
    Scene scene;
    scene.entities = {entity(figure, {-0.8, 0.0, 0.0}, profile)};
    const Camera view = camera(15, 10);
    Frame frame(kViewport);
    const auto next = [&] {
        return must(renderer_->draw(frame, scene, view, profile, SpriteMode::spriteBuffer));
    };
    const SceneStats first = next();
    EXPECT_GT(first.rays, 0U);
    EXPECT_EQ(first.castsReused, 0U);
    const SceneStats second = next();
    EXPECT_EQ(second.rays, 0U);
    EXPECT_EQ(second.castsReused, 1U);
    // The same model under the same view: one cast serves both.
    scene.entities.push_back(scene.entities[0]);
    EXPECT_EQ(next().rays, 0U);
    // New voxels are new pixels.
    OctreeChanges none;
    none.nodes.push_back({0, 1});
    figure.gpu.update(figure.octree.view(), none);
    const SceneStats edited = next();
    EXPECT_EQ(edited.rays, first.rays);
    EXPECT_EQ(edited.castsReused, 1U);
    EXPECT_GT(second.screenPxPerPx, 0.0);
    EXPECT_EQ(second.sigmaInForce, profile.sigma);
}

TEST_F(Scenes, OnlyWhatIsOnTheScreenIsCast) {
    GameProfile profile = plainProfile();
    profile.sigma = 16.0;
    Scene scene;
    scene.background = kBackground;
    scene.entities = {entity(*figure_, {0.0, 0.0, 0.0}, profile)};
    const Camera close = camera(15, 10, 1.6);
    const Picture picture = draw(scene, close, profile);
    const SpriteView view = *must(viewSprite(scene.entities[0].placed, close, profile)).view;
    const auto all = static_cast<std::uint64_t>(view.lattice.size.x) *
                     static_cast<std::uint64_t>(view.lattice.size.y);
    EXPECT_LT(picture.stats.rays, all / 2);
    EXPECT_GT(picture.stats.rays, 0U);
    const Image cpu = composed(scene, {figure_.get()}, close, profile);
    EXPECT_LE(mismatches(picture.colour, cpu), 40U);
    // Beside the screen: nothing.
    scene.entities = {entity(*figure_, {400.0, 0.0, 0.0}, profile)};
    EXPECT_EQ(draw(scene, close, profile).stats.unseen, 1);
}

TEST_F(Scenes, ASpriteBeyondTheDriversTexturesIsAnErrorThatSaysSo) {
    GameProfile profile = plainProfile();
    profile.sigma = 1.0;
    const GpuModel rod(test::solidBox({40'000, 1, 1}, 3));
    Scene scene;
    scene.entities = {entity(rod, {0.0, 0.0, 0.0}, profile)};
    Camera far = camera(0, 0, 9000.0);
    Frame frame(kViewport);
    const auto stats = renderer_->draw(frame, scene, far, profile, SpriteMode::spriteBuffer);
    ASSERT_FALSE(stats);
    EXPECT_NE(stats.error().message.find("40002 x"), std::string::npos) << stats.error().message;
}

}  // namespace
}  // namespace voxprite
