// Which picture a sprite shows: view rules, rotation, snapping, minification, the pole.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "core/sprite/sprite_view.h"
#include "core/sprite/view_axes.h"
#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

using test::figure;
using test::mustView;
using test::orbit;
using test::plainPalette;
using test::solidBox;
using test::Subject;

GameProfile profileWith(ViewRule rule) {
    GameProfile profile;
    profile.view = rule;
    return profile;
}

// The camera turned in place: the eye stays.
Camera turned(const Camera& camera, double yaw, double pitch, double roll) {
    const glm::dmat3 axes =
        glm::dmat3(camera.right, camera.up, -camera.forward) *
        glm::dmat3(orbitBasis({yaw, pitch, roll})[0], orbitBasis({yaw, pitch, roll})[1],
                   -orbitBasis({yaw, pitch, roll})[2]);
    Camera result = camera;
    result.right = axes[0];
    result.up = axes[1];
    result.forward = -axes[2];
    return result;
}

double changedShare(const SpriteBuffer& a, const SpriteBuffer& b) {
    if (a.size != b.size || a.first != b.first) return 1.0;
    std::size_t changed = 0;
    for (std::size_t at = 0; at < a.ids.size(); ++at)
        if (a.ids[at] != b.ids[at]) ++changed;
    return static_cast<double>(changed) / static_cast<double>(a.opaqueCount());
}

// Row 4: camera_forward, the seed's rule, shows another picture after every turn.
TEST(TowardEntity, TurningTheCameraChangesNothing) {
    const Subject subject = figure();
    const Camera camera = orbit(30, 20, 12);
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        GameProfile profile = profileWith(rule);
        profile.depth = DepthRule::centre;
        const PlacedEntity entity = subject.centredAt({0.4, 0.3, -0.2}, profile);
        const SpriteView before = mustView(entity, camera, profile);
        const SpriteBuffer picture =
            castSprite(subject.octree.view(), before.lattice, plainPalette());
        for (const OrbitAngles turn :
             {OrbitAngles{0.1, 0, 0}, OrbitAngles{15, -9, 0}, OrbitAngles{-18, 4, 50}}) {
            const Camera after =
                turned(camera, turn.yawDegrees, turn.pitchDegrees, turn.rollDegrees);
            const SpriteView view = mustView(entity, after, profile);
            if (rule == ViewRule::towardEntity) {
                EXPECT_EQ(view.lattice, before.lattice);
                EXPECT_EQ(view.sigmaInForce, before.sigmaInForce);
                EXPECT_EQ(view.light8, before.light8);
                EXPECT_EQ(view.right, before.right);
            } else {
                EXPECT_GT(
                    changedShare(castSprite(subject.octree.view(), view.lattice, plainPalette()),
                                 picture),
                    0.01);
            }
        }
    }
}

// Row 4: off the axis camera_forward shows the model from a direction nobody looks from.
TEST(TowardEntity, LooksAlongTheLineOfSight) {
    const Camera camera = orbit(0, 0, 10);
    const glm::dvec3 centre{6.0, 2.0, -1.0};
    const Subject subject = figure();
    const GameProfile toward = profileWith(ViewRule::towardEntity);
    const SpriteView seen = mustView(subject.centredAt(centre, toward), camera, toward);
    EXPECT_NEAR(glm::dot(seen.forward, glm::normalize(centre - camera.eyeMetres)), 1.0, 1e-15);
    EXPECT_NEAR(glm::dot(seen.right, glm::dvec3(0, 1, 0)), 0.0, 1e-15);  // upright
    const GameProfile forward = profileWith(ViewRule::cameraForward);
    EXPECT_EQ(mustView(subject.centredAt(centre, forward), camera, forward).forward,
              camera.forward);
}

// Row 5: turning the box by +90 shows what an orbit by -90 shows.
TEST(EntityRotation, TurnsThePicture) {
    Subject subject = test::letterBlock();
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        const GameProfile profile = profileWith(rule);
        const auto lattice = [&](double box, double yaw, double pitch) {
            subject.entity.yawDegrees = box;
            return mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(yaw, pitch, 10),
                            profile)
                .lattice;
        };
        for (const double quarter : {90.0, 180.0, 270.0})
            for (const double pitch : {0.0, 30.0, -45.0}) {
                EXPECT_EQ(lattice(quarter, 0, pitch), lattice(0, -quarter, pitch));
                EXPECT_NE(lattice(quarter, 0, pitch), lattice(0, 0, pitch));
            }
        // At other angles up to the last bits of the doubles.
        EXPECT_EQ(lattice(33, 20, 10).D, lattice(0, -13, 10).D);
    }
}

TEST(EntityRotation, PitchAndRollTurnThePictureToo) {
    Subject subject = test::letterBlock();
    const GameProfile profile = profileWith(ViewRule::cameraForward);
    const auto text = [&] {
        const SpriteView view =
            mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 1), profile);
        return test::textOf(castSprite(subject.octree.view(), view.lattice, plainPalette()),
                            subject.octree);
    };
    const auto contains = [](const std::vector<std::string>& rows, char material) {
        for (const std::string& row : rows)
            if (row.find(material) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(contains(text(), '2'));
    subject.entity.pitchDegrees = 90;  // +Z turns toward the eye (-Y): the top is seen
    EXPECT_TRUE(contains(text(), '4'));
    subject.entity.pitchDegrees = 0;
    subject.entity.yawDegrees = -90;  // +X turns toward the eye
    EXPECT_TRUE(contains(text(), '3'));
    EXPECT_FALSE(contains(text(), '2'));
}

TEST(OrbitAngles, AreFoundAgain) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> angle(-179.0, 179.0);
    const auto axesOf = [](const OrbitAngles& angles) {
        const glm::dmat3 world = orbitBasis(angles);
        return glm::dmat3(voxelFromWorld(world[0]), voxelFromWorld(world[1]),
                          voxelFromWorld(world[2]));
    };
    for (int n = 0; n < 500; ++n) {
        const OrbitAngles angles{angle(random), angle(random) / 2.0, angle(random)};
        const OrbitAngles found = orbitAnglesOf(axesOf(angles));
        EXPECT_NEAR(found.yawDegrees, angles.yawDegrees, 1e-9);
        EXPECT_NEAR(found.pitchDegrees, angles.pitchDegrees, 1e-9);
        EXPECT_NEAR(found.rollDegrees, angles.rollDegrees, 1e-9);
    }
    for (const double pole : {90.0, -90.0}) {
        const OrbitAngles found = orbitAnglesOf(axesOf({40, pole, 0}));
        EXPECT_NEAR(found.yawDegrees, 40.0, 1e-9);
        EXPECT_EQ(found.pitchDegrees, pole);
        EXPECT_EQ(found.rollDegrees, 0.0);
    }
}

TEST(ViewSnapping, NearViewsShareOneLattice) {
    GameProfile profile = profileWith(ViewRule::towardEntity);
    profile.viewStepDegrees = 45.0;
    const Subject subject = figure();
    const auto lattice = [&](double yaw, double pitch, ViewHistory* history = nullptr) {
        return mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(yaw, pitch, 12), profile,
                        history)
            .lattice;
    };
    EXPECT_EQ(lattice(10, 5), lattice(-22, -22));
    EXPECT_EQ(lattice(179, 0), lattice(-170, 10));
    EXPECT_NE(lattice(10, 5), lattice(23, 5));
    // The snapped view is the very view of that angle.
    profile.viewStepDegrees = 0.0;
    const LatticeView exact = lattice(45, 0);
    profile.viewStepDegrees = 45.0;
    EXPECT_EQ(lattice(38, 9), exact);

    // Hysteresis: 22.5 is the middle; the old view stays until 27.
    ViewHistory history;
    const LatticeView front = lattice(0, 0, &history);
    EXPECT_EQ(lattice(24, 0, &history), front);
    EXPECT_EQ(lattice(26.9, 0, &history), front);
    EXPECT_EQ(lattice(27.1, 0, &history), exact);
    EXPECT_EQ(lattice(19, 0, &history), exact);
    EXPECT_EQ(lattice(17.9, 0, &history), front);
    // Across the seam at 180 there is no jump round.
    ViewHistory behind;
    const LatticeView back = lattice(179, 0, &behind);
    EXPECT_EQ(lattice(-179, 0, &behind), back);
    EXPECT_EQ(lattice(-160, 0, &behind), back);
}

TEST(ViewSnapping, ThePictureStandsFlatBeforeTheEye) {
    GameProfile profile = profileWith(ViewRule::towardEntity);
    profile.viewStepDegrees = 45.0;
    const SpriteView view =
        mustView(figure().centredAt(glm::dvec3(0.0), profile), orbit(20, 0, 12), profile);
    EXPECT_NEAR(glm::dot(view.forward, orbit(20, 0, 12).forward), 1.0, 1e-15);
    EXPECT_EQ(view.ortho.forward, glm::dvec3(0, 1, 0));
}

// Row 12.
TEST(Minification, AVirtualPixelCoversAScreenPixel) {
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        GameProfile profile = profileWith(rule);
        const Subject subject = figure();
        for (double distance = 8.0; distance < 300.0; distance *= 1.07) {
            const Camera camera = orbit(30, 20, distance);
            const SpriteView view =
                mustView(subject.centredAt(glm::dvec3(0.0), profile), camera, profile);
            ASSERT_GE(view.screenPxPerPx, 1.0 - 1e-12);
            // No further than needed.
            if (view.sigmaInForce < profile.sigma) {
                ASSERT_LT(view.screenPxPerPx, 2.0);
            }
            const double halvings = std::log2(profile.sigma / view.sigmaInForce);
            ASSERT_EQ(halvings, std::round(halvings));
            ASSERT_DOUBLE_EQ(view.metresPerPx * view.sigmaInForce, profile.voxelSizeMetres);
        }
        profile.minification = false;
        const SpriteView raw =
            mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 200), profile);
        EXPECT_EQ(raw.sigmaInForce, profile.sigma);
        EXPECT_LT(raw.screenPxPerPx, 1.0);
    }
}

TEST(Minification, NeverBelowTwoVirtualPixelsNorBeyondTheRange) {
    GameProfile profile;
    const Subject cube = solidBox({32, 32, 32});
    const SpriteView dot =
        mustView(cube.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 1e6), profile);
    EXPECT_EQ(dot.sigmaInForce, 2.0 / 32.0);
    const Subject wide = solidBox({400, 1, 400});
    const SpriteView least =
        mustView(wide.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 1e7), profile);
    EXPECT_EQ(least.ortho.sigmaInForce, 1.0 / 64.0);
    // sigma * scale stays in range by powers of two even without minification.
    profile.minification = false;
    Subject giant = solidBox({1, 1, 1});
    giant.entity.scale = 1000.0;
    const SpriteView large =
        mustView(giant.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 1000), profile);
    EXPECT_EQ(large.sigmaInForce, 1.0 / 16.0);
    giant.entity.scale = 0.001;
    const SpriteView small =
        mustView(giant.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 10), profile);
    EXPECT_EQ(small.sigmaInForce, 16.0);
}

TEST(Minification, DoesNotFlickerAtTheThreshold) {
    const GameProfile profile;
    const Subject subject = figure();
    // A virtual pixel is one screen pixel wide at this distance.
    const double threshold = 0.025 * 512.0 / (2.0 * std::tan(std::numbers::pi / 8.0));
    const auto sigma = [&](double distance, ViewHistory* history) {
        return mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, distance), profile,
                        history)
            .sigmaInForce;
    };
    EXPECT_NE(sigma(threshold * 0.999, nullptr), sigma(threshold * 1.001, nullptr));
    ViewHistory history;
    EXPECT_EQ(sigma(threshold * 0.999, &history), 4.0);
    for (int n = 0; n < 5; ++n) {
        EXPECT_EQ(sigma(threshold * 1.001, &history), 2.0);
        EXPECT_EQ(sigma(threshold * 0.999, &history), 2.0);
    }
    EXPECT_EQ(sigma(threshold * 0.79, &history), 4.0);
    EXPECT_EQ(sigma(threshold * 0.999, &history), 4.0);
}

// Row 13: without memory the picture turns by any angle at the smallest move.
TEST(Pole, TheLastGoodBasisIsKept) {
    const GameProfile profile = profileWith(ViewRule::towardEntity);
    const PlacedEntity entity = figure().centredAt(glm::dvec3(0.0), profile);
    const auto upFrom = [&](glm::dvec2 offset, ViewHistory* history) {
        Camera camera = orbit(0, 90, 12);
        camera.eyeMetres += glm::dvec3(offset.x, 0.0, offset.y);
        return mustView(entity, camera, profile, history).up;
    };
    ViewHistory history;
    const glm::dvec3 before = upFrom({0.0, 0.5}, &history);  // from the south: up is north
    EXPECT_NEAR(before.z, -1.0, 1e-2);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> tremble(-0.01, 0.01);
    double worstWithout = 1.0;
    for (int n = 0; n < 100; ++n) {
        const glm::dvec2 offset{tremble(random), tremble(random)};
        EXPECT_GT(glm::dot(upFrom(offset, &history), before), 0.99);
        worstWithout = std::min(worstWithout, glm::dot(upFrom(offset, nullptr), before));
    }
    EXPECT_LT(worstWithout, -0.9);
    EXPECT_GT(glm::dot(upFrom({0.0, 0.0}, &history), before), 0.99);
}

// Without a history, exactly above: the camera's up decides, and so the orbit's yaw.
TEST(Pole, ExactlyAboveTheCameraDecides) {
    const GameProfile profile = profileWith(ViewRule::towardEntity);
    const PlacedEntity entity = figure().centredAt(glm::dvec3(0.0), profile);
    for (const double yaw : {0.0, 30.0, 90.0, 200.0})
        for (const double pitch : {90.0, -90.0}) {
            const Camera camera = orbit(yaw, pitch, 12);
            EXPECT_NEAR(glm::dot(mustView(entity, camera, profile).up, camera.up), 1.0, 1e-12);
        }
}

}  // namespace
}  // namespace voxprite
