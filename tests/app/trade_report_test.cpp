// voxprite trade FILES -o DIR, as a script would use it.
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "tests/app/cli_program.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

class TradeReport : public CommandLine {
  protected:
    // A small model; few axes, so that it is quick.
    std::string model() const {
        const std::string path = file("figure.vox");
        EXPECT_TRUE(saveDocument(path, documentOf(figure()), GameProfile{}));
        return path;
    }
    std::vector<std::string> command(const std::string& folder,
                                     const std::vector<std::string>& more = {},
                                     const std::string& axes = "mode") const {
        std::vector<std::string> all{"trade",  model(), "-o",        folder, "--quick",
                                     "--axes", axes,    "--backend", "cpu"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    static nlohmann::json reportIn(const std::string& folder) {
        return nlohmann::json::parse(contentOf(folder + "/trade.json"));
    }
};

// Everything but times.
nlohmann::json withoutTimes(nlohmann::json report) {
    report.erase("machine");
    for (nlohmann::json& model : report["models"])
        for (nlohmann::json& point : model["points"]) {
            point.erase("ms");
            point.erase("front");
            for (nlohmann::json& size : point["sizes"]) {
                size["costs"].erase("ms");
                size["costs"].erase("prepare_ms");
            }
        }
    return report;
}

TEST_F(TradeReport, IsJsonTableAndPageWithPlots) {
    const std::string folder = file("report");
    const ProgramResult result = run(command(folder, {"--json"}, "sigma"));
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json printed = result.json();
    EXPECT_TRUE(printed.at("finished").get<bool>());
    const nlohmann::json report = reportIn(folder);
    EXPECT_EQ(report.at("schema"), "voxprite-trade");
    EXPECT_EQ(report.at("version"), 1);
    EXPECT_FALSE(report.at("program").at("commit").get<std::string>().empty());
    EXPECT_FALSE(report.at("machine").at("cpu").get<std::string>().empty());
    const nlohmann::json& points = report.at("models").at(0).at("points");
    EXPECT_EQ(points.size(), report.at("models").at(0).at("settings"));
    std::map<std::string, nlohmann::json> named;
    int onFront = 0;
    for (const nlohmann::json& point : points) {
        named[point.at("name")] = point;
        onFront += point.at("front").at("sprite").get<bool>() ? 1 : 0;
    }
    EXPECT_GE(onFront, 1);
    EXPECT_EQ(named.at("as the game has it").at("flip").at("sprite"), 0.0);
    EXPECT_LT(named.at("sigma 0.5").at("rays"), named.at("sigma 2").at("rays"));

    const std::string csv = contentOf(folder + "/trade.csv");
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
              points.size() + 1);
    const std::string head = csv.substr(0, csv.find('\n'));
    std::string row = csv.substr(csv.find('\n') + 1);
    row = row.substr(0, row.find('\n'));
    EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(row.begin(), row.end(), ','));

    const std::string page = contentOf(folder + "/report.html");
    EXPECT_NE(page.find("<svg"), std::string::npos);
    for (const char* outside : {"http://", "https://", "src=", "@import", "<script", "nan"})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    int pictures = 0;
    for (const nlohmann::json& written : printed.at("files")) {
        const std::string path = written.get<std::string>();
        ASSERT_TRUE(std::filesystem::exists(path)) << path;
        if (!path.ends_with(".png")) continue;
        ++pictures;
        EXPECT_GT(must(readPngFile(path)).width, 1000);
    }
    EXPECT_GE(pictures, 3);
}

TEST_F(TradeReport, IsTheSameAgainButForTimesAndAnotherWithAnotherSeed) {
    for (const char* folder : {"first", "again"}) ASSERT_EQ(run(command(file(folder))).status, 0);
    ASSERT_EQ(run(command(file("other"), {"--seed", "7"})).status, 0);
    const nlohmann::json first = withoutTimes(reportIn(file("first")));
    EXPECT_EQ(withoutTimes(reportIn(file("again"))), first);
    // The seed itself stands in the report.
    const auto withoutSeed = [](nlohmann::json report) {
        for (nlohmann::json& model : report.at("models")) {
            EXPECT_EQ(model.at("plan").erase("seed"), 1u);
        }
        return report;
    };
    EXPECT_NE(withoutSeed(withoutTimes(reportIn(file("other")))), withoutSeed(first));
}

// A turn and back again: what comes and goes is counted along the way that was recorded, and a
// still camera casts once.
TEST_F(TradeReport, GoesAlongARecordedWay) {
    const auto wayFile = [&](const char* name, const std::vector<double>& yaws) {
        nlohmann::json frames = nlohmann::json::array();
        for (const double yaw : yaws) frames.push_back({{"yaw", yaw}, {"pitch", 20}});
        const std::string path = file(name);
        std::ofstream(path) << nlohmann::json{{"voxprite_way", 1}, {"frames", frames}};
        return path;
    };
    const auto gameAlong = [&](const std::string& folder, const std::string& way) {
        EXPECT_EQ(run(command(file(folder), {"--way", way})).status, 0);
        const nlohmann::json model = reportIn(file(folder)).at("models").at(0);
        EXPECT_EQ(model.at("plan").at("recorded_frames"), 4);
        return model.at("points").at(0).at("sizes").at(0);
    };
    const nlohmann::json still = gameAlong("still", wayFile("still.json", {40, 40, 40, 40}));
    EXPECT_EQ(still.at("time").at("changed_a_degree"), 0.0);
    EXPECT_EQ(still.at("costs").at("casts"), 0.25);
    const nlohmann::json swing = gameAlong("swing", wayFile("swing.json", {40, 60, 40, 60}));
    EXPECT_GT(swing.at("time").at("changed_a_degree"), 0.0);
    // Every pixel that changed in the last two turns changed back.
    EXPECT_GT(swing.at("time").at("flips_a_degree"), 0.0);
    EXPECT_EQ(swing.at("costs").at("casts"), 0.5);

    for (const char* wrong : {"[]", R"({"voxprite_way": 1, "frames": [{"yaw": 1, "pitch": 2}]})",
                              R"({"voxprite_way": 2, "frames": []})",
                              R"({"voxprite_way": 1, "frames": [{"yaw": 1, "pitch": 91}, 0]})"}) {
        std::ofstream(file("wrong.json")) << wrong;
        const ProgramResult refused = run(command(file("none"), {"--way", file("wrong.json")}));
        EXPECT_EQ(refused.status, 1) << wrong;
        EXPECT_NE(refused.err.find("wrong.json"), std::string::npos) << refused.err;
    }
    EXPECT_FALSE(std::filesystem::exists(file("none")));
}

TEST_F(TradeReport, BudgetsChooseAndWriteAProfile) {
    const std::string profile = file("report/game.json");  // a folder that is made first
    const ProgramResult result =
        run(command(file("report"), {"--json", "--budget-error", "1", "--write-profile", profile}));
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json choice = result.json().at("choice");
    // Within an error of 1 there is everything, and the cheapest is the cheapest of all. (What the
    // two modes show is alike, but not what they cast.)
    double least = 1e300;
    const nlohmann::json report = reportIn(file("report"));
    for (const nlohmann::json& point : report.at("models").at(0).at("points"))
        least = std::min(least, point.at("ms").get<double>());
    EXPECT_EQ(choice.at("best").at("ms"), least);
    EXPECT_EQ(must(readProfileFile(profile)).sigma,
              choice.at("best_of_profile").at("setting").at("sigma").get<double>());

    const ProgramResult exact = run(command(file("report"), {"--json", "--budget-ms", "1e9"}));
    EXPECT_EQ(exact.json().at("choice").at("best").at("flip").at("sprite"), 0.0);

    // Nothing takes no time; nothing is written.
    const std::string none = file("none.json");
    const ProgramResult nothing =
        run(command(file("report"), {"--budget-ms", "0", "--write-profile", none}));
    EXPECT_EQ(nothing.status, 1);
    EXPECT_FALSE(std::filesystem::exists(none));
}

TEST_F(TradeReport, CtrlCKeepsWhatIsDone) {
    const std::string folder = file("report"), started = file("err");
    std::vector<std::string> arguments{"trade", model(), "-o", folder, "--backend", "cpu"};
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        std::freopen("/dev/null", "w", stdout);
        std::freopen(started.c_str(), "w", stderr);
        std::vector<char*> argv{const_cast<char*>(VOXPRITE_PROGRAM)};
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        execv(VOXPRITE_PROGRAM, argv.data());
        _exit(127);
    }
    // Once it says how far it is, it is measuring.
    int status = 0;
    while (contentOf(started).find('%') == std::string::npos) {
        ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "it ended: " << contentOf(started);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    kill(child, SIGINT);
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_NE(contentOf(started).find("stopped"), std::string::npos) << contentOf(started);
    const nlohmann::json report = reportIn(folder);
    EXPECT_FALSE(report.at("finished").get<bool>());
    EXPECT_LT(report.at("models").at(0).at("points").size(),
              report.at("models").at(0).at("settings").get<std::size_t>());
    EXPECT_TRUE(std::filesystem::exists(folder + "/report.html"));
}

TEST_F(TradeReport, SaysWhatIsWrong) {
    EXPECT_EQ(run({"trade", model()}).status, 2);
    EXPECT_EQ(run({"trade", "-o", file("x")}).status, 2);
    EXPECT_EQ(run({"trade", model(), "-o", file("x"), "--conformance"}).status, 2);
    EXPECT_EQ(
        run({"trade", model(), "-o", file("x"), "--budget-ms", "1", "--budget-error", "1"}).status,
        2);
    EXPECT_EQ(run({"trade", model(), "-o", file("x"), "--write-profile", "p.json"}).status, 2);
    EXPECT_EQ(run({"trade", model(), "-o", file("x"), "--axes", "colour"}).status, 2);
    EXPECT_EQ(run({"trade", file("none.vox"), "-o", file("x")}).status, 1);
    EXPECT_EQ(run({"trade", "-o", file("x"), "--costs", "--entity", "0"}).status, 2);
    EXPECT_FALSE(std::filesystem::exists(file("x")));
}

TEST_F(TradeReport, NumbersOutOfRangeAreWrongUsage) {
    for (const auto& [option, value] :
         std::vector<std::pair<std::string, std::string>>{{"--seed", "-1"},
                                                          {"--seed", "18446744073709551616"},
                                                          {"--seed", "1.5"},
                                                          {"--budget-error", "2.5"},
                                                          {"--budget-error", "-0.1"},
                                                          {"--budget-error", "nan"},
                                                          {"--budget-ms", "-1"},
                                                          {"--budget-ms", "inf"}}) {
        const ProgramResult refused = run(command(file("x"), {option + "=" + value}));
        EXPECT_EQ(refused.status, 2) << option << " " << value;
        EXPECT_NE(refused.err.find(option + ": "), std::string::npos) << refused.err;
    }
    EXPECT_FALSE(std::filesystem::exists(file("x")));
}

// Before anything is measured.
TEST_F(TradeReport, TheProfileReplacesNothingThatIsRead) {
    const std::string way = file("way.json");
    std::ofstream(way) << R"({"voxprite_way": 1, "frames": [{"yaw": 1, "pitch": 2}, )"
                          R"({"yaw": 3, "pitch": 2}]})";
    std::filesystem::create_symlink(model(), file("link.json"));
    std::filesystem::create_directory(file("folder.json"));
    const auto status = [&](const std::string& profile) {
        return run(command(file("x"),
                           {"--budget-error", "1", "--way", way, "--write-profile", profile}))
            .status;
    };
    const std::string before = contentOf(model());
    EXPECT_EQ(status(model()), 2);
    EXPECT_EQ(status(file("link.json")), 2);
    EXPECT_EQ(status(way), 2);
    EXPECT_EQ(status(""), 2);
    EXPECT_EQ(status(file("folder.json")), 1);
    EXPECT_EQ(status(file("none/game.json")), 1);
    EXPECT_EQ(contentOf(file("figure.vox")), before);
    EXPECT_FALSE(std::filesystem::exists(file("x/trade.json")));
}

}  // namespace
}  // namespace voxprite::test
