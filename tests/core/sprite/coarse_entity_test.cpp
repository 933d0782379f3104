#include "core/sprite/coarse_entity.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/sprite/sprite_view.h"
#include "core/svo/coarsen.h"
#include "core/trace/lattice_caster.h"
#include "tests/core/sprite/subject.h"
#include "tests/support/must.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::must;

Entity turnedEntity() {
    Entity entity;
    entity.yawDegrees = 35.0;
    entity.pitchDegrees = -10.0;
    entity.rollDegrees = 5.0;
    entity.scale = 1.25;
    entity.positionMetres = {40.0, 2.0, -7.0};
    return entity;
}

Camera cameraToward(glm::dvec3 place) {
    Camera camera;
    camera.eyeMetres = place + glm::dvec3(3.0, 6.0, 25.0);
    camera.forward = glm::normalize(place - camera.eyeMetres);
    camera.right = glm::normalize(glm::cross(camera.forward, glm::dvec3(0, 1, 0)));
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

IBox boundsOf(const Octree& octree) {
    return {octree.origin, octree.origin + octree.size};
}

TEST(CoarseEntity, EveryVoxelLiesInItsCell) {
    test::Random random(21);
    for (int round = 0; round < 200; ++round) {
        const glm::ivec3 origin = random.voxel(-300, 300);
        const IBox bounds{origin, origin + random.voxel(1, 70)};
        const int levels = random.between(0, 5);
        const PlacedEntity fine = placeEntity(turnedEntity(), bounds, GameProfile{});
        const PlacedEntity coarse = coarseEntity(fine, origin, levels);
        const glm::ivec3 coarseOrigin = origin >> levels;
        for (const glm::ivec3 v : {bounds.min, bounds.max - 1}) {
            const glm::ivec3 cell = (v >> levels) - coarseOrigin;
            // A corner of the cell, by way of the fine model.
            const glm::ivec3 corner = ((v >> levels) << levels) - origin;
            EXPECT_LT(glm::distance(coarse.worldFromVoxel(glm::dvec3(cell)),
                                    fine.worldFromVoxel(glm::dvec3(corner))),
                      1e-11);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(cell[axis], 0);
                EXPECT_LT(cell[axis], coarse.modelSize[axis]);
            }
        }
        EXPECT_LT(glm::distance(coarse.centreMetres(), fine.centreMetres()), 1e-11);
        EXPECT_EQ(coarse.anchorMetres, fine.anchorMetres);
        EXPECT_TRUE(validate(coarse));
    }
}

TEST(CoarseEntity, HasTheSizeOfTheCoarseOctree) {
    for (const glm::ivec3 shift : {glm::ivec3(0), glm::ivec3(3, -5, 1), glm::ivec3(-1)}) {
        Octree octree = test::figure().octree;
        octree.origin = shift;
        const PlacedEntity fine = placeEntity(Entity{}, boundsOf(octree), GameProfile{});
        for (int levels = 0; levels <= 6; ++levels) {
            EXPECT_EQ(coarseEntity(fine, octree.origin, levels).modelSize,
                      must(coarsen(octree, levels)).size);
        }
    }
}

TEST(CoarseEntity, PlaneDepthAndPixelsAreThoseOfTheFineOne) {
    const IBox bounds{{-7, 3, 1}, {30, 24, 72}};
    const PlacedEntity fine = placeEntity(turnedEntity(), bounds, GameProfile{});
    const Camera camera = cameraToward(fine.anchorMetres);
    const SpriteView exact = *must(viewSprite(fine, camera, GameProfile{})).view;
    for (int levels = 1; levels <= 3; ++levels) {
        const PlacedEntity coarse = coarseEntity(fine, bounds.min, levels);
        const SpriteView view = *must(viewSprite(coarse, camera, GameProfile{})).view;
        EXPECT_NEAR(view.planeDepthMetres, exact.planeDepthMetres, 1e-11);
        EXPECT_EQ(view.metresPerPx, exact.metresPerPx);
        EXPECT_LT(glm::distance(view.centreFromEyeMetres, exact.centreFromEyeMetres), 1e-11);
        EXPECT_LT(glm::distance(view.right, exact.right), 1e-11);
        EXPECT_LT(glm::distance(view.up, exact.up), 1e-11);
        // The proxy box holds the fine one's.
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(view.boxHalfMetres[axis], exact.boxHalfMetres[axis] - 1e-12);
        }
    }
}

// What the eye ray through a screen position hits in the fine model, the coarse one covers.
TEST(CoarseEntity, CoversTheFineSprite) {
    const Octree octree = test::figure().octree;
    const PlacedEntity fine = placeEntity(turnedEntity(), boundsOf(octree), GameProfile{});
    const Camera camera = cameraToward(fine.anchorMetres);
    const auto viewOf = [&](const PlacedEntity& placed) {
        return *must(viewSprite(placed, camera, GameProfile{})).view;
    };
    const auto hitsAt = [&](const Octree& model, const SpriteView& view, glm::dvec2 screen) {
        const auto pixel = pixelUnder(view, camera, screen);
        return pixel && castLattice(model.view(), rayOf(view.lattice, *pixel)).material != 0;
    };
    const SpriteView exact = viewOf(fine);
    int covered = 0;
    int missed = 0;
    for (int levels = 1; levels <= 2; ++levels) {
        const Octree coarse = must(coarsen(octree, levels));
        const SpriteView view = viewOf(coarseEntity(fine, octree.origin, levels));
        for (int y = 0; y < camera.viewportPx.y; y += 5) {
            for (int x = 0; x < camera.viewportPx.x; x += 5) {
                const glm::dvec2 screen(x + 0.5, y + 0.5);
                if (!hitsAt(octree, exact, screen)) continue;
                ++(hitsAt(coarse, view, screen) ? covered : missed);
            }
        }
    }
    EXPECT_GT(covered, 200);
    // Samples of the two lie up to a virtual pixel apart, so that a few at the edge may differ.
    EXPECT_LT(missed, covered / 50);
}

}  // namespace
}  // namespace voxprite
