// voxprite bench: what its crowds count (never how long they take).
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "core/io/formats.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class Bench : public CommandLine {};

// 16 models, 8 turns, and sigma halved up to four times between the front row and the last.
constexpr int kMostDistinct = 16 * 8 * 5;

void checkStill(const Json& figure) {
    EXPECT_EQ(figure.at("rays"), 0) << figure;
    EXPECT_EQ(figure.at("casts"), 0) << figure;
    EXPECT_EQ(figure.at("castsReused"), figure.at("drawn")) << figure;
}

// Depths 5 and 6 in a quick run: shells and noise, down to the voxels and to two levels above.
TEST_F(Bench, RaysAtEveryDepthAgreeWithOpenGl) {
    const ProgramResult result = run({"bench", "--quick", "--only", "raycast", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    std::map<std::string, int> figures;
    const Json report = result.json();
    for (const Json& figure : report.at("raycast")) {
        const std::string by = figure.at("by").get<std::string>();
        ++figures[by];
        EXPECT_TRUE(figure.at("depth") == 5 || figure.at("depth") == 6) << figure;
        const int left = figure.at("depth").get<int>() - figure.at("maxDepth").get<int>();
        EXPECT_TRUE(left == 0 || left == 2) << figure;
        if (by == "gl") {
            EXPECT_EQ(figure.at("differing"), 0) << figure;
        }
        if (by == "cpu") {
            EXPECT_GT(figure.at("hits").get<double>(), 0.1) << figure;
            EXPECT_LT(figure.at("iterations_a_ray").get<double>(), 3 * 64) << figure;
        }
        if (by == "frame") {
            EXPECT_GT(figure.at("ms").get<double>(), 0.0) << figure;
        }
    }
    EXPECT_EQ(figures["gl"], 8);
    EXPECT_EQ(figures["frame"], 8);
    EXPECT_GE(figures["cpu"], 8);
}

// The same work in every run, so that what is counted of it can be compared.
TEST_F(Bench, HotLoopsDoTheSameWorkInEveryRun) {
    std::vector<std::map<std::string, int>> runs;
    for (int n = 0; n < 2; ++n) {
        const ProgramResult result = run({"bench", "--quick", "--only", "loops", "--json"});
        ASSERT_EQ(result.status, 0) << result.err;
        const Json report = result.json();
        // Counters, or why there are none.
        const Json& counters = report.at("machine").at("counters");
        EXPECT_TRUE(counters == true || counters.is_string()) << counters;
        std::map<std::string, int>& counts = runs.emplace_back();
        for (const Json& figure : report.at("loops")) {
            counts[figure.at("loop").get<std::string>()] = figure.at("count").get<int>();
            EXPECT_EQ(figure.contains("instructions_per_" + figure.at("unit").get<std::string>()),
                      counters == true)
                << figure;
        }
        EXPECT_EQ(counts.size(), 6u);
        EXPECT_EQ(counts["packet_cast"], 256 * 256);
        EXPECT_EQ(counts["bake"], counts["naive_bake"]);
    }
    EXPECT_EQ(runs[0], runs[1]);
}

TEST_F(Bench, CrowdsAreOneDrawAndCastOnlyWhatIsNew) {
    // A model of one voxel, too: at no sigma that there is does it fill the picture.
    std::filesystem::create_directory(file("corpus"));
    ASSERT_TRUE(saveDocument(file("corpus/dot.vox"), documentOf(solidBox({1, 1, 1})), {}));
    const ProgramResult result =
        run({"bench", "--quick", "--only", "frame", "--corpus", file("corpus"), "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    std::set<std::tuple<std::string, std::string, std::string>> ways;
    int oneSprite = 0;
    std::map<int, int> drawnOf;  // ways, by how many entities
    const Json report = result.json();
    for (const Json& figure : report.at("frame")) {
        const std::string scene = figure.at("scene").get<std::string>();
        if (scene == "one_sprite") {
            ++oneSprite;
            EXPECT_NEAR(figure.at("screenPxPerPx").get<double>(), 8.0, 1e-9);
        }
        if (scene != "crowd") continue;
        const std::string mode = figure.at("mode").get<std::string>();
        const std::string view = figure.at("view").get<std::string>();
        const std::string camera = figure.at("camera").get<std::string>();
        ways.insert({mode, view, camera});
        const int entities = figure.at("entities").get<int>();
        if (figure.at("ms").is_null()) {
            // A slow machine leaves out large crowds alone.
            EXPECT_GT(entities, 100) << figure;
            EXPECT_FALSE(figure.at("skipped").get<std::string>().empty());
            continue;
        }
        ++drawnOf[entities];
        const int drawn = figure.at("drawn").get<int>();
        EXPECT_LE(drawn, entities);
        EXPECT_GE(drawn, entities * 9 / 10);
        if (mode == "seed") {
            EXPECT_EQ(figure.at("drawCalls"), drawn);
            // It draws what we draw; alone, at an exact view, its rays may miss all of it.
            if (entities > 1 && entities <= 100) {
                EXPECT_LT(figure.at("differing").get<double>(), 0.2) << figure;
            }
            EXPECT_GT(figure.at("rays"), 0);
            continue;
        }
        EXPECT_EQ(figure.at("drawCalls"), 1) << figure;
        if (mode == "single_pass") continue;
        if (camera == "still") checkStill(figure);
        if (view == "camera_forward") {
            EXPECT_LE(figure.at("firstCasts"), std::min(entities, kMostDistinct)) << figure;
        }
    }
    EXPECT_EQ(ways.size(), 2u * 2u * 2u + 2u);  // the rival knows one view
    EXPECT_EQ(oneSprite, 4);
    // With a view step, too, when the camera moves.
    for (const int entities : {1, 10, 100}) EXPECT_EQ(drawnOf[entities], 12) << entities;
}

// Each kind of shade alone changes a part of the pixels, and both together at least as many.
TEST_F(Bench, ShadeChangesAPartOfTheSprite) {
    const ProgramResult result = run({"bench", "--quick", "--only", "shade", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = result.json();
    std::map<std::string, double> changed;
    int views = 0;
    const Json sample = report.at("shade").at(0).at("model");  // others are of the corpus
    for (const Json& figure : report.at("shade")) {
        if (figure.at("model") != sample) continue;
        if (figure.at("scene") == "sprite") {
            changed[figure.at("shade").get<std::string>()] = figure.at("changed").get<double>();
        }
        views += figure.at("scene") == "voxels" ? 1 : 0;
    }
    EXPECT_EQ(changed.at("off"), 0.0);
    EXPECT_GT(changed.at("occlusion"), 0.02);
    EXPECT_LT(changed.at("occlusion"), 0.8);
    EXPECT_GT(changed.at("shadow"), 0.0);
    EXPECT_LT(changed.at("shadow"), 0.8);
    EXPECT_GE(changed.at("both"), std::max(changed.at("occlusion"), changed.at("shadow")));
    EXPECT_EQ(views, 4);
}

// What a budget promises is seen: nothing sticks out by more, nothing is missing, and more
// tolerance takes no more clusters.
TEST_F(Bench, ClustersKeepTheirBudgets) {
    const ProgramResult result = run({"bench", "--quick", "--only", "clusters", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = result.json();
    std::map<std::string, std::uint64_t> clusters;
    std::map<std::string, std::uint64_t> finest;
    int saved = 0;
    for (const Json& figure : report.at("clusters")) {
        const std::string model = figure.at("model").get<std::string>();
        if (figure.contains("level") && figure.at("level") == 0)
            finest[model] = figure.at("clusters").get<std::uint64_t>();
        if (!figure.contains("overhang_px")) continue;
        const double budget = figure.at("budget_px").get<double>();
        const auto count = figure.at("clusters").get<std::uint64_t>();
        // A pixel more, since those of both silhouettes are whole.
        EXPECT_LE(figure.at("overhang_px").get<double>(), budget + 1.0) << figure;
        EXPECT_LE(figure.at("missing_px").get<int>(), 2) << figure;
        if (budget == 0.0) {
            EXPECT_EQ(count, finest.at(model));
        } else {
            EXPECT_LE(count, clusters.at(model)) << figure;
            saved += count < clusters.at(model) ? 1 : 0;
        }
        clusters[model] = count;
    }
    EXPECT_GE(clusters.size(), 5u);
    EXPECT_GT(saved, 5);
}

}  // namespace
}  // namespace voxprite::test
