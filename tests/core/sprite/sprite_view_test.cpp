// Where a sprite's pixels land: the grid, the plane, the mapping from the screen.
#include "core/sprite/sprite_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "core/trace/lattice_caster.h"
#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

using test::figure;
using test::mustView;
using test::orbit;
using test::pixelAt;
using test::plainPalette;
using test::solidBox;
using test::Subject;

GameProfile profileWith(ViewRule rule) {
    GameProfile profile;
    profile.view = rule;
    profile.minification = false;
    return profile;
}

void expectNear(glm::dvec2 a, glm::dvec2 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

class Mapping : public testing::TestWithParam<ViewRule> {};
INSTANTIATE_TEST_SUITE_P(BothRules, Mapping,
                         testing::Values(ViewRule::cameraForward, ViewRule::towardEntity));

// Row 1: registered at the anchor, the sprite of a 6.4 m figure would stand 3.2 m too low.
TEST_P(Mapping, TheGridBelongsToTheModelCentre) {
    const GameProfile profile = profileWith(GetParam());
    const Camera camera = orbit(20, 15, 12);
    const PlacedEntity entity = figure().centredAt({0.7, -0.4, 0.3}, profile);
    const SpriteView view = mustView(entity, camera, profile);
    const glm::dvec2 centre = camera.project(entity.centreMetres()).screenPx;
    expectNear(pixelAt(view, camera, centre), view.pixelFromCentre, 1e-9);
    // The figure's sizes are even: its centre is a lattice corner, half a pixel from sample (0,0).
    expectNear(view.pixelFromCentre, {0.0, 0.0}, 0.0);
}

TEST_P(Mapping, TheAnchorOnlyPlacesTheModel) {
    const GameProfile profile = profileWith(GetParam());
    const Camera camera = orbit(20, 15, 12);
    Subject subject = figure();
    const SpriteView bottom = mustView(subject.centredAt({1, 2, 0}, profile), camera, profile);
    subject.entity.anchorVoxels = glm::dvec3(-40, 3, 200);
    const SpriteView far = mustView(subject.centredAt({1, 2, 0}, profile), camera, profile);
    EXPECT_EQ(bottom.lattice, far.lattice);
    for (const glm::dvec2 screen : {glm::dvec2(100, 100), glm::dvec2(300, 411)})
        expectNear(pixelAt(bottom, camera, screen), pixelAt(far, camera, screen), 1e-9);
}

// Row 3: with the Euclidean distance a sprite 30 degrees off the axis is 13 % too small.
TEST(CameraForward, SizeGoesByThePlanesDepth) {
    const GameProfile profile = profileWith(ViewRule::cameraForward);
    const Camera camera = orbit(0, 0, 10);
    const double depth = 10.0;
    for (const double degrees : {0.0, 15.0, 20.0}) {
        const glm::dvec3 centre =
            camera.eyeMetres + camera.forward * depth +
            camera.right * (depth * std::tan(degrees * std::numbers::pi / 180.0));
        const SpriteView view = mustView(figure().centredAt(centre, profile), camera, profile);
        EXPECT_NEAR(view.planeDepthMetres, depth, 1e-12);
        // One virtual pixel in metres, seen at that depth.
        const double screenPx = 0.025 / (2.0 * depth * std::tan(std::numbers::pi / 8.0) / 512.0);
        EXPECT_NEAR(view.screenPxPerPx, screenPx, 1e-12);
        const glm::dvec2 at = camera.project(centre).screenPx;
        const glm::dvec2 step =
            pixelAt(view, camera, at + glm::dvec2(screenPx, -screenPx)) - pixelAt(view, camera, at);
        expectNear(step, {1, 1}, 1e-9);
    }
}

// Any point of the sprite plane is found under its own projection, whatever the plane's tilt.
TEST_P(Mapping, MeetsTheSpritePlane) {
    const GameProfile profile = profileWith(GetParam());
    std::mt19937 random(4);
    std::uniform_real_distribution<double> offset(-1.5, 1.5);
    for (const bool orthographic : {false, true}) {
        for (int n = 0; n < 100; ++n) {
            Camera camera = orbit(offset(random) * 100, offset(random) * 40, 12, n % 4 * 30);
            camera.orthographic = orthographic;
            const glm::dvec3 centre{offset(random), offset(random), offset(random)};
            const SpriteView view =
                mustView(solidBox({7, 12, 9}).centredAt(centre, profile), camera, profile);
            const glm::dvec2 metres{offset(random), offset(random)};
            const glm::dvec3 point = centre + view.right * metres.x + view.up * metres.y;
            expectNear(pixelAt(view, camera, camera.project(point).screenPx),
                       metres / view.metresPerPx + view.pixelFromCentre, 1e-8);
        }
    }
}

// The cast ray of pixel (i, j) goes through the middle of the place where (i, j) is drawn.
TEST_P(Mapping, EverySampleLiesInTheMiddleOfItsPixel) {
    for (const glm::ivec3 size : {glm::ivec3(8, 8, 8), glm::ivec3(7, 5, 9), glm::ivec3(1, 2, 3)})
        for (const double sigma : {0.5, 1.0, 1.5, 4.0, 7.5}) {
            GameProfile profile = profileWith(GetParam());
            profile.sigma = sigma;
            const PlacedEntity entity = solidBox(size).centredAt(glm::dvec3(0.0), profile);
            const SpriteView view = mustView(entity, orbit(35, 20, 40), profile);
            for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(-3, 2), glm::ivec2(4, 5)}) {
                const LatticeRay ray = rayOf(view.lattice, pixel);
                const glm::dvec3 fromCentre =
                    glm::dvec3(ray.origin) / std::ldexp(1.0, ray.positionBits) -
                    glm::dvec3(size) * 0.5;
                const glm::dvec2 sample{glm::dot(fromCentre, view.ortho.right),
                                        glm::dot(fromCentre, view.ortho.up)};
                expectNear(sample * sigma + view.pixelFromCentre, glm::dvec2(pixel) + 0.5, 0.07);
            }
        }
}

// Row 8: on the line between two pixels floor has one answer.
TEST(PixelUnder, FloorsAndRefusesWhatIsBehind) {
    GameProfile profile = profileWith(ViewRule::cameraForward);
    profile.sigma = 1.0;
    profile.voxelSizeMetres = 1.0;
    Camera camera = orbit(0, 0, 8);
    camera.orthographic = true;
    camera.orthographicHeightMetres = 512.0;  // one screen pixel a metre, so all is exact
    const SpriteView view =
        mustView(solidBox({4, 4, 4}).centredAt(glm::dvec3(0.0), profile), camera, profile);
    EXPECT_EQ(pixelUnder(view, camera, {256.0, 256.0}), glm::ivec2(0, 0));
    EXPECT_EQ(pixelUnder(view, camera, {255.999, 256.001}), glm::ivec2(-1, -1));
    EXPECT_EQ(pixelUnder(view, camera, {257.0, 255.0}), glm::ivec2(1, 1));

    Camera perspective = orbit(0, 0, 8);
    perspective.verticalFovDegrees = 150.0;
    profile.view = ViewRule::towardEntity;
    const SpriteView aside =
        mustView(solidBox({4, 4, 4}).centredAt({40.0, 0.0, 0.0}, profile), perspective, profile);
    EXPECT_TRUE(pixelUnder(aside, perspective, {500, 256}));
    EXPECT_FALSE(pixelUnder(aside, perspective, {1, 256}));  // that ray leaves the plane behind
}

// Row 8: samples at whole virtual pixels from the centre of an even size run along voxel faces, and
// the smallest turn sends most of them into other voxels.
TEST(SampleOffset, ATinyTurnChangesNextToNothing) {
    const Subject subject = figure();
    for (const double sigma : {1.0, 2.0, 4.0, 0.5, 1.5}) {
        GameProfile profile = profileWith(ViewRule::cameraForward);
        profile.sigma = sigma;
        const auto cast = [&](double turnDegrees, bool offset) {
            LatticeView lattice = mustView(subject.centredAt(glm::dvec3(0.0), profile),
                                           orbit(turnDegrees, 0, 10), profile)
                                      .lattice;
            if (!offset) lattice.C = (subject.octree.size / 2) << lattice.positionBits;
            return castSprite(subject.octree.view(), lattice, plainPalette());
        };
        const auto changed = [&](bool offset) {
            const SpriteBuffer left = cast(-0.01, offset);
            const SpriteBuffer right = cast(0.01, offset);
            EXPECT_EQ(left.size, right.size);
            int count = 0;
            for (std::size_t at = 0; at < left.ids.size() && at < right.ids.size(); ++at)
                if (left.ids[at] != right.ids[at]) ++count;
            return count / static_cast<double>(left.opaqueCount());
        };
        RecordProperty("flipped_percent_" + std::to_string(sigma),
                       std::to_string(100 * changed(true)) + " against " +
                           std::to_string(100 * changed(false)));
        EXPECT_LT(changed(true), 0.02) << sigma;
        EXPECT_GT(changed(false), 0.2) << sigma;
    }
}

// Row 6: an entity twice as large has twice the virtual pixels, each as wide as before.
TEST(Scale, KeepsTheWidthOfAVirtualPixel) {
    const GameProfile profile = profileWith(ViewRule::towardEntity);
    const Camera camera = orbit(30, 20, 12);
    Subject subject = figure();
    const SpriteView plain = mustView(subject.centredAt(glm::dvec3(0.0), profile), camera, profile);
    subject.entity.scale = 2.0;
    const SpriteView large = mustView(subject.centredAt(glm::dvec3(0.0), profile), camera, profile);
    EXPECT_EQ(large.metresPerPx, plain.metresPerPx);
    EXPECT_EQ(large.screenPxPerPx, plain.screenPxPerPx);
    EXPECT_EQ(large.sigmaInForce, plain.sigmaInForce);
    EXPECT_EQ(large.ortho.sigmaInForce, 2.0 * plain.ortho.sigmaInForce);
    expectNear(glm::dvec2(large.lattice.size), 2.0 * glm::dvec2(plain.lattice.size), 4.0);
}

// Row 11: in single precision everything below jumps by whole pixels.
TEST_P(Mapping, TenThousandKilometresAwayNothingChanges) {
    const GameProfile profile = profileWith(GetParam());
    const Subject subject = figure();
    const glm::dvec3 far{1e7, -3e6, 1e7};
    double worst = 0.0;
    for (int step = 0; step < 400; ++step) {
        // A camera that drifts by a few millimetres a frame.
        Camera here = orbit(25, 12, 12);
        here.eyeMetres += here.right * (0.003 * step) + here.up * (0.001 * step);
        Camera there = here;
        there.eyeMetres += far;
        const SpriteView near =
            mustView(subject.centredAt(glm::dvec3(0.0), profile), here, profile);
        PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
        entity.anchorMetres += far;
        const SpriteView away = mustView(entity, there, profile);
        if (GetParam() == ViewRule::cameraForward) {
            ASSERT_EQ(near.lattice, away.lattice);
        }
        for (const glm::dvec2 screen : {glm::dvec2(0, 0), glm::dvec2(512, 512), glm::dvec2(256)})
            worst = std::max(
                worst, glm::length(pixelAt(near, here, screen) - pixelAt(away, there, screen)));
    }
    RecordProperty("jitter_nano_vpx", std::to_string(worst * 1e9));
    EXPECT_LE(worst, 1e-6);
}

// Row 14.
TEST(Unseen, ForThreeReasons) {
    const GameProfile profile;
    const Camera camera = orbit(0, 0, 10);
    const auto why = [&](const PlacedEntity& entity) {
        const auto result = viewSprite(entity, camera, profile);
        EXPECT_TRUE(result.has_value());
        EXPECT_NE(result->view.has_value(), result->unseen.has_value());
        return result->unseen;
    };
    const Subject box = solidBox({10, 10, 10});
    EXPECT_EQ(why(placeEntity({}, {}, profile)), Unseen::emptyModel);
    EXPECT_EQ(why(box.centredAt(glm::dvec3(0.0), profile)), std::nullopt);
    EXPECT_EQ(why(box.centredAt(camera.eyeMetres + glm::dvec3(0, 0, 5), profile)),
              Unseen::behindCamera);
    // The centre is ahead and still the eye is inside, up to one virtual pixel from the box.
    const double half = 0.5 + 0.025;
    EXPECT_EQ(why(box.centredAt(camera.eyeMetres - glm::dvec3(0, 0, half - 1e-6), profile)),
              Unseen::cameraInside);
    EXPECT_EQ(why(box.centredAt(camera.eyeMetres - glm::dvec3(0, 0, half + 1e-6), profile)),
              std::nullopt);
    // An anchor behind the camera hides nothing.
    Subject anchored = box;
    anchored.entity.anchorVoxels = glm::dvec3(5, -500, 5);
    EXPECT_EQ(why(anchored.centredAt(glm::dvec3(0.0), profile)), std::nullopt);
}

TEST(ViewSprite, RefusesNumbersThatAreNone) {
    const GameProfile profile;
    const Camera camera = orbit(0, 0, 10);
    const PlacedEntity entity = solidBox({4, 4, 4}).centredAt(glm::dvec3(0.0), profile);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        PlacedEntity moved = entity;
        moved.anchorMetres.y = bad;
        EXPECT_FALSE(viewSprite(moved, camera, profile));
        Camera lost = camera;
        lost.eyeMetres.x = bad;
        EXPECT_FALSE(viewSprite(entity, lost, profile));
        GameProfile odd;
        odd.sigma = bad;
        EXPECT_FALSE(viewSprite(entity, camera, odd));
        odd = {};
        odd.light.towardLight.x = bad;
        EXPECT_FALSE(viewSprite(entity, camera, odd));
        odd = {};
        odd.viewStepDegrees = bad;
        EXPECT_FALSE(viewSprite(entity, camera, odd));
    }
    // Finite and beyond all measure: an answer or an error, no crash.
    for (const double huge : {1e30, 1e160, 1e308}) {
        PlacedEntity moved = entity;
        moved.anchorMetres = {huge, -huge, -huge};
        static_cast<void>(viewSprite(moved, camera, profile));
        moved = entity;
        moved.anchor = {huge, 0, 0};
        const auto result = viewSprite(moved, camera, profile);
        if (result && result->view) {
            EXPECT_TRUE(std::isfinite(result->view->depthMetres));
        }
    }
    PlacedEntity large = entity;
    large.modelSize = glm::ivec3(200);
    large.anchorMetres = {0, 0, -50};
    GameProfile dense;
    dense.sigma = 64.0;
    EXPECT_TRUE(viewSprite(large, camera, dense));  // minified
    // So close that a virtual pixel covers several of the screen: coarser rather than none.
    Camera close = camera;
    close.verticalFovDegrees = 1.0;
    close.viewportPx = glm::ivec2(4096);
    const auto coarser = viewSprite(large, close, dense);
    ASSERT_TRUE(coarser && coarser->view);
    EXPECT_LT(coarser->view->sigmaInForce, 64.0);
    EXPECT_GT(coarser->view->screenPxPerPx, 2.0);
    GameProfile same = dense;
    same.sigma = coarser->view->sigmaInForce;
    same.minification = false;
    EXPECT_EQ(viewSprite(large, close, same).value().view->lattice, coarser->view->lattice);
    same.sigma *= 2.0;
    EXPECT_FALSE(viewSprite(large, close, same));
    dense.minification = false;
    const auto refused = viewSprite(large, camera, dense);
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().message, testing::HasSubstr("16777216"));
}

}  // namespace
}  // namespace voxprite
