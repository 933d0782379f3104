// voxprite trade FILES -o DIR: what is asked for in another way, or cannot be done.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/io/formats.h"
#include "core/io/json_text.h"
#include "core/io/profile_json.h"
#include "tests/app/cli_program.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

class TradeChoices : public CommandLine {
  protected:
    std::string model(const std::string& name = "figure.vox") const {
        const std::string path = file(name);
        EXPECT_TRUE(saveDocument(path, documentOf(figure()), GameProfile{}));
        return path;
    }
    static nlohmann::json reportIn(const std::string& folder) {
        return nlohmann::json::parse(contentOf(folder + "/trade.json"));
    }
};

// A quick run of few settings, on the processor.
std::vector<std::string> quickly(const std::vector<std::string>& arguments,
                                 const std::string& axes) {
    std::vector<std::string> all{"trade"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"--quick", "--backend", "cpu", "--axes", axes});
    return all;
}

// Beside figures nothing would come of them.
TEST_F(TradeChoices, OptionsOfTheReportNeedOne) {
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--quick"},
          {"--seed", "2"},
          {"--costs"},
          {"--budget-error", "0.1", "--write-profile", file("never.json")}}) {
        std::vector<std::string> all{"trade", "--temporal", model()};
        all.insert(all.end(), more.begin(), more.end());
        EXPECT_EQ(run(all).status, 2) << more.front();
    }
    EXPECT_FALSE(std::filesystem::exists(file("never.json")));
}

TEST_F(TradeChoices, ABudgetSaysTheErrorThatItChoseBy) {
    const ProgramResult result = run(quickly(
        {model(), "-o", file("report"), "--budget-error", "1", "--yardstick", "perspective"},
        "mode"));
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("% off the perspective)"), std::string::npos) << result.out;
    // Against the exact sprite both modes are off by nothing.
    EXPECT_EQ(result.out.find("FLIP 0.0 %"), std::string::npos) << result.out;
}

// The virtual pixels of its own sigma would be smaller than the screen's.
TEST_F(TradeChoices, WhatIsDrawnAtAnotherSigmaSaysSo) {
    const std::string large = file("large.vox");
    ASSERT_TRUE(saveDocument(large, documentOf(solidBox({80, 80, 20})), GameProfile{}));
    const ProgramResult result = run(quickly({large, "-o", file("report"), "--markdown"}, "sigma"));
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("as the game has it, drawn at sigma 1 |"), std::string::npos)
        << result.out;
    EXPECT_NE(contentOf(file("report") + "/report.html").find("sigma 8, drawn at sigma 1<"),
              std::string::npos);
}

// A setting that cannot be drawn takes neither the others away nor the models after it.
TEST_F(TradeChoices, WhatCannotBeDrawnIsLeftOutAndNoted) {
    VoxelGrid apart;
    apart.set({0, 0, 0}, 1);
    apart.set({255, 255, 255}, 2);
    Document wide = documentOf(apart);
    wide.entity.scale = 2.0;  // at sigma 8 no buffer holds it
    GameProfile profile;
    profile.sigma = 1.0;
    profile.minification = false;
    ASSERT_TRUE(saveDocument(file("wide.voxprite"), wide, profile));
    ASSERT_TRUE(writeProfileFile(file("game.json"), profile));
    std::ofstream(file("way.json"))
        << R"({"voxprite_way": 1, "frames": [{"yaw": 10, "pitch": 20}, {"yaw": 12, "pitch": 20}]})";
    const std::string folder = file("report");
    const ProgramResult result =
        run(quickly({file("wide.voxprite"), model(), "-o", folder, "--profile", file("game.json"),
                     "--way", file("way.json"), "--json"},
                    "sigma"));
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json warnings = result.json().at("warnings");
    ASSERT_EQ(warnings.size(), 1u) << warnings;
    EXPECT_NE(warnings[0].get<std::string>().find("wide, sigma 8: "), std::string::npos);
    const nlohmann::json models = reportIn(folder).at("models");
    ASSERT_EQ(models.size(), 2u);
    EXPECT_EQ(models[0].at("skipped").at(0).at("name"), "sigma 8");
    EXPECT_EQ(models[0].at("points").size() + 1, models[0].at("settings"));
    EXPECT_EQ(models[1].at("points").size(), models[1].at("settings"));
    EXPECT_NE(contentOf(folder + "/report.html").find("sigma 8: "), std::string::npos);
}

// Names of files may hold any bytes. (And one named as the plots of growing costs are.)
TEST_F(TradeChoices, NamesNeedNotBeUtf8) {
    const std::string folder = file("o\xE9");
    const ProgramResult result =
        run(quickly({model("k\xE9<.vox"), model("costs.vox"), "-o", folder, "--json"}, "mode"));
    ASSERT_EQ(result.status, 0) << result.err;
    bool costs = false;
    const nlohmann::json report = result.json();
    for (const nlohmann::json& written : report.at("files")) {
        const std::string path = bytesFromJsonText(written.get<std::string>());
        EXPECT_TRUE(std::filesystem::exists(path)) << path;
        EXPECT_FALSE(std::filesystem::path(path).filename().string().starts_with("costs-f"));
        costs = costs || path.ends_with("costs-2-front.png");
    }
    EXPECT_TRUE(costs);
    const std::string page = contentOf(folder + "/report.html");
    EXPECT_EQ(jsonTextFromBytes(page), page);
    EXPECT_NE(page.find("<h2>k\uFFFD&lt;</h2>"), std::string::npos);
}

// The rival's walk and ours beside it are timed on the processor, as often as all else.
TEST_F(TradeChoices, EverySettingIsTimedAsOften) {
    const std::string folder = file("report");
    const ProgramResult result =
        run({"trade", model(), "-o", folder, "--quick", "--axes", "walk", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json points = reportIn(folder).at("models").at(0).at("points");
    EXPECT_EQ(points.size(), 3u);
    for (const nlohmann::json& point : points)
        EXPECT_EQ(point.at("sizes").at(0).at("costs").at("ms").at("runs"), 2) << point.at("name");
}

}  // namespace
}  // namespace voxprite::test
