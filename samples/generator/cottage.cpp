// A timber-framed cottage with a tiled roof; its door faces -Y.
#include <cmath>
#include <cstdlib>

#include "samples/generator/brush.h"

namespace voxprite::samples {

namespace {

constexpr int kHalfX = 20;  // walls run over x in [-20, 19]
constexpr int kHalfY = 15;
constexpr int kEaves = 22;

void walls(Brush& brush) {
    brush.box({-kHalfX - 1, -kHalfY - 1, 0}, {kHalfX, kHalfY, 4}, [](glm::ivec3 v) {
        const bool joint = v.z % 3 == 2 || (v.x + v.y + (v.z / 3) * 3) % 6 == 0;
        return shade(Ramp::stone,
                     joint ? 1 : 2 + static_cast<int>(grain({v.x / 5, v.y / 5, v.z / 3}) * 3));
    });
    brush.box({-kHalfX, -kHalfY, 5}, {kHalfX - 1, kHalfY - 1, kEaves},
              grained(Ramp::plaster, 4, 0.2));
    const Paint beam = grained(Ramp::wood, 1, 0.4);
    for (int x : {-kHalfX, -8, 6, kHalfX - 2})  // posts of the front and the back
        for (int y : {-kHalfY, kHalfY - 1}) brush.repaint({x, y, 5}, {x + 1, y, kEaves}, beam);
    for (int y : {-kHalfY, -1, kHalfY - 2})  // posts of the sides
        for (int x : {-kHalfX, kHalfX - 1}) brush.repaint({x, y, 5}, {x, y + 1, kEaves}, beam);
    for (int z : {5, 13, kEaves - 1})
        brush.repaint({-kHalfX, -kHalfY, z}, {kHalfX - 1, kHalfY - 1, z + 1}, beam);
    brush.erase({-kHalfX + 2, -kHalfY + 2, 5}, {kHalfX - 3, kHalfY - 3, kEaves});
    brush.box({-kHalfX + 2, -kHalfY + 2, 5}, {kHalfX - 3, kHalfY - 3, 5},
              grained(Ramp::wood, 2, 0.3));
}

void gables(Brush& brush) {
    for (int z = kEaves + 1; z <= kEaves + 16; ++z) {
        const int half = kHalfY - (z - kEaves) + 1;
        if (half <= 0) break;
        for (int x : {-kHalfX, kHalfX - 1})
            brush.box({x, -half, z}, {x, half - 1, z}, grained(Ramp::plaster, 3, 0.2));
        for (int x : {-kHalfX, kHalfX - 1}) brush.box({x, -1, z}, {x, 0, z}, plain(Ramp::wood, 1));
    }
}

void roof(Brush& brush) {
    for (int k = 0; k <= kHalfY + 3; ++k) {
        const int z = kEaves - 2 + k;
        for (int side : {-1, 1}) {
            const int y = side < 0 ? -kHalfY - 3 + k : kHalfY + 2 - k;
            for (int x = -kHalfX - 3; x <= kHalfX + 2; ++x) {
                const bool gap = (x + (k / 2 % 2) * 2) % 4 == 0;
                const int tone = gap ? 1 : 2 + static_cast<int>(grain({x / 4, y, k / 2}, 13) * 2.6);
                brush.dot({x, y, z}, shade(Ramp::roof, tone));
                brush.dot({x, y, z + 1}, shade(Ramp::roof, k % 2 == 0 ? tone + 1 : tone));
            }
            for (int x : {-kHalfX - 3, kHalfX + 2}) {
                brush.dot({x, y, z}, shade(Ramp::wood, 2));
                brush.dot({x, y, z + 1}, shade(Ramp::wood, 3));
            }
        }
    }
    const int ridge = kEaves + kHalfY + 2;
    brush.box({-kHalfX - 3, -1, ridge}, {kHalfX + 2, 0, ridge + 1},
              [](glm::ivec3 v) { return shade(Ramp::roof, std::abs(v.x) % 4 == 0 ? 2 : 4); });
}

void window(Brush& brush, int x, int z) {
    const int y = -kHalfY;
    brush.box({x - 1, y - 1, z - 1}, {x + 6, y, z + 7}, grained(Ramp::wood, 2, 0.2));
    brush.box({x, y - 1, z}, {x + 5, y, z + 6}, [=](glm::ivec3 v) {
        const bool bar = v.x == x + 2 || v.x == x + 3 || v.z == z + 3;
        if (bar) return shade(Ramp::wood, 3);
        return shade(Ramp::glass, (v.x - x + v.z - z) % 5 == 0 ? 5 : 3);
    });
    for (int shutter : {x - 4, x + 7})
        brush.box({shutter, y - 1, z - 1}, {shutter + 2, y - 1, z + 7},
                  [](glm::ivec3 v) { return shade(Ramp::leaf, v.z % 2 == 0 ? 2 : 3); });
    brush.box({x - 2, y - 3, z - 3}, {x + 7, y - 1, z - 2}, grained(Ramp::wood, 2, 0.3));
    for (int i = x - 2; i <= x + 7; ++i) {
        brush.dot({i, y - 2, z - 1}, shade(Ramp::leaf, 3));
        if (i % 2 == 0) brush.dot({i, y - 3, z - 1}, shade(Ramp::blossom, 3 + (i / 2) % 2));
    }
}

void door(Brush& brush) {
    const int y = -kHalfY;
    brush.box({-6, y - 1, 1}, {5, y, 18}, grained(Ramp::stone, 3, 0.4));
    brush.box({-4, y - 1, 1}, {3, y, 15},
              [](glm::ivec3 v) { return shade(Ramp::roof, v.x % 2 == 0 ? 1 : 2); });
    brush.box({-3, y - 1, 16}, {2, y, 16}, plain(Ramp::roof, 1));
    brush.box({-4, y - 2, 5}, {3, y - 2, 5}, plain(Ramp::ink, 2));
    brush.box({-4, y - 2, 12}, {3, y - 2, 12}, plain(Ramp::ink, 2));
    brush.dot({2, y - 2, 9}, shade(Ramp::gold, 4));
    brush.box({-7, y - 6, 0}, {6, y - 2, 0}, grained(Ramp::stone, 4, 0.5));
    brush.box({7, y - 3, 14}, {7, y - 1, 14}, plain(Ramp::ink, 1));  // lantern
    brush.box({7, y - 3, 11}, {7, y - 3, 13}, plain(Ramp::gold, 5));
}

void chimney(Brush& brush) {
    brush.box({9, 4, 24}, {15, 10, 46}, [](glm::ivec3 v) {
        const bool joint = v.z % 3 == 0 || (v.x + v.y + (v.z / 3 % 2) * 2) % 4 == 0;
        return shade(Ramp::stone, joint ? 1 : 3);
    });
    brush.box({8, 3, 46}, {16, 11, 47}, grained(Ramp::stone, 4, 0.3));
    brush.erase({11, 6, 44}, {13, 8, 47});
    brush.box({11, 6, 43}, {13, 8, 43}, plain(Ramp::ink, 0));
}

}  // namespace

VoxelGrid cottage() {
    VoxelGrid grid;
    Brush brush(grid);
    walls(brush);
    gables(brush);
    chimney(brush);
    roof(brush);
    window(brush, -17, 10);
    window(brush, 11, 10);
    door(brush);
    // Ivy climbs the left corner.
    for (int z = 1; z < 26; ++z)
        for (int i = 0; i < 9 - z / 4; ++i)
            if (grain({i, z, 0}, 77) < 0.8 - z * 0.015)
                brush.dot({-kHalfX - 1, -kHalfY + 1 + i, z},
                          shade(Ramp::leaf, 1 + static_cast<int>(grain({i, z, 1}) * 4)));
    return grid;
}

}  // namespace voxprite::samples
