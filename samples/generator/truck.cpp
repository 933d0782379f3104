// A little delivery truck that drives toward -Y.
#include <cmath>

#include "samples/generator/brush.h"

namespace voxprite::samples {

namespace {

void wheel(Brush& brush, int x, int y) {
    for (int dx = 0; dx < 4; ++dx)
        for (int dz = -5; dz <= 4; ++dz)
            for (int dy = -5; dy <= 4; ++dy) {
                const double r = std::sqrt((dy + 0.5) * (dy + 0.5) + (dz + 0.5) * (dz + 0.5));
                if (r > 5.1) continue;
                const auto colour = r < 1.3   ? shade(Ramp::gold, 4)
                                    : r < 2.9 ? shade(Ramp::steel, 4)
                                    : r > 4.2 ? shade(Ramp::ink, 1)
                                              : shade(Ramp::ink, 3);
                brush.dot({x + dx, y + dy, 5 + dz}, colour);
            }
}

void lamp(Brush& brush, int x, int y, int z, Ramp ramp, int step) {
    brush.box({x, y, z}, {x + 2, y, z + 2}, plain(ramp, step));
}

void cab(Brush& brush) {
    brush.box({-11, -30, 5}, {10, -12, 15}, plain(Ramp::red, 3));
    brush.box({-11, -26, 16}, {10, -12, 27}, plain(Ramp::red, 4));
    brush.box({-10, -25, 28}, {9, -12, 28}, plain(Ramp::plaster, 4));
    // Glass: windscreen and doors, with a bright reflection running across.
    const Paint pane = [](glm::ivec3 v) {
        return shade(Ramp::glass, (v.x + v.y + v.z) % 9 < 2 ? 5 : 2);
    };
    brush.box({-9, -27, 17}, {8, -26, 25}, pane);
    for (int x : {-11, 10}) brush.box({x, -24, 18}, {x, -15, 25}, pane);
    brush.box({-11, -30, 9}, {10, -30, 13}, plain(Ramp::steel, 4));
    for (int x = -6; x <= 5; x += 2) brush.box({x, -31, 9}, {x, -31, 13}, plain(Ramp::ink, 2));
    brush.box({-12, -32, 4}, {11, -30, 6}, plain(Ramp::steel, 3));
    lamp(brush, -10, -31, 10, Ramp::gold, 5);
    lamp(brush, 7, -31, 10, Ramp::gold, 5);
    for (int x : {-11, 10}) {
        brush.box({x, -22, 9}, {x, -13, 9}, plain(Ramp::red, 1));
        brush.dot({x, -14, 14}, shade(Ramp::gold, 5));
    }
    for (int x : {-13, 12}) brush.box({x, -25, 18}, {x, -24, 22}, plain(Ramp::ink, 2));
}

void load(Brush& brush) {
    brush.box({-12, -11, 7}, {11, 30, 8}, grained(Ramp::ink, 3, 0.2));
    brush.box({-12, -10, 9}, {11, 30, 36}, plain(Ramp::plaster, 4));
    brush.box({-12, -10, 9}, {11, 30, 11}, plain(Ramp::blue, 3));
    brush.box({-12, -10, 34}, {11, 30, 36}, plain(Ramp::blue, 3));
    for (int x : {-13, 12})  // the firm's sign: a loaf in a disc
        for (int z = 13; z <= 31; ++z)
            for (int y = 0; y <= 20; ++y) {
                const double r = std::sqrt((y - 10) * (y - 10) + (z - 22) * (z - 22));
                if (r > 9.3) continue;
                const bool loaf = std::abs(z - 21) <= 3 && std::abs(y - 10) <= 6 - (z > 22);
                const bool cut = loaf && (y % 4 == 0) && z >= 22;
                brush.dot({x, y, z}, cut     ? shade(Ramp::wood, 5)
                                     : loaf  ? shade(Ramp::wood, 3)
                                     : r > 8 ? shade(Ramp::gold, 3)
                                             : shade(Ramp::red, 4));
            }
    brush.box({-1, 31, 10}, {0, 31, 35}, plain(Ramp::ink, 2));  // rear doors
    lamp(brush, -11, 31, 9, Ramp::red, 4);
    lamp(brush, 8, 31, 9, Ramp::red, 4);
}

}  // namespace

VoxelGrid truck() {
    VoxelGrid grid;
    Brush brush(grid);
    cab(brush);
    load(brush);
    for (int y : {-20, 20}) {
        for (int x : {-12, 8}) {
            brush.erase({x, y - 6, 0}, {x + 3, y + 5, 10});
            wheel(brush, x, y);
        }
    }
    return grid;
}

}  // namespace voxprite::samples
