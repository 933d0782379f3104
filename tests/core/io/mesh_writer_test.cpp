// Written meshes: their quads are the open faces, their bytes are glTF, and read again they are the
// voxels that they came from.
#include "core/io/mesh_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/file.h"
#include "core/io/obj_reader.h"
#include "core/io/png.h"
#include "core/io/quad_mesh.h"
#include "core/io/voxel_quads.h"
#include "core/model/entity_voxels.h"
#include "tests/core/io/mesh_shapes.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

Bytes glbOf(const Document& document, const WriteOptions& options = {}) {
    const GameProfile profile;
    return must(writeGlb({document, profile, options, "model.glb", {}}));
}

// Every face between a solid voxel and an empty one, by voxel and direction.
std::map<std::tuple<int, int, int, int>, std::uint8_t> openFaces(const VoxelGrid& voxels) {
    std::map<std::tuple<int, int, int, int>, std::uint8_t> faces;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        for (std::uint8_t face = 0; face < 6; ++face) {
            if (voxels.get(v + normalOf(face)) == 0) faces[{v.x, v.y, v.z, face}] = value;
        }
    });
    return faces;
}

void expectQuadsAreOpenFaces(const VoxelGrid& voxels) {
    auto open = openFaces(voxels);
    for (const VoxelQuad& quad : must(openQuads(voxels))) {
        const int axis = quad.face % 3;
        glm::ivec3 first = quad.min, last = quad.max;
        if (quad.face < 3) --first[axis];
        last[axis] = first[axis] + 1;
        for (glm::ivec3 v = first; v.z < last.z; ++v.z) {
            for (v.y = first.y; v.y < last.y; ++v.y) {
                for (v.x = first.x; v.x < last.x; ++v.x) {
                    const auto found = open.find({v.x, v.y, v.z, quad.face});
                    ASSERT_NE(found, open.end()) << "covered twice, or not open";
                    ASSERT_EQ(found->second, quad.material);
                    open.erase(found);
                }
            }
        }
    }
    EXPECT_TRUE(open.empty());
}

TEST(VoxelQuads, AreExactlyTheOpenFaces) {
    expectQuadsAreOpenFaces(VoxelGrid{});
    expectQuadsAreOpenFaces(figure());
    expectQuadsAreOpenFaces(asymmetric());
    expectQuadsAreOpenFaces(shellSphere(20));
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
        expectQuadsAreOpenFaces(
            randomVoxels(seed, {19, 11, 23}, 0.2 * static_cast<double>(seed), 3));
    }
    // Across blocks, tiles, squares of the merging and the origin.
    VoxelGrid wide;
    wide.fill({{-70, -9, -3}, {70, 80, 70}}, 5);
    wide.fill({{-1, -9, -3}, {1, 80, 0}}, 0);
    wide.set({1023, 4, 4}, 1);
    wide.set({1024, 4, 4}, 1);
    wide.set({kMaxCoordinate, -kMaxCoordinate, kMaxCoordinate}, 9);
    expectQuadsAreOpenFaces(wide);
}

TEST(VoxelQuads, ABoxHasSix) {
    EXPECT_EQ(must(openQuads(solidBox({100, 50, 300}))).size(), 6u);
    const QuadMesh mesh = must(quadMeshOf(solidBox({100, 50, 300})));
    EXPECT_EQ(mesh.vertices.size(), 24u);  // three normals meet in each corner
    EXPECT_EQ(mesh.indices.size(), 36u);
}

TEST(QuadMesh, TrianglesLookOutwardAndShareVertices) {
    const QuadMesh mesh = must(quadMeshOf(figure()));
    const std::size_t quads = must(openQuads(figure())).size();
    EXPECT_EQ(mesh.indices.size(), 6 * quads);
    EXPECT_LT(mesh.vertices.size(), 4 * quads);
    std::set<std::tuple<float, float, float, int, int>> distinct;
    for (const QuadVertex& v : mesh.vertices) {
        EXPECT_TRUE(distinct.insert({v.x, v.y, v.z, v.material, v.face}).second);
    }
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
        glm::dvec3 at[3];
        for (std::size_t c = 0; c < 3; ++c) {
            const QuadVertex& v = mesh.vertices.at(mesh.indices[k + c]);
            at[c] = {v.x, v.y, v.z};
            EXPECT_EQ(v.face, mesh.vertices[mesh.indices[k]].face);
            EXPECT_EQ(v.material, mesh.vertices[mesh.indices[k]].material);
        }
        const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
        const glm::dvec3 normal(normalOf(mesh.vertices[mesh.indices[k]].face));
        EXPECT_GT(glm::dot(across, normal), 0.99);
    }
}

// The longest side of the flattened model is what brings it back at its own resolution.
LoadedDocument readBack(Result<MeshImport> import, const Document& document, bool solid = true) {
    const glm::ivec3 size = frameBounds(document, 0).size();
    return must(voxelsOf(std::move(must(std::move(import)).mesh),
                         options(std::max({size.x, size.y, size.z}), solid)));
}

void expectSame(const LoadedDocument& loaded, const Document& document) {
    const VoxelGrid flat = flatten(document, 0);
    const glm::ivec3 corner = flat.bounds().min;
    EXPECT_TRUE(loaded.warnings.empty());
    ASSERT_EQ(voxelsIn(loaded).bounds(), (IBox{{0, 0, 0}, flat.bounds().size()}));
    EXPECT_EQ(voxelsIn(loaded).solidCount(), flat.solidCount());
    flat.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        ASSERT_NE(voxelsIn(loaded).get(v - corner), 0);
        bool open = false;
        for (std::uint8_t face = 0; face < 6; ++face) open |= flat.get(v + normalOf(face)) == 0;
        if (!open) return;
        Rgba8 colour = document.palette.colours[value];
        colour.w = 255;
        ASSERT_EQ(colourIn(loaded, v - corner), colour) << v.x << ' ' << v.y << ' ' << v.z;
    });
    const glm::dvec3 anchor = anchorVoxels(loaded.document.entity, voxelsIn(loaded).bounds());
    const glm::dvec3 expected = originOf(document) - glm::dvec3(corner);
    EXPECT_LT(glm::length(anchor - expected), 1e-3);
}

// Objects side by side, turned and mirrored, in a group that is itself mirrored.
Document scene() {
    Document document = documentOf(asymmetric());
    document.palette.colours[3] = Rgba8(1, 2, 3, 128);
    const auto add = [&](int parent, const std::string& name, Placement placement) {
        SceneNode node;
        node.name = name;
        node.parent = parent;
        node.placements[0].placement = placement;
        document.nodes[static_cast<std::size_t>(parent)].children.push_back(
            static_cast<int>(document.nodes.size()));
        document.nodes.push_back(node);
        return static_cast<int>(document.nodes.size()) - 1;
    };
    const int group = add(0, "group", {{{1, 0, 2}, {-1, 1, -1}}, {60, -30, 40}});
    const int mirrored = add(group, "mirrored", {{{0, 1, 2}, {-1, 1, 1}}, {0, 30, 0}});
    const int turned = add(group, "turned \xFF", {{{2, 0, 1}, {1, -1, 1}}, {-30, -30, -30}});
    document.nodes[static_cast<std::size_t>(mirrored)].models = {{0, 0}};
    document.nodes[static_cast<std::size_t>(turned)].models = {{0, 0}};
    return document;
}

// Each of a chequered row of boxes beside the next.
Document touching() {
    Document document = documentOf(solidBox({3, 4, 5}, 1));
    for (const std::uint8_t colour : std::initializer_list<std::uint8_t>{9, 4, 7}) {
        SceneNode node;
        node.parent = 0;
        node.models = {{0, static_cast<int>(document.models.size())}};
        node.placements[0].placement.translation = {3 * static_cast<int>(document.models.size()), 0,
                                                    1};
        document.models.push_back({solidBox({3, 4, 5}, colour), {}});
        document.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
        document.nodes.push_back(node);
    }
    return document;
}

TEST(MeshRoundTrip, GlbGivesTheVoxelsBack) {
    Document noise = documentOf(randomVoxels(3, {24, 17, 31}, 0.5, 255));
    noise.entity.anchorVoxels = glm::dvec3(3.0, -2.5, 40.0);
    for (const Document& document :
         {documentOf(figure()), scene(), noise, touching(), documentOf(shellSphere(33)),
          documentOf(solidBox({1, 1, 1}))}) {
        WriteOptions colours;
        colours.mesh.vertexColours = true;
        for (const WriteOptions& options : {WriteOptions{}, colours}) {
            const Bytes file = glbOf(document, options);
            ASSERT_TRUE(file == glbOf(document, options));
            expectSame(readBack(readGltf(file, ModelFolder()), document), document);
        }
    }
}

TEST(MeshRoundTrip, ObjGivesTheVoxelsBack) {
    const TemporaryFolder folder;
    for (const Document& document : {scene(), documentOf(randomVoxels(4, {13, 17, 9}, 0.4, 99))}) {
        for (const bool colours : {false, true}) {
            WriteOptions options;
            options.mesh.vertexColours = colours;
            const auto path = folder / "my model.obj";
            ASSERT_TRUE(saveDocument(path, document, {}, {}, options));
            EXPECT_EQ(std::filesystem::exists(folder / "my_model.png"), !colours);
            const Bytes text = must(readFile(path));
            expectSame(readBack(readObj(text, ModelFolder(path), MeshUpAxis::y), document),
                       document);
            std::filesystem::remove(folder / "my_model.png");
        }
    }
}

// Hollow, it is the voxels that an open face shows.
TEST(MeshRoundTrip, WithoutFillingTheOpenVoxelsComeBack) {
    const Document document = documentOf(figure());
    const LoadedDocument loaded =
        readBack(readGltf(glbOf(document), ModelFolder()), document, false);
    std::set<std::tuple<int, int, int>> open;
    for (const auto& [face, value] : openFaces(figure())) {
        open.insert({std::get<0>(face), std::get<1>(face), std::get<2>(face)});
    }
    EXPECT_EQ(voxelsIn(loaded).solidCount(), open.size());
    for (const auto& [x, y, z] : open) EXPECT_NE(voxelsIn(loaded).get({x, y, z}), 0);
}

TEST(MeshRoundTrip, TheSamplesComeBack) {
    for (const std::string name : {"knight.vox", "village.voxprite"}) {
        const Document document =
            must(loadDocument(std::filesystem::path(VOXPRITE_SOURCE_DIR) / "samples" / name))
                .document;
        const LoadedDocument loaded = readBack(readGltf(glbOf(document), ModelFolder()), document);
        const VoxelGrid flat = flatten(document, 0);
        const glm::ivec3 corner = flat.bounds().min;
        EXPECT_EQ(voxelsIn(loaded).solidCount(), flat.solidCount()) << name;
        flat.forEachSolid([&](glm::ivec3 v, std::uint8_t) {
            ASSERT_NE(voxelsIn(loaded).get(v - corner), 0) << name;
        });
    }
}

// By another parser: the file's structure, the names, that each number lies where it should.
TEST(GlbWriter, WritesWhatTheSpecificationAsksFor) {
    const Document document = scene();
    const Bytes file = glbOf(document);
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + at, 4);
        return value;
    };
    ASSERT_EQ(word(0), 0x46546C67u);
    EXPECT_EQ(word(4), 2u);
    EXPECT_EQ(word(8), file.size());
    const std::size_t jsonSize = word(12);
    EXPECT_EQ(word(16), 0x4E4F534Au);
    EXPECT_EQ(jsonSize % 4, 0u);
    const Json json = Json::parse(file.begin() + 20, file.begin() + 20 + jsonSize);
    const std::size_t start = 20 + jsonSize + 8;
    EXPECT_EQ(word(start - 8), file.size() - start);
    EXPECT_EQ(word(start - 4), 0x004E4942u);
    EXPECT_EQ(json["asset"]["version"], "2.0");
    EXPECT_EQ(json["buffers"].size(), 1u);
    EXPECT_EQ(json["buffers"][0]["byteLength"], file.size() - start);
    EXPECT_FALSE(json["buffers"][0].contains("uri"));
    // One model, three objects that show it.
    EXPECT_EQ(json["meshes"].size(), 1u);
    std::map<std::string, int> shown;
    std::vector<int> parents(json["nodes"].size());
    for (const Json& node : json["nodes"]) {
        if (node.contains("mesh")) ++shown[node["name"]];
        for (const int child : node.value("children", std::vector<int>{})) ++parents.at(child);
    }
    EXPECT_EQ(shown.size(), 3u);
    EXPECT_EQ(shown["mirrored"], 1);
    EXPECT_EQ(std::ranges::count(parents, 0), 1);
    EXPECT_EQ(std::ranges::count(parents, 1), static_cast<int>(parents.size()) - 1);
    std::size_t end = 0;
    for (const Json& view : json["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
        EXPECT_GE(view["byteOffset"].get<std::size_t>(), end);
        end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
    }
    EXPECT_LE(end, file.size() - start);
    const Json& primitive = json["meshes"][0]["primitives"][0];
    const auto floats = [&](const char* attribute) {
        const Json& accessor = json["accessors"][primitive["attributes"][attribute].get<int>()];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<int>()];
        std::vector<float> numbers(view["byteLength"].get<std::size_t>() / 4);
        std::memcpy(numbers.data(), file.data() + start + view["byteOffset"].get<std::size_t>(),
                    4 * numbers.size());
        return std::pair(accessor, numbers);
    };
    const auto [accessor, positions] = floats("POSITION");
    for (int k = 0; k < 3; ++k) {
        float low = 1e9f, high = -1e9f;
        for (std::size_t at = static_cast<std::size_t>(k); at < positions.size(); at += 3) {
            low = std::min(low, positions[at]);
            high = std::max(high, positions[at]);
        }
        EXPECT_EQ(accessor["min"][k].get<float>(), low);
        EXPECT_EQ(accessor["max"][k].get<float>(), high);
    }
    // Height along Y, in metres of 0.1.
    const IBox bounds = asymmetric().bounds();
    EXPECT_FLOAT_EQ(accessor["max"][1].get<float>(), static_cast<float>(bounds.max.z) * 0.1f);
    for (const float u : floats("TEXCOORD_0").second) {
        if (u != 0.5f) {
            EXPECT_EQ(std::fmod(u * 256.0f, 1.0f), 0.5f);
        }
    }
    const Json& image = json["bufferViews"][json["images"][0]["bufferView"].get<int>()];
    const Image palette = must(readPng(ByteView(file).subspan(
        start + image["byteOffset"].get<std::size_t>(), image["byteLength"].get<std::size_t>())));
    EXPECT_EQ(palette.width, 256);
    EXPECT_EQ(palette.at(3, 0), Rgba8(1, 2, 3, 255));
    EXPECT_EQ(json["samplers"][0]["magFilter"], 9728);
}

TEST(GlbWriter, AnEmptyDocumentIsAValidFile) {
    const Bytes file = glbOf(Document::withEmptyModel());
    const MeshImport import = must(readGltf(file, ModelFolder()));
    EXPECT_TRUE(import.mesh.triangles.empty());
}

TEST(MeshLosses, AreListed) {
    Document document = busyDocument();
    document.models.push_back(document.models[0]);
    document.palette.variants = {{"Red", {{1, Rgba8(255, 0, 0, 255)}}}};
    document.palette.ramps = {{"stone", {1, 2, 3}}};
    document.cameras = {{4, {{"_mode", "pers"}}}};
    document.nodes[3].attributes = {{"_other", "1"}};
    for (const Format format : {Format::glb, Format::obj}) {
        const std::vector<std::string> losses = lossesOf(document, format);
        for (const char* what : {"frames: 4 left out", "clips", "sockets", "hidden objects",
                                 "names of colours", "materials", "order of display",
                                 "transparency", "variants", "ramps", "models that no object shows",
                                 "cameras", "layers", "locks", "attributes", "rotation, scale"}) {
            EXPECT_THAT(losses, Contains(HasSubstr(what))) << infoOf(format).ending;
        }
    }
    const auto groups = [&](Format format) {
        return testing::Matches(Contains(HasSubstr("groups")))(lossesOf(document, format));
    };
    EXPECT_TRUE(groups(Format::obj));
    EXPECT_FALSE(groups(Format::glb)) << "which has them";
    EXPECT_EQ(lossesOf(documentOf(figure()), Format::obj).size(), 1u);
}

// What overlaps and what is hidden, by the shape alone.
TEST(MeshRoundTrip, ABusyDocumentKeepsItsShape) {
    const Document document = busyDocument();
    const LoadedDocument loaded = readBack(readGltf(glbOf(document), ModelFolder()), document);
    const VoxelGrid flat = flatten(document, 0);
    EXPECT_EQ(voxelsIn(loaded).solidCount(), flat.solidCount());
    EXPECT_EQ(voxelsIn(loaded).bounds().size(), flat.bounds().size());
}

}  // namespace
}  // namespace voxprite::test
