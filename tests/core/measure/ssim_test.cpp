#include "core/measure/ssim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace voxprite {
namespace {

Plane noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Plane plane(width, height);
    for (double& value : plane.values) value = static_cast<double>(random() & 255);
    return plane;
}

Plane constant(int width, int height, double value) {
    Plane plane(width, height);
    for (double& v : plane.values) v = value;
    return plane;
}

// The definition of the paper for one 11x11 window, as double sums over its 121 weights.
double ssimOfWindow(const Plane& a, const Plane& b, int left, int top) {
    double weights[11][11];
    double sum = 0.0;
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 11; ++x) {
            weights[y][x] = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
            sum += weights[y][x];
        }
    }
    double ma = 0, mb = 0;
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 11; ++x) {
            ma += weights[y][x] / sum * a.at(left + x, top + y);
            mb += weights[y][x] / sum * b.at(left + x, top + y);
        }
    }
    double va = 0, vb = 0, vab = 0;
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 11; ++x) {
            const double w = weights[y][x] / sum;
            const double da = a.at(left + x, top + y) - ma;
            const double db = b.at(left + x, top + y) - mb;
            va += w * da * da;
            vb += w * db * db;
            vab += w * da * db;
        }
    }
    const double c1 = 6.5025;
    const double c2 = 58.5225;
    return (2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
}

TEST(Ssim, ConstantPicturesLeaveOnlyTheLuminanceTerm) {
    const double c1 = 6.5025;
    EXPECT_NEAR(meanSsim(constant(16, 16, 0), constant(16, 16, 255)), c1 / (255.0 * 255.0 + c1),
                1e-12);
    EXPECT_NEAR(meanSsim(constant(16, 16, 100), constant(16, 16, 150)),
                (2 * 100.0 * 150.0 + c1) / (100.0 * 100.0 + 150.0 * 150.0 + c1), 1e-9);
}

TEST(Ssim, OneWindowIsTheDefinition) {
    const Plane a = noise(11, 11, 5);
    const Plane b = noise(11, 11, 6);
    EXPECT_NEAR(meanSsim(a, b), ssimOfWindow(a, b, 0, 0), 1e-9);
}

TEST(Ssim, ManyWindowsAreTheMeanOfAllInside) {
    const Plane a = noise(15, 13, 7);
    const Plane b = noise(15, 13, 8);
    double sum = 0.0;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) sum += ssimOfWindow(a, b, x, y);
    }
    EXPECT_NEAR(meanSsim(a, b), sum / 15.0, 1e-9);
}

TEST(Ssim, SmallerThanTheWindow) {
    EXPECT_DOUBLE_EQ(meanSsim(noise(1, 1, 3), noise(1, 1, 3)), 1.0);
    const double c1 = 6.5025;
    EXPECT_NEAR(meanSsim(constant(1, 40, 10), constant(1, 40, 20)),
                (2 * 200.0 + c1) / (100.0 + 400.0 + c1), 1e-9);
}

}  // namespace
}  // namespace voxprite
