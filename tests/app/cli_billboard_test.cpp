// `voxprite render --mode billboard`: snapshots of both kinds, from both backends.
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/sprite/view_set.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliBillboard : public CommandLine {
  protected:
    void SetUp() override {
        ASSERT_TRUE(saveDocument(model(), documentOf(figure()), GameProfile{}));
    }
    [[nodiscard]] std::string model() const { return file("figure.vox"); }
    Json render(const std::vector<std::string>& options) const {
        std::vector<std::string> arguments{"render", model(), "--json", "--size", "200x160"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.json();
    }
    Json billboard(std::vector<std::string> options) const {
        options.insert(options.end(), {"--mode", "billboard"});
        return render(options);
    }
    [[nodiscard]] Image png(const std::string& name) const {
        const auto image = readPngFile(file(name));
        EXPECT_TRUE(image) << image.error().describe();
        return image ? *image : Image{};
    }
};

TEST_F(CliBillboard, SaysWhichViewWasTakenAndHowFarOffItIs) {
    const Json json = billboard({"--yaw", "33", "--pitch", "12", "-o", file("a.png")});
    EXPECT_EQ(json["mode"], "billboard");
    const Json& snapshots = json["snapshots"];
    EXPECT_EQ(snapshots["kind"], "seed");
    EXPECT_EQ(snapshots["view_set"], "canonical26");
    EXPECT_EQ(snapshots["views"], 26);
    EXPECT_EQ(snapshots["size_px"], 128);
    EXPECT_EQ(snapshots["depth"], "centre");
    EXPECT_EQ(snapshots["roll"], "matched");
    EXPECT_GE(snapshots["bytes"].get<int>(), 128 * 128 * 12);
    EXPECT_EQ(json["buffer"]["size"], Json({128, 128}));
    EXPECT_TRUE(json["ms"].contains("cast"));
    // yaw 33, pitch 12 is nearest to the view between -y and +x, 45 degrees round.
    const int view = snapshots["view"].get<int>();
    const glm::dvec3 direction = ViewSet().direction(view);
    EXPECT_NEAR(direction.x, 0.7071, 1e-4);
    EXPECT_NEAR(direction.y, -0.7071, 1e-4);
    EXPECT_NEAR(snapshots["degrees_off"].get<double>(), 16.94, 0.05);
    EXPECT_EQ(snapshots["shown"].size(), 1u);
}

TEST_F(CliBillboard, BothBackendsDrawTheSame) {
    for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
             {"--snapshots", "seed"},
             {"--snapshots", "seed", "--snapshot-depth", "pixel", "--ground"},
             {"--snapshots", "seed", "--snapshot-blend", "on", "--view-set", "octahedral:8"},
             {"--snapshots", "sprite", "--view-set", "hemisphere:12"},
             {"--snapshots", "sprite", "--snapshot-depth", "pixel", "--snapshot-roll", "own"}}) {
        std::vector<std::string> all{"--yaw", "25", "--pitch", "35", "-o", file("cpu.png")};
        all.insert(all.end(), options.begin(), options.end());
        const Json cpu = billboard(all);
        all[5] = file("gl.png");
        all.insert(all.end(), {"--backend", "gl"});
        const Json gl = billboard(all);
        EXPECT_EQ(cpu["snapshots"]["shown"], gl["snapshots"]["shown"]);
        const Image a = png("cpu.png");
        const Image b = png("gl.png");
        ASSERT_EQ(a.pixels.size(), b.pixels.size());
        int shown = 0;
        int other = 0;
        for (std::size_t at = 0; at < a.pixels.size(); ++at) {
            shown += a.pixels[at].w != 0 ? 1 : 0;
            const glm::ivec4 off = glm::abs(glm::ivec4(a.pixels[at]) - glm::ivec4(b.pixels[at]));
            other += std::max({off.x, off.y, off.z, off.w}) > 1 ? 1 : 0;
        }
        EXPECT_GT(shown, 1000);
        EXPECT_LE(other, shown / 200) << options[1];
    }
}

TEST_F(CliBillboard, SpritesAtAViewAreTheExactSprite) {
    for (const auto& [yaw, pitch] : {std::pair("0", "0"), std::pair("45", "0"),
                                     std::pair("-90", "45"), std::pair("180", "0")}) {
        for (const char* backend : {"cpu", "gl"}) {
            const std::vector<std::string> view{"--yaw", yaw,         "--pitch",
                                                pitch,   "--backend", backend};
            std::vector<std::string> exact = view;
            exact.insert(exact.end(), {"-o", file("exact.png")});
            std::vector<std::string> snapshot = view;
            snapshot.insert(snapshot.end(), {"--snapshots", "sprite", "-o", file("snapshot.png")});
            const Json a = render(exact);
            const Json b = billboard(snapshot);
            EXPECT_EQ(a["buffer"], b["buffer"]);
            EXPECT_EQ(a["lattice"], b["lattice"]);
            EXPECT_NEAR(b["snapshots"]["degrees_off"].get<double>(), 0.0, 1e-6);
            EXPECT_EQ(png("exact.png"), png("snapshot.png"));
        }
    }
}

TEST_F(CliBillboard, WhatIsNotSeenSaysWhy) {
    for (const char* kind : {"seed", "sprite"}) {
        const Json json = billboard({"--snapshots", kind, "--distance", "100000"});
        EXPECT_EQ(json["snapshots"]["unseen"], "sub_pixel") << kind;
        EXPECT_TRUE(json["snapshots"]["shown"].empty());
    }
    EXPECT_EQ(billboard({"--position", "0,0,1000"})["snapshots"].contains("unseen"), false);
}

TEST_F(CliBillboard, BlendingStandsAlone) {
    const auto shown = [&](const std::vector<std::string>& options) {
        return billboard(options)["snapshots"]["shown"].size();
    };
    EXPECT_GT(shown({"--snapshot-blend", "--yaw", "20"}), 1u);
    EXPECT_EQ(shown({"--snapshot-blend", "off", "--yaw", "20"}), 1u);
}

TEST_F(CliBillboard, WrongUsageIsSaid) {
    for (const std::vector<std::string>& options :
         std::vector<std::vector<std::string>>{{"--view-set", "octahedral:1"},
                                               {"--view-set", "ball"},
                                               {"--snapshots", "both"},
                                               {"--snapshot-size", "0"},
                                               {"--snapshot-size", "5000"},
                                               {"--snapshot-depth", "deep"},
                                               {"--snapshot-blend", "perhaps"}}) {
        std::vector<std::string> arguments{"render", model(), "--mode", "billboard", "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run(arguments).status, 2) << options[0] << ' ' << options[1];
    }
}

}  // namespace
}  // namespace voxprite::test
