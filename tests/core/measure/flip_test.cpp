#include "core/measure/flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace voxprite {
namespace {

constexpr double kPi = std::numbers::pi;

// A second implementation, straight from the paper's formulas: full two-dimensional kernels, no
// separation, matrices of the sRGB standard with four digits more than its text has.
namespace direct {

using Colour = std::array<double, 3>;
using Picture = std::vector<std::vector<Colour>>;  // [y][x]
using Kernel = std::vector<std::vector<double>>;

constexpr double kToXyz[3][3] = {{0.41238656, 0.35759149, 0.18045049},
                                 {0.21263682, 0.71518298, 0.07218020},
                                 {0.01933062, 0.11919716, 0.95037259}};
constexpr double kToRgb[3][3] = {{3.2410033, -1.5373989, -0.4986159},
                                 {-0.9692243, 1.8759299, 0.0415542},
                                 {0.0556394, -0.2040112, 1.0571490}};
constexpr Colour kWhite{0.950428545, 1.0, 1.088900371};

Colour times(const double (&m)[3][3], Colour c) {
    Colour r{};
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 3; ++k) r[row] += m[row][k] * c[k];
    }
    return r;
}

Colour ycxcz(Rgba8 p) {
    Colour linear;
    for (int k = 0; k < 3; ++k) {
        const double s = p[k] / 255.0;
        linear[k] = s > 0.04045 ? std::pow((s + 0.055) / 1.055, 2.4) : s / 12.92;
    }
    Colour xyz = times(kToXyz, linear);
    for (int k = 0; k < 3; ++k) xyz[k] /= kWhite[k];
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Colour huntLab(Colour rgb) {
    Colour xyz = times(kToXyz, rgb);
    for (int k = 0; k < 3; ++k) {
        const double t = xyz[k] / kWhite[k];
        xyz[k] = t > 216.0 / 24389.0 ? std::cbrt(t) : (841.0 / 108.0) * t + 4.0 / 29.0;
    }
    const double l = 116 * xyz[1] - 16;
    return {l, 0.01 * l * 500 * (xyz[0] - xyz[1]), 0.01 * l * 200 * (xyz[1] - xyz[2])};
}

double hyab(Colour a, Colour b) {
    return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

double at(const Picture& p, int x, int y, int channel) {
    const int h = static_cast<int>(p.size());
    const int w = static_cast<int>(p[0].size());
    return p[std::clamp(y, 0, h - 1)][std::clamp(x, 0, w - 1)][channel];
}

double convolve(const Picture& p, int channel, const Kernel& kernel, int x, int y) {
    const int r = static_cast<int>(kernel.size() / 2);
    double sum = 0;
    for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
            sum += kernel[dy + r][dx + r] * at(p, x + dx, y + dy, channel);
        }
    }
    return sum;
}

Kernel sensitivity(double a1, double b1, double a2, double b2, double ppd) {
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
    Kernel kernel(2 * r + 1, std::vector<double>(2 * r + 1));
    double sum = 0;
    for (int y = -r; y <= r; ++y) {
        for (int x = -r; x <= r; ++x) {
            const double d2 = (x * x + y * y) / (ppd * ppd);
            kernel[y + r][x + r] = a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * d2 / b1) +
                                   a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * d2 / b2);
            sum += kernel[y + r][x + r];
        }
    }
    for (auto& row : kernel) {
        for (double& w : row) w /= sum;
    }
    return kernel;
}

Kernel feature(bool point, bool vertical, double ppd) {
    const double sd = 0.5 * 0.082 * ppd;
    const int r = static_cast<int>(std::ceil(3 * sd));
    Kernel kernel(2 * r + 1, std::vector<double>(2 * r + 1));
    double positive = 0, negative = 0;
    for (int y = -r; y <= r; ++y) {
        for (int x = -r; x <= r; ++x) {
            const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
            const double a = vertical ? y : x;
            const double w = point ? (a * a / (sd * sd) - 1) * g : -a * g;
            kernel[y + r][x + r] = w;
            (w > 0 ? positive : negative) += w;
        }
    }
    for (auto& row : kernel) {
        for (double& w : row) w /= w > 0 ? positive : -negative;
    }
    return kernel;
}

struct Analysis {
    Picture colours, features;  // features: edge magnitude, point magnitude
};

Analysis analyse(const Image& image, double ppd) {
    Picture opponent(image.height, std::vector<Colour>(image.width));
    Picture luminance = opponent;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            opponent[y][x] = ycxcz(image.at(x, y));
            luminance[y][x] = {(opponent[y][x][0] + 16) / 116, 0, 0};
        }
    }
    const Kernel filters[3] = {sensitivity(1, 0.0047, 0, 1e-5, ppd),
                               sensitivity(1, 0.0053, 0, 1e-5, ppd),
                               sensitivity(34.1, 0.04, 13.5, 0.025, ppd)};
    Analysis result{opponent, opponent};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            Colour c;
            for (int k = 0; k < 3; ++k) c[k] = convolve(opponent, k, filters[k], x, y);
            const double fy = (c[0] + 16) / 116;
            const Colour xyz{(fy + c[1] / 500) * kWhite[0], fy * kWhite[1],
                             (fy - c[2] / 200) * kWhite[2]};
            Colour rgb = times(kToRgb, xyz);
            for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
            result.colours[y][x] = huntLab(rgb);
            for (int kind = 0; kind < 2; ++kind) {
                result.features[y][x][kind] =
                    std::hypot(convolve(luminance, 0, feature(kind == 1, false, ppd), x, y),
                               convolve(luminance, 0, feature(kind == 1, true, ppd), x, y));
            }
        }
    }
    return result;
}

double flipAt(const Analysis& a, const Analysis& b, int x, int y) {
    const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7);
    const double power = std::pow(hyab(a.colours[y][x], b.colours[y][x]), 0.7);
    const double knee = 0.4 * largest;
    const double colour =
        power < knee ? 0.95 / knee * power : 0.95 + (power - knee) / (largest - knee) * 0.05;
    const double edge = std::abs(a.features[y][x][0] - b.features[y][x][0]);
    const double point = std::abs(a.features[y][x][1] - b.features[y][x][1]);
    return std::pow(colour, 1 - std::sqrt(std::max(edge, point) / std::sqrt(2.0)));
}

}  // namespace direct

// Coloured shapes with hard edges, a gradient and some noise.
Image testPicture(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = Rgba8(x * 255 / width, y * 255 / height, random() & 63, 255);
        }
    }
    for (int shape = 0; shape < 6; ++shape) {
        const Rgba8 colour(random() & 255, random() & 255, random() & 255, 255);
        const int left = static_cast<int>(random() % static_cast<unsigned>(width - 4));
        const int top = static_cast<int>(random() % static_cast<unsigned>(height - 4));
        for (int y = top; y < top + 4; ++y) {
            for (int x = left; x < left + 4; ++x) image.at(x, y) = colour;
        }
    }
    return image;
}

TEST(Flip, BlackAgainstWhite) {
    const Image black(32, 32, Rgba8(0, 0, 0, 255));
    const Image white(32, 32, Rgba8(255, 255, 255, 255));
    const Plane map = flipMap(black, white);
    // Flat pictures have no features, so all is the colour term: a distance of exactly 100.
    const double largest =
        std::pow(direct::hyab(direct::huntLab({0, 1, 0}), direct::huntLab({0, 0, 1})), 0.7);
    const double expected = 0.95 + (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
    EXPECT_NEAR(expected, 0.967, 0.001);
    for (const double value : map.values) EXPECT_NEAR(value, expected, 1e-6);
}

TEST(Flip, AgreesWithTheFormulasInTwoDimensions) {
    for (const double ppd : {67.0, 30.0}) {
        const Image a = testPicture(23, 19, 1);
        const Image b = testPicture(23, 19, 2);
        const Plane map = flipMap(a, b, ppd);
        const direct::Analysis da = direct::analyse(a, ppd);
        const direct::Analysis db = direct::analyse(b, ppd);
        for (int y = 0; y < a.height; ++y) {
            for (int x = 0; x < a.width; ++x) {
                EXPECT_NEAR(map.at(x, y), direct::flipAt(da, db, x, y), 2e-5) << x << "," << y;
            }
        }
    }
}

TEST(Flip, StaysWithinItsRangeAndIsZeroWhereNothingDiffers) {
    const Image a = testPicture(80, 60, 3);
    Image b = a;
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 10; ++x) b.at(x, y) = Rgba8(255, 255, 255, 255);
    }
    const Plane map = flipMap(a, b);
    for (const double value : map.values) {
        EXPECT_GE(value, 0.0);
        EXPECT_LE(value, 1.0);
    }
    // The widest kernel reaches 10 pixels.
    for (int y = 0; y < 60; ++y) {
        EXPECT_GT(map.at(0, y), 0.0);
        for (int x = 20; x < 80; ++x) EXPECT_EQ(map.at(x, y), 0.0);
    }
}

}  // namespace
}  // namespace voxprite
