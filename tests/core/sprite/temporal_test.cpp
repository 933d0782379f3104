// The picture over time: a still camera never flickers, a slow turn changes it in steps, and what
// is shown depends on where the camera is, not on how it came there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>
#include <tuple>

#include "core/sprite/sprite_view.h"
#include "core/sprite/view_axes.h"
#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

using test::mustView;
using test::orbit;

constexpr double kDistance = 12.0;

GameProfile profileOf(ViewRule rule, double stepDegrees) {
    GameProfile profile;
    profile.view = rule;
    profile.viewStepDegrees = stepDegrees;
    return profile;
}

glm::dmat3 axesOf(const OrbitAngles& angles) {
    const glm::dmat3 world = orbitBasis(angles);
    return {voxelFromWorld(world[0]), voxelFromWorld(world[1]), voxelFromWorld(world[2])};
}

// Moved by about `radians` as seen from the model, and turned by as much.
Camera trembled(const Camera& camera, double radians, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Camera moved = camera;
    const double sideways = unit(random), upward = unit(random);
    moved.eyeMetres += (camera.right * sideways + camera.up * upward) * (radians * kDistance);
    moved.forward = glm::normalize(camera.forward + camera.right * (unit(random) * radians) +
                                   camera.up * (unit(random) * radians));
    const glm::dvec3 up = camera.up + camera.right * (unit(random) * radians);
    moved.right = glm::normalize(glm::cross(moved.forward, up));
    moved.up = glm::cross(moved.right, moved.forward);
    return moved;
}

// How often the lattice changes over frames of a camera that trembles.
int changesWhileTrembling(const Camera& camera, const GameProfile& profile, double radians,
                          int frames) {
    static const test::Subject subject = test::figure();
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    std::mt19937 random(5);
    ViewHistory history;
    LatticeView shown = mustView(entity, camera, profile, &history).lattice;
    int changes = 0;
    for (int n = 0; n < frames; ++n) {
        const LatticeView next =
            mustView(entity, trembled(camera, radians, random), profile, &history).lattice;
        changes += next == shown ? 0 : 1;
        shown = next;
    }
    return changes;
}

TEST(StillCamera, NeverFlickers) {
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward})
        for (const double step : {3.0, 11.25})
            // On a step, in the middle between two, at the pole, and anywhere.
            for (const OrbitAngles angles : {OrbitAngles{0, 0, 0},
                                             {1.5, 1.5, 0},
                                             {5.625, 28.125, 0},
                                             {43.5, 40.5, 0},
                                             {180, 16.5, 0},
                                             {33, 90, 0},
                                             {10, -90, 0},
                                             {61.7, 80.0, 0},
                                             {17, 88.5, 0}})
                for (const double radians : {1e-7, 1e-5, 1e-4, 1e-3}) {
                    // Nearer to the pole than 84 degrees a move of the eye turns the picture.
                    const bool steep = std::abs(angles.pitchDegrees) > 84.0 &&
                                       std::abs(angles.pitchDegrees) < 90.0;
                    if (steep && radians > 2e-4) continue;
                    EXPECT_EQ(changesWhileTrembling(
                                  orbit(angles.yawDegrees, angles.pitchDegrees, kDistance),
                                  profileOf(rule, step), radians, 250),
                              0)
                        << static_cast<int>(rule) << ", step " << step << ", yaw "
                        << angles.yawDegrees << ", pitch " << angles.pitchDegrees << ", "
                        << radians;
                }
}

// Thousands of frames in the worst place, and what happens there without snapping.
TEST(StillCamera, NeverFlickersInTheMiddleBetweenTwoSteps) {
    const Camera between = orbit(1.5, 4.5, kDistance);
    EXPECT_EQ(changesWhileTrembling(between, profileOf(ViewRule::towardEntity, 3.0), 1e-3, 5000),
              0);
    EXPECT_GT(changesWhileTrembling(between, profileOf(ViewRule::towardEntity, 0.0), 1e-3, 500),
              400);
}

// Yaw and roll rounded one by one would turn the picture by a step whenever the eye trembles.
TEST(StillCamera, LooksStraightDown) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> angle(-180.0, 180.0);
    for (int n = 0; n < 100; ++n) {
        const double heading = angle(random);
        const double yaw = angle(random);
        // One picture, told apart in many ways: near the pole the yaw is any angle.
        const glm::dmat3 axes = axesOf({yaw, 89.99, yaw - heading});
        const double shown = 5.0 * std::round(heading / 5.0);
        const glm::dmat3 snapped = snapAxes(axes, 5.0, nullptr);
        const glm::dmat3 expected = axesOf({shown, 90.0, 0.0});
        if (std::abs(heading / 5.0 - std::floor(heading / 5.0) - 0.5) < 1e-3) continue;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(glm::distance(snapped[k], expected[k]), 0.0, 1e-12) << heading;
    }
}

TEST(StillCamera, TheHeadingFollowsTheCameraThatLooksStraightDown) {
    for (const double pitch : {90.0, -90.0}) {
        ViewHistory history;
        for (int degrees = 0; degrees < 720; ++degrees) {
            const glm::dmat3 axes = axesOf({degrees * 1.0, pitch, 0.0});
            const glm::dmat3 snapped = snapAxes(axes, 5.0, &history);
            // Half a step, and the band of hysteresis: at the pole a whole one.
            EXPECT_GT(glm::dot(snapped[0], axes[0]), std::cos(7.6 * 3.14159265358979 / 180.0));
            EXPECT_EQ(std::abs(snapped[2].z), 1.0);
        }
    }
}

TEST(SlowTurn, ChangesThePictureInSteps) {
    const test::Subject subject = test::figure();
    const GameProfile profile = profileOf(ViewRule::towardEntity, 5.0);
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    ViewHistory history;
    LatticeView shown = mustView(entity, orbit(0, 20, kDistance), profile, &history).lattice;
    int changes = 0;
    for (int frame = 1; frame <= 900; ++frame) {
        const LatticeView next =
            mustView(entity, orbit(0.1 * frame, 20, kDistance), profile, &history).lattice;
        changes += next == shown ? 0 : 1;
        shown = next;
    }
    EXPECT_EQ(changes, 90 / 5);
}

// A -> B -> A: outside the band of hysteresis the way back ends at the same picture.
TEST(SlowTurn, ThereAndBackShowsTheSamePicture) {
    const test::Subject subject = test::letterBlock();
    std::mt19937 random(3);
    const double step = 7.5;
    std::uniform_int_distribution<int> steps(-24, 24);
    std::uniform_real_distribution<double> within(-0.39, 0.39);  // of a step, from the nearest
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        const GameProfile profile = profileOf(rule, step);
        const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
        const auto lattice = [&](const OrbitAngles& angles, ViewHistory* history) {
            return mustView(
                       entity,
                       orbit(angles.yawDegrees, angles.pitchDegrees, kDistance, angles.rollDegrees),
                       profile, history)
                .lattice;
        };
        for (int n = 0; n < 60; ++n) {
            // The band grows toward the poles: A stays below 45 degrees.
            const OrbitAngles a{(steps(random) + 0.9 * within(random)) * step,
                                (steps(random) / 5 + within(random)) * step,
                                rule == ViewRule::cameraForward ? within(random) * step : 0.0};
            ViewHistory history;
            const LatticeView before = lattice(a, &history);
            for (int k = 0; k < 5; ++k)
                static_cast<void>(
                    lattice({180.0 * anywhere(random), 88.0 * anywhere(random), 0.0}, &history));
            EXPECT_EQ(lattice(a, &history), before);
            EXPECT_EQ(lattice(a, nullptr), before);
        }
    }
}

// Whatever the history, what is shown is one of the snapped views: that of a viewer who comes
// straight there.
TEST(SlowTurn, WhatIsShownIsTheVeryViewOfItsAngles) {
    const test::Subject subject = test::letterBlock();
    const GameProfile snapping = profileOf(ViewRule::towardEntity, 15.0);
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), snapping);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> move(-9.0, 9.0);
    ViewHistory history;
    OrbitAngles angles;
    for (int n = 0; n < 300; ++n) {
        angles.yawDegrees += move(random);
        angles.pitchDegrees = std::clamp(angles.pitchDegrees + move(random), -70.0, 70.0);
        const LatticeView shown =
            mustView(entity, orbit(angles.yawDegrees, angles.pitchDegrees, kDistance), snapping,
                     &history)
                .lattice;
        const glm::ivec3 steps = history.snappedSteps.value();
        EXPECT_EQ(steps.z, 0);
        EXPECT_EQ(
            shown,
            mustView(entity, orbit(15.0 * steps.x, 15.0 * steps.y, kDistance), snapping).lattice);
    }
}

// Yaw and roll are one turn there: a roll that is remembered would come on top.
TEST(ViewStep, FromThePoleThereIsNoRoll) {
    for (const double step : {2.5, 15.0}) {
        for (const double pitch : {-90.0, 90.0}) {
            for (const int roll : {-1, 0, 1}) {
                ViewHistory history;
                const auto steps = static_cast<int>(std::lround(pitch / step));
                history.snappedSteps = glm::ivec3(0, steps, roll);
                const glm::dmat3 snapped = snapAxes(axesOf({0.0, pitch, 0.0}), step, &history);
                EXPECT_EQ(history.snappedSteps, glm::ivec3(0, steps, 0));
                EXPECT_LT(glm::distance(snapped[0], axesOf({0.0, pitch, 0.0})[0]), 1e-12);
            }
        }
    }
}

// Steps that do not divide 45 degrees are brought to one that does: axes and diagonals are always
// among the views shown, and the circle has no seam.
TEST(ViewStep, AxesAndDiagonalsAreAmongTheViews) {
    for (const double step : {0.7, 2.0, 7.0, 10.0, 31.0, 45.0}) {
        for (int yaw = -360; yaw <= 360; yaw += 45)
            for (const double pitch : {-90.0, -45.0, 0.0, 45.0, 90.0}) {
                const glm::dmat3 exact = axesOf({yaw * 1.0, pitch, 0.0});
                const glm::dmat3 snapped = snapAxes(exact, step, nullptr);
                for (int k = 0; k < 3; ++k)
                    EXPECT_LT(glm::distance(snapped[k], exact[k]), 1e-15) << step << ", " << yaw;
            }
        // Round the circle: as many views as steps, none twice.
        std::set<std::tuple<double, double>> views;
        const int expected = 8 * static_cast<int>(std::lround(45.0 / step));
        for (int n = 0; n < 20'000; ++n) {
            const glm::dmat3 snapped =
                snapAxes(axesOf({-180.0 + 360.0 * (n + 0.5) / 20'000, 10.0, 0.0}), step, nullptr);
            views.insert({std::round(snapped[0].x * 1e9), std::round(snapped[0].y * 1e9)});
        }
        EXPECT_EQ(static_cast<int>(views.size()), expected) << step;
    }
}

}  // namespace
}  // namespace voxprite
