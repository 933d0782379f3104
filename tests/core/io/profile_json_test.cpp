#include "core/io/profile_json.h"

#include <gtest/gtest.h>

namespace voxprite {
namespace {

GameProfile unusualProfile() {
    GameProfile profile;
    profile.voxelSizeMetres = 0.1 + 0.2;  // no short decimal
    profile.sigma = 7.5;
    profile.view = ViewRule::cameraForward;
    profile.registration = Registration::anchor;
    profile.proxy = ProxyShape::box;
    profile.depth = DepthRule::perPixel;
    profile.mode = SpriteMode::singlePass;
    profile.groundClearancePx = 0.0;
    profile.minification = false;
    profile.viewStepDegrees = 11.25;
    profile.outline = {false, Rgba8(255, 16, 1, 255)};
    profile.light = {0.125, {-1.0, 2.5, 1e-3}, 0.3, 0.7};
    profile.shading = Shading::palette;
    return profile;
}

std::string withField(const std::string& field) {
    return "{\"voxprite_profile\": 1, " + field + "}";
}

void expectError(const std::string& json, const std::string& part) {
    const auto profile = readProfile(json);
    ASSERT_FALSE(profile) << json;
    EXPECT_NE(profile.error().describe().find(part), std::string::npos)
        << profile.error().describe();
}

TEST(ProfileJson, ReadsBackEqual) {
    for (const GameProfile& profile : {GameProfile{}, unusualProfile()}) {
        const auto read = readProfile(writeProfile(profile));
        ASSERT_TRUE(read) << read.error().describe();
        EXPECT_EQ(*read, profile);
        EXPECT_EQ(writeProfile(*read), writeProfile(profile));
    }
}

TEST(ProfileJson, MissingFieldsKeepTheirDefaults) {
    const auto read = readProfile(withField("\"sigma\": 2, \"outline\": {\"enabled\": false}"));
    ASSERT_TRUE(read) << read.error().describe();
    GameProfile expected;
    expected.sigma = 2.0;
    expected.outline.enabled = false;
    EXPECT_EQ(*read, expected);
}

TEST(ProfileJson, NamesAreThoseOfTheCommandLine) {
    EXPECT_STREQ(nameOf(ViewRule::towardEntity), "toward_entity");
    EXPECT_STREQ(nameOf(Registration::modelCentre), "model_centre");
    EXPECT_STREQ(nameOf(ProxyShape::box), "box");
    EXPECT_STREQ(nameOf(DepthRule::groundSafe), "ground_safe");
    for (const ViewRule v : {ViewRule::cameraForward, ViewRule::towardEntity}) {
        EXPECT_EQ(viewRuleNamed(nameOf(v)).value(), v);
    }
    for (const Registration v : {Registration::modelCentre, Registration::anchor}) {
        EXPECT_EQ(registrationNamed(nameOf(v)).value(), v);
    }
    for (const ProxyShape v : {ProxyShape::quad, ProxyShape::box}) {
        EXPECT_EQ(proxyShapeNamed(nameOf(v)).value(), v);
    }
    for (const DepthRule v : {DepthRule::centre, DepthRule::groundSafe, DepthRule::perPixel}) {
        EXPECT_EQ(depthRuleNamed(nameOf(v)).value(), v);
    }
    for (const SpriteMode v : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
        EXPECT_EQ(spriteModeNamed(nameOf(v)).value(), v);
    }
    EXPECT_NE(depthRuleNamed("middle").error().message.find("ground_safe"), std::string::npos);
}

TEST(ProfileJson, SyntaxErrorsHaveLineAndColumn) {
    const auto profile = readProfile("{\n  \"voxprite_profile\": 1,\n  \"sigma\": x\n}");
    ASSERT_FALSE(profile);
    EXPECT_EQ(profile.error().line, 3);
    EXPECT_EQ(profile.error().column, 12);
    EXPECT_NE(profile.error().message.find("invalid literal"), std::string::npos)
        << profile.error().message;
    EXPECT_EQ(readProfile("").error().line, 1);
    EXPECT_EQ(readProfile("{\"voxprite_profile\": 1}\n}").error().line, 2);
}

TEST(ProfileJson, FieldErrorsNameTheField) {
    expectError("[]", "must be an object");
    expectError("{}", "\"voxprite_profile\" is missing");
    expectError("{\"voxprite_profile\": 2}", "newer version");
    expectError(withField("\"sigmma\": 2"), "unknown field \"sigmma\"");
    expectError(withField("\"sigma\": \"2\""), "sigma: must be a number");
    expectError(withField("\"sigma\": 0"), "sigma");
    expectError(withField("\"sigma\": -1"), "sigma");
    expectError(withField("\"sigma\": 65"), "sigma");
    expectError(withField("\"sigma\": 1e999"), "JSON: number overflow parsing '1e999'");
    expectError(withField("\"voxelSizeMetres\": 0"), "oxel");
    expectError(withField("\"minification\": 1"), "minification: must be true or false");
    expectError(withField("\"view\": \"sideways\""), "view: \"sideways\" is none of");
    expectError(withField("\"view\": 3"), "view: must be a text");
    expectError(withField("\"outline\": {\"colour\": \"red\"}"),
                "outline.colour: must be a colour");
    expectError(withField("\"outline\": {\"color\": \"#000000\"}"), "outline: unknown field");
    expectError(withField("\"light\": {\"towardLight\": [0, 1]}"),
                "light.towardLight: must be a list of 3");
    expectError(withField("\"light\": {\"towardLight\": [0, 1, true]}"),
                "light.towardLight[2]: must be a number");
    expectError(withField("\"light\": {\"towardLight\": [0, 0, 0]}"), "ight");
    expectError(withField("\"light\": {\"occlusion\": 1.5}"), "light.occlusion is 1.5");
    expectError(withField("\"light\": {\"shadow\": true}"), "light.shadow: must be a number");
}

TEST(ProfileJson, DeepNestingIsRefused) {
    const std::string deep(100000, '[');
    expectError(deep, "nested deeper");
}

TEST(ProfileJson, EveryTruncationIsAnError) {
    const std::string json = writeProfile(unusualProfile());
    for (std::size_t length = 0; length + 2 < json.size(); ++length) {
        EXPECT_FALSE(readProfile(json.substr(0, length))) << length;
    }
}

TEST(ProfileJson, EveryFlippedByteEndsInAnErrorOrAValidProfile) {
    const std::string json = writeProfile(unusualProfile());
    for (std::size_t at = 0; at < json.size(); ++at) {
        for (const int mask : {0x01, 0x80, 0xFF}) {
            std::string flipped = json;
            flipped[at] = static_cast<char>(flipped[at] ^ mask);
            const auto read = readProfile(flipped);
            EXPECT_TRUE(!read || validate(*read)) << at;
        }
    }
}

}  // namespace
}  // namespace voxprite
