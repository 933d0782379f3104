// glTF made by hand: what is read of it, and what is refused.
#include "core/io/gltf_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/base/srgb.h"
#include "core/io/png.h"
#include "tests/core/io/mesh_shapes.h"
#include "tests/support/temporary_folder.h"

namespace voxprite::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MeshImport read(const Bytes& file) {
    return must(readGltf(file, ModelFolder()));
}

std::string errorOf(const Bytes& file) {
    const Result<MeshImport> import = readGltf(file, ModelFolder());
    return import ? "no error" : import.error().describe();
}

glm::dvec3 normalOf(const MeshTriangle& t) {
    const auto& c = t.corners;
    return glm::normalize(glm::cross(c[1].position - c[0].position, c[2].position - c[0].position));
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-9);
}

TEST(GltfReader, UpIsOurUp) {
    const MeshImport import = read(triangleGlb(R"([{"mesh":0}])"));
    ASSERT_EQ(import.mesh.triangles.size(), 1u);
    const auto& c = import.mesh.triangles[0].corners;
    expectNear(c[1].position, {4, 0, 0});
    expectNear(c[2].position, {0, 0, 2});
    // +Z, toward the viewer, is our -Y.
    expectNear(normalOf(import.mesh.triangles[0]), {0, -1, 0});
    EXPECT_TRUE(import.warnings.empty());
}

TEST(GltfReader, TransformsOfNodesAreApplied) {
    // A quarter turn about glTF's Y, then moved; the child scaled and moved within.
    const MeshImport import = read(triangleGlb(
        R"([{"children":[1],"translation":[10,0,0],"rotation":[0,0.7071067811865476,0,0.7071067811865476]},)"
        R"({"mesh":0,"scale":[2,3,1],"translation":[1,0,0]}])"));
    const auto& c = import.mesh.triangles[0].corners;
    // x -> -z of glTF, which is +y of ours.
    expectNear(c[0].position, {10, 1, 0});
    expectNear(c[1].position, {10, 9, 0});
    expectNear(c[2].position, {10, 1, 6});
    expectNear(normalOf(import.mesh.triangles[0]), {1, 0, 0});
    const MeshImport same =
        read(triangleGlb(R"([{"mesh":0,"matrix":[0,0,-2,0, 0,3,0,0, 1,0,0,0, 10,0,-1,1]}])"));
    for (std::size_t k = 0; k < 3; ++k) {
        expectNear(same.mesh.triangles[0].corners[k].position, c[k].position);
    }
}

TEST(GltfReader, MirroredTrianglesKeepTheirOutside) {
    const MeshImport import = read(triangleGlb(R"([{"mesh":0,"scale":[-1,1,1]}])"));
    expectNear(import.mesh.triangles[0].corners[2].position, {-4, 0, 0});
    expectNear(normalOf(import.mesh.triangles[0]), {0, -1, 0});
}

TEST(GltfReader, TheSceneChoosesWhatIsShown) {
    const std::string nodes = R"([{"mesh":0},{"mesh":0,"translation":[0,5,0]},{"children":[0,1]}])";
    EXPECT_EQ(read(triangleGlb(nodes)).mesh.triangles.size(), 2u);
    const MeshImport second =
        read(triangleGlb(nodes, R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])"));
    ASSERT_EQ(second.mesh.triangles.size(), 1u);
    expectNear(second.mesh.triangles[0].corners[0].position, {0, 0, 5});
    EXPECT_TRUE(read(triangleGlb(nodes, R"(,"scenes":[{}])")).mesh.triangles.empty());
}

TEST(GltfReader, StripsAndFansAreTriangles) {
    Chunk chunk;
    chunk.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    const auto file = [&](int mode) {
        return glb(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
                   R"({"attributes":{"POSITION":0},"mode":)" +
                       std::to_string(mode) +
                       R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":5,)"
                       R"("type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":60}],)"
                       R"("buffers":[{"byteLength":60}]})",
                   chunk.bytes());
    };
    const MeshImport strip = read(file(5));
    ASSERT_EQ(strip.mesh.triangles.size(), 3u);
    for (const MeshTriangle& t : strip.mesh.triangles) expectNear(normalOf(t), {0, -1, 0});
    EXPECT_EQ(read(file(6)).mesh.triangles.size(), 3u);
    EXPECT_EQ(read(file(4)).mesh.triangles.size(), 1u);
    const MeshImport lines = read(file(1));
    EXPECT_TRUE(lines.mesh.triangles.empty());
    EXPECT_THAT(lines.warnings, ElementsAre(HasSubstr("points or lines")));
}

// Base colour, texture, its place, and vertex colours.
TEST(GltfReader, MaterialsColourTheMesh) {
    Image image(2, 2);
    image.pixels = {Rgba8(10, 20, 30, 255), Rgba8(40, 50, 60, 255), Rgba8(70, 80, 90, 255),
                    Rgba8(100, 110, 120, 255)};
    Chunk chunk;
    chunk.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    chunk.floats({0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f});
    chunk.shorts({65535, 0, 0, 65535, 0, 0, 65535, 0, 0});
    const Bytes png = must(writePng(image));
    const std::size_t at = chunk.raw(png);
    const auto file = [&](const std::string& info, const std::string& attributes) {
        return glb(
            R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
            R"({"attributes":{"POSITION":0)" +
                attributes + R"(},"material":0}]}],"materials":[{"pbrMetallicRoughness":{)" + info +
                R"(}}],"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071,"wrapT":33648}],)"
                R"("images":[{"bufferView":3,"mimeType":"image/png"}],"accessors":[)"
                R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
                R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"},)"
                R"({"bufferView":2,"componentType":5123,"count":3,"type":"VEC3","normalized":true}],)"
                R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},)"
                R"({"buffer":0,"byteOffset":60,"byteLength":18},{"buffer":0,"byteOffset":)" +
                std::to_string(at) + R"(,"byteLength":)" + std::to_string(png.size()) +
                R"(}],"buffers":[{"byteLength":)" + std::to_string(chunk.bytes().size()) + "}]}",
            chunk.bytes());
    };
    const auto colour = [&](const std::string& info, const std::string& attributes) {
        const MeshImport import = read(file(info, attributes));
        EXPECT_TRUE(import.warnings.empty());
        return colourAt(import.mesh, import.mesh.triangles.at(0), glm::dvec3(1.0 / 3.0)).value();
    };
    EXPECT_EQ(colour("", ""), Rgba8(255));
    EXPECT_EQ(colour(R"("baseColorFactor":[1,0.5,0,1])", ""), Rgba8(255, 188, 0, 255));
    const std::string textured = R"("baseColorTexture":{"index":0)";
    EXPECT_EQ(colour(textured + "}", R"(,"TEXCOORD_0":1)"), image.at(0, 0));
    EXPECT_EQ(colour(textured + "}", R"(,"TEXCOORD_0":1,"COLOR_0":2)"), Rgba8(10, 0, 0, 255));
    const auto moved = [&](const std::string& transform) {
        return colour(textured + R"(,"extensions":{"KHR_texture_transform":{)" + transform + "}}}",
                      R"(,"TEXCOORD_0":1)");
    };
    EXPECT_EQ(moved(R"("offset":[0.5,0])"), image.at(1, 0));
    EXPECT_EQ(moved(R"("scale":[9,1])"), image.at(1, 0));
    EXPECT_EQ(moved(R"("scale":[90,1])"), image.at(1, 0));    // clamped
    EXPECT_EQ(moved(R"("offset":[0,1.2])"), image.at(0, 1));  // mirrored
    EXPECT_EQ(moved(R"("offset":[0,1.7])"), image.at(0, 0));
    // A quarter turn counter-clockwise, v downwards: (0.1, 0.1) to (0.1, -0.1).
    EXPECT_EQ(moved(R"("rotation":1.5707963267948966,"offset":[0.5,0.3])"), image.at(1, 0));
    EXPECT_EQ(moved(R"("rotation":1.5707963267948966,"offset":[0.3,0.7])"), image.at(0, 1));
}

TEST(GltfReader, TheOlderWayOfMaterialsIsRead) {
    const MeshImport import = read(triangleGlb(
        R"([{"mesh":0}])",
        R"(,"extensionsRequired":["KHR_materials_pbrSpecularGlossiness"],"materials":[{)"
        R"("pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]},"extensions":{)"
        R"("KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,0,0,1]}}}])",
        R"(,"material":0)"));
    EXPECT_EQ(colourAt(import.mesh, import.mesh.triangles.at(0), glm::dvec3(1.0 / 3.0)),
              Rgba8(255, 0, 0, 255));
}

// Files without another picture have to require what their textures are made of.
TEST(GltfReader, TexturesThatAreNotReadDoNotRefuseTheMesh) {
    const MeshImport import = read(triangleGlb(
        R"([{"mesh":0}])",
        R"(,"extensionsRequired":["EXT_texture_webp"],"materials":[{"pbrMetallicRoughness":{)"
        R"("baseColorFactor":[1,0,0,1],"baseColorTexture":{"index":0}}}],"textures":[{)"
        R"("extensions":{"EXT_texture_webp":{"source":0}}}],"images":[{"uri":"a.webp"}])",
        R"(,"material":0)"));
    EXPECT_THAT(import.warnings, ElementsAre(HasSubstr("the texture has no PNG or JPEG")));
    EXPECT_EQ(colourAt(import.mesh, import.mesh.triangles.at(0), glm::dvec3(1.0 / 3.0)),
              Rgba8(255, 0, 0, 255));
}

// A triangle (0,0,0), (4,0,0), (0,2,0) whose corners hang on joint 0, on joint 1, and on both.
Bytes skinnedGlb(const std::string& nodes, const std::string& skin) {
    Chunk chunk;
    chunk.floats({0, 0, 0, 4, 0, 0, 0, 2, 0});
    chunk.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
    chunk.shorts({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    // Both joints were bound at (-1, 0, 0).
    for (int k = 0; k < 2; ++k) chunk.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1});
    return glb(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":)" + nodes +
                   R"(,"skins":[)" + skin +
                   R"(],"meshes":[{"primitives":[{"attributes":)"
                   R"({"POSITION":0,"WEIGHTS_0":1,"JOINTS_0":2}}]}],"accessors":[)"
                   R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC4"},)"
                   R"({"bufferView":2,"componentType":5123,"count":3,"type":"VEC4"},)"
                   R"({"bufferView":3,"componentType":5126,"count":2,"type":"MAT4"}],)"
                   R"("bufferViews":[{"buffer":0,"byteLength":36},)"
                   R"({"buffer":0,"byteOffset":36,"byteLength":48},)"
                   R"({"buffer":0,"byteOffset":84,"byteLength":24},)"
                   R"({"buffer":0,"byteOffset":108,"byteLength":128}],)"
                   R"("buffers":[{"byteLength":236}]})",
               chunk.bytes());
}

TEST(GltfReader, SkinsHangOnTheirJointsAndNotOnTheirNode) {
    // The node lies down and is large, which says nothing; joint 1 is 10 above joint 0.
    const std::string nodes =
        R"([{"mesh":0,"skin":0,"scale":[9,9,9],"rotation":[0.7071068,0,0,0.7071068]},)"
        R"({"children":[2]},{"translation":[0,10,0]},{}])";
    const std::string bind = R"("inverseBindMatrices":3)";
    const MeshImport import = read(skinnedGlb(nodes, R"({"joints":[1,2],)" + bind + "}"));
    ASSERT_EQ(import.mesh.triangles.size(), 1u);
    EXPECT_TRUE(import.warnings.empty());
    const auto& c = import.mesh.triangles[0].corners;
    expectNear(c[0].position, {1, 0, 0});
    expectNear(c[1].position, {5, 0, 10});
    expectNear(c[2].position, {1, 0, 7});
    const MeshImport bare = read(skinnedGlb(nodes, R"({"joints":[1,2]})"));
    expectNear(bare.mesh.triangles.at(0).corners[1].position, {4, 0, 10});
    const auto warned = read(skinnedGlb(nodes, R"({"joints":[1,3]})")).warnings;
    EXPECT_THAT(warned, ElementsAre(HasSubstr("outside of the scene")));
    EXPECT_THAT(errorOf(skinnedGlb(nodes, R"({"joints":[1]})")), HasSubstr("JOINTS_0: a joint is"));
    EXPECT_THAT(errorOf(skinnedGlb(nodes, R"({"joints":[1,2,2],)" + bind + "}")),
                HasSubstr("fewer matrices"));
}

TEST(GltfReader, NumbersWithoutBytesAreZero) {
    const auto file = [](const std::string& count) {
        const std::string text =
            R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
            R"({"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":)" +
            count + R"(,"type":"VEC3"}]})";
        return glb(text, {});
    };
    const MeshImport import = read(file("3"));
    ASSERT_EQ(import.mesh.triangles.size(), 1u);
    for (const MeshCorner& corner : import.mesh.triangles[0].corners) {
        EXPECT_EQ(corner.position, glm::dvec3(0));
    }
    EXPECT_THAT(errorOf(file("1000000000000000")), HasSubstr("more than 4194304 triangles"));
}

TEST(GltfReader, InstancesThatAreNotReadAreTold) {
    const MeshImport import = read(
        triangleGlb(R"([{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{}}}}])"));
    EXPECT_THAT(import.warnings, ElementsAre(HasSubstr("EXT_mesh_gpu_instancing")));
}

TEST(GltfReader, OtherFilesAreBesideOrBelow) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "model/sub");
    Chunk chunk;
    chunk.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const auto put = [&](const std::string& name) {
        ASSERT_TRUE(writeFileAtomically(folder / name, ByteView(chunk.bytes())));
    };
    put("outside.bin");
    put("model/a b.bin");
    put("model/sub/c.bin");
    std::filesystem::create_symlink(folder / "outside.bin", folder / "model/link.bin");
    const auto result = [&](const std::string& uri) -> std::string {
        const std::string text =
            R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
            R"({"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
            R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
            R"("byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
            uri + "\"}]}";
        const Result<MeshImport> import =
            readGltf({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                     ModelFolder(folder / "model/x.gltf"));
        return import ? "read" : import.error().message;
    };
    EXPECT_EQ(result("a%20b.bin"), "read");
    EXPECT_EQ(result("sub/c.bin"), "read");
    EXPECT_EQ(result("sub\\\\c.bin"), "read");
    EXPECT_EQ(result("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAA"
                     "gD8AAAAA"),
              "read");
    for (const std::string uri : {"../outside.bin", "sub/../../outside.bin", "link.bin",
                                  "..\\\\outside.bin", "C:/outside.bin"}) {
        EXPECT_THAT(result(uri), HasSubstr("outside of the model's folder")) << uri;
    }
    EXPECT_THAT(result((folder / "outside.bin").string()), HasSubstr("outside"));
    EXPECT_THAT(result("none.bin"), HasSubstr("none.bin"));
    EXPECT_THAT(result("sub"), HasSubstr("no regular file"));
    EXPECT_THAT(result(""), HasSubstr("no file's name"));
    EXPECT_THAT(result("data:text/plain,abc"), HasSubstr("base64"));
    EXPECT_THAT(result("data:;base64,####"), HasSubstr("base64"));
    EXPECT_THAT(result("data:;base64,AAAA"), HasSubstr("should have 36 bytes and has 3"));
}

TEST(GltfReader, WhatIsWrongIsNamed) {
    const auto with = [](const std::string& more) { return triangleGlb(R"([{"mesh":0}])", more); };
    const auto nodes = [](const std::string& list) { return errorOf(triangleGlb(list)); };
    EXPECT_THAT(nodes(R"([{"mesh":1}])"), HasSubstr("nodes[0].mesh: must be a whole number"));
    EXPECT_THAT(nodes(R"([{"children":[0]}])"), HasSubstr("no error"));  // nobody's root
    EXPECT_THAT(errorOf(triangleGlb(R"([{"children":[1]},{"children":[0]}])",
                                    R"(,"scenes":[{"nodes":[0]}])")),
                HasSubstr("several parents"));
    EXPECT_THAT(nodes(R"([{"children":[1,1]},{}])"), HasSubstr("several parents"));
    EXPECT_THAT(nodes(R"([{"mesh":0,"scale":[1,2]}])"), HasSubstr("list of 3"));
    EXPECT_THAT(nodes(R"([{"mesh":0,"rotation":[0,0,0,0]}])"), HasSubstr("no rotation"));
    EXPECT_THAT(nodes(R"([{"mesh":0,"scale":[1e300,1e300,1]}])"), HasSubstr("not a number"));
    EXPECT_THAT(errorOf(with(R"(,"extensionsRequired":["KHR_draco_mesh_compression"])")),
                HasSubstr("requires KHR_draco_mesh_compression"));
    EXPECT_EQ(errorOf(with(R"(,"extensionsRequired":["KHR_materials_unlit"])")), "no error");
    EXPECT_EQ(errorOf(with(R"(,"extensionsRequired":["KHR_animation_pointer"])")), "no error");
    EXPECT_THAT(errorOf(triangleGlb(R"([{"mesh":0}])", "", R"(,"material":0)")),
                HasSubstr("material"));

    const auto changed = [&](const std::string& from, const std::string& to) {
        Bytes file = triangleGlb(R"([{"mesh":0}])");
        std::string text(file.begin(), file.end());
        EXPECT_EQ(from.size(), to.size());
        text.replace(text.find(from), from.size(), to);
        return errorOf(Bytes(text.begin(), text.end()));
    };
    EXPECT_THAT(changed("\"count\":3,\"type\":\"V", "\"count\":4,\"type\":\"V"),
                HasSubstr("accessors[0]: reaches beyond its buffer view"));
    EXPECT_THAT(changed("Length\":36", "Length\":99"), HasSubstr("reaches beyond its buffer"));
    EXPECT_THAT(changed("\"2.0\"", "\"1.0\""), HasSubstr("only glTF 2"));
    EXPECT_THAT(changed("5123", "5126"), HasSubstr("accessors[1]: reaches beyond"));
    EXPECT_THAT(changed("5126", "5129"), HasSubstr("component type"));
    EXPECT_THAT(changed("VEC3", "MAT2"), HasSubstr("its type"));
    EXPECT_THAT(changed("\"byteLength\":44", "\"byteLength\":99"), HasSubstr("buffers[0]"));
    EXPECT_THAT(changed(std::string("\0\0\1\0\2\0", 6), std::string("\0\0\1\0\3\0", 6)),
                HasSubstr("index 3 is beyond the 3 vertices"));
    EXPECT_THAT(changed(std::string("\0\0\x80\x40", 4), std::string("\0\0\xC0\x7F", 4)),
                HasSubstr("a position is not a number"));
    EXPECT_THAT(errorOf({'{'}), HasSubstr("line 1"));
    EXPECT_THAT(errorOf({}), HasSubstr("the file is empty"));
    EXPECT_THAT(errorOf({'g', 'l', 'T', 'F', 1, 0, 0, 0}), HasSubstr("byte 4: glTF 1"));
}

// Refused before memory for them is taken.
TEST(GltfReader, TrianglesAreCounted) {
    Chunk chunk;
    chunk.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::string count = std::to_string(3 * (kMaxMeshTriangles + 1));
    chunk.raw(Bytes(3 * (kMaxMeshTriangles + 1)));
    const Bytes file =
        glb(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
            R"({"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
            R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
            R"({"bufferView":1,"componentType":5121,"count":)" +
                count +
                R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":36},)"
                R"({"buffer":0,"byteOffset":36,"byteLength":)" +
                count + R"(}],"buffers":[{"byteLength":)" + std::to_string(chunk.bytes().size()) +
                "}]}",
            chunk.bytes());
    EXPECT_THAT(errorOf(file), HasSubstr("more than 4194304 triangles"));
}

}  // namespace
}  // namespace voxprite::test
