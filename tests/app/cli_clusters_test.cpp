// `voxprite render --mode clusters`: the voxels as rays show them, or coarser within the budget.
#include <cmath>

#include "core/io/formats.h"
#include "core/io/png.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliClusters : public CommandLine {
  protected:
    void SetUp() override {
        ASSERT_TRUE(saveDocument(model(), documentOf(shellSphere(90)), GameProfile{}));
    }
    [[nodiscard]] std::string model() const { return file("ball.voxprite"); }

    Json render(const std::string& mode, const std::string& picture,
                std::vector<std::string> options) const {
        std::vector<std::string> arguments{"render", model(),   "--json",     "--mode", mode,
                                           "--size", "200x200", "--backend",  "gl",     "--pitch",
                                           "20",     "-o",      file(picture)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.json();
    }
    [[nodiscard]] double wrongPixels(const std::string& a, const std::string& b) const {
        return run({"compare", file(a), file(b), "--json"}).json()["mismatched"].get<double>();
    }
};

TEST_F(CliClusters, TheFinestAreThePixelsOfTheVoxels) {
    const Json exact = render("clusters", "clusters.png", {"--cluster-budget", "0"});
    render("voxels", "voxels.png", {});
    EXPECT_LE(wrongPixels("clusters.png", "voxels.png"), 200.0);  // of 40,000
    EXPECT_EQ(exact["mode"], "clusters");
    EXPECT_FALSE(exact.contains("buffer"));
    const Json& clusters = exact["clusters"];
    ASSERT_EQ(clusters["levels"].size(), 1U);
    EXPECT_EQ(clusters["levels"][0]["level"], 0);
    EXPECT_EQ(clusters["levels"][0]["clusters"], clusters["clusters"]);
    EXPECT_EQ(clusters["levels"][0]["triangles"], clusters["triangles"]);
    EXPECT_GT(clusters["all_clusters"], clusters["clusters"]);
    for (const char* part : {"build", "start", "draw"}) EXPECT_TRUE(exact["ms"].contains(part));
}

TEST_F(CliClusters, ALargerBudgetTakesFewerTriangles) {
    std::uint64_t before = ~std::uint64_t{0};
    for (const char* budget : {"0", "4", "16", "1000"}) {
        const Json clusters = render("clusters", "c.png", {"--cluster-budget", budget})["clusters"];
        EXPECT_LT(clusters["triangles"], before) << budget;
        before = clusters["triangles"].get<std::uint64_t>();
    }
    EXPECT_GT(before, 0U);
    render("clusters", "plain.png", {"--cluster-budget", "16"});
    render("clusters", "tinted.png", {"--cluster-budget", "16", "--tint-levels"});
    EXPECT_GT(wrongPixels("plain.png", "tinted.png"), 5000.0);
}

TEST_F(CliClusters, WhatCannotBeIsSaid) {
    const auto fails = [&](const std::vector<std::string>& options, const char* reason) {
        std::vector<std::string> arguments{"render",   model(), "--mode",
                                           "clusters", "-o",    file("c.png")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    };
    fails({}, "--backend gl");
    fails({"--backend", "cpu"}, "--backend gl");
    fails({"--backend", "gl", "--cluster-budget", "-1"}, "--cluster-budget");
    fails({"--backend", "gl", "--buffer", file("b.png")}, "--buffer");
}

}  // namespace
}  // namespace voxprite::test
