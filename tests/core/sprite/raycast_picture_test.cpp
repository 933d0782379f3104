// From the box through the octree to the light: small pictures cast ray by ray, against pictures
// drawn by hand.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "core/sprite/lit_palette.h"
#include "core/svo/bake.h"
#include "core/trace/raycast.h"
#include "tests/support/must.h"

namespace voxprite::test {
namespace {

constexpr Rgba8 kSky{10, 20, 30, 255};
constexpr double kAmbient = 0.2;

Palette twoColours() {
    Palette palette;
    palette.colours[1] = {200, 100, 50, 255};
    palette.colours[2] = {40, 240, 80, 255};
    return palette;
}

// Parallel rays that fall at 45 degrees onto front and top: through all points with y + z = c.
// A column for each voxel of x, a row for each half of c, the top row first.
std::vector<std::vector<Rgba8>> picture(const Octree& octree, int columns, int rows,
                                        glm::dvec3 towardLight, RaycastCounters& counters) {
    PaletteShader shader(twoColours());
    const glm::dvec3 along(0, 1, -1);
    const auto light8 = faceLight(glm::ivec3(along), towardLight, kAmbient);
    std::vector<std::vector<Rgba8>> pixels;
    for (int row = rows - 1; row >= 0; --row) {
        pixels.emplace_back();
        for (int column = 0; column < columns; ++column) {
            const glm::dvec3 through(column + 0.5, 0.0, 0.5 * row + 0.25);
            const RaycastHit hit =
                raycast(octree.view(), {through - along * 30.0, along}, {}, &counters);
            pixels.back().push_back(
                hit.hit ? shader.inLight(light8[hit.axis], Shading::multiply)[hit.value] : kSky);
        }
    }
    return pixels;
}

// . sky; a and A front and top of colour 1, b and B of colour 2, in these lights.
void expectPicture(const VoxelGrid& voxels, glm::dvec3 towardLight, int frontLight, int topLight,
                   const std::vector<std::string>& drawn) {
    const auto lit = [](Rgba8 colour, int light) {
        const auto channel = [&](int c) {
            return static_cast<std::uint8_t>((c * light + 127) / 255);
        };
        return Rgba8(channel(colour.x), channel(colour.y), channel(colour.z), 255);
    };
    const Palette palette = twoColours();
    const std::map<char, Rgba8> colours{{'.', kSky},
                                        {'a', lit(palette.colours[1], frontLight)},
                                        {'A', lit(palette.colours[1], topLight)},
                                        {'b', lit(palette.colours[2], frontLight)},
                                        {'B', lit(palette.colours[2], topLight)}};
    RaycastCounters counters;
    const auto pixels = picture(must(bake(voxels)), static_cast<int>(drawn[0].size()),
                                static_cast<int>(drawn.size()), towardLight, counters);
    for (std::size_t row = 0; row < drawn.size(); ++row)
        for (std::size_t column = 0; column < drawn[row].size(); ++column)
            EXPECT_EQ(pixels[row][column], colours.at(drawn[row][column]))
                << "row " << row << " column " << column;
    EXPECT_EQ(counters.guardReached, 0u);
}

constexpr glm::dvec3 kInFront{0, -0.6, 0.8};  // front 0.2 + 0.8 * 0.6 -> 173, top 0.84 -> 214

TEST(RaycastPicture, OfASolidRoot) {
    VoxelGrid cube;
    for (int k = 0; k < 8; ++k) cube.set({k & 1, k >> 1 & 1, k >> 2}, 1);
    expectPicture(cube, kInFront, 173, 214,
                  {"...", "AA.", "AA.", "AA.", "AA.", "aa.", "aa.", "aa.", "aa."});
    // By numbers: (200, 100, 50) at 173 of 255.
    RaycastCounters counters;
    EXPECT_EQ(picture(must(bake(cube)), 1, 1, kInFront, counters)[0][0], Rgba8(136, 68, 34, 255));
}

TEST(RaycastPicture, OfStairsInABrick) {
    // On the left one low step; on the right a high one of another colour behind it.
    VoxelGrid stairs;
    stairs.set({0, 0, 0}, 1);
    stairs.set({1, 0, 0}, 1);
    stairs.set({1, 1, 0}, 2);
    stairs.set({1, 1, 1}, 2);
    expectPicture(stairs, kInFront, 173, 214,
                  {"..", "..", ".B", ".B", ".b", ".b", "AA", "AA", "aa", "aa"});
}

TEST(RaycastPicture, OfNestedNodes) {
    // A wall of 8 behind a gap of empty nodes, with a window, and a single voxel before it.
    VoxelGrid wall;
    for (int x = 0; x < 8; ++x)
        for (int z = 0; z < 2; ++z)
            if (x != 5) wall.set({x, 7, z}, 2);
    wall.set({1, 0, 0}, 1);
    expectPicture(
        wall, kInFront, 173, 214,
        {"........", "BBBBB.BB", "BBBBB.BB", "bbbbb.bb", "bbbbb.bb", "bbbbb.bb", "bbbbb.bb",
         "........", "........", "........", "........", "........", "........", "........",
         "........", "........", "........", ".A......", ".A......", ".a......", ".a......"});
}

TEST(RaycastPicture, LightFromBehindLeavesTheAmbient) {
    VoxelGrid one;
    one.set({0, 0, 0}, 1);
    expectPicture(one, {0, 0.6, -0.8}, 51, 51, {"..", "A.", "A.", "a.", "a."});
}

TEST(RaycastPicture, OfNothingIsSky) {
    VoxelGrid none;
    expectPicture(none, kInFront, 173, 214, {"..", ".."});
}

}  // namespace
}  // namespace voxprite::test
