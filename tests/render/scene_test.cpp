// Scenes of sprites: what hides what, and what is cast at all.
#include "tests/render/scene_support.h"

namespace voxprite {
namespace {

using test::composed;
using test::GpuModel;
using test::kBackground;
using test::kViewport;
using test::mismatches;
using test::must;
using test::plainProfile;

class Scenes : public test::Scenes {};

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

TEST_F(Scenes, APictureBeyondTheDriversTexturesIsAnErrorThatSaysSo) {
    const GameProfile profile = plainProfile();
    const Scene scene = crowd(profile);
    Camera wide = camera(0, 0);
    wide.viewportPx = {30'000, 20};
    Frame frame(wide.viewportPx);
    const auto stats = renderer_->draw(frame, scene, wide, profile, SpriteMode::spriteBuffer);
    ASSERT_FALSE(stats);
    EXPECT_NE(stats.error().message.find("30000 x 20"), std::string::npos) << stats.error().message;
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
