#include "core/sprite/placed_entity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/sprite/camera.h"

namespace voxprite {
namespace {

using testing::HasSubstr;

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-12) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << ", " << a.y << ", " << a.z << " against " << b.x << ", " << b.y << ", " << b.z;
}

PlacedEntity place(const Entity& entity, const IBox& bounds) {
    return placeEntity(entity, bounds, GameProfile{});
}

// Row 2: at 128 cubed the seed's example, (64, 64, 64), stands 9 m beside it.
TEST(PlaceEntity, CentreStandsHalfTheHeightAboveABottomCentreAnchor) {
    Entity entity;
    entity.positionMetres = {10, 20, 30};
    const PlacedEntity placed = place(entity, {{0, 0, 0}, {128, 128, 128}});
    EXPECT_EQ(placed.anchor, glm::dvec3(64, 64, 0));
    expectNear(placed.centreMetres(), {10, 20 + 6.4, 30});
}

TEST(PlaceEntity, AnchorCountsFromTheBoundsCorner) {
    Entity entity;
    entity.anchorVoxels = glm::dvec3(-3, 5, 100);  // outside is allowed
    const PlacedEntity placed = place(entity, {{-10, 2, 4}, {10, 8, 40}});
    EXPECT_EQ(placed.anchor, glm::dvec3(7, 3, 96));
    EXPECT_EQ(placed.modelSize, glm::ivec3(20, 6, 36));
    expectNear(placed.worldFromVoxel(placed.anchor), entity.positionMetres);
    // Voxel z is the world's height, voxel y runs away from the viewer (-Z).
    expectNear(placed.worldFromVoxel(placed.anchor + glm::dvec3(1, 2, 3)), {0.1, 0.3, -0.2});
}

TEST(PlaceEntity, RotationAndScaleTurnAboutTheAnchor) {
    Entity entity;
    entity.positionMetres = {1, 2, 3};
    entity.yawDegrees = 90;
    entity.scale = 2;
    const PlacedEntity placed = place(entity, {{0, 0, 0}, {4, 4, 4}});
    expectNear(placed.worldFromVoxel(placed.anchor), entity.positionMetres);
    // +X turns to +Y (voxel), which is -Z in the world; twice as far.
    expectNear(placed.worldFromVoxel(placed.anchor + glm::dvec3(1, 0, 0)), {1, 2, 3 - 0.2});
    EXPECT_DOUBLE_EQ(placed.metresPerVoxel(), 0.2);
    EXPECT_DOUBLE_EQ(placed.radiusMetres(), std::sqrt(12.0) * 0.2);
}

TEST(EntityRotation, ExactQuartersCounterClockwise) {
    const auto turned = [](double yaw, double pitch, double roll, glm::dvec3 v) {
        Entity entity;
        entity.yawDegrees = yaw;
        entity.pitchDegrees = pitch;
        entity.rollDegrees = roll;
        return entityRotation(entity) * v;
    };
    EXPECT_EQ(turned(90, 0, 0, {1, 0, 0}), glm::dvec3(0, 1, 0));
    EXPECT_EQ(turned(0, 90, 0, {0, 1, 0}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(turned(0, 0, 90, {0, 0, 1}), glm::dvec3(1, 0, 0));
    // Roll first, then pitch, then yaw: z -> x -> x -> y.
    EXPECT_EQ(turned(90, 90, 90, {0, 0, 1}), glm::dvec3(0, 1, 0));
    EXPECT_EQ(turned(90, 90, 90, {0, 1, 0}), glm::dvec3(0, 0, 1));
}

TEST(ProxyCorners, TheModelsBoxAndOneVirtualPixel) {
    Entity entity;
    entity.scale = 2;
    const PlacedEntity placed = place(entity, {{0, 0, 0}, {4, 6, 8}});
    const auto corners = proxyCorners(placed, 4.0);
    // 0.1 / 4 m a virtual pixel; 0.2 m a voxel.
    expectNear(corners[0], {-0.4 - 0.025, 0 - 0.025, 0.6 + 0.025});
    expectNear(corners[1], {0.4 + 0.025, 0 - 0.025, 0.6 + 0.025});
    expectNear(corners[2], {-0.4 - 0.025, 0 - 0.025, -0.6 - 0.025});
    expectNear(corners[7], {0.4 + 0.025, 1.6 + 0.025, -0.6 - 0.025});
}

TEST(GroundClearance, InVirtualPixelsOfTheProfile) {
    GameProfile profile;
    profile.groundClearancePx = 2.0;
    EXPECT_DOUBLE_EQ(groundClearanceMetres(profile), 2.0 * 0.1 / 4.0);
}

TEST(PlacedEntityCheck, RefusesWhatCannotBeSeen) {
    const PlacedEntity good = place({}, {{0, 0, 0}, {4, 4, 4}});
    EXPECT_TRUE(validate(good));
    const auto broken = [&](auto change) {
        PlacedEntity entity = good;
        change(entity);
        const Status status = validate(entity);
        return status ? std::string() : status.error().message;
    };
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_NE(broken([&](PlacedEntity& e) { e.anchor.z = bad; }), "");
        EXPECT_NE(broken([&](PlacedEntity& e) { e.anchorMetres.x = bad; }), "");
        EXPECT_NE(broken([&](PlacedEntity& e) { e.scale = bad; }), "");
        EXPECT_NE(broken([&](PlacedEntity& e) { e.voxelSizeMetres = bad; }), "");
        EXPECT_NE(broken([&](PlacedEntity& e) { e.worldFromVoxelAxes[1][1] = bad; }), "");
    }
    EXPECT_NE(broken([](PlacedEntity& e) { e.scale = 0; }), "");
    EXPECT_NE(broken([](PlacedEntity& e) { e.scale = -1; }), "");
    EXPECT_NE(broken([](PlacedEntity& e) { e.modelSize.y = -1; }), "");
    // Row 6.
    EXPECT_THAT(broken([](PlacedEntity& e) { e.worldFromVoxelAxes[0] *= 2.0; }),
                HasSubstr("uniform"));
    EXPECT_THAT(broken([](PlacedEntity& e) { e.worldFromVoxelAxes[0] *= -1.0; }),
                HasSubstr("mirror"));
}

}  // namespace
}  // namespace voxprite
