// Where `voxprite render --json` says that sockets show, against a projection worked out here from
// the angles alone, and a walk towards the eye through the voxels themselves.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/app/cli_program.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

struct Axes {
    glm::dvec3 right, up, forward;
};

// The command line's camera: the eye at -Y, positive yaw towards +X, positive pitch upward.
Axes axesOf(double yawDegrees, double pitchDegrees) {
    const double yaw = yawDegrees * std::numbers::pi / 180.0;
    const double pitch = pitchDegrees * std::numbers::pi / 180.0;
    const glm::dvec3 towardEye(std::sin(yaw) * std::cos(pitch), -std::cos(yaw) * std::cos(pitch),
                               std::sin(pitch));
    const glm::dvec3 right(std::cos(yaw), std::sin(yaw), 0.0);
    return {right, glm::cross(towardEye, right), -towardEye};
}

// Does a voxel stand between the point and the eye, the one around the point aside? In small steps.
bool hidden(const VoxelGrid& voxels, glm::dvec3 point, glm::dvec3 forward) {
    const glm::ivec3 own(glm::floor(point));
    for (double t = 0.004; t < 80.0; t += 0.01) {
        const glm::ivec3 voxel(glm::floor(point - forward * t));
        if (voxel != own && voxels.get(voxel) != 0) return true;
    }
    return false;
}

class CliSockets : public CommandLine {
  protected:
    Json sockets(const Document& document, const std::vector<std::string>& options) {
        const std::string path = file("model.voxprite");
        EXPECT_TRUE(saveDocument(path, document, GameProfile{}));
        std::vector<std::string> arguments{"render", path, "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        answer_ = result.json();
        return answer_.value("sockets", Json());
    }
    [[nodiscard]] const Json& answer() const { return answer_; }

  private:
    Json answer_;
};

TEST_F(CliSockets, ShowWhereAnIndependentProjectionHasThem) {
    Document document = documentOf(figure());
    const VoxelGrid& voxels = document.models[0].voxels;
    const IBox bounds = entityBounds(document);
    Random random(3);
    for (int k = 0; k < 60; ++k) {
        const auto within = [&](int axis) {
            return bounds.min[axis] - 3.0 + random.unit() * (bounds.size()[axis] + 6.0);
        };
        const double x = within(0), y = within(1);
        document.sockets.push_back(Socket{"s" + std::to_string(k), {{0, {x, y, within(2)}}}});
    }
    int seen = 0, compared = 0;
    for (const auto& [yaw, pitch, sigma] :
         {std::array{0.0, 0.0, 4.0}, {35.0, 25.0, 4.0}, {-120.5, 50.0, 7.0}, {90.0, -30.0, 1.0}}) {
        const Json listed =
            sockets(document, {"--yaw", std::to_string(yaw), "--pitch", std::to_string(pitch),
                               "--sigma", std::to_string(sigma), "--ortho"});
        ASSERT_EQ(listed.size(), document.sockets.size());
        const Axes axes = axesOf(yaw, pitch);
        const glm::dvec3 corner = glm::dvec3(bounds.min + bounds.size() / 2);
        const Json& first = answer()["lattice"]["first"];
        const int height = answer()["buffer"]["size"][1];
        for (std::size_t k = 0; k < listed.size(); ++k) {
            const glm::dvec3 point = document.sockets[k].positions[0].positionVoxels;
            EXPECT_EQ(listed[k]["name"], document.sockets[k].name);
            // Whole sigma: samples lie half a virtual pixel off the lattice corner, each in the
            // middle of its pixel.
            const double i = glm::dot(point - corner, axes.right) * sigma;
            const double j = glm::dot(point - corner, axes.up) * sigma;
            EXPECT_NEAR(listed[k]["px"][0], i - first[0].get<int>(), 0.05) << k;
            EXPECT_NEAR(listed[k]["px"][1], height - (j - first[1].get<int>()), 0.05) << k;

            // Where a hair's breadth decides, rays that are quantised may decide otherwise.
            const bool expected = !hidden(voxels, point, axes.forward);
            bool clear = true;
            for (const double aside : {-0.02, 0.02}) {
                clear = clear &&
                        hidden(voxels, point + axes.right * aside, axes.forward) != expected &&
                        hidden(voxels, point + axes.up * aside, axes.forward) != expected;
            }
            if (!clear) continue;
            ++compared;
            seen += expected ? 1 : 0;
            EXPECT_EQ(listed[k]["visible"], expected) << k << " at yaw " << yaw;
        }
    }
    EXPECT_GT(compared, 200);
    EXPECT_GT(seen, 50);
    EXPECT_LT(seen, compared - 20);
}

TEST_F(CliSockets, AFacesMiddleIsHiddenFromBehindAndItsVoxelsMiddleIsNot) {
    Document document = documentOf(solidBox({4, 4, 4}));
    document.sockets = {
        Socket{"face", {{0, {2.5, 0.0, 2.5}}}}, Socket{"behind", {{0, {2.5, 4.0, 2.5}}}},
        Socket{"first", {{0, {2.5, 0.5, 2.5}}}}, Socket{"second", {{0, {2.5, 1.5, 2.5}}}},
        Socket{"before", {{0, {2.5, -1e6, 2.5}}}}};
    const Json front = sockets(document, {});
    const std::vector<bool> expected{true, false, true, false, true};
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(front[k]["visible"], expected[k]) << front[k]["name"];
        EXPECT_EQ(front[k]["px"], front[0]["px"]);
    }
    const Json back = sockets(document, {"--yaw", "180"});
    EXPECT_EQ(back[0]["visible"], false);
    EXPECT_EQ(back[1]["visible"], true);
}

TEST_F(CliSockets, FollowTheFrameAndTheBackendAndTheLattice) {
    Document document = animationOf({solidBox({4, 4, 4}), solidBox({4, 4, 8})});
    document.sockets = {Socket{"tip", {{0, {2, 2, 4}}, {1, {2, 2, 8}}}}};
    const Json low = sockets(document, {"--sigma", "4"});
    const Json high = sockets(document, {"--sigma", "4", "--frame", "1"});
    EXPECT_NEAR(low[0]["px"][1].get<double>() - high[0]["px"][1].get<double>(), 16.0, 0.05);
    EXPECT_EQ(low[0]["px"][0], high[0]["px"][0]);
    EXPECT_EQ(sockets(document, {"--sigma", "4", "--backend", "gl"}), low);

    std::ofstream(file("lattice.json")) << answer()["lattice"].dump();
    EXPECT_EQ(sockets(document, {"--lattice", file("lattice.json")}), low);
    EXPECT_FALSE(sockets(document, {"--mode", "voxels"}).is_array());
}

TEST_F(CliSockets, AreNowhereWhenTheSpriteIsNotSeen) {
    Document document = documentOf(VoxelGrid{});
    document.sockets = {Socket{"hand", {{0, {1, 2, 3}}}}};
    const Json listed = sockets(document, {});
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_TRUE(listed[0]["px"].is_null());
    EXPECT_EQ(listed[0]["visible"], false);
    document.sockets.clear();
    EXPECT_EQ(sockets(document, {}), Json::array());
}

TEST_F(CliSockets, AreCarriedIntoTheOctreesFileAndBack) {
    Document document = documentOf(figure());
    document.sockets = {Socket{"hand", {{0, {12.5, 3.0, 20.0}}}}};
    const Json before = sockets(document, {"--yaw", "30"});
    const ProgramResult exported =
        run({"export", file("model.voxprite"), "-o", file("model.svo"), "--json"});
    ASSERT_EQ(exported.status, 0) << exported.err;
    EXPECT_EQ(exported.json()["sockets"], 1);
    const ProgramResult drawn = run({"render", file("model.svo"), "--json", "--yaw", "30"});
    EXPECT_EQ(drawn.json()["sockets"], before);
}

TEST_F(CliSockets, AreListedWithTheClips) {
    Document document = animationOf({solidBox({4, 4, 4}), solidBox({4, 4, 8})});
    document.clips = {Clip{"blink", 0, 1, 8.0, false, {50, 200}}};
    document.sockets = {Socket{"tip", {{0, {2, 2, 4}}, {1, {2, 2, 8}}}}};
    ASSERT_TRUE(saveDocument(file("model.voxprite"), document, GameProfile{}));
    const Json json = run({"inspect", file("model.voxprite"), "--json"}).json();
    EXPECT_EQ(json["clips"], Json::parse(R"([{"name": "blink", "first": 0, "last": 1,
                                              "seconds": 0.25, "loop": false}])"));
    EXPECT_EQ(json["sockets"], Json::parse(R"([{"name": "tip", "positions": 2}])"));
    const std::string text = run({"inspect", file("model.voxprite")}).out;
    EXPECT_NE(text.find("clips:  \"blink\"\n  sockets:  \"tip\""), std::string::npos) << text;
}

}  // namespace
}  // namespace voxprite::test
