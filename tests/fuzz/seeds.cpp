// Writes what the fuzzers start from: FOLDER/<target>/<file>, the same on every run.
//     fuzz_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/base/file.h"
#include "core/edit/palette_edits.h"
#include "core/io/csm_writer.h"
#include "core/io/mesh_writer.h"
#include "core/io/palette_files.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "core/io/project_file.h"
#include "core/io/project_json.h"
#include "core/io/qb.h"
#include "core/io/slices.h"
#include "core/io/svo_file.h"
#include "core/io/vdb.h"
#include "core/io/vox.h"
#include "core/io/voxel_payload.h"
#include "tests/support/voxels.h"

using namespace voxprite;

namespace {

class Seeds {
  public:
    explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void add(const std::string& target, const std::string& name, ByteView bytes) {
        std::filesystem::create_directories(folder_ / target);
        const Status written = writeFileAtomically(folder_ / target / name, bytes);
        if (!written) complain(written.error());
    }
    void add(const std::string& target, const std::string& name, const Result<Bytes>& bytes) {
        if (bytes) add(target, name, ByteView(*bytes));
        if (!bytes) complain(bytes.error());
    }
    void add(const std::string& target, const std::string& name, const std::string& text) {
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
        add(target, name, ByteView(bytes, text.size()));
    }
    [[nodiscard]] bool complete() const { return complete_; }

  private:
    void complain(const Error& error) {
        std::fprintf(stderr, "%s\n", error.describe().c_str());
        complete_ = false;
    }
    std::filesystem::path folder_;
    bool complete_ = true;
};

void addMeshes(Seeds& seeds, const std::string& name, const Document& document) {
    for (const bool vertexColours : {false, true}) {
        const GameProfile profile;
        const WriteOptions options{{vertexColours}};
        const SaveRequest request{document, profile, options, "seed.obj", {}, {}};
        const std::string variant = name + (vertexColours ? "-vertices" : "-texture");
        seeds.add("gltf", variant, writeGlb(request));
        const Result<std::vector<NamedBytes>> files = writeObj(request);
        seeds.add("obj", variant, files.map([](const auto& all) { return all.back().bytes; }));
    }
}

// A .gltf that carries its buffer as text: a triangle, one vertex of it far away.
constexpr const char* kGltfOfText = R"({"asset": {"version": "2.0"}, "scene": 0,
"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "scale": [1, 2, -1], "translation": [1, 0, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 4, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}, "alphaMode": "MASK"}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                                    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAIA/"
                                    R"("}]})";

void addDocument(Seeds& seeds, const std::string& name, const Document& document) {
    seeds.add("vox", name, writeVox(document));
    seeds.add("csm", name, writeCsm(document));
    seeds.add("project", name, writeProject(document));
    seeds.add("qb", name, writeQb(document));
    seeds.add("vdb", name, writeVdb(document, document.authored));
    const Result<std::vector<SlicePicture>> strip = writeSlices(document, "strip.png");
    if (strip) seeds.add("slices", name, ByteView(strip->front().png));
    const std::vector<VoxelEntry> entries(document.models.size(), VoxelEntry{"models", 0, 0});
    seeds.add("project_json", name, writeProjectJson(document, document.authored, entries));
    const Result<SvoFile> octrees = bakeForExport(document, GameProfile{});
    if (octrees) {
        seeds.add("svo", name, writeSvo(*octrees));
        seeds.add("svo", name + "-set", writeSvoSet(std::vector{*octrees, *octrees}));
    }
    for (std::size_t k = 0; k < document.models.size(); ++k) {
        seeds.add("voxel_payload", name + std::to_string(k),
                  writeVoxelPayload(document.models[k].voxels));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
        return 2;
    }
    Seeds seeds(argv[1]);
    addDocument(seeds, "busy", test::busyDocument());
    const Document figure = test::documentOf(test::figure());
    addDocument(seeds, "figure", figure);
    addMeshes(seeds, "figure", figure);
    addMeshes(seeds, "box", test::documentOf(test::solidBox({1, 2, 3})));
    addDocument(seeds, "noise", test::documentOf(test::randomVoxels(1, {5, 7, 9}, 0.3, 200)));
    addDocument(seeds, "frames",
                test::animationOf({test::asymmetric(), test::solidBox({8, 8, 8}, 7)}));

    const ColourList colours = colourList(Palette::standard());
    seeds.add("palettes", "standard.gpl", writeGimpPalette(colours, "standard"));
    seeds.add("palettes", "standard.pal", writeJascPalette(colours));
    seeds.add("palettes", "standard.png", writePalettePicture(colours));
    Image image(3, 2, {10, 20, 30, 255});
    image.at(1, 1) = {255, 0, 0, 128};
    seeds.add("png", "small.png", writePng(image));
    seeds.add("gltf", "text.gltf", std::string(kGltfOfText));
    seeds.add("obj", "hand.obj",
              std::string("mtllib none.mtl\no box\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0\nv 0 1 1\n"
                          "vt 0.5 0.5\nvn 0 0 1\nusemtl red\ng side\nf 1/1/1 2/1/1 3//1 -1\n"));
    seeds.add("profile", "default.json", writeProfile(GameProfile{}));
    return seeds.complete() ? 0 : 1;
}
