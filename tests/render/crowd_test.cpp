// Crowds: what is shared, what is cast again, in how many draws, and that none of it changes a
// pixel.
#include "tests/render/crowd_support.h"

namespace voxprite {
namespace {

using test::kBackground;
using test::kViewport;
using test::mismatches;
using test::must;
using test::plainProfile;

class Crowds : public test::Crowds {};

TEST_F(Crowds, EveryEntityLooksAsItDoesAlone) {
    int variant = 0;
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        for (const DepthRule depth : {DepthRule::groundSafe, DepthRule::perPixel}) {
            GameProfile profile = plainProfile();
            profile.view = rule;
            profile.depth = depth;
            profile.viewStepDegrees = variant % 2 == 0 ? 0.0 : 5.0;
            profile.proxy = variant == 2 ? ProxyShape::box : ProxyShape::quad;
            const Scene scene = rows(24, profile);
            const Camera view = camera(12.0, 21.0, 9.0);
            const Picture picture = draw(scene, view, profile);
            EXPECT_EQ(picture.stats.drawCalls, 1);
            EXPECT_EQ(mismatches(picture.colour, oneByOne(scene, view, profile)), 0U)
                << "variant " << variant;
            // Again, now that all is held.
            const Picture again = draw(scene, view, profile);
            EXPECT_EQ(again.stats.casts, 0U);
            EXPECT_EQ(again.stats.rays, 0U);
            EXPECT_EQ(mismatches(again.colour, picture.colour), 0U);
            EXPECT_TRUE(again.depth == picture.depth);
            ++variant;
        }
    }
}

TEST_F(Crowds, AThousandOfOneModelAreOneCastAndOneDraw) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    const Scene scene = onlyModel(1000, profile);
    const SceneStats stats = draw(scene, far(), profile).stats;
    EXPECT_EQ(stats.drawn, 1000);
    EXPECT_EQ(stats.casts, 1U);
    EXPECT_EQ(stats.castsReused, 999U);
    EXPECT_EQ(stats.drawCalls, 1);
    const SpriteView one = *must(viewSprite(scene.entities[0].placed, far(), profile)).view;
    EXPECT_EQ(stats.rays, static_cast<std::uint64_t>(one.lattice.size.x) *
                              static_cast<std::uint64_t>(one.lattice.size.y));
    EXPECT_EQ(draw(scene, far(), profile).stats.casts, 0U);
}

TEST_F(Crowds, AMarchUnderCameraForwardCastsNothingNew) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    Scene scene = onlyModel(40, profile);
    const Image first = draw(scene, far(), profile).colour;
    for (int step = 0; step < 3; ++step) {
        for (SceneEntity& each : scene.entities) each.placed.anchorMetres.x += 0.37;
        const Picture picture = draw(scene, far(), profile);
        EXPECT_EQ(picture.stats.casts, 0U);
        EXPECT_EQ(picture.stats.drawCalls, 1);
        EXPECT_GT(mismatches(picture.colour, first), 100U);
        EXPECT_EQ(mismatches(picture.colour, oneByOne(scene, far(), profile)), 0U);
    }
}

TEST_F(Crowds, ASpriteThatLeavesTheScreenIsNotCastAgainUntilHalfOfItIsGone) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    Scene scene;
    scene.background = kBackground;
    scene.entities = {entity(*figure_, {0, 0, 0}, profile)};
    const Camera view = camera(0, 0, 7.0);
    EXPECT_EQ(draw(scene, view, profile).stats.casts, 1U);
    const double edge = 0.5 * kViewport.x * view.metresPerScreenPx(7.0);
    scene.entities[0].placed.anchorMetres.x = edge - 0.2;
    const Picture leaving = draw(scene, view, profile);
    EXPECT_EQ(leaving.stats.casts, 0U);
    EXPECT_EQ(mismatches(leaving.colour, draw(scene, view, profile, SpriteMode::singlePass).colour),
              0U);
    scene.entities[0].placed.anchorMetres.x = edge + 0.5;
    const Picture mostlyGone = draw(scene, view, profile);
    EXPECT_EQ(mostlyGone.stats.casts, 1U);
    EXPECT_EQ(
        mismatches(mostlyGone.colour, draw(scene, view, profile, SpriteMode::singlePass).colour),
        0U);
}

TEST_F(Crowds, TheViewStepIsSharedByNeighbours) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::towardEntity;
    const Scene scene = onlyModel(200, profile);
    const SceneStats exact = draw(scene, far(), profile).stats;
    profile.viewStepDegrees = 10.0;
    const SceneStats snapped = draw(scene, far(), profile).stats;
    EXPECT_EQ(exact.casts + exact.castsReused, 200U);
    EXPECT_LT(10 * snapped.casts, exact.casts);
    EXPECT_GT(snapped.casts, 1U);
}

TEST_F(Crowds, ATinyAtlasGivesTheSamePicture) {
    for (const DepthRule depth : {DepthRule::centre, DepthRule::perPixel}) {
        GameProfile profile = plainProfile();
        profile.depth = depth;
        Scene scene = rows(24, profile);
        const Camera view = camera(12.0, 21.0, 9.0);
        const Picture roomy = draw(scene, view, profile);
        // Two sprites a page or so; and pages that no sprite fits.
        for (const AtlasLimits limits :
             {AtlasLimits{192, 1}, AtlasLimits{192, 3}, AtlasLimits{16, 1}, AtlasLimits{100, 2}}) {
            renderer_.emplace(must(SceneRenderer::create(limits)));
            for (int turn = 0; turn < 3; ++turn) {
                const Picture tiny = draw(scene, view, profile);
                EXPECT_EQ(mismatches(tiny.colour, roomy.colour), 0U)
                    << limits.pageEdgePx << " " << turn;
                EXPECT_TRUE(tiny.depth == roomy.depth);
                EXPECT_GT(tiny.stats.drawCalls, 1);
                if (limits.pageEdgePx == 192) {
                    EXPECT_LE(tiny.stats.atlasBytes, 192U * 192U * 8U * unsigned(limits.pages));
                }
            }
        }
    }
}

TEST_F(Crowds, OldSpritesGiveTheirRoomToNewOnes) {
    const GameProfile profile = plainProfile();
    renderer_.emplace(must(SceneRenderer::create({384, 1})));
    const Scene scene = rows(3, profile);
    for (int step = 0; step < 12; ++step) {
        const Camera view = camera(7.0 * step, 15.0, 9.0);
        const Picture picture = draw(scene, view, profile);
        EXPECT_EQ(picture.stats.drawCalls, 1);
        EXPECT_EQ(picture.stats.atlasBytes, 384U * 384U * 4U);
        EXPECT_EQ(mismatches(picture.colour, oneByOne(scene, view, profile)), 0U) << step;
    }
}

TEST_F(Crowds, EqualDepthsKeepTheOrderOfTheScene) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    // Copies of one place in many colours: the first hides all others.
    std::vector<Palette> palettes(64);
    for (std::size_t k = 0; k < palettes.size(); ++k) {
        palettes[k].colours.fill({static_cast<std::uint8_t>(4 * k), 255, 0, 255});
    }
    for (const AtlasLimits limits : {AtlasLimits{}, AtlasLimits{192, 1}}) {
        renderer_.emplace(must(SceneRenderer::create(limits)));
        for (std::size_t first = 0; first < palettes.size(); first += 21) {
            Scene scene;
            scene.background = kBackground;
            for (std::size_t k = 0; k < palettes.size(); ++k) {
                scene.entities.push_back(entity(*ball_, {0, 0, 0}, profile));
                scene.entities.back().palette = &palettes[(first + k) % palettes.size()];
            }
            Scene alone = scene;
            alone.entities.resize(1);
            const Image all = draw(scene, camera(15, 10), profile).colour;
            EXPECT_EQ(mismatches(all, draw(alone, camera(15, 10), profile).colour), 0U);
        }
    }
}

}  // namespace
}  // namespace voxprite
