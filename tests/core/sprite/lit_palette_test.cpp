#include "core/sprite/lit_palette.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "core/sprite/sprite_key.h"
#include "core/trace/lattice_caster.h"
#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

Light lightWith(double occlusion, double shadow) {
    Light light;
    light.ambient = 0.4;
    light.occlusion = occlusion;
    light.shadow = shadow;
    return light;
}

constexpr glm::ivec3 kAll{-1, -1, -1};  // rays down all axes: they see what looks up them

TEST(FaceLights, WithoutOcclusionAndShadowNothingIsCast) {
    const FaceLights lights = faceLights(kAll, glm::dmat3(1.0), lightWith(0.0, 0.0));
    EXPECT_FALSE(lights.rays.any());
    EXPECT_EQ(lights.open, faceLight(kAll, Light{}.towardLight, 0.4));
    EXPECT_EQ(lights.open, lights.shadowed);
    EXPECT_EQ(litPalette(Palette::standard(), lights, {}),
              litPalette(Palette::standard(), lights.open, {}));
}

// Shadow takes from what the light gives, never from the ambient; occlusion from both.
TEST(FaceLights, ShadowLeavesTheAmbientLight) {
    for (const double shadow : {0.25, 0.7, 1.0}) {
        const Light light = lightWith(0.0, shadow);
        const FaceLights lights = faceLights(kAll, glm::dmat3(1.0), light);
        const glm::dvec3 toward = glm::normalize(light.towardLight);
        for (int axis = 0; axis < 3; ++axis) {
            const double direct = 0.6 * toward[axis];
            EXPECT_NEAR(lights.of(axis, {0, false}), 255 * (0.4 + direct), 0.51);
            EXPECT_NEAR(lights.of(axis, {0, true}), 255 * (0.4 + (1 - shadow) * direct), 1.01);
        }
        EXPECT_EQ(lights.rays.towardLight, shadowDirection(light.towardLight));
    }
    // Faces that look away have nothing to lose.
    const FaceLights behind = faceLights({1, 1, 1}, glm::dmat3(1.0), lightWith(0.0, 1.0));
    EXPECT_EQ(behind.open, behind.shadowed);
}

TEST(FaceLights, OcclusionTakesAQuarterALevel) {
    const FaceLights lights = faceLights(kAll, glm::dmat3(1.0), lightWith(0.8, 0.5));
    EXPECT_TRUE(lights.rays.occlusion);
    for (int axis = 0; axis < 3; ++axis) {
        for (int level = 0; level < kOcclusionLevels; ++level) {
            const double left = 1.0 - 204.0 / 255.0 * level / 4.0;
            for (const bool shadowed : {false, true}) {
                EXPECT_NEAR(lights.of(axis, {level, shadowed}),
                            lights.of(axis, {0, shadowed}) * left, 0.5001);
            }
        }
    }
}

TEST(FaceLights, TheLightTurnsWithTheVoxels) {
    const glm::dmat3 quarter{0, 1, 0, -1, 0, 0, 0, 0, 1};
    const FaceLights lights = faceLights(kAll, quarter, lightWith(0.0, 1.0));
    EXPECT_EQ(lights.rays.towardLight, shadowDirection(quarter * Light{}.towardLight));
    EXPECT_NE(lights.rays.towardLight, shadowDirection(Light{}.towardLight));
}

TEST(LitPalette, HasARowForEachKindOfFace) {
    const Palette palette = Palette::standard();
    for (const auto& [occlusion, shadow, rows] :
         {std::tuple{0.0, 0.0, 3U}, {0.5, 0.0, 12U}, {0.0, 0.5, 24U}, {0.5, 0.5, 24U}}) {
        const FaceLights lights = faceLights(kAll, glm::dmat3(1.0), lightWith(occlusion, shadow));
        const LitPalette lit = litPalette(palette, lights, {});
        ASSERT_EQ(lit.faces.size(), rows);
        for (std::uint8_t axis = 0; axis < 3; ++axis) {
            for (unsigned state = 0; state < rows / 3; ++state) {
                const FaceShade shade{static_cast<int>(state % 4), state >= 4};
                const unsigned light = lights.of(axis, shade);
                const Rgba8 colour = palette.colours[77];
                EXPECT_EQ(lit.shade(77, axis, shade),
                          Rgba8((colour.x * light + 127) / 255, (colour.y * light + 127) / 255,
                                (colour.z * light + 127) / 255, 255));
            }
        }
    }
}

// Whatever a light does to a picture, it does to the number.
TEST(LitPalettes, AnotherLightIsAnotherNumber) {
    LitPalettes palettes;
    palettes.beginFrame();
    const Palette palette = Palette::standard();
    std::set<std::uint64_t> numbers;
    const auto number = [&](const Light& light, const glm::dmat3& axes) {
        return palettes.of(palette, faceLights(kAll, axes, light), {}).number;
    };
    const glm::dmat3 upright(1.0);
    // The same lights of faces, from two directions: only shadow rays tell them apart.
    const glm::dmat3 exchanged{0, 1, 0, 1, 0, 0, 0, 0, 1};
    Light even = lightWith(0.0, 0.0);
    even.towardLight = {-1.0, -2.0, 0.5};
    EXPECT_EQ(number(even, upright), number(even, exchanged));
    even.shadow = 0.5;
    EXPECT_NE(number(even, upright), number(even, exchanged));
    for (const double occlusion : {0.0, 0.3, 0.9}) {
        for (const double shadow : {0.0, 0.3, 0.9}) {
            numbers.insert(number(lightWith(occlusion, shadow), upright));
        }
    }
    EXPECT_EQ(numbers.size(), 9U);
    EXPECT_EQ(number(lightWith(0.3, 0.9), upright), number(lightWith(0.3, 0.9), upright));
}

// A sprite is its voxels' faces, each in the colour of its shade: and only colours change.
TEST(ShadedSprite, EveryPixelIsItsFaceInItsShade) {
    const test::Subject subject = test::figure();
    GameProfile profile;
    profile.light = lightWith(0.7, 0.8);
    const PlacedEntity placed = subject.centredAt({0, 0, 0}, profile);
    for (const glm::dvec2 angles : {glm::dvec2(30, 20), glm::dvec2(-140, 50), glm::dvec2(0, 0)}) {
        const SpriteView view =
            test::mustView(placed, test::orbit(angles.x, angles.y, 14.0), profile);
        const OctreeView octree = subject.octree.view();
        const LitPalette lit = litPalette(test::plainColours(), view.light8, profile.outline);
        const SpriteBuffer buffer = castSprite(octree, view.lattice, lit);
        const SpriteBuffer plain =
            castSprite(octree, view.lattice, test::plainPalette(view.light8.open));
        EXPECT_EQ(buffer.idsSha256(), plain.idsSha256());
        EXPECT_NE(buffer.sha256(), plain.sha256());
        const FaceShader shader(octree, lit.rays);
        std::set<std::pair<int, bool>> kinds;
        for (int row = 0; row < buffer.size.y; ++row)
            for (int column = 0; column < buffer.size.x; ++column) {
                const auto at = static_cast<std::size_t>(row * buffer.size.x + column);
                if (buffer.ids[at] < kIdFirstVoxel) continue;
                const LatticeHit hit = castLattice(
                    octree, rayOf(view.lattice, {buffer.first.x + column,
                                                 buffer.first.y + buffer.size.y - 1 - row}));
                const int side = view.lattice.D[hit.faceAxis] < 0 ? 1 : -1;
                const FaceShade shade = shader.shadeOf({hit.voxel, hit.faceAxis, side});
                kinds.emplace(shade.occlusion, shade.shadowed);
                ASSERT_EQ(buffer.colours[at], lit.shade(hit.material, hit.faceAxis, shade));
            }
        EXPECT_GE(kinds.size(), 3U);
        for (const int threads : {1, 3}) {
            EXPECT_EQ(castSprite(octree, view.lattice, lit, threads).sha256(), buffer.sha256());
        }
    }
}

}  // namespace
}  // namespace voxprite
