// From a script to a picture: the text is read, rays are cast through the octree that it makes, and
// the sprite is drawn.
#include <gtest/gtest.h>

#include "core/io/csm_reader.h"
#include "core/sprite/sprite_buffer.h"
#include "core/trace/raycast.h"
#include "tests/support/must.h"

namespace voxprite {
namespace {

using test::must;

// A hall: a floor of one voxel, a pillar in each corner, made once and mirrored, and a lamp.
constexpr std::string_view kScript = R"(
# a quarter: 8 voxels an edge
>a  [[20 0 20 0 20 0 20 0] 0 [20 0 20 0 20 0 20 0] 0 [20 0 20 0 20 0 20 0] 0 [20 0 20 0 20 0 20 0] 0]
>aa [31 31 31 31 31 31 31 31]
>ab 31
>aaaaa 0       # 1/32 of it: a voxel of this model
|
> [<a 0 /y <a 0 /x <a 0 /xy <a 0]
>bgg [0 0 0 0 0 0 250 0]
)";

Octree octreeOf(std::string_view text) {
    return must(octreeFromCsm({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

TEST(CsmRaycast, RaysMeetWhatTheScriptSays) {
    // A wall of 4 cubed with one voxel out of its middle.
    const Octree octree = octreeOf(">a 9 >b 9 >c 9 >d 9 >da 0 >h [1 2 3 4 5 6 7 8]");
    ASSERT_EQ(octree.size, glm::ivec3(4));
    // Along +x at the height of the hole: through voxel (0, 2, 2) into (1, 2, 2).
    const RaycastHit through = raycast(octree.view(), {{-5.0, 2.5, 2.5}, {1, 0, 0}});
    ASSERT_TRUE(through.hit);
    EXPECT_EQ(through.voxel, glm::ivec3(1, 2, 2));
    EXPECT_EQ(through.value, 9);
    EXPECT_NEAR(through.t, 6.0, 1e-5);
    EXPECT_EQ(through.normal, glm::dvec3(-1, 0, 0));
    // From above onto the corner h: letter h is its highest voxel.
    const RaycastHit corner = raycast(octree.view(), {{3.5, 3.5, 10.0}, {0, 0, -1}});
    ASSERT_TRUE(corner.hit);
    EXPECT_EQ(corner.voxel, glm::ivec3(3, 3, 3));
    EXPECT_EQ(corner.value, 8);
    // From the far side letter e ... h are met first; past the model nothing is.
    EXPECT_EQ(raycast(octree.view(), {{9.0, 2.5, 3.5}, {-1, 0, 0}}).value, 6);
    EXPECT_FALSE(raycast(octree.view(), {{3.5, 0.5, 9.0}, {0, 0, -1}}).hit);
}

TEST(CsmRaycast, EveryRayDownMeetsTheTopOfItsColumn) {
    const Octree octree = octreeOf(kScript);
    int hits = 0;
    for (int x = 0; x < octree.size.x; ++x) {
        for (int y = 0; y < octree.size.y; ++y) {
            int top = octree.size.z - 1;
            while (top >= 0 && materialAt(octree.view(), {x, y, top}) == 0) --top;
            const RaycastHit hit = raycast(octree.view(), {{x + 0.5, y + 0.5, 100.0}, {0, 0, -1}});
            ASSERT_EQ(hit.hit, top >= 0) << x << " " << y;
            if (top < 0) continue;
            ++hits;
            EXPECT_EQ(hit.voxel, glm::ivec3(x, y, top));
            EXPECT_EQ(hit.value, materialAt(octree.view(), {x, y, top}));
            EXPECT_NEAR(hit.t, 100.0 - top - 1, 1e-4);
        }
    }
    EXPECT_GT(hits, 10);
}

TEST(CsmRaycast, TheSpriteShowsTheScriptsColours) {
    const Octree octree = octreeOf("> [1 2 3 4 5 6 7 8]");
    Palette palette;
    for (std::uint8_t i = 1; i <= 8; ++i) {
        palette.colours[i] = Rgba8(20 * i, 255 - 20 * i, 7 * i, 255);
    }
    // From the front, at yaw 0: b and f above a and e (y = 0), full light.
    OrthoView view;
    view.sigmaInForce = 1.0;
    const LatticeView lattice = must(quantiseView(view, octree.size));
    const SpriteBuffer sprite =
        castSprite(octree.view(), lattice, litPalette(palette, {255, 255, 255}, Outline{}), 1);
    std::vector<Rgba8> hits;
    for (std::size_t k = 0; k < sprite.ids.size(); ++k) {
        if (sprite.ids[k] >= kIdFirstVoxel) hits.push_back(sprite.colours[k]);
    }
    EXPECT_EQ(hits, (std::vector<Rgba8>{palette.colours[2], palette.colours[6], palette.colours[1],
                                        palette.colours[5]}));
}

}  // namespace
}  // namespace voxprite
