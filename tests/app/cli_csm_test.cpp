// CSM text and coarser octrees through the command line.
#include <fstream>

#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/model/entity_voxels.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliCsm : public CommandLine {
  protected:
    std::string written(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::binary) << text;
        return file(name);
    }
    Json json(std::vector<std::string> arguments) const {
        arguments.push_back("--json");
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.json();
    }
};

TEST_F(CliCsm, GoesThroughEveryCommand) {
    const std::string model = written("m.csm", ">b 9 >hg 4 # two colours\n");
    const Json inspected = json({"inspect", model});
    EXPECT_EQ(inspected["format"], "csm");
    ASSERT_EQ(inspected["models"].size(), 1u);
    EXPECT_EQ(inspected["models"][0]["voxels"], 9);
    EXPECT_EQ(inspected["models"][0]["size"], Json({4, 4, 2}));

    for (const char* name : {"m.vox", "m.voxprite", "m.svo", "n.csm"}) {
        const Json converted = json({"convert", model, "-o", file(name)});
        EXPECT_EQ(converted["warnings"].size(), std::string(name) == "n.csm" ? 1u : 0u) << name;
        json({"convert", file(name), "-o", file("back.csm")});
        const auto expected = loadDocument(model);
        const auto back = loadDocument(file("back.csm"));
        ASSERT_TRUE(back) << name;
        const VoxelGrid was = flatten(expected->document, 0);
        const VoxelGrid is = flatten(back->document, 0);
        EXPECT_EQ(is.solidCount(), was.solidCount()) << name;
        const glm::ivec3 shift = is.bounds().min - was.bounds().min;
        was.forEachSolid(
            [&](glm::ivec3 v, std::uint8_t value) { EXPECT_EQ(is.get(v + shift), value) << name; });
    }
    EXPECT_EQ(contentOf(file("n.csm")), ">b 9\n>h [0 0 0 0 0 0 4 0]\n");
    EXPECT_EQ(json({"export", model, "-o", file("x.svo")})["verified"], true);
    EXPECT_EQ(json({"render", model, "--buffer", file("b.png")})["buffer"]["sha256"],
              json({"render", file("x.svo"), "--buffer", file("c.png")})["buffer"]["sha256"]);
}

TEST_F(CliCsm, ErrorsNameLineAndColumn) {
    const std::string model = written("bad.csm", "> [1 2 3 4\n   5 6 7 300]");
    const ProgramResult result = run({"inspect", model, "--json"});
    EXPECT_EQ(result.status, 1);
    const Json error = result.json()["error"];
    EXPECT_EQ(error["line"], 2);
    EXPECT_EQ(error["column"], 10);
    EXPECT_EQ(run({"render", model, "-o", file("o.png")}).err,
              "voxprite render: " + model +
                  ": line 2, column 10: a value above 255 has no voxel: 0 to 255\n");
}

TEST_F(CliCsm, LevelsDrawACoarserOctree) {
    ASSERT_TRUE(saveDocument(file("f.vox"), documentOf(figure()), GameProfile{}));
    const auto sprite = [&](const std::string& levels) {
        return json({"render", file("f.vox"), "--levels", levels, "--yaw", "25", "--pitch", "20"});
    };
    const Json fine = sprite("0");
    EXPECT_EQ(fine["buffer"]["sha256"],
              json({"render", file("f.vox"), "--yaw", "25", "--pitch", "20"})["buffer"]["sha256"]);
    int opaque = fine["buffer"]["opaque"];
    for (const char* levels : {"1", "2", "3"}) {
        const Json coarse = sprite(levels);
        // As dense on the screen, and covering at least as much.
        EXPECT_EQ(coarse["sigma_in_force"], fine["sigma_in_force"]);
        EXPECT_GT(coarse["buffer"]["opaque"], opaque) << levels;
        opaque = coarse["buffer"]["opaque"];
    }
    for (const char* wrong : {"-1", "17", "1.5"}) {
        EXPECT_EQ(run({"render", file("f.vox"), "--json", "--levels", wrong}).status, 2) << wrong;
    }
}

TEST_F(CliCsm, OctreeDepthCutsTheVoxelView) {
    ASSERT_TRUE(saveDocument(file("f.vox"), documentOf(figure()), GameProfile{}));
    const auto picture = [&](const std::string& depth, const std::string& backend) {
        const std::string name = file(depth + backend + ".png");
        json({"render", file("f.vox"), "-o", name, "--mode", "voxels", "--size", "96x96", "--yaw",
              "25", "--pitch", "20", "--octree-depth", depth, "--backend", backend});
        return *readPngFile(name);
    };
    std::size_t before = 96 * 96 + 1;
    for (const char* depth : {"2", "3", "4", "5", "16"}) {
        const Image cpu = picture(depth, "cpu");
        const Image gl = picture(depth, "gl");
        std::size_t opaque = 0;
        std::size_t different = 0;
        for (std::size_t k = 0; k < cpu.pixels.size(); ++k) {
            opaque += cpu.pixels[k].w != 0 ? 1 : 0;
            different += cpu.pixels[k] != gl.pixels[k] ? 1 : 0;
        }
        EXPECT_LE(opaque, before) << depth;  // finer is never more
        EXPECT_LE(different, 96 * 96 / 200) << depth;
        before = opaque;
    }
    EXPECT_GT(before, 100u);
}

}  // namespace
}  // namespace voxprite::test
