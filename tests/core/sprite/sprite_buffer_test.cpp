#include "core/sprite/sprite_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "core/sprite/sprite_key.h"
#include "core/sprite/sprite_outline.h"
#include "core/trace/packet_caster.h"
#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

using test::letterBlock;
using test::mustView;
using test::orbit;
using test::plainPalette;
using test::Subject;
using test::subjectFrom;
using test::textOf;

using Text = std::vector<std::string>;

SpriteView viewOf(const Subject& subject, const OrbitAngles& angles, double sigma,
                  ViewRule rule = ViewRule::cameraForward) {
    GameProfile profile;
    profile.sigma = sigma;
    profile.view = rule;
    profile.minification = false;
    const Camera camera = orbit(angles.yawDegrees, angles.pitchDegrees, 10.0, angles.rollDegrees);
    return mustView(subject.centredAt(glm::dvec3(0.0), profile), camera, profile);
}

// Ids are 32 bits, voxels of the largest models more; none may become "nothing" or "outline".
TEST(SpriteBuffer, NoVoxelHasTheNumberOfNothingOrOfTheOutline) {
    const glm::ivec3 size(1 << 16, 1 << 16, 2);
    EXPECT_EQ(voxelId({0, 0, 0}, size), kIdFirstVoxel);
    EXPECT_EQ(voxelId({(1 << 16) - 3, (1 << 16) - 1, 0}, size), 0xFFFF'FFFFu);
    EXPECT_EQ(voxelId({(1 << 16) - 2, (1 << 16) - 1, 0}, size), kIdFirstVoxel);
    EXPECT_EQ(voxelId({(1 << 16) - 1, (1 << 16) - 1, 0}, size), kIdFirstVoxel + 1);
    EXPECT_EQ(voxelId({0, 0, 1}, size), kIdFirstVoxel);
}

SpriteBuffer castFrom(const Subject& subject, const OrbitAngles& angles, double sigma,
                      ViewRule rule = ViewRule::cameraForward) {
    return castSprite(subject.octree.view(), viewOf(subject, angles, sigma, rule).lattice,
                      plainPalette());
}

class Orientation : public testing::TestWithParam<ViewRule> {
  protected:
    Text seen(const OrbitAngles& angles) {
        return textOf(castFrom(subject_, angles, 1.0, GetParam()), subject_.octree);
    }
    Subject subject_ = letterBlock();
};
INSTANTIATE_TEST_SUITE_P(BothRules, Orientation,
                         testing::Values(ViewRule::cameraForward, ViewRule::towardEntity));

TEST_P(Orientation, YawZeroShowsTheMinusYFaceUnmirrored) {
    EXPECT_EQ(seen({0, 0, 0}), (Text{".ooooo.",  //
                                     "o11111o",  //
                                     "o12221o",  //
                                     "o12111o",  //
                                     "o12211o",  //
                                     "o12111o",  //
                                     "o12111o",  //
                                     "o11111o",  //
                                     ".ooooo."}));
}

TEST_P(Orientation, YawNinetyShowsThePlusXFaceUnmirrored) {
    EXPECT_EQ(seen({90, 0, 0}), (Text{".ooooo.",  //
                                      "o11111o",  //
                                      "o13311o",  //
                                      "o13131o",  //
                                      "o13311o",  //
                                      "o13131o",  //
                                      "o13131o",  //
                                      "o11111o",  //
                                      ".ooooo."}));
}

TEST_P(Orientation, FromAboveTheYawSetsThePicturesUp) {
    EXPECT_EQ(seen({0, 90, 0}), (Text{".ooooo.",  //
                                      "o11111o",  //
                                      "o14411o",  //
                                      "o14411o",  //
                                      "o14111o",  //
                                      "o11111o",  //
                                      ".ooooo."}));
    EXPECT_EQ(seen({90, 90, 0}), (Text{".ooooo.",  //
                                       "o11111o",  //
                                       "o14441o",  //
                                       "o11441o",  //
                                       "o11111o",  //
                                       "o11111o",  //
                                       ".ooooo."}));
}

TEST(CameraForward, ClockwiseRollTurnsThePictureTheOtherWay) {
    const Subject subject = letterBlock();
    EXPECT_EQ(textOf(castFrom(subject, {0, 0, 90}, 1.0), subject.octree),
              (Text{".ooooooo.",  //
                    "o1111111o",  //
                    "o1211111o",  //
                    "o1212111o",  //
                    "o1222221o",  //
                    "o1111111o",  //
                    ".ooooooo."}));
}

TEST(SpriteBuffer, HashesOfATinySpriteWorkedOutByHand) {
    const Subject subject = test::solidBox({1, 1, 1});
    Palette palette;
    palette.colours[1] = Rgba8(200, 100, 50, 77);
    Outline outline;
    outline.colour = Rgba8(1, 2, 3, 255);
    // The -Y face is seen: 200 * 128 / 255 = 100.4 and so on.
    const LitPalette lit = litPalette(palette, {10, 128, 20}, outline);
    const SpriteBuffer buffer =
        castSprite(subject.octree.view(), viewOf(subject, {}, 1.0).lattice, lit);
    ASSERT_EQ(buffer.size, glm::ivec2(3, 3));
    ASSERT_EQ(buffer.first, glm::ivec2(-1, -1));
    // SHA-256 of nine RGBA values: empty and outline (1,2,3,255) by turns round (100,50,25,255).
    EXPECT_EQ(buffer.sha256(), "05e20216856611276e3ecb27ea9ae0836792cb7c17e83c818df5f922622fdbee");
    // SHA-256 of the little-endian words 0 1 0 1 2 1 0 1 0.
    EXPECT_EQ(buffer.idsSha256(),
              "2cec7b336a9283b10fe8e411cc6254f9ce15b8d0482fc366721edfd2e8a2695e");
    EXPECT_EQ(buffer.opaqueCount(), 1u);
    EXPECT_EQ(buffer.outlineCount(), 4u);
    EXPECT_EQ(buffer.image().at(1, 1), Rgba8(100, 50, 25, 255));
    EXPECT_EQ(buffer.image().at(1, 0), Rgba8(1, 2, 3, 255));
}

// An id per pixel is enough to say again what colour it has: the palette's, lit by one of three.
TEST(SpriteBuffer, ColoursAreTheVoxelsLitByOneOfThreeFaces) {
    const Subject subject = test::figure();
    const std::array<std::uint8_t, 3> light8{91, 173, 240};
    const Palette palette = test::plainColours();
    const LitPalette lit = plainPalette(light8);
    const SpriteBuffer buffer =
        castSprite(subject.octree.view(), viewOf(subject, {35, 25, 0}, 3.0).lattice, lit);
    std::array<bool, 3> used{};
    for (std::size_t at = 0; at < buffer.ids.size(); ++at) {
        if (buffer.ids[at] == kIdEmpty) {
            ASSERT_EQ(buffer.colours[at], Rgba8(0));
        } else if (buffer.ids[at] == kIdOutline) {
            ASSERT_EQ(buffer.colours[at], lit.outline.colour);
        } else {
            const glm::ivec3 voxel = test::voxelOf(buffer.ids[at], subject.octree.size);
            const Rgba8 plain = palette.colours[materialAt(subject.octree.view(), voxel)];
            bool found = false;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int light = light8[axis];
                const Rgba8 expected((plain.x * light + 127) / 255, (plain.y * light + 127) / 255,
                                     (plain.z * light + 127) / 255, 255);
                if (buffer.colours[at] == expected) found = used[axis] = true;
            }
            ASSERT_TRUE(found);
        }
    }
    EXPECT_TRUE(used[0] && used[1] && used[2]);
}

TEST(SpriteBuffer, ThreadsChangeNothing) {
    const Subject subject = test::figure();
    const LatticeView lattice = viewOf(subject, {70, 10, 0}, 4.0).lattice;
    const SpriteBuffer one = castSprite(subject.octree.view(), lattice, plainPalette(), 1);
    const SpriteBuffer many = castSprite(subject.octree.view(), lattice, plainPalette(), 5);
    EXPECT_EQ(one.sha256(), many.sha256());
    EXPECT_EQ(one.idsSha256(), many.idsSha256());
}

// The rule of the specification, said once more from the finished buffer alone.
void expectExactOutline(const SpriteBuffer& buffer, bool framed = true) {
    const auto opaque = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < buffer.size.x && y < buffer.size.y &&
               buffer.ids[static_cast<std::size_t>(y * buffer.size.x + x)] >= 2;
    };
    for (int y = 0; y < buffer.size.y; ++y)
        for (int x = 0; x < buffer.size.x; ++x) {
            const bool wanted = !opaque(x, y) && (opaque(x - 1, y) || opaque(x + 1, y) ||
                                                  opaque(x, y - 1) || opaque(x, y + 1));
            const bool is = buffer.ids[static_cast<std::size_t>(y * buffer.size.x + x)] == 1;
            ASSERT_EQ(wanted, is) << x << ", " << y;
            // Every hit has room for its outline.
            if (!framed) continue;
            if (x == 0 || y == 0 || x == buffer.size.x - 1 || y == buffer.size.y - 1) {
                ASSERT_FALSE(opaque(x, y)) << x << ", " << y;
            }
        }
}

TEST(Outline, IsExactlyTheEmptyCardinalNeighbours) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-180.0, 180.0);
    const Subject sparse = subjectFrom({9, 7, 8}, [](glm::ivec3 v) -> std::uint8_t {
        return (v.x * 7 + v.y * 5 + v.z * 3) % 11 == 0 ? 1 : 0;
    });
    for (const Subject& subject : {test::figure(), sparse, letterBlock()})
        for (const double sigma : {0.25, 1.0, 2.0, 3.0, 4.0, 7.5}) {
            expectExactOutline(castFrom(subject, {0, 0, 0}, sigma));
            expectExactOutline(castFrom(subject, {45, 90, 0}, sigma));
            expectExactOutline(
                castFrom(subject, {angle(random), angle(random) / 2, angle(random)}, sigma));
        }
}

// Noise whose pixels meet at every seam of four by four packets.
TEST(Outline, GoesOnFromPacketToPacket) {
    std::mt19937 random(5);
    const Subject noise = subjectFrom(
        {24, 24, 24}, [&](glm::ivec3) -> std::uint8_t { return random() % 50 == 0 ? 1 : 0; });
    LitPalette bare = plainPalette();
    bare.outline.enabled = false;
    for (const double sigma : {7.0, 7.5}) {
        const LatticeView lattice = viewOf(noise, {31, -22, 5}, sigma).lattice;
        ASSERT_GT(lattice.size.x, 3 * PacketHits::kEdge);
        ASSERT_GT(lattice.size.y, 3 * PacketHits::kEdge);
        const SpriteBuffer sprite = castSprite(noise.octree.view(), lattice, plainPalette());
        expectExactOutline(sprite);
        SpriteBuffer dilated = castSprite(noise.octree.view(), lattice, bare);
        EXPECT_EQ(dilated.outlineCount(), 0u);
        dilateOutline(dilated, plainPalette().outline.colour);
        EXPECT_EQ(dilated.ids, sprite.ids);
        EXPECT_EQ(dilated.colours, sprite.colours);
    }
}

TEST(Outline, IsDrawnIntoNothingElseWhateverTheWidth) {
    std::mt19937 random(29);
    for (int width = 1; width <= 200; width += width < 70 ? 1 : 13) {
        SpriteBuffer buffer;
        buffer.size = {width, 1 + width % 5};
        const auto count = static_cast<std::size_t>(buffer.size.x * buffer.size.y);
        const auto oneIn = 2 + random() % 20;
        for (std::size_t at = 0; at < count; ++at) {
            const bool hit = random() % oneIn == 0;
            buffer.ids.push_back(hit ? kIdFirstVoxel + static_cast<std::uint32_t>(at) : kIdEmpty);
            buffer.colours.push_back(hit ? Rgba8(1, 2, 3, 255) : Rgba8(0));
        }
        const SpriteBuffer before = buffer;
        dilateOutline(buffer, {10, 20, 30, 40});
        expectExactOutline(buffer, false);
        for (std::size_t at = 0; at < count; ++at) {
            const bool outline = buffer.ids[at] == kIdOutline;
            ASSERT_EQ(buffer.colours[at], outline ? Rgba8(10, 20, 30, 255) : before.colours[at]);
            ASSERT_EQ(buffer.ids[at], outline ? kIdOutline : before.ids[at]);
        }
    }
}

TEST(Outline, CanBeOff) {
    const Subject subject = letterBlock();
    LitPalette lit = plainPalette();
    lit.outline.enabled = false;
    const LatticeView lattice = viewOf(subject, {20, 20, 0}, 2.0).lattice;
    const SpriteBuffer bare = castSprite(subject.octree.view(), lattice, lit);
    SpriteBuffer dilated = bare;
    dilateOutline(dilated, plainPalette().outline.colour);
    EXPECT_EQ(bare.outlineCount(), 0u);
    EXPECT_EQ(dilated.sha256(),
              castSprite(subject.octree.view(), lattice, plainPalette()).sha256());
}

TEST(FaceLight, EachAxisShowsTheFaceTurnedToTheEye) {
    // Rays run +x, -y: the faces seen are -x and +y.
    const std::array<std::uint8_t, 3> light = faceLight({5, -3, 0}, {-1, 0, 0}, 0.2);
    EXPECT_EQ(light[0], 255);
    EXPECT_EQ(light[1], 51);  // 0.2 * 255
    EXPECT_EQ(light[2], 51);
    const auto slanted = faceLight({-1, -1, -1}, {3e200, 4e200, 0}, 0.0);
    EXPECT_EQ(slanted, (std::array<std::uint8_t, 3>{153, 204, 0}));
    // Lit from behind: ambient only.
    EXPECT_EQ(faceLight({1, 1, 1}, {1, 1, 1}, 0.5), (std::array<std::uint8_t, 3>{128, 128, 128}));
}

// Section 0: position and distance change no pixel under camera_forward.
TEST(SpriteBuffer, IndependentOfPositionAndDistance) {
    const Subject subject = test::figure();
    GameProfile profile;
    profile.view = ViewRule::cameraForward;
    profile.minification = false;
    const Camera camera = orbit(31, 17, 10);
    const auto cast = [&](glm::dvec3 centre) {
        const SpriteView view = mustView(subject.centredAt(centre, profile), camera, profile);
        return castSprite(subject.octree.view(), view.lattice, plainPalette()).sha256();
    };
    const std::string here = cast(glm::dvec3(0.0));
    for (const double away : {-4.0, 3.7, 100.0, 5000.0})
        EXPECT_EQ(cast(camera.forward * away + camera.right * (away * 0.2)), here) << away;
}

TEST(SpriteKey, EqualKeysOnlyForTheSamePixels) {
    const Subject subject = letterBlock();
    SpriteKey key{7, 0, viewOf(subject, {20, 20, 0}, 2.0).lattice, 5};
    const SpriteKey same = key;
    EXPECT_EQ(key, same);
    EXPECT_EQ(std::hash<SpriteKey>()(key), std::hash<SpriteKey>()(same));
    const auto differs = [&](auto change) {
        SpriteKey other = key;
        change(other);
        return !(other == key) && std::hash<SpriteKey>()(other) != std::hash<SpriteKey>()(key);
    };
    EXPECT_TRUE(differs([](SpriteKey& k) { ++k.modelRevision; }));
    EXPECT_TRUE(differs([](SpriteKey& k) { ++k.frame; }));
    EXPECT_TRUE(differs([](SpriteKey& k) { ++k.lattice.D.z; }));
    EXPECT_TRUE(differs([](SpriteKey& k) { ++k.lattice.size.y; }));
    EXPECT_TRUE(differs([](SpriteKey& k) { ++k.litPalette; }));
}

}  // namespace
}  // namespace voxprite
