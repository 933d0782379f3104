// What is written never takes the place of what is read, nor of another output.
#include "core/io/formats.h"
#include "core/io/png.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

class CliOutputs : public CommandLine {
  protected:
    std::string saved(const std::string& name, const Document& document) const {
        const Status status = saveDocument(file(name), document, GameProfile{});
        EXPECT_TRUE(status) << status.error().describe();
        return file(name);
    }
    // Wrong usage that names `part`; `kept` is as it was.
    void expectRefused(const std::vector<std::string>& arguments, const std::string& part,
                       const std::string& kept) const {
        const std::string before = contentOf(kept);
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 2) << arguments[0] << ": " << result.err;
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
        EXPECT_EQ(contentOf(kept), before) << arguments[0];
    }
};

TEST_F(CliOutputs, PicturesDoNotReplaceModels) {
    const std::string vox = saved("hut.vox", documentOf(figure()));
    expectRefused({"render", vox, "-o", vox}, "must end in .png", vox);
    expectRefused({"render", vox, "--buffer", vox}, "must end in .png", vox);
    expectRefused({"render", vox, "-o", ""}, "--output", vox);
    const ProgramResult stream = run({"render", vox, "-o", "/dev/stdout", "--size", "8x8"});
    EXPECT_EQ(stream.status, 0) << stream.err;
    EXPECT_EQ(stream.out.substr(1, 3), "PNG");

    const std::string strip = saved("strip.png", documentOf(figure()));
    const std::string layer = saved("hut_000.png", documentOf(figure()));
    const std::string linked = file("linked.png");
    std::filesystem::create_symlink(strip, linked);
    for (const char* command : {"render", "sheet", "palette"}) {
        expectRefused({command, strip, "-o", strip}, "is read", strip);
        expectRefused({command, strip, "-o", linked}, "is read", strip);
        expectRefused({command, layer, "-o", file("hut_001.png")}, "is read", file("hut_001.png"));
    }
    expectRefused({"sheet", strip, "-o", file("s.png"), "--turntable", strip}, "--turntable",
                  strip);
    // The picture of a mesh's colours belongs to the mesh.
    const std::string mesh = saved("m.obj", documentOf(figure()));
    expectRefused({"render", mesh, "-o", file("m.png")}, "is read for", file("m.png"));
    EXPECT_EQ(run({"palette", vox, "--remove-unused", "-o", vox}).status, 0) << "in its place";
    const std::string colours = file("two.gpl");
    EXPECT_EQ(run({"palette", vox, "-o", colours}).status, 0);
    expectRefused({"palette", vox, "--import", colours, "-o", colours}, "is read", colours);
}

TEST_F(CliOutputs, AMeshIsNotReplacedByItsVoxels) {
    const std::string obj = saved("m.obj", documentOf(figure()));
    const std::string glb = saved("m.glb", documentOf(figure()));
    for (const std::string& mesh : {obj, glb}) {
        expectRefused({"convert", mesh, "-o", mesh}, "is read", mesh);
        expectRefused({"palette", mesh, "--remove-unused", "-o", mesh}, "is read", mesh);
    }
    expectRefused({"convert", obj, "-o", file("m.png")}, "is read for", file("m.png"));
    EXPECT_EQ(run({"convert", obj, "-o", file("m.vox")}).status, 0);
    EXPECT_EQ(run({"convert", file("m.vox"), "-o", file("m.vox")}).status, 0) << "in its place";
}

TEST_F(CliOutputs, WhatAMeshRefersToIsNotReplaced) {
    std::filesystem::create_directory(file("tx"));
    const std::string picture = file("tx/a t.png"), buffer = file("g.bin");
    ASSERT_TRUE(writePngFile(picture, Image(1, 1, Rgba8(200, 0, 0, 255))));
    const float corners[9] = {0, 0, 0, 9, 0, 0, 0, 9, 0};
    std::ofstream(buffer).write(reinterpret_cast<const char*>(corners), sizeof(corners));
    std::ofstream(file("m.mtl")) << "newmtl a\nmap_Kd tx\\a t.png\n";
    std::ofstream(file("m.obj"))
        << "mtllib ./m.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nusemtl a\nf 1 2 3\n";
    std::ofstream(file("g.gltf"))
        << R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
           R"({"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
           R"("componentType":5126,"count":3,"type":"VEC3"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("buffers":[{"byteLength":36,"uri":"g.bin"}],)"
           R"("images":[{"uri":"tx/a%20t.png"},{"uri":"data:image/png;base64,AAAA"}]})";
    std::filesystem::create_symlink(picture, file("link.png"));
    for (const std::string& mesh : {file("m.obj"), file("g.gltf")}) {
        for (const char* command : {"render", "convert", "sheet", "palette"}) {
            expectRefused({command, mesh, "-o", picture}, "is read for", picture);
        }
        expectRefused({"render", mesh, "-o", file("link.png")}, "is read for", picture);
    }
    expectRefused({"convert", file("g.gltf"), "--out-dir", file("out"), "--log", buffer},
                  "is read for", buffer);
}

TEST_F(CliOutputs, APartOfAModelDoesNotTakeItsPlace) {
    Document document = busyDocument();
    document.palette.variants = {{"red", {{7, Rgba8(255, 0, 0, 255)}}}};
    const std::string project = saved("a.voxprite", document);
    expectRefused({"convert", project, "--variant", "red", "-o", project}, "is read", project);
    EXPECT_EQ(run({"convert", project, "-o", project}).status, 0);
    // Only reading tells which grids are passed over.
    const std::string grids = saved("a.vdb", document);
    expectRefused({"convert", grids, "--grid", "noise", "-o", grids}, "is read", grids);
    EXPECT_EQ(run({"convert", grids, "-o", grids}).status, 0);
}

TEST_F(CliOutputs, TwoDoNotHaveOneName) {
    const std::string vox = saved("hut.vox", documentOf(figure()));
    expectRefused({"render", vox, "-o", file("a.png"), "--buffer", file("./a.png")}, "--buffer",
                  vox);
    expectRefused({"sheet", vox, "-o", file("a.png"), "--turntable", file("./a.png")},
                  "--turntable", vox);
    EXPECT_FALSE(std::filesystem::exists(file("a.png")));
}

TEST_F(CliOutputs, WhatTheReaderSaysIsPassedOn) {
    // How many layers these are is not told by the picture.
    const std::string strip = file("strip.png");
    ASSERT_TRUE(writePngFile(strip, Image(2, 4, Rgba8(200, 0, 0, 255))));
    const nlohmann::json told = run({"inspect", strip, "--json"}).json()["warnings"];
    ASSERT_EQ(told.size(), 1u);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"render", strip, "-o", file("r.png")},
          {"sheet", strip, "-o", file("s.png"), "--directions", "1"},
          {"palette", strip, "-o", file("p.gpl")},
          {"export", strip, "-o", file("e.svo")}}) {
        const ProgramResult text = run(command);
        EXPECT_NE(text.out.find("warning: " + told[0].get<std::string>()), std::string::npos)
            << command[0] << text.out;
        std::vector<std::string> asJson = command;
        asJson.emplace_back("--json");
        EXPECT_EQ(run(asJson).json()["warnings"], told) << command[0];
    }
}

}  // namespace
}  // namespace voxprite::test
