// voxprite bench where something fails: what was measured is printed.
#include <filesystem>

#include "core/io/formats.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

class BenchFailures : public CommandLine {};

TEST_F(BenchFailures, FiguresThatCannotBeKeptArePrinted) {
    std::filesystem::create_directory(file("folder"));
    const ProgramResult result =
        run({"bench", "--quick", "--only", "memory", "--json", "--keep", file("folder")});
    EXPECT_EQ(result.status, 1);
    const nlohmann::json report = result.json();
    EXPECT_GT(report.at("memory").size(), 4u);
    EXPECT_EQ(report.at("error").at("file"), file("folder"));
}

// At no sigma that there is does one voxel fill the picture.
TEST_F(BenchFailures, ModelsOfOneVoxelHaveAShade) {
    std::filesystem::create_directory(file("corpus"));
    ASSERT_TRUE(saveDocument(file("corpus/dot.vox"), documentOf(solidBox({1, 1, 1})), {}));
    const ProgramResult result =
        run({"bench", "--quick", "--only", "shade", "--corpus", file("corpus"), "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    int figures = 0;
    const nlohmann::json report = result.json();
    for (const nlohmann::json& figure : report.at("shade"))
        figures += figure.at("model") == "dot" ? 1 : 0;
    EXPECT_EQ(figures, 8);
}

}  // namespace
}  // namespace voxprite::test
