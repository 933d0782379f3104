// The depth rules, measured against the ground and against what perspective would truly show.
#include "core/sprite/sprite_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/sprite/composite.h"
#include "core/sprite/voxel_placement.h"
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

GameProfile profileWith(DepthRule rule) {
    GameProfile profile;
    profile.depth = rule;
    profile.minification = false;
    return profile;
}

struct Drawn {
    SpriteView view;
    SpriteBuffer buffer;
    std::vector<float> depths;

    Drawn(const Subject& subject, const PlacedEntity& entity, const Camera& camera,
          const GameProfile& profile, Rgba8 colour)
        : view(mustView(entity, camera, profile)),
          buffer(castSprite(subject.octree.view(), view.lattice, paint(colour))) {
        if (profile.depth == DepthRule::perPixel)
            depths = pixelDepths(view, subject.octree.view(), buffer);
    }
    [[nodiscard]] CompositeSprite sprite() const {
        return {&view, &buffer, depths.empty() ? nullptr : &depths};
    }
};

int countOf(const Image& image, Rgba8 colour) {
    return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

// The share of the sprite's screen pixels that the ground hides, the entity floating by the
// profile's clearance. Nothing of the model lies below the ground: all of it is wrong.
double hiddenByGround(const Subject& subject, const Camera& camera, const GameProfile& profile) {
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    constexpr Rgba8 red{255, 0, 0, 255};
    const Drawn drawn(subject, entity, camera, profile, red);
    const std::array<CompositeSprite, 1> sprites{drawn.sprite()};
    const Ground ground{entity.anchorMetres.y - groundClearanceMetres(profile), kGrass};
    const int all = countOf(composite(sprites, camera, kSky), red);
    const int shown = countOf(composite(sprites, camera, kSky, ground), red);
    return static_cast<double>(all - shown) / all;
}

// Row 19, with the conditions of its figures: sigma 4, 12 m away, voxels of 0.1 m.
struct GroundCase {
    const char* name;
    Subject subject;
    double leastHiddenByCentre;
};

std::vector<GroundCase> groundCases() {
    return {{"cube", solidBox({32, 32, 32}), 0.05},
            {"vehicle", solidBox({16, 40, 18}), 0.12},
            {"slab", solidBox({64, 64, 8}), 0.3},
            {"figure", figure(), 0.0005}};
}

Camera smallOrbit(double yaw, double pitch) {
    Camera camera = orbit(yaw, pitch, 12);
    camera.viewportPx = {256, 256};
    return camera;
}

TEST(GroundSafe, HidesNoPixelWhereCentreDepthHidesMany) {
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward})
        for (const GroundCase& one : groundCases()) {
            double worstCentre = 0.0;
            for (const double pitch : {15.0, 30.0})
                for (const double yaw : {0.0, 35.0}) {
                    const Camera camera = smallOrbit(yaw, pitch);
                    GameProfile profile = profileWith(DepthRule::centre);
                    profile.view = rule;
                    worstCentre =
                        std::max(worstCentre, hiddenByGround(one.subject, camera, profile));
                    profile.depth = DepthRule::groundSafe;
                    EXPECT_EQ(hiddenByGround(one.subject, camera, profile), 0.0) << one.name;
                    // Also without the clearance, which the seed cannot do without.
                    profile.groundClearancePx = 0.0;
                    EXPECT_EQ(hiddenByGround(one.subject, camera, profile), 0.0) << one.name;
                }
            EXPECT_GE(worstCentre, one.leastHiddenByCentre) << one.name;
            RecordProperty(std::string(one.name) + (rule == ViewRule::towardEntity ? "_t" : "_f"),
                           std::to_string(worstCentre * 100.0));
        }
}

TEST(GroundSafe, OrthographicCamerasToo) {
    for (const GroundCase& one : groundCases()) {
        Camera camera = smallOrbit(35, 25);
        camera.orthographic = true;
        camera.orthographicHeightMetres = 9.0;
        EXPECT_EQ(hiddenByGround(one.subject, camera, profileWith(DepthRule::groundSafe)), 0.0);
        if (std::string(one.name) != "figure") {  // too thin to need it
            EXPECT_GT(hiddenByGround(one.subject, camera, profileWith(DepthRule::centre)), 0.01);
        }
    }
}

TEST(GroundSafe, PullsNoFurtherThanItMust) {
    const Subject subject = solidBox({32, 32, 32});
    const GameProfile profile = profileWith(DepthRule::groundSafe);
    const Camera camera = orbit(30, 20, 12);
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    SpriteView view = mustView(entity, camera, profile);
    EXPECT_LT(view.depthMetres, view.planeDepthMetres);
    // Two virtual pixels of depth further away, the ground under the anchor would hide some.
    view.depthMetres += 2.0 * view.metresPerPx / std::tan(20.0 * 3.14159 / 180.0);
    const SpriteBuffer buffer =
        castSprite(subject.octree.view(), view.lattice, paint({255, 0, 0, 255}));
    const std::array<CompositeSprite, 1> sprites{CompositeSprite{&view, &buffer, nullptr}};
    const Image with = composite(sprites, camera, kSky, Ground{entity.anchorMetres.y, kGrass});
    EXPECT_LT(countOf(with, {255, 0, 0, 255}),
              countOf(composite(sprites, camera, kSky), {255, 0, 0, 255}));
}

TEST(GroundSafe, StaysAtTheCentreWithoutNeed) {
    const Subject subject = solidBox({8, 8, 64});
    const GameProfile profile = profileWith(DepthRule::groundSafe);
    // From below: the ground truly hides what stands on it.
    const SpriteView below =
        mustView(subject.centredAt(glm::dvec3(0.0), profile), orbit(0, -50, 12), profile);
    EXPECT_EQ(below.depthMetres, below.planeDepthMetres);
    // A bird, its anchor far below.
    Subject bird = solidBox({8, 8, 8});
    bird.entity.anchorVoxels = glm::dvec3(4, 4, -60);
    const SpriteView high =
        mustView(bird.centredAt(glm::dvec3(0.0), profile), orbit(0, 20, 12), profile);
    EXPECT_EQ(high.depthMetres, high.planeDepthMetres);
}

TEST(GroundSafe, NeverNearerThanTheProxyNorTheNearPlane) {
    const GameProfile profile = profileWith(DepthRule::groundSafe);
    // An anchor at the top: all of it hangs below the "ground".
    Subject hanging = solidBox({10, 20, 30});
    hanging.entity.anchorVoxels = glm::dvec3(5, 10, 30);
    hanging.entity.yawDegrees = 25;
    for (const double pitch : {40.0, 50.0}) {
        Camera camera = orbit(10, pitch, 6);
        const PlacedEntity entity = hanging.centredAt(glm::dvec3(0.0), profile);
        const SpriteView view = mustView(entity, camera, profile);
        double nearest = 1e9;
        for (const glm::dvec3 corner : proxyCorners(entity, view.sigmaInForce))
            nearest = std::min(nearest, camera.project(corner).depthMetres);
        EXPECT_NEAR(view.depthMetres, nearest, 1e-9);
        camera.nearMetres = nearest + 0.1;
        EXPECT_EQ(mustView(entity, camera, profile).depthMetres, camera.nearMetres);
    }
}

TEST(PixelDepths, AreThoseOfTheVoxelsFaces) {
    const Subject subject = figure();
    GameProfile profile = profileWith(DepthRule::perPixel);
    const Camera camera = orbit(40, 25, 12);
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        profile.view = rule;
        const PlacedEntity entity = subject.centredAt({0.5, 0.2, 0.1}, profile);
        const Drawn drawn(subject, entity, camera, profile, {255, 0, 0, 255});
        int hits = 0;
        for (std::size_t at = 0; at < drawn.depths.size(); ++at) {
            const std::uint32_t id = drawn.buffer.ids[at];
            if (id == kIdEmpty) {
                ASSERT_TRUE(std::isinf(drawn.depths[at]));
                continue;
            }
            ASSERT_GE(drawn.depths[at], static_cast<float>(drawn.view.depthMetres));
            if (id == kIdOutline) continue;
            ++hits;
            // Within the depths of the voxel's own corners.
            const glm::dvec3 voxel(test::voxelOf(id, subject.octree.size));
            double least = 1e9;
            double most = 0.0;
            for (unsigned octant = 0; octant < 8; ++octant) {
                const glm::dvec3 corner = voxel + glm::dvec3(octantCorner(octant));
                const double depth = camera.project(entity.worldFromVoxel(corner)).depthMetres;
                least = std::min(least, depth);
                most = std::max(most, depth);
            }
            ASSERT_GE(drawn.depths[at], least - 1e-4);
            ASSERT_LE(drawn.depths[at], most + 1e-4);
        }
        EXPECT_GT(hits, 1000);
    }
}

TEST(PixelDepths, AnOutlinePixelHasItsNearestNeighboursDepth) {
    const Subject subject = figure();
    const GameProfile profile = profileWith(DepthRule::perPixel);
    const Drawn drawn(subject, subject.centredAt(glm::dvec3(0.0), profile), orbit(40, 25, 12),
                      profile, {255, 0, 0, 255});
    const glm::ivec2 size = drawn.buffer.size;
    int checked = 0;
    for (int y = 1; y + 1 < size.y; ++y)
        for (int x = 1; x + 1 < size.x; ++x) {
            const auto index = [&](int column, int row) {
                return static_cast<std::size_t>(row * size.x + column);
            };
            if (drawn.buffer.ids[index(x, y)] != kIdOutline) continue;
            float nearest = 1e9f;
            for (const glm::ivec2 to :
                 {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
                if (drawn.buffer.ids[index(x + to.x, y + to.y)] >= kIdFirstVoxel)
                    nearest = std::min(nearest, drawn.depths[index(x + to.x, y + to.y)]);
            ASSERT_EQ(drawn.depths[index(x, y)], nearest);
            ++checked;
        }
    EXPECT_GT(checked, 100);
}

// Two neighbours on one ground: of the screen pixels where an entity is shown and an entity is
// truly seen (perspective rays through both octrees), how many show the wrong one?
double wrongNeighbour(const Subject& a, glm::dvec3 standsA, const Subject& b, glm::dvec3 standsB,
                      const Camera& camera, const GameProfile& profile) {
    const auto placed = [&](const Subject& subject, glm::dvec3 stands) {
        PlacedEntity entity = subject.placed(profile);
        entity.anchorMetres = stands;
        return entity;
    };
    const std::array<const Subject*, 2> subjects{&a, &b};
    const std::array<PlacedEntity, 2> entities{placed(a, standsA), placed(b, standsB)};
    const std::array<Rgba8, 2> colours{Rgba8(255, 0, 0, 255), Rgba8(0, 0, 255, 255)};
    const Drawn drawnA(a, entities[0], camera, profile, colours[0]);
    const Drawn drawnB(b, entities[1], camera, profile, colours[1]);
    const std::array<CompositeSprite, 2> sprites{drawnA.sprite(), drawnB.sprite()};
    const Image image = composite(sprites, camera, kSky);
    int both = 0;
    int wrong = 0;
    for (int y = 0; y < image.height; y += 2)
        for (int x = 0; x < image.width; x += 2) {
            if (image.at(x, y) == kSky) continue;
            const Camera::Ray ray = camera.rayThrough(glm::dvec2(x, y) + 0.5);
            double nearest = 1e9;
            std::size_t seen = 2;
            for (std::size_t which = 0; which < 2; ++which) {
                const PlacedEntity& entity = entities[which];
                const RaycastHit hit = raycast(subjects[which]->octree.view(),
                                               voxelPlacement(entity), {ray.origin, ray.direction});
                if (hit.hit && hit.t < nearest) {
                    nearest = hit.t;
                    seen = which;
                }
            }
            if (seen == 2) continue;
            ++both;
            if (image.at(x, y) != colours[seen]) ++wrong;
        }
    return static_cast<double>(wrong) / both;
}

TEST(DepthRules, NeighboursAgainstThePerspectiveTruth) {
    const Subject slab = solidBox({64, 64, 8});
    const Subject pillar = solidBox({8, 8, 30});
    Camera camera = orbit(20, 25, 14);
    camera.viewportPx = {256, 256};
    std::array<double, 3> wrong{};
    const std::array<DepthRule, 3> rules{DepthRule::centre, DepthRule::groundSafe,
                                         DepthRule::perPixel};
    for (std::size_t rule = 0; rule < 3; ++rule) {
        // All round the slab.
        for (const glm::dvec2 place : {glm::dvec2(4, 0), glm::dvec2(4, 3), glm::dvec2(0, 4),
                                       glm::dvec2(-4, 1), glm::dvec2(-2, -4), glm::dvec2(3, -4)})
            wrong[rule] += wrongNeighbour(slab, glm::dvec3(0.0), pillar, {place.x, 0, place.y},
                                          camera, profileWith(rules[rule])) /
                           6.0;
        RecordProperty("wrong_neighbour_percent_" + std::to_string(rule),
                       std::to_string(wrong[rule] * 100.0));
    }
    // One depth a sprite is wrong somewhere, pulled forward or not; a depth a pixel only at the
    // edges, where the parallel shapes differ from the true ones.
    EXPECT_LT(wrong[2], 0.01);
    EXPECT_LT(wrong[2], wrong[0]);
    EXPECT_LT(wrong[2], wrong[1]);
}

}  // namespace
}  // namespace voxprite
