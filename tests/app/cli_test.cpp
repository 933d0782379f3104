// The contract of the command line: exit statuses, messages, JSON keys, files.
#include <fstream>

#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "core/io/svo_file.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class Cli : public CommandLine {
  protected:
    std::string saved(const std::string& name, const Document& document) const {
        const std::string path = file(name);
        const Status status = saveDocument(path, document, GameProfile{});
        EXPECT_TRUE(status) << status.error().describe();
        return path;
    }
    std::string written(const std::string& name, const std::string& content) const {
        std::ofstream(file(name), std::ios::binary) << content;
        return file(name);
    }
    // Exit status 1, one line on stderr that names the file; the same as JSON with --json.
    void expectFailure(std::vector<std::string> arguments, const std::string& name,
                       const std::string& part) const {
        const ProgramResult plain = run(arguments);
        EXPECT_EQ(plain.status, 1) << plain.err;
        EXPECT_EQ(plain.out, "");
        EXPECT_EQ(plain.errorLines(), 1) << plain.err;
        EXPECT_NE(plain.err.find(name), std::string::npos) << plain.err;
        EXPECT_NE(plain.err.find(part), std::string::npos) << plain.err;
        arguments.push_back("--json");
        const ProgramResult withJson = run(arguments);
        EXPECT_EQ(withJson.status, 1);
        const Json error = withJson.json()["error"];
        EXPECT_NE(error["file"].get<std::string>().find(name), std::string::npos);
        EXPECT_FALSE(error["message"].get<std::string>().empty());
        EXPECT_NE(error.contains("offset"), error.contains("line")) << withJson.out;
    }
    void expectWrongUsage(const std::vector<std::string>& arguments,
                          const std::string& part) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 2) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.errorLines(), 1) << result.err;
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    }
};

TEST_F(Cli, HelpNamesEveryCommand) {
    const ProgramResult help = run({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* command :
         {"edit", "inspect", "convert", "export", "render", "compare", "bench", "trade"}) {
        EXPECT_NE(help.out.find(command), std::string::npos) << command;
        EXPECT_EQ(run({command, "--help"}).status, 0) << command;
    }
    EXPECT_EQ(run({"--version"}).status, 0);
    for (const char* full : {"--help", "--version"}) {
        const ProgramResult result = run({full}, ">/dev/full");
        EXPECT_EQ(result.status, 1) << full;
        EXPECT_NE(result.err.find("standard output"), std::string::npos) << result.err;
    }
    EXPECT_EQ(run({"--version"}, ">&-").status, 1);
    const std::string convert = run({"convert", "--help"}).out;
    EXPECT_NE(convert.find("y|z"), std::string::npos);
    EXPECT_EQ(convert.find('\0'), std::string::npos);
}

TEST_F(Cli, WrongUsageIsStatus2) {
    const std::string figureFile = saved("figure.vox", documentOf(figure()));
    expectWrongUsage({"paint", "x"}, "'paint'");
    expectWrongUsage({"inspect"}, "FILE");
    expectWrongUsage({"inspect", figureFile, "--colour"}, "--colour");
    expectWrongUsage({"convert", figureFile}, "--output");
    expectWrongUsage({"convert", figureFile, "-o", file("a.fbx")}, ".fbx");
    expectWrongUsage({"export", figureFile, "-o", file("a.vox")}, ".svo");
    expectWrongUsage({"compare", "a.png"}, "B");
    expectWrongUsage({"bench", "--only", "cast,soup"}, "soup");
    expectWrongUsage({std::string(300, 'a')}, "neither a command nor a file");
    expectWrongUsage({"edit", figureFile, "--content-scale", "nan"}, "--content-scale");
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
             {"--up", "q"}, {"--voxels-per-unit", "nan"}, {"--slice-rows", "0"}}) {
        expectWrongUsage({"convert", figureFile, "-o", file("a.qb"), option, value}, option);
    }
    expectWrongUsage({"render", figureFile}, "--json");
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
             {"--size", "512"},      {"--size", "0x5"},         {"--size", "99999x99999"},
             {"--yaw", "north"},     {"--yaw", "nan"},          {"--sigma", "0"},
             {"--sigma", "inf"},     {"--sigma", "65"},         {"--voxel-size", "-1"},
             {"--anchor", "1,2"},    {"--anchor", "1,2,3,4"},   {"--rotate", "a,b,c"},
             {"--mode", "hologram"}, {"--backend", "vulkan"},   {"--view", "sideways"},
             {"--depth", "middle"},  {"--background", "red"},   {"--distance", "0"},
             {"--fov", "180"},       {"--scale", "0"},          {"--view-step", "90"},
             {"--clearance", "-1"},  {"--position", "1,nan,0"}, {"--model", ""},
             {"--frame", ""},        {"--frame", "0.5"}}) {
        const ProgramResult result = run({"render", figureFile, "--json", option, value});
        EXPECT_EQ(result.status, 2) << option << " " << value << ": " << result.err;
        EXPECT_EQ(result.errorLines(), 1) << result.err;
        EXPECT_FALSE(result.json()["error"]["message"].get<std::string>().empty()) << option;
    }
    for (const char* fov : {"0", "1e308"}) {
        expectWrongUsage({"render", figureFile, "-o", file("a.png"), "--fov", fov},
                         "field of view");
    }
}

TEST_F(Cli, FailuresNameFilePlaceAndReason) {
    const std::string missing = file("missing.vox");
    const std::string noVox = written("broken.vox", "VOX \xC8");
    const std::string noZip = written("broken.voxprite", "something else");
    const std::string noSvo = written("broken.svo", "something else");
    const std::string unknown = written("model.fbx", "v 0 0 0");
    for (const std::string& path : {missing, noVox, noZip, noSvo, unknown}) {
        const std::string name = std::filesystem::path(path).filename().string();
        expectFailure({"inspect", path}, name, ":");
        expectFailure({"convert", path, "-o", file("out.vox")}, name, ":");
        expectFailure({"export", path, "-o", file("out.svo")}, name, ":");
        expectFailure({"render", path, "-o", file("out.png")}, name, ":");
    }
    EXPECT_TRUE(run({"inspect", noVox, "--json"}).json()["error"]["offset"].is_number());
    EXPECT_TRUE(run({"inspect", missing, "--json"}).json()["error"]["offset"].is_null());
    EXPECT_EQ(run({"inspect", "--json"}).json()["error"]["file"], "");

    const std::string figureFile = saved("figure.vox", documentOf(figure()));
    expectFailure({"convert", figureFile, "-o", file("no/folder/out.vox")}, "out.vox", "folder");
    expectFailure({"render", figureFile, "-o", file("no/folder/out.png")}, "out.png", "folder");
    expectFailure({"render", figureFile, "-o", file("o.png"), "--model", "1"}, "figure.vox",
                  "no model 1");
    expectFailure({"render", figureFile, "-o", file("o.png"), "--frame", "1"}, "figure.vox",
                  "no frame 1");
    const std::string profile = written("game.json", "{\n\"sigma\" 4}");
    expectFailure({"render", figureFile, "-o", file("o.png"), "--profile", profile}, "game.json",
                  "line 2");
    EXPECT_EQ(run({"render", figureFile, "--json", "--profile", profile}).json()["error"]["line"],
              2);
    EXPECT_FALSE(std::filesystem::exists(file("o.png")));
}

TEST_F(Cli, InspectListsModelsInFileOrder) {
    const VoxelGrid model = figure();
    Document document = documentOf(model);
    document.nodes[1].name = "the figure";
    const Json json = run({"inspect", saved("figure.vox", document), "--json"}).json();
    EXPECT_EQ(json["format"], "vox");
    ASSERT_EQ(json["models"].size(), 1u);
    const Json& m = json["models"][0];
    const IBox bounds = model.bounds();
    EXPECT_EQ(m["size"], Json({bounds.size().x, bounds.size().y, bounds.size().z}));
    EXPECT_EQ(m["voxels"], model.solidCount());
    std::set<int> colours;
    model.forEachSolid([&](glm::ivec3, std::uint8_t value) { colours.insert(value); });
    EXPECT_EQ(m["colours"], colours.size());
    EXPECT_EQ(m["frames"], 1);
    EXPECT_EQ(m["name"], "the figure");
    const Octree octree = bake(model).value();
    EXPECT_EQ(m["svo"]["max_depth"], octree.maxDepth);
    EXPECT_EQ(m["svo"]["nodes"], octree.nodes.size());
    EXPECT_EQ(m["svo"]["payloads"], octree.payloads.size());
    EXPECT_EQ(m["svo"]["bytes"], octree.nodes.size() * 4 + octree.payloads.size() * 8);
    EXPECT_EQ(json["instances"],
              Json::array({{{"model", 0}, {"name", "the figure"}, {"hidden", false}}}));
    EXPECT_TRUE(json["warnings"].is_array());
}

TEST_F(Cli, InspectSkipsEmptyModelsAndSaysWhatIsHidden) {
    Document document = documentOf(figure());
    document.models.insert(document.models.begin(), Model{});
    document.nodes[1].models[0].model = 1;
    SceneNode hidden = document.nodes[1];
    hidden.name = "ghost";
    hidden.hidden = true;
    document.nodes.push_back(hidden);
    document.nodes[0].children.push_back(2);
    const Json json = run({"inspect", saved("a.voxprite", document), "--json"}).json();
    EXPECT_EQ(json["format"], "voxprite");
    ASSERT_EQ(json["models"].size(), 1u);
    ASSERT_EQ(json["instances"].size(), 2u);
    EXPECT_EQ(json["instances"][0]["model"], 0);
    EXPECT_EQ(json["instances"][0]["hidden"], false);
    EXPECT_EQ(json["instances"][1]["name"], "ghost");
    EXPECT_EQ(json["instances"][1]["hidden"], true);
}

TEST_F(Cli, InspectCountsFrames) {
    const Document document =
        animationOf({solidBox({1, 2, 3}), solidBox({4, 5, 6}, 9), shellSphere(7)});
    for (const char* name : {"walk.vox", "walk.voxprite", "walk.svo"}) {
        const Json json = run({"inspect", saved(name, document), "--json"}).json();
        ASSERT_EQ(json["models"].size(), 3u) << name;
        EXPECT_EQ(json["frames"], 3) << name;
        for (const Json& model : json["models"]) EXPECT_EQ(model["frames"], 3) << name;
        EXPECT_EQ(json["models"][1]["size"], Json({4, 5, 6})) << name;
        EXPECT_EQ(json["models"][1]["voxels"], 120) << name;
    }
}

TEST_F(Cli, ConvertsAroundTheFormats) {
    const Document document = documentOf(asymmetric());
    std::string previous = saved("a.vox", document);
    for (const char* next : {"b.voxprite", "c.svo", "d.vox", "e.svo", "f.voxprite"}) {
        const ProgramResult result = run({"convert", previous, "-o", file(next), "--json"});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.json()["bytes"], std::filesystem::file_size(file(next)));
        previous = file(next);
    }
    const auto last = loadDocument(previous);
    ASSERT_TRUE(last);
    EXPECT_EQ(bake(flatten(last->document, 0))->nodes, bake(flatten(document, 0))->nodes);
    EXPECT_EQ(bake(flatten(last->document, 0))->payloads, bake(flatten(document, 0))->payloads);
    EXPECT_EQ(contentOf(file("c.svo")).substr(0, 4), contentOf(file("e.svo")).substr(0, 4));
}

TEST_F(Cli, ExportIsTheCanonicalBake) {
    const Document document = busyDocument();
    const std::string input = saved("busy.voxprite", document);
    const ProgramResult result = run({"export", input, "-o", file("busy.svo"), "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.json()["verified"], true);
    const Bytes bytes = readFile(file("busy.svo")).value();
    EXPECT_TRUE(verifyExport(bytes, document));
    EXPECT_EQ(result.json()["bytes"], bytes.size());

    const ProgramResult one = run({"export", input, "-o", file("one.svo"), "--model", "0"});
    ASSERT_EQ(one.status, 0) << one.err;
    const auto file0 = readSvo(readFile(file("one.svo")).value());
    ASSERT_TRUE(file0);
    ASSERT_EQ(file0->models.size(), 1u);
    EXPECT_EQ(file0->models[0].octree.nodes, bake(document.models[0].voxels)->nodes);
}

TEST_F(Cli, CompareMeasuresPictures) {
    Image a(20, 10, Rgba8(10, 20, 30, 255));
    Image b = a;
    b.at(3, 3) = Rgba8(0, 0, 0, 0);
    ASSERT_TRUE(writePngFile(file("a.png"), a));
    ASSERT_TRUE(writePngFile(file("b.png"), b));
    ASSERT_TRUE(writePngFile(file("c.png"), Image(10, 20)));
    const Json same = run({"compare", file("a.png"), file("a.png"), "--json"}).json();
    EXPECT_EQ(same["pixels"], 200);
    EXPECT_EQ(same["mismatched"], 0);
    EXPECT_EQ(same["mismatch_rate"], 0.0);
    EXPECT_EQ(same["silhouette_xor"], 0);
    EXPECT_EQ(same["iou"], 1.0);
    EXPECT_EQ(same["flip_mean"], 0.0);
    EXPECT_TRUE(same["psnr"].is_null());
    EXPECT_EQ(same["ssim"], 1.0);
    const Json other = run({"compare", file("a.png"), file("b.png"), "--json"}).json();
    EXPECT_EQ(other["mismatched"], 1);
    EXPECT_EQ(other["mismatch_rate"], 0.005);
    EXPECT_EQ(other["silhouette_xor"], 1);
    EXPECT_GT(other["psnr"].get<double>(), 20.0);
    expectFailure({"compare", file("a.png"), file("c.png")}, "c.png", "differ in size");
    expectFailure({"compare", file("a.png"), file("none.png")}, "none.png", ":");
}

TEST_F(Cli, BenchPrintsMeasuredFigures) {
    const ProgramResult result = run({"bench", "--quick", "--only", "update,files", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json json = result.json();
    for (const char* key : {"cpu", "cores", "simd", "gl"}) {
        EXPECT_TRUE(json["machine"].contains(key)) << key;
    }
    EXPECT_FALSE(json.contains("cast"));
    EXPECT_TRUE(json["files"].is_array());
    ASSERT_GE(json["update"].size(), 6u);
    for (const Json& figure : json["update"]) {
        EXPECT_TRUE(figure["model"].is_string());
        EXPECT_TRUE(figure["edit"].is_string());
        EXPECT_GT(figure["us"].get<double>(), 0.0);
    }
}

}  // namespace
}  // namespace voxprite::test
