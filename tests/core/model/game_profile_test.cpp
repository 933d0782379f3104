#include "core/model/game_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace voxprite {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string messageFor(const std::function<void(GameProfile&)>& change) {
    GameProfile profile;
    change(profile);
    const Status status = validate(profile);
    return status ? "valid" : status.error().describe();
}

TEST(GameProfile, TheDefaultsAreValidAndAsDesigned) {
    const GameProfile profile;
    EXPECT_TRUE(validate(profile));
    EXPECT_EQ(profile.voxelSizeMetres, 0.1);
    EXPECT_EQ(profile.sigma, 4.0);
    EXPECT_EQ(profile.outline.colour, Rgba8(0, 0, 0, 255));
    EXPECT_EQ(profile.light.occlusion, 0.0);
    EXPECT_EQ(profile.light.shadow, 0.0);
}

TEST(GameProfile, MessagesNameFieldValueAndRange) {
    EXPECT_EQ(messageFor([](GameProfile& p) { p.sigma = 0; }),
              "sigma is 0; it must be between 1/64 and 64");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.voxelSizeMetres = -0.5; }),
              "voxelSizeMetres is -0.5; it must be between 1e-6 and 1e6 metres");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.light.ambient = 1.25; }),
              "light.ambient is 1.25; it must be between 0 and 1");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.light.towardLight.y = kNan; }),
              "light.towardLight.y is nan; it must be between -1e+06 and 1e+06");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.light.towardLight = glm::dvec3(0.0); }),
              "light.towardLight has no length; it must point toward the light");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.light.occlusion = -0.5; }),
              "light.occlusion is -0.5; it must be between 0 and 1");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.light.shadow = 2.0; }),
              "light.shadow is 2; it must be between 0 and 1");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.outline.colour.w = 128; }),
              "outline.colour has alpha 128; it must be 255");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.depth = static_cast<DepthRule>(3); }),
              "depth is no choice there is (3)");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.mode = static_cast<SpriteMode>(2); }),
              "mode is no choice there is (2)");
    EXPECT_EQ(messageFor([](GameProfile& p) { p.view = static_cast<ViewRule>(9); }),
              "view is no choice there is (9)");
}

TEST(GameProfile, EveryNumberHasARange) {
    struct Field {
        double& (*of)(GameProfile&);
        double lowest, highest;
    };
    const Field fields[] = {
        {[](GameProfile& p) -> double& { return p.voxelSizeMetres; }, 1e-6, 1e6},
        {[](GameProfile& p) -> double& { return p.sigma; }, 1.0 / 64, 64},
        {[](GameProfile& p) -> double& { return p.groundClearancePx; }, 0, 64},
        {[](GameProfile& p) -> double& { return p.viewStepDegrees; }, 0, 45},
        {[](GameProfile& p) -> double& { return p.light.ambient; }, 0, 1},
        {[](GameProfile& p) -> double& { return p.light.towardLight.x; }, -1e6, 1e6},
        {[](GameProfile& p) -> double& { return p.light.occlusion; }, 0, 1},
        {[](GameProfile& p) -> double& { return p.light.shadow; }, 0, 1},
    };
    for (const Field& field : fields) {
        const auto valid = [&](double value) {
            return messageFor([&](GameProfile& p) { field.of(p) = value; }) == "valid";
        };
        EXPECT_TRUE(valid(field.lowest));
        EXPECT_TRUE(valid(field.highest));
        EXPECT_FALSE(valid(std::nextafter(field.lowest, -kInfinity)));
        EXPECT_FALSE(valid(std::nextafter(field.highest, kInfinity)));
        EXPECT_FALSE(valid(kNan));
        EXPECT_FALSE(valid(kInfinity));
        EXPECT_FALSE(valid(-kInfinity));
    }
}

}  // namespace
}  // namespace voxprite
