// .obj made by hand: what is read of it, and what is refused.
#include "core/io/obj_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/io/png.h"
#include "tests/core/io/mesh_shapes.h"
#include "tests/support/temporary_folder.h"

namespace voxprite::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<MeshImport> parse(const std::string& text, MeshUpAxis up = MeshUpAxis::z,
                         const ModelFolder& folder = ModelFolder()) {
    return readObj({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, folder, up);
}

std::string errorOf(const std::string& text) {
    const Result<MeshImport> import = parse(text);
    return import ? "no error" : import.error().describe();
}

const std::string kSquare = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\n";

TEST(ObjReader, PolygonsAreCutIntoTriangles) {
    EXPECT_EQ(must(parse(kSquare + "f 1 2 3 4\n")).mesh.triangles.size(), 2u);
    EXPECT_EQ(must(parse(kSquare + "f -4//1 -3//2 -2//1\n")).mesh.triangles.size(), 1u);
    EXPECT_EQ(must(parse(kSquare + "v 2 1 0\nf 1 2 5 3 4\n")).mesh.triangles.size(), 3u);
    EXPECT_TRUE(must(parse("# nothing\n")).mesh.triangles.empty());
}

TEST(ObjReader, TheUpAxisIsChosen) {
    const glm::dvec3 asItIs =
        must(parse("v 1 2 3\n" + kSquare + "f 1 2 3\n")).mesh.triangles[0].corners[0].position;
    EXPECT_EQ(asItIs, glm::dvec3(1, 2, 3));
    const glm::dvec3 turned = must(parse("v 1 2 3\n" + kSquare + "f 1 2 3\n", MeshUpAxis::y))
                                  .mesh.triangles[0]
                                  .corners[0]
                                  .position;
    EXPECT_EQ(turned, glm::dvec3(1, -3, 2));
}

TEST(ObjReader, VertexColoursAreBytesOfSrgb) {
    const MeshImport import =
        must(parse("v 0 0 0 1 0.5019607843 0\nv 1 0 0 1 0.5019607843 0\nv 1 1 0 1 0.5019607843 0\n"
                   "f 1 2 3\n"));
    EXPECT_EQ(colourAt(import.mesh, import.mesh.triangles[0], glm::dvec3(1.0 / 3.0)),
              Rgba8(255, 128, 0, 255));
}

TEST(ObjReader, MaterialsComeFromBesideTheFile) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "model");
    Image image(2, 1);
    image.pixels = {Rgba8(1, 2, 3, 255), Rgba8(4, 5, 6, 255)};
    ASSERT_TRUE(writePngFile(folder / "model/p.png", image));
    ASSERT_TRUE(writePngFile(folder / "outside.png", image));
    ASSERT_TRUE(writeFileAtomically(
        folder / "model/m.mtl",
        std::string("newmtl plain\nKd 0.2 0.4 0.6\nnewmtl painted\nKd 0 0 0\nmap_Kd p.png\n"
                    "newmtl moved\nmap_Kd -o 0.5 0 0 p.png\nnewmtl far\nKd 1 0 0\n"
                    "map_Kd ../outside.png\n")));
    const ModelFolder beside(folder / "model/x.obj");
    const auto colour = [&](const std::string& name, std::vector<std::string>* warnings = nullptr) {
        const MeshImport import = must(
            parse("mtllib m.mtl\n" + kSquare + "vt 0.1 0.9\nusemtl " + name + "\nf 1/1 2/1 3/1\n",
                  MeshUpAxis::y, beside));
        if (warnings != nullptr) *warnings = import.warnings;
        return colourAt(import.mesh, import.mesh.triangles[0], glm::dvec3(1.0 / 3.0)).value();
    };
    EXPECT_EQ(colour("plain"), Rgba8(51, 102, 153, 255));
    EXPECT_EQ(colour("painted"), image.at(0, 0));
    EXPECT_EQ(colour("moved"), image.at(1, 0));
    EXPECT_EQ(colour("unknown"), Rgba8(255));
    std::vector<std::string> warnings;
    EXPECT_EQ(colour("far", &warnings), Rgba8(255, 0, 0, 255));
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("outside of the model's folder")));
    const MeshImport none =
        must(parse("mtllib ../m.mtl\n" + kSquare + "f 1 2 3\n", MeshUpAxis::y, beside));
    EXPECT_THAT(none.warnings, ElementsAre(HasSubstr("outside of the model's folder")));
}

TEST(ObjReader, WhatIsWrongIsNamed) {
    EXPECT_THAT(errorOf(kSquare + "f 1 2 5\n"),
                HasSubstr("line 5, column 7: a face uses vertex 5; the file has 4"));
    EXPECT_THAT(errorOf(kSquare + "f 1 2 -9\n"),
                HasSubstr("line 5, column 7: a face uses vertex -9"));
    EXPECT_THAT(errorOf(kSquare + "f 0 1 2\n"), HasSubstr("line 5"));
    EXPECT_THAT(errorOf(kSquare + "f 1/7 2/7 3/7\n"),
                HasSubstr("line 5, column 5: a face uses texture point 7; the file has 0"));
    for (const std::string word : {"1e999", "nan", "inf", "1,0", "-", "1e31"}) {
        EXPECT_THAT(errorOf("v 1 0 0\r\nv " + word + " 0 0\n"),
                    HasSubstr("line 2, column 3: \"" + word + "\" is not a number"));
        EXPECT_THAT(errorOf("vt 0 " + word + "\n"), HasSubstr("line 1, column 6: "));
    }
    EXPECT_THAT(errorOf("v 1 0\n"), HasSubstr("line 1, column 1: \"v\" has 2 numbers"));
    EXPECT_THAT(errorOf(kSquare + "f 1 2 3x\n"), HasSubstr("line 5, column 7: \"3x\""));
    EXPECT_THAT(errorOf(kSquare + "f 1 2 \\\n  7\n"), HasSubstr("line 6, column 3: a face uses"));
    std::string face = "f";
    for (int k = 0; k < 300; ++k) face += " 1";
    EXPECT_THAT(errorOf(kSquare + face), HasSubstr("line 5, column 1: a face has 300 corners"));
}

TEST(ObjReader, NotesContinuedLinesAndMarksAreUnderstood) {
    const std::string mark = "\xEF\xBB\xBF";
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text = mark + "v 7 0 0#a\n" + kSquare +
                           "# ends in \\\nf 2 3 \\\n 4\\\n5 # 9\nf 1 2 +3 # note\n";
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
            text.replace(at, 1, end);
            at += end.size();
        }
        const MeshImport import = must(parse(text));
        ASSERT_EQ(import.mesh.triangles.size(), 3u);
        EXPECT_EQ(import.mesh.triangles[2].corners[0].position, glm::dvec3(7, 0, 0));
    }
}

TEST(ObjReader, VerticesWithoutColoursAreWhiteBesideOthers) {
    const MeshImport import = must(parse("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nf 1 2 3\n"));
    EXPECT_EQ(import.mesh.triangles[0].corners[0].colour, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(import.mesh.triangles[0].corners[2].colour, glm::vec4(1));
}

class ObjMaterials : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) {
        ASSERT_TRUE(writeFileAtomically(folder_ / name, text));
    }
    // Of a triangle behind these lines.
    Rgba8 colour(const std::string& lines) {
        const MeshImport import = must(
            parse(kSquare + lines + "\nf 1 2 3\n", MeshUpAxis::y, ModelFolder(folder_ / "m.obj")));
        warnings_ = import.warnings;
        return colourAt(import.mesh, import.mesh.triangles[0], glm::dvec3(1.0 / 3.0)).value();
    }
    TemporaryFolder folder_;
    std::vector<std::string> warnings_;
    const Rgba8 red_{255, 0, 0, 255}, blue_{0, 0, 255, 255};
};

TEST_F(ObjMaterials, LibrariesHaveBlanksInTheirNamesOrAreSeveral) {
    write("my model.mtl", "\xEF\xBB\xBFnewmtl red\nKd 1 0 0\n");
    write("b.mtl", "newmtl blue\rKd 0 0 1\r");
    EXPECT_EQ(colour("mtllib my model.mtl\nusemtl red"), red_);
    EXPECT_EQ(colour("mtllib my\\ model.mtl\nusemtl red"), red_);
    EXPECT_TRUE(warnings_.empty());
    EXPECT_EQ(colour("mtllib my\\ model.mtl b.mtl\nusemtl blue"), blue_);
    EXPECT_TRUE(warnings_.empty());
    EXPECT_EQ(colour("usemtl blue\nmtllib x.mtl b.mtl"), blue_);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"x.mtl\"")));
    EXPECT_EQ(colour("mtllib not there.mtl"), Rgba8(255));
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"not there.mtl\"")));
}

TEST_F(ObjMaterials, NamesAreWholeLinesAndUnknownOnesAreTold) {
    write("a.mtl",
          "newmtl dark red\nKd 1 0 0\nnewmtl dark\nKd 0 0 1\nnewmtl Material #25\nKd 1 0 0\n"
          "newmtl bare\nNs 4\n");
    EXPECT_EQ(colour("mtllib a.mtl\nusemtl dark red"), red_);
    EXPECT_EQ(colour("mtllib a.mtl\nusemtl \tdark  # a note"), blue_);
    EXPECT_EQ(colour("mtllib a.mtl\nusemtl Material #25"), red_);
    EXPECT_EQ(colour("mtllib a.mtl\nusemtl bare"), Rgba8(255)) << "has no Kd";
    EXPECT_TRUE(warnings_.empty());
    EXPECT_EQ(colour("usemtl pale red\nusemtl dark"), Rgba8(255));
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("white: \"pale red\", \"dark\"")));
}

// Statements that are not read are not parsed: tinyobjloader would take gigabytes for these tags.
TEST(ObjReader, TagsTakeNoMemory) {
    EXPECT_EQ(errorOf(kSquare + "t crease 2000000000/2000000000/2000000000 1\nf 1 2 3\n"),
              "no error");
}

}  // namespace
}  // namespace voxprite::test
