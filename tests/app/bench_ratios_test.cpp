// voxprite bench --against, --keep: ratios of figures, never how large those are.
#include <fstream>
#include <map>

#include "tests/app/cli_program.h"

namespace voxprite::test {
namespace {

class BenchRatios : public CommandLine {};

TEST_F(BenchRatios, AreThoseToTheKeptFiguresAndToTheRivals) {
    const std::string kept = file("figures.json");
    const ProgramResult first =
        run({"bench", "--quick", "--only", "bake", "--json", "--keep", kept});
    ASSERT_EQ(first.status, 0) << first.err;
    // Ordered: figures are told apart by their keys in the order that the bench has them in.
    nlohmann::ordered_json figures = nlohmann::ordered_json::parse(contentOf(kept));
    EXPECT_EQ(figures.at("voxprite_figures"), 1);
    for (nlohmann::ordered_json& figure : figures.at("figures").at("bake")) {
        EXPECT_NE(figure.at("baker"), "naive");  // rivals are measured anew
        figure["ms"] = 2.0;
    }
    std::ofstream(kept) << figures;

    const ProgramResult second =
        run({"bench", "--quick", "--only", "bake", "--json", "--against", kept});
    ASSERT_EQ(second.status, 0) << second.err;
    const nlohmann::json report = second.json();
    std::map<std::string, double> naive;
    for (const nlohmann::json& figure : report.at("bake")) {
        if (figure.at("baker") != "naive" || figure.at("ms").is_null()) continue;  // not run
        naive[figure.at("model")] = figure.at("ms");
    }
    int compared = 0;
    ASSERT_EQ(report.at("ratios").size(), figures.at("figures").at("bake").size());
    for (const nlohmann::json& ratio : report.at("ratios")) {
        EXPECT_NEAR(ratio.at("to_kept").get<double>() * ratio.at("now").get<double>(), 2.0, 1e-9);
        if (ratio.at("rival") != "naive") continue;
        const std::string of = ratio.at("of").get<std::string>();  // the model first
        const double rival = naive.at(of.substr(0, of.find(", ")));
        EXPECT_NEAR(ratio.at("to_rival").get<double>() * ratio.at("now").get<double>(), rival,
                    1e-9 * rival);
        ++compared;
    }
    EXPECT_GT(compared, 0);
}

// Those of the repository can be read, and are of parts that the bench has.
TEST_F(BenchRatios, OfTheRepositoryAreThere) {
    const nlohmann::json kept = nlohmann::json::parse(
        contentOf(std::string(VOXPRITE_SOURCE_DIR) + "/tests/bench/figures.json"));
    EXPECT_EQ(kept.at("voxprite_figures"), 1);
    EXPECT_TRUE(kept.at("figures").contains("cast"));
    EXPECT_FALSE(kept.at("figures").at("cast").empty());
}

TEST_F(BenchRatios, NeedFiguresToCompareWith) {
    std::ofstream(file("other.json")) << "{}";
    EXPECT_EQ(run({"bench", "--quick", "--only", "bake", "--against", file("none.json")}).status,
              1);
    EXPECT_EQ(run({"bench", "--quick", "--only", "bake", "--against", file("other.json")}).status,
              1);
}

}  // namespace
}  // namespace voxprite::test
