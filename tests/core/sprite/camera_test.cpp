#include "core/sprite/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace voxprite {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << ", " << a.y << ", " << a.z << " against " << b.x << ", " << b.y << ", " << b.z;
}

TEST(SinCosDegrees, ExactAtMultiplesOfNinety) {
    const double sines[] = {0, 1, 0, -1};
    for (int k = -4000; k <= 4000; ++k) {
        const SinCos value = sinCosDegrees(90.0 * k);
        EXPECT_EQ(value.sin, sines[((k % 4) + 4) % 4]);
        EXPECT_EQ(value.cos, sines[(((k + 1) % 4) + 4) % 4]);
    }
    EXPECT_EQ(sinCosDegrees(90.0 * 4e12).sin, 0.0);
}

TEST(SinCosDegrees, SymmetricAtThirtyAndFortyFive) {
    EXPECT_EQ(sinCosDegrees(30).sin, 0.5);
    EXPECT_EQ(sinCosDegrees(60).cos, 0.5);
    EXPECT_EQ(sinCosDegrees(150).sin, 0.5);
    EXPECT_EQ(sinCosDegrees(240).cos, -0.5);
    for (const double diagonal : {45.0, 135.0, 225.0, 315.0, -45.0}) {
        const SinCos value = sinCosDegrees(diagonal);
        EXPECT_EQ(std::abs(value.sin), std::abs(value.cos));
    }
}

TEST(SinCosDegrees, AsAccurateAsDoubleAllows) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(-1000.0, 1000.0);
    for (int n = 0; n < 100'000; ++n) {
        const double degrees = angle(random);
        const long double radians =
            static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180.0L;
        const SinCos value = sinCosDegrees(degrees);
        ASSERT_NEAR(value.sin, static_cast<double>(std::sin(radians)), 3e-16) << degrees;
        ASSERT_NEAR(value.cos, static_cast<double>(std::cos(radians)), 3e-16) << degrees;
    }
}

TEST(SinCosDegrees, NotANumberStaysSo) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_TRUE(std::isnan(sinCosDegrees(bad).sin));
        EXPECT_TRUE(std::isnan(sinCosDegrees(bad).cos));
    }
}

// The command line's contract, in voxel space.
TEST(OrbitBasis, EyeGoesWhereTheContractSays) {
    const auto eye = [](OrbitAngles angles) { return voxelFromWorld(-orbitBasis(angles)[2]); };
    const auto right = [](OrbitAngles angles) { return voxelFromWorld(orbitBasis(angles)[0]); };
    const auto up = [](OrbitAngles angles) { return voxelFromWorld(orbitBasis(angles)[1]); };
    EXPECT_EQ(eye({0, 0, 0}), glm::dvec3(0, -1, 0));
    EXPECT_EQ(right({0, 0, 0}), glm::dvec3(1, 0, 0));
    EXPECT_EQ(up({0, 0, 0}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(eye({90, 0, 0}), glm::dvec3(1, 0, 0));
    EXPECT_EQ(right({90, 0, 0}), glm::dvec3(0, 1, 0));
    EXPECT_EQ(eye({180, 0, 0}), glm::dvec3(0, 1, 0));
    EXPECT_EQ(eye({-90, 0, 0}), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(eye({0, 90, 0}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(up({0, 90, 0}), glm::dvec3(0, 1, 0));
    EXPECT_EQ(up({90, 90, 0}), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(up({0, -90, 0}), glm::dvec3(0, -1, 0));
    // Clockwise, as the photographer turns: the camera's up goes to where its right was.
    EXPECT_EQ(up({0, 0, 90}), glm::dvec3(1, 0, 0));
    EXPECT_EQ(right({0, 0, 90}), glm::dvec3(0, 0, -1));
    EXPECT_GT(eye({10, 0, 0}).x, 0.0);
    EXPECT_GT(eye({0, 10, 0}).z, 0.0);
}

TEST(OrbitBasis, OrthonormalAndRightHanded) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> angle(-400.0, 400.0);
    for (int n = 0; n < 1000; ++n) {
        const glm::dmat3 basis = orbitBasis({angle(random), angle(random), angle(random)});
        expectNear(glm::cross(basis[0], basis[1]), -basis[2], 1e-15);
        EXPECT_NEAR(glm::length(basis[0]), 1.0, 1e-15);
        EXPECT_NEAR(glm::length(basis[2]), 1.0, 1e-15);
    }
}

Camera tilted(bool orthographic) {
    Camera camera = orbitCamera({33, 21, 7}, {4, 5, 6}, 12.0, 50.0, {640, 360});
    camera.orthographic = orthographic;
    camera.orthographicHeightMetres = 9.0;
    return camera;
}

TEST(Camera, ProjectingUndoesTheRay) {
    for (const bool orthographic : {false, true}) {
        const Camera camera = tilted(orthographic);
        for (const glm::dvec2 screen : {glm::dvec2(0, 0), glm::dvec2(640, 360),
                                        glm::dvec2(320, 180), glm::dvec2(12.5, 300.25)}) {
            const Camera::Ray ray = camera.rayThrough(screen);
            EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-15);
            const auto back = camera.project(ray.origin + ray.direction * 7.0);
            EXPECT_NEAR(back.screenPx.x, screen.x, 1e-9);
            EXPECT_NEAR(back.screenPx.y, screen.y, 1e-9);
            EXPECT_GT(back.depthMetres, 0.0);
        }
    }
}

TEST(Camera, TopLeftIsUpAndLeft) {
    const Camera camera = orbitCamera({}, {}, 10.0, 90.0, {200, 100});
    const glm::dvec3 direction = camera.rayThrough({0, 0}).direction;
    // 90 degrees high, twice as wide.
    expectNear(direction / -direction.z, {-2, 1, -1}, 1e-14);
    EXPECT_NEAR(camera.metresPerScreenPx(10.0), 20.0 / 100.0, 1e-14);
}

TEST(Camera, ClipMatrixIsReversedAndAgreesWithProject) {
    for (const bool orthographic : {false, true}) {
        const Camera camera = tilted(orthographic);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> offset(-5.0, 5.0);
        for (int n = 0; n < 200; ++n) {
            const glm::dvec3 world =
                glm::dvec3(4, 5, 6) + glm::dvec3(offset(random), offset(random), offset(random));
            const glm::dvec4 clip =
                camera.clipFromCameraRelative() * glm::dvec4(world - camera.eyeMetres, 1.0);
            const auto seen = camera.project(world);
            EXPECT_NEAR((clip.x / clip.w * 0.5 + 0.5) * 640, seen.screenPx.x, 1e-9);
            EXPECT_NEAR((0.5 - clip.y / clip.w * 0.5) * 360, seen.screenPx.y, 1e-9);
            EXPECT_NEAR(clip.z / clip.w, camera.reversedDepth(seen.depthMetres), 1e-6);
        }
        EXPECT_EQ(camera.reversedDepth(camera.nearMetres), 1.0f);
        EXPECT_GT(camera.reversedDepth(5.0), camera.reversedDepth(6.0));
        EXPECT_GE(camera.reversedDepth(6.0), 0.0f);
    }
}

// Row 10: a 24-bit depth buffer, not reversed, cannot tell 1000 m from 1000.5 m.
TEST(Camera, ReversedFloatDepthTellsFifthsOfAMillimetreAtAKilometre) {
    const Camera camera;
    EXPECT_GT(camera.reversedDepth(1000.0), camera.reversedDepth(1000.0002));
    const auto classic24 = [&](double depth) {
        return std::floor((1.0 - camera.nearMetres / depth) * (1 << 24));
    };
    EXPECT_EQ(classic24(1000.0), classic24(1000.5));
}

TEST(Camera, RefusesWhatIsNoCamera) {
    EXPECT_TRUE(validate(Camera{}));
    const auto broken = [](auto change) {
        Camera camera;
        change(camera);
        return !validate(camera).has_value();
    };
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_TRUE(broken([&](Camera& c) { c.eyeMetres.y = bad; }));
        EXPECT_TRUE(broken([&](Camera& c) { c.right.x = bad; }));
        EXPECT_TRUE(broken([&](Camera& c) { c.up.z = bad; }));
        EXPECT_TRUE(broken([&](Camera& c) { c.forward.z = bad; }));
        EXPECT_TRUE(broken([&](Camera& c) { c.verticalFovDegrees = bad; }));
        EXPECT_TRUE(broken([&](Camera& c) { c.nearMetres = bad; }));
        EXPECT_TRUE(broken([&](Camera& c) {
            c.orthographic = true;
            c.orthographicHeightMetres = bad;
        }));
    }
    EXPECT_TRUE(broken([](Camera& c) { c.verticalFovDegrees = 0.0; }));
    EXPECT_TRUE(broken([](Camera& c) { c.verticalFovDegrees = 180.0; }));
    EXPECT_TRUE(broken([](Camera& c) { c.nearMetres = 0.0; }));
    EXPECT_TRUE(broken([](Camera& c) { c.viewportPx = {0, 10}; }));
    EXPECT_TRUE(broken([](Camera& c) { c.up = {0, 2, 0}; }));
    EXPECT_TRUE(broken([](Camera& c) { c.right = {-1, 0, 0}; }));
}

}  // namespace
}  // namespace voxprite
