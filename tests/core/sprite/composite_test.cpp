// The picture of a scene: which sprite pixel shows at which screen pixel, and what hides what.
#include "core/sprite/composite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/core/sprite/subject.h"

namespace voxprite {
namespace {

using test::figure;
using test::mustView;
using test::orbit;
using test::paint;
using test::plainPalette;
using test::solidBox;
using test::Subject;

constexpr Rgba8 kSky{10, 20, 200, 255};
constexpr Rgba8 kGrass{10, 200, 20, 255};

GameProfile plainProfile() {
    GameProfile profile;
    profile.minification = false;
    return profile;
}

Image compose(const SpriteView& view, const SpriteBuffer& buffer, const Camera& camera,
              std::optional<Ground> ground = std::nullopt) {
    const std::array<CompositeSprite, 1> sprites{CompositeSprite{&view, &buffer, nullptr}};
    return composite(sprites, camera, kSky, ground);
}

// Pixels of the buffer (of those with this id's kind) that do not show in the middle of the place
// where they belong, found by projecting that place into the world and back.
int missing(const SpriteView& view, const SpriteBuffer& buffer, const Image& image,
            const Camera& camera, bool outline) {
    int lost = 0;
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column) {
            const auto at = static_cast<std::size_t>(row * buffer.size.x + column);
            const std::uint32_t id = buffer.ids[at];
            if (id == kIdEmpty || (id == kIdOutline) != outline) continue;
            const glm::dvec2 pixel{buffer.first.x + column + 0.5,
                                   buffer.first.y + buffer.size.y - 1 - row + 0.5};
            const glm::dvec2 metres = (pixel - view.pixelFromCentre) * view.metresPerPx;
            const glm::dvec3 world = camera.eyeMetres + view.centreFromEyeMetres +
                                     view.right * metres.x + view.up * metres.y;
            const glm::ivec2 screen = glm::ivec2(glm::floor(camera.project(world).screenPx));
            if (screen.x < 0 || screen.y < 0 || screen.x >= image.width ||
                screen.y >= image.height || image.at(screen.x, screen.y) != buffer.colours[at])
                ++lost;
        }
    return lost;
}

// Row 7: the seed's box cuts outline pixels away, the quad none.
TEST(Proxy, TheQuadLosesNoPixelAndTheBoxDoes) {
    int boxLost = 0;
    int outlines = 0;
    for (const Subject& subject : {solidBox({16, 16, 16}), solidBox({10, 20, 6})})
        for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward})
            for (const double yaw : {0.0, 45.0, 70.0})
                for (const double pitch : {0.0, 35.26, 60.0}) {
                    GameProfile profile = plainProfile();
                    profile.view = rule;
                    const Camera camera = orbit(yaw, pitch, 4.5);
                    const PlacedEntity entity =
                        subject.centredAt(camera.right * 0.3 - camera.up * 0.2, profile);
                    SpriteView view = mustView(entity, camera, profile);
                    ASSERT_GT(view.screenPxPerPx, 3.0);
                    const SpriteBuffer buffer =
                        castSprite(subject.octree.view(), view.lattice, plainPalette());
                    const Image quad = compose(view, buffer, camera);
                    EXPECT_EQ(missing(view, buffer, quad, camera, true), 0);
                    EXPECT_EQ(missing(view, buffer, quad, camera, false), 0);
                    view.proxy = ProxyShape::box;
                    boxLost += missing(view, buffer, compose(view, buffer, camera), camera, true);
                    outlines += static_cast<int>(buffer.outlineCount());
                }
    const double share = static_cast<double>(boxLost) / outlines;
    RecordProperty("outline_lost_by_box_percent", std::to_string(share * 100.0));
    EXPECT_GT(share, 0.03);
}

TEST(Proxy, TheProfileChooses) {
    GameProfile profile = plainProfile();
    profile.proxy = ProxyShape::box;
    const PlacedEntity entity = figure().centredAt(glm::dvec3(0.0), profile);
    EXPECT_EQ(mustView(entity, orbit(0, 0, 12), profile).proxy, ProxyShape::box);
}

// Registration at the anchor: the feet stay on their place of the ground.
TEST(Registration, TheAnchorsPixelFallsOnTheAnchorsProjection) {
    Subject subject = figure();
    for (const bool orthographic : {false, true})
        for (const double step : {0.0, 30.0})
            for (const double yaw : {0.0, 33.0, 140.0}) {
                GameProfile profile = plainProfile();
                profile.viewStepDegrees = step;
                Camera camera = orbit(yaw, 30, 9);
                camera.orthographic = orthographic;
                const PlacedEntity entity = subject.centredAt({0.8, 0.5, -0.6}, profile);
                const auto anchorPixel = [&](const SpriteView& view) {
                    // Where the anchor lies in the parallel picture, in virtual pixels.
                    const glm::dvec3 fromCentre =
                        (entity.anchor - glm::dvec3(entity.modelSize) * 0.5) * 4.0;
                    return glm::dvec2(glm::dot(fromCentre, view.ortho.right),
                                      glm::dot(fromCentre, view.ortho.up));
                };
                const auto drawnAt = [&](const SpriteView& view) {
                    return test::pixelAt(view, camera,
                                         camera.project(entity.anchorMetres).screenPx);
                };
                const SpriteView centre = mustView(entity, camera, profile);
                profile.registration = Registration::anchor;
                const SpriteView anchor = mustView(entity, camera, profile);
                EXPECT_EQ(centre.lattice, anchor.lattice);  // no pixel changes, all are moved
                EXPECT_LT(glm::length(drawnAt(anchor) - anchorPixel(anchor)), 1e-8);
                if (!orthographic && step == 0.0) {
                    EXPECT_GT(glm::length(drawnAt(centre) - anchorPixel(centre)), 3.0);
                }
                EXPECT_LT(
                    glm::length(drawnAt(centre) - drawnAt(anchor) - anchor.registrationShiftPx),
                    1e-8);
            }
    // An anchor behind the eye has no projection: nothing is shifted.
    subject.entity.anchorVoxels = glm::dvec3(16, -500, 0);
    GameProfile profile = plainProfile();
    profile.registration = Registration::anchor;
    EXPECT_EQ(mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(0, 0, 12), profile)
                  .registrationShiftPx,
              glm::dvec2(0.0));
}

TEST(Composite, NearerSpritesHideFartherOnesWhateverTheOrder) {
    const GameProfile profile = plainProfile();
    const Camera camera = orbit(0, 0, 12);
    const Subject box = solidBox({10, 10, 10});
    const SpriteView nearView = mustView(box.centredAt({0, 0, 2}, profile), camera, profile);
    const SpriteView farView = mustView(box.centredAt({0.2, 0, -2}, profile), camera, profile);
    const Rgba8 red{255, 0, 0, 255};
    const Rgba8 blue{0, 0, 255, 255};
    const SpriteBuffer nearBuffer = castSprite(box.octree.view(), nearView.lattice, paint(red));
    const SpriteBuffer farBuffer = castSprite(box.octree.view(), farView.lattice, paint(blue));
    const CompositeSprite near{&nearView, &nearBuffer, nullptr};
    const CompositeSprite far{&farView, &farBuffer, nullptr};
    const Image one = composite(std::array{near, far}, camera, kSky);
    EXPECT_EQ(one, composite(std::array{far, near}, camera, kSky));
    EXPECT_EQ(one.at(256, 256), red);
    EXPECT_EQ(one.at(0, 0), kSky);
}

TEST(Composite, OfEqualDepthsTheEarlierStays) {
    const GameProfile profile = plainProfile();
    const Camera camera = orbit(0, 0, 12);
    const Subject box = solidBox({10, 10, 10});
    const SpriteView view = mustView(box.centredAt(glm::dvec3(0.0), profile), camera, profile);
    const Rgba8 red{255, 0, 0, 255};
    const Rgba8 blue{0, 0, 255, 255};
    const SpriteBuffer a = castSprite(box.octree.view(), view.lattice, paint(red));
    const SpriteBuffer b = castSprite(box.octree.view(), view.lattice, paint(blue));
    const CompositeSprite first{&view, &a, nullptr};
    const CompositeSprite second{&view, &b, nullptr};
    EXPECT_EQ(composite(std::array{first, second}, camera, kSky).at(256, 256), red);
    EXPECT_EQ(composite(std::array{second, first}, camera, kSky).at(256, 256), blue);
}

TEST(Composite, TheGroundReachesItsHorizonAndHidesWhatIsBelow) {
    GameProfile profile = plainProfile();
    profile.depth = DepthRule::centre;
    const Subject box = solidBox({10, 10, 10});
    for (const bool orthographic : {false, true}) {
        Camera camera = orbit(0, orthographic ? 30 : 0, 12);
        camera.orthographic = orthographic;
        const SpriteView view = mustView(box.centredAt({0, -2, 0}, profile), camera, profile);
        const SpriteBuffer buffer =
            castSprite(box.octree.view(), view.lattice, paint({255, 0, 0, 255}));
        const Image image = compose(view, buffer, camera, Ground{-1.0, kGrass});
        EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), Rgba8(255, 0, 0, 255)), 0);
        EXPECT_EQ(image.at(100, 511), kGrass);
        if (!orthographic) {
            // Looking level, the horizon is the middle row.
            EXPECT_EQ(image.at(100, 256), kGrass);
            EXPECT_EQ(image.at(100, 255), kSky);
        }
    }
    // From below the ground hides what is above it.
    const Camera mole = orbit(0, -30, 12);
    profile.depth = DepthRule::groundSafe;
    const SpriteView view = mustView(box.centredAt({0, 1, 0}, profile), mole, profile);
    const SpriteBuffer buffer =
        castSprite(box.octree.view(), view.lattice, paint({255, 0, 0, 255}));
    const Image image = compose(view, buffer, mole, Ground{0.0, kGrass});
    EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), Rgba8(255, 0, 0, 255)), 0);
}

TEST(VisibleLattice, HoldsEveryPixelOfTheScreenAndFewMore) {
    const Subject subject = figure();
    const GameProfile profile = plainProfile();
    for (const double yaw : {0.0, 30.0, 75.0}) {
        Camera camera = orbit(yaw, 20, 4.5);  // near: the figure is larger than the screen
        camera.verticalFovDegrees = 25;
        const PlacedEntity entity = subject.centredAt(camera.right * 0.7, profile);
        const SpriteView view = mustView(entity, camera, profile);
        const LatticeView visible = visibleLattice(view, camera);
        EXPECT_LT(visible.size.x * visible.size.y, view.lattice.size.x * view.lattice.size.y / 2);
        const SpriteBuffer whole = castSprite(subject.octree.view(), view.lattice, plainPalette());
        const SpriteBuffer part = castSprite(subject.octree.view(), visible, plainPalette());
        EXPECT_EQ(compose(view, whole, camera), compose(view, part, camera));
    }
    // Beside the screen nothing is cast.
    const Camera camera = orbit(0, 0, 12);
    const SpriteView aside = mustView(subject.centredAt({40, 0, 0}, profile), camera, profile);
    EXPECT_EQ(visibleLattice(aside, camera).size, glm::ivec2(0));
}

}  // namespace
}  // namespace voxprite
