// voxprite trade: every decision beats the specification's literal reading, and holds its promise.
#include <map>
#include <set>
#include <sstream>

#include "core/io/formats.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

class Trade : public CommandLine {};

TEST_F(Trade, OursKeepsItsPromiseAndTheLiteralReadingBreaksIt) {
    const ProgramResult result = run({"trade", "--conformance", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const nlohmann::json report = result.json();
    std::map<std::string, double> literal;
    std::set<int> rows;
    std::set<std::string> keys;
    for (const nlohmann::json& one : report.at("conformance")) {
        const std::string key = one.at("key").get<std::string>();
        EXPECT_TRUE(keys.insert(key).second) << key;
        rows.insert(one.at("row").get<int>());
        literal[key] = one.at("literal").get<double>();
        const double ours = one.at("ours").get<double>();
        const double promised = one.at("promised").get<double>();
        EXPECT_LE(ours, promised) << key;
        EXPECT_GT(one.at("literal").get<double>(), promised) << key;
        EXPECT_GE(ours, 0.0) << key;
        EXPECT_TRUE(one.at("held").get<bool>()) << key;
        EXPECT_FALSE(one.at("what").get<std::string>().empty());
        EXPECT_FALSE(one.at("unit").get<std::string>().empty());
        EXPECT_FALSE(one.at("how").get<std::string>().empty());
    }
    std::set<int> all;
    for (int row = 1; row <= 19; ++row) all.insert(row);
    EXPECT_EQ(rows, all);

    // Figures whose true value is known beforehand: the readings are the ones they claim to be.
    EXPECT_NEAR(literal.at("registration"), 3.2, 0.05);             // half of 64 voxels of 0.1 m
    EXPECT_NEAR(literal.at("anchor_to_center"), 9.0509668, 1e-6);   // 6.4 m along both axes
    EXPECT_NEAR(literal.at("camera_distance_30"), 13.39746, 1e-4);  // 1 - cos 30
    EXPECT_NEAR(literal.at("camera_distance_45"), 29.28932, 1e-4);  // 1 - cos 45
    EXPECT_NEAR(literal.at("entity_scale"), 50.0, 1e-9);
    EXPECT_NEAR(literal.at("orthographic"), 100.0 * 11 / 12, 1e-9);  // divided by 12 m
    EXPECT_NEAR(literal.at("minification"), 25.0, 3.0);
    EXPECT_NEAR(literal.at("depth_resolution"), 0.6, 0.02);
    EXPECT_NEAR(literal.at("view_off_mean"), 15.5, 0.3);
    EXPECT_NEAR(literal.at("view_off_worst"), 27.6, 0.5);
}

TEST_F(Trade, FiguresAreTheSameOnEveryRun) {
    EXPECT_EQ(run({"trade", "--conformance", "--json"}).out,
              run({"trade", "--conformance", "--json"}).out);
}

TEST_F(Trade, NothingBreaksAtTheExtremes) {
    const ProgramResult result = run({"trade", "--stability", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const nlohmann::json report = result.json();
    const std::string page = contentOf(VOXPRITE_SOURCE_DIR "/README.md");
    int bounded = 0;
    for (const nlohmann::json& sweep : report.at("stability")) {
        const std::string key = sweep.at("key").get<std::string>();
        EXPECT_EQ(sweep.at("failures"), 0) << key << ": " << sweep.at("first_failure");
        EXPECT_EQ(sweep.at("not_run"), "") << key;
        EXPECT_GT(sweep.at("cases").get<int>(), sweep.at("refused").get<int>()) << key;
        EXPECT_NE(page.find("| " + key + " | "), std::string::npos) << key;
        for (const nlohmann::json& figure : sweep.at("figures")) {
            EXPECT_NE(page.find(figure.at("what").get<std::string>()), std::string::npos);
            if (figure.at("promised").is_null()) continue;
            ++bounded;
            EXPECT_LE(figure.at("value").get<double>(), figure.at("promised").get<double>())
                << key << ", " << figure.at("key");
        }
    }
    EXPECT_EQ(report.at("stability").size(), 11u);
    EXPECT_GE(bounded, 23);
}

// The README shows the command's own table: what is new, or measured in another way, must be put
// there.
TEST_F(Trade, TheReadmeShowsWhatTheCommandPrints) {
    const std::string page = contentOf(VOXPRITE_SOURCE_DIR "/README.md");
    const ProgramResult printed = run({"trade", "--conformance", "--markdown"});
    EXPECT_EQ(printed.status, 0);
    std::istringstream lines(printed.out);
    int rows = 0;
    for (std::string line; std::getline(lines, line);) {
        // Row and what is measured: the figures may differ in the last digit on another machine.
        const bool cells = line.starts_with("| ");
        const std::string what =
            cells ? line.substr(0, line.find(" | ", line.find(" | ") + 1) + 3) : line;
        EXPECT_NE(page.find(what), std::string::npos) << what;
        rows += cells ? 1 : 0;
    }
    EXPECT_GE(rows, 29);
    // Rays are counts that people read.
    EXPECT_EQ(printed.out.find("e+"), std::string::npos);
}

// Without snapping every frame of a slow turn changes pixels, and trembling does; with a step a few
// do, and none.
TEST_F(Trade, SnappedViewsChangeInSteps) {
    const nlohmann::json report = run({"trade", "--temporal", "--json"}).json();
    std::map<double, double> offByStep;
    for (const nlohmann::json& row : report.at("temporal")) {
        const double step = row.at("viewStep").get<double>();
        const double frames = row.at("frames_changed").get<double>();
        offByStep[step] = row.at("off_the_exact").get<double>();
        if (step == 0.0) {
            EXPECT_GT(frames, 80.0);
            EXPECT_GT(row.at("frames_changed_trembling").get<double>(), 50.0);
            continue;
        }
        // A frame turns by 0.1 degrees: a step comes every step / 0.1 frames, in yaw and in pitch.
        EXPECT_LT(frames, 100.0 * (0.1 + 0.06) / step + 1.0) << step;
        if (step > 1.15) {
            EXPECT_EQ(row.at("frames_changed_trembling"), 0.0) << step;
        }
    }
    EXPECT_EQ(offByStep.at(0.0), 0.0);
    EXPECT_GT(offByStep.at(0.5), 0.0);
    EXPECT_GT(offByStep.at(2.5), 2.0 * offByStep.at(0.5));
    EXPECT_GT(offByStep.at(15.0), 2.0 * offByStep.at(2.5));
}

// The denser the set, the less unlike; in every distance. A snapshot of the seed's kind is unlike
// the sprite even where it is of the right view.
TEST_F(Trade, DenserSetsOfSnapshotsAreLessUnlike) {
    ASSERT_TRUE(saveDocument(file("arms.vox"), documentOf(asymmetric()), GameProfile{}));
    const nlohmann::json report = run({"trade", "--snapshots", "--json", file("arms.vox")}).json();
    std::map<std::string, nlohmann::json> sprites;
    for (const nlohmann::json& row : report.at("snapshots")) {
        ASSERT_EQ(row.at("distances").size(), 3u);
        EXPECT_GT(row.at("bytes").get<double>(), 1000.0 * row.at("views").get<int>());
        EXPECT_EQ(row.at("distances")[0].at("voxels").is_null(), row.at("kind") == "seed, blended");
        if (row.at("kind") == "sprite") sprites[row.at("view_set")] = row;
    }
    EXPECT_EQ(report.at("snapshots").size(), 10u);
    for (const char* measure : {"flip", "silhouette", "voxels"}) {
        for (const std::size_t distance : {0u, 1u, 2u}) {
            const auto of = [&](const char* set) {
                return sprites.at(set).at("distances")[distance].at(measure).get<double>();
            };
            EXPECT_GT(of("canonical26"), of("octahedral:12")) << measure;
            EXPECT_GT(of("octahedral:12"), of("octahedral:36")) << measure;
            EXPECT_GT(of("octahedral:36"), 0.0) << measure;
        }
    }
}

TEST_F(Trade, RepresentationsAreWorthWhatTheyShowAndCost) {
    const std::string model = std::string(VOXPRITE_SOURCE_DIR) + "/samples/letters.vox";
    const nlohmann::json report = run({"trade", "--representations", "--json", model}).json();
    std::map<std::string, nlohmann::json> rows;
    for (const nlohmann::json& row : report.at("representations")) {
        EXPECT_EQ(row.at("model"), "letters");
        ASSERT_EQ(row.at("sizes").size(), 6u);
        for (const nlohmann::json& at : row.at("sizes")) {
            EXPECT_EQ(at.at("error") == 0.0, row.at("drawn_by") == "exact sprite");
            EXPECT_LE(at.at("error").get<double>(), 1.0);
            EXPECT_GE(at.at("us").get<double>(), 0.0);
        }
        rows[row.at("drawn_by")] = row;
    }
    const auto near = [&](const char* kind) {
        return rows.at(kind).at("sizes")[5].at("error").get<double>();
    };
    EXPECT_LT(near("snapshot, 256 views"), near("snapshot, 64 views"));
    EXPECT_LT(near("snapshot, 64 views"), near("snapshot, 26 views"));
    EXPECT_LT(near("clusters"), near("coarser by 1"));
}

TEST_F(Trade, TurnsModelsOnlyOverTime) {
    EXPECT_EQ(run({"trade", "--temporal", "no_such.vox"}).status, 1);
    EXPECT_EQ(run({"trade", "--conformance", "no_such.vox"}).status, 2);
}

TEST_F(Trade, SaysWhatToMeasure) {
    EXPECT_EQ(run({"trade"}).status, 2);
    EXPECT_EQ(run({"trade", "--json"}).status, 2);
}

}  // namespace
}  // namespace voxprite::test
