// An oak, a fence and a patch of meadow.
#include <array>
#include <cmath>

#include "samples/generator/brush.h"

namespace voxprite::samples {

VoxelGrid oak() {
    VoxelGrid grid;
    Brush brush(grid);
    const Paint bark = [](glm::ivec3 v) {
        // Vertical furrows: the colour belongs to the column, with a little moss below.
        const double g = grain({v.x, v.y, v.z / 4}, 3);
        if (v.z < 8 && grain(v, 9) < 0.12) return shade(Ramp::leaf, 2);
        return shade(Ramp::bark, g < 0.3 ? 1 : g < 0.75 ? 2 : 3);
    };
    brush.cone({0, 0}, 0, 3, 6.5, 4.4, bark);
    brush.cone({0, 0}, 4, 22, 4.3, 3.2, bark);
    for (const glm::dvec3 root :
         {glm::dvec3(9, 2, 0), glm::dvec3(-7, 6, 0), glm::dvec3(-6, -7, 0), glm::dvec3(4, -8, 0)})
        brush.limb({0, 0, 4}, root, 2.6, 1.0, bark);
    const std::array<glm::dvec3, 6> crowns{
        {{0, 0, 40}, {13, 3, 33}, {-13, 5, 34}, {2, -13, 32}, {-3, 13, 35}, {5, 2, 48}}};
    const std::array<double, 6> radii{14.5, 10.5, 11.0, 10.0, 10.5, 9.0};
    for (const glm::dvec3& crown : crowns) brush.limb({0, 0, 17}, crown, 2.4, 1.2, bark);
    // Leaves in clumps: light from above, ragged at the rim, with gaps to see the sky through.
    for (std::size_t i = 0; i < crowns.size(); ++i) {
        const glm::dvec3 centre = crowns[i];
        const double radius = radii[i];
        const int reach = static_cast<int>(std::ceil(radius)) + 2;
        const glm::ivec3 mid(glm::floor(centre));
        brush.box(mid - reach, mid + reach, [&](glm::ivec3 v) -> std::uint8_t {
            const glm::dvec3 d =
                (glm::dvec3(v) + 0.5 - centre) / glm::dvec3(radius, radius, radius * 0.82);
            const double r = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
            const double ragged = 0.16 * grain({v.x / 2, v.y / 2, v.z / 2}, 5) + 0.06 * grain(v, 6);
            if (r + ragged > 1.08 || r < 0.55) return 0;
            const double light =
                0.55 * d.z - 0.25 * d.y + 0.2 * d.x + 0.35 * grain({v.x / 3, v.y / 3, v.z / 2}, 8);
            const int step = light > 0.55   ? 5
                             : light > 0.32 ? 4
                             : light > 0.05 ? 3
                             : light > -0.3 ? 2
                                            : 1;
            if (step >= 3 && grain(v, 11) < 0.006) return shade(Ramp::red, 4);  // an apple
            return shade(Ramp::leaf, step);
        });
    }
    return grid;
}

VoxelGrid fence() {
    VoxelGrid grid;
    Brush brush(grid);
    for (int post = 0; post < 4; ++post) {
        const int x = -15 + post * 10;
        brush.box({x - 1, -1, 0}, {x, 0, 10}, grained(Ramp::wood, 2, 0.4));
        brush.box({x - 1, -1, 11}, {x, 0, 11}, plain(Ramp::wood, 4));
    }
    brush.box({-18, -2, 4}, {17, -2, 5}, grained(Ramp::wood, 3, 0.5, 2));
    brush.box({-18, -2, 8}, {17, -2, 9}, grained(Ramp::wood, 3, 0.5, 4));
    return grid;
}

VoxelGrid meadow() {
    VoxelGrid grid;
    Brush brush(grid);
    const auto height = [](int x, int y) {
        return static_cast<int>(std::floor(1.6 * std::sin(x * 0.045) + 1.3 * std::cos(y * 0.06)));
    };
    for (int y = -64; y < 64; ++y) {
        for (int x = -64; x < 64; ++x) {
            const double edge = std::sqrt(x * x + y * y) + 5.0 * grain({x / 5, y / 5, 0}, 21);
            if (edge > 62.0) continue;
            const int top = height(x, y);
            const double path = std::abs(x - 6.0 * std::sin(y * 0.05) - 2.0);
            const bool onPath = y < -2 && path < 6.0 + 1.5 * grain({x, y, 1}, 2);
            for (int z = -5 + static_cast<int>(edge / 24); z < top; ++z)
                brush.dot({x, y, z}, grained(Ramp::soil, z < -2 ? 1 : 2, 0.4)({x, y, z}));
            if (onPath) {
                brush.dot({x, y, top},
                          shade(Ramp::soil, grain({x / 2, y / 2, 0}, 4) < 0.3 ? 5 : 4));
                continue;
            }
            const double g = grain({x / 3, y / 3, 0}, 30) + 0.3 * grain({x, y, 0}, 31);
            brush.dot({x, y, top}, shade(Ramp::grass, g < 0.35 ? 2 : g < 0.95 ? 3 : 4));
            const double flower = grain({x, y, 5}, 40);
            if (flower < 0.035) brush.dot({x, y, top + 1}, shade(Ramp::grass, 4));
            if (flower > 0.994) {
                brush.dot({x, y, top + 1}, shade(Ramp::leaf, 3));
                brush.dot({x, y, top + 2},
                          flower > 0.997 ? shade(Ramp::blossom, 4) : shade(Ramp::gold, 5));
            }
        }
    }
    return grid;
}

}  // namespace voxprite::samples
