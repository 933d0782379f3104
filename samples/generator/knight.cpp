// A small knight who faces -Y: the figure that the game's camera sees from the front at yaw 0.
#include <array>

#include "samples/generator/brush.h"

namespace voxprite::samples {

namespace {

void leg(Brush& brush, int side, int stride) {
    const int x0 = side < 0 ? -5 : 1;
    const int x1 = side < 0 ? -2 : 4;
    const int y = -2 + stride;
    const int lift = stride < 0 ? 1 : 0;
    brush.box({x0, y, 3 + lift}, {x1, y + 3, 8}, grained(Ramp::steel, 2, 0.2));
    brush.box({x0, y - 1, 5 + lift}, {x1, y - 1, 6 + lift}, plain(Ramp::steel, 4));  // knee
    brush.box({x0, y - 2, lift}, {x1, y + 3, 2 + lift}, grained(Ramp::hair, 1, 0.15));
    brush.box({x0, y - 2, 2 + lift}, {x1, y + 3, 2 + lift}, plain(Ramp::hair, 3));
}

void torso(Brush& brush) {
    brush.box({-6, -3, 9}, {5, 2, 18}, grained(Ramp::steel, 3, 0.2));
    brush.box({-4, -4, 7}, {3, -4, 17}, grained(Ramp::blue, 3, 0.12));  // tabard
    brush.box({-4, 3, 7}, {3, 3, 17}, grained(Ramp::blue, 2, 0.12));
    brush.box({-5, -4, 7}, {-5, -4, 9}, plain(Ramp::blue, 2));
    brush.box({4, -4, 7}, {4, -4, 9}, plain(Ramp::blue, 2));
    brush.box({-6, -4, 10}, {5, 3, 11}, grained(Ramp::hair, 2, 0.1));  // belt
    brush.box({-1, -5, 10}, {0, -5, 11}, plain(Ramp::gold, 4));
    brush.box({-1, -4, 12}, {0, -4, 17}, plain(Ramp::gold, 3));  // the cross
    brush.box({-3, -4, 14}, {2, -4, 15}, plain(Ramp::gold, 3));
}

void cape(Brush& brush, int sway) {
    for (int z = 3; z <= 18; ++z) {
        const int flare = (18 - z) / 4;
        const int back = 4 + (18 - z) / 5 + (z < 8 ? sway : 0);
        brush.box({-5 - flare / 2, back, z}, {4 + flare / 2, back + 1, z},
                  [=](glm::ivec3 v) { return shade(Ramp::red, (v.x % 3 == 0 ? 2 : 3) - (z < 5)); });
    }
}

void helmet(Brush& brush) {
    brush.ellipsoid({0, 0, 25}, {7.4, 6.8, 7.6}, grained(Ramp::steel, 3, 0.12));
    brush.box({-6, -4, 19}, {5, 4, 20}, grained(Ramp::steel, 2, 0.1));  // gorget
    brush.repaint({-8, -8, 28}, {7, 7, 33}, grained(Ramp::steel, 4, 0.15));
    // Visor: a dark slit with a cross-shaped guard and breathing holes.
    for (int x = -5; x <= 4; ++x) {
        for (int y = -8; y <= -3; ++y) brush.repaint({x, y, 24}, {x, y, 25}, plain(Ramp::ink, 0));
    }
    brush.box({-1, -8, 20}, {0, -7, 27}, plain(Ramp::gold, 3));
    for (int x : {-4, -3, 2, 3})
        for (int z : {20, 22}) brush.repaint({x, -8, z}, {x, -5, z}, plain(Ramp::ink, 1));
    brush.repaint({-8, -8, 27}, {7, 7, 27}, plain(Ramp::gold, 3));  // brow band
}

void plume(Brush& brush, int sway) {
    const std::array<glm::dvec3, 4> path{
        {{0, -1, 32}, {0, 2, 36}, {0.0 + sway, 6, 36}, {0.0 + sway, 9, 31}}};
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        brush.limb(path[i], path[i + 1], 1.6 + 0.4 * static_cast<double>(i),
                   2.0 + 0.3 * static_cast<double>(i), grained(Ramp::red, 3, 0.5, 7));
}

void swordArm(Brush& brush, int lift) {
    brush.limb({-8, 0, 16}, {-9.5, -3, 10.0 + lift}, 2.2, 1.8, grained(Ramp::steel, 3, 0.2));
    brush.ellipsoid({-7.5, 0, 17}, {3.2, 3.4, 2.8}, grained(Ramp::steel, 4, 0.2));
    const int z = 9 + lift;
    brush.box({-11, -5, z}, {-9, -3, z + 2}, plain(Ramp::hair, 3));       // glove
    brush.box({-10, -5, z - 2}, {-10, -5, z - 1}, plain(Ramp::gold, 4));  // pommel
    brush.box({-12, -5, z + 3}, {-8, -4, z + 3}, plain(Ramp::gold, 3));   // guard
    brush.box({-11, -5, z + 4}, {-10, -5, z + 19},
              [](glm::ivec3 v) { return shade(Ramp::steel, v.x == -11 ? 5 : 3); });
    brush.box({-10, -5, z + 20}, {-10, -5, z + 21}, plain(Ramp::steel, 5));
}

void shieldArm(Brush& brush, int lift) {
    brush.limb({8, 0, 16}, {9, -2, 11}, 2.2, 1.8, grained(Ramp::steel, 3, 0.2));
    brush.ellipsoid({7.5, 0, 17}, {3.2, 3.4, 2.8}, grained(Ramp::steel, 4, 0.2));
    for (int z = 4; z <= 17; ++z) {
        const int half = z >= 10 ? 4 : z >= 7 ? 3 : z >= 5 ? 2 : 1;
        for (int x = 9 - half; x <= 8 + half; ++x) {
            const bool rim = x == 9 - half || x == 8 + half || z == 17 || z <= 4;
            const bool cross = x == 8 || x == 9 || z == 12 || z == 13;
            const auto colour = rim     ? shade(Ramp::gold, 3)
                                : cross ? shade(Ramp::plaster, 4)
                                        : shade(Ramp::red, 3);
            brush.dot({x, -5, z + lift}, colour);
            brush.dot({x, -4, z + lift}, shade(Ramp::wood, 1));
        }
    }
}

}  // namespace

VoxelGrid knight(int step) {
    constexpr std::array<int, 4> kStride{0, 2, 0, -2};
    const int stride = kStride[static_cast<std::size_t>(step & 3)];
    const int sway = stride / 2;
    VoxelGrid grid;
    Brush brush(grid);
    cape(brush, sway);
    leg(brush, -1, stride);
    leg(brush, 1, -stride);
    torso(brush);
    helmet(brush);
    plume(brush, sway);
    swordArm(brush, sway);
    shieldArm(brush, -sway);
    return grid;
}

}  // namespace voxprite::samples
