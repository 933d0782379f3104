// The table of formats, and what joins each reader and writer to it.
#include <array>
#include <utility>

#include "core/io/csm_reader.h"
#include "core/io/csm_writer.h"
#include "core/io/formats.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_voxels.h"
#include "core/io/mesh_writer.h"
#include "core/io/obj_reader.h"
#include "core/io/project_file.h"
#include "core/io/svo_file.h"
#include "core/io/vox.h"

namespace voxprite {
namespace {

Result<LoadedDocument> loadProject(const FileSource& source) {
    Result<Document> document = readProject(source.bytes);
    if (!document) return Failure(document.error());
    return LoadedDocument{.document = std::move(*document)};
}

Result<Bytes> saveProject(const SaveRequest& request) {
    return writeProject(request.document, {request.profile.voxelSizeMetres, request.profile.sigma});
}

std::vector<std::string> noLosses(const Document& /*document*/) {
    return {};
}

// What the palettes of .vox and .svo have no words for.
std::vector<std::string> paletteLosses(const Palette& palette, const std::string& where) {
    std::vector<std::string> losses;
    if (!palette.variants.empty()) {
        std::string names;
        for (const PaletteVariant& variant : palette.variants) {
            names += (names.empty() ? "" : ", ") + variant.name;
        }
        losses.push_back(where + " holds one palette: the variants are left out (" + names + ")");
    }
    if (!palette.ramps.empty()) {
        losses.push_back(where + " has no colour ramps: " + std::to_string(palette.ramps.size()) +
                         " left out");
    }
    return losses;
}

Result<LoadedDocument> loadVox(const FileSource& source) {
    Result<VoxImport> import = readVox(source.bytes);
    if (!import) return Failure(import.error());
    return LoadedDocument{.document = std::move(import->document),
                          .warnings = std::move(import->warnings)};
}

Result<Bytes> saveVox(const SaveRequest& request) {
    return writeVox(request.document);
}

std::vector<std::string> voxLosses(const Document& document) {
    std::vector<std::string> losses = paletteLosses(document.palette, ".vox");
    const auto leftOut = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        losses.push_back(std::string(".vox has no ") + what + ": " + std::to_string(count) +
                         " left out");
    };
    leftOut(document.clips.size(), "clips");
    leftOut(document.sockets.size(), "sockets");
    return losses;
}

Result<LoadedDocument> loadSvo(const FileSource& source) {
    const Result<SvoFile> file = readSvo(source.bytes);
    if (!file) return Failure(file.error());
    return LoadedDocument{.document = documentFromSvo(*file)};
}

Result<Bytes> saveSvo(const SaveRequest& request) {
    const Result<SvoFile> baked = bakeForExport(request.document, request.profile);
    if (!baked) return Failure(baked.error());
    Result<Bytes> bytes = writeSvo(*baked);
    if (!bytes) return bytes;
    if (Status same = verifyExport(*bytes, request.document); !same) return Failure(same.error());
    return bytes;
}

std::vector<std::string> svoLosses(const Document& document) {
    return paletteLosses(document.palette, ".svo");
}

Result<LoadedDocument> loadCsm(const FileSource& source) {
    Result<Document> document = readCsm(source.bytes);
    if (!document) return Failure(document.error());
    LoadedDocument loaded{.document = std::move(*document)};
    if (loaded.document.models[0].voxels.empty()) {
        loaded.warnings.emplace_back("the text assigns no voxel");
    }
    return loaded;
}

Result<Bytes> saveCsm(const SaveRequest& request) {
    return writeCsm(request.document);
}

Result<LoadedDocument> loadMesh(Result<MeshImport> import, const ReadOptions& options) {
    if (!import) return Failure(import.error());
    Result<LoadedDocument> loaded = voxelsOf(std::move(import->mesh), options.mesh);
    if (!loaded) return loaded;
    std::vector<std::string>& warnings = loaded->warnings;
    warnings.insert(warnings.begin(), import->warnings.begin(), import->warnings.end());
    return loaded;
}

Result<LoadedDocument> loadGltf(const FileSource& source) {
    if (Status s = validate(source.options.mesh); !s) return Failure(s.error());
    return loadMesh(readGltf(source.bytes, ModelFolder(source.path)), source.options);
}

std::vector<std::string> glbLosses(const Document& document) {
    return meshLosses(document, ".glb");
}

Result<LoadedDocument> loadObj(const FileSource& source) {
    if (Status s = validate(source.options.mesh); !s) return Failure(s.error());
    return loadMesh(readObj(source.bytes, ModelFolder(source.path), source.options.mesh.objUp),
                    source.options);
}

std::vector<std::string> objLosses(const Document& document) {
    return meshLosses(document, ".obj");
}

constexpr std::array kFormats{
    FormatInfo{.format = Format::voxprite,
               .name = "voxprite",
               .ending = ".voxprite",
               .title = "voxprite project",
               .load = loadProject,
               .save = saveProject,
               .losses = noLosses},
    FormatInfo{.format = Format::vox,
               .name = "vox",
               .ending = ".vox",
               .title = "MagicaVoxel",
               .load = loadVox,
               .save = saveVox,
               .losses = voxLosses},
    FormatInfo{.format = Format::svo,
               .name = "svo",
               .ending = ".svo",
               .title = "Octree for the runtime",
               .load = loadSvo,
               .save = saveSvo,
               .losses = svoLosses},
    FormatInfo{.format = Format::csm,
               .name = "csm",
               .ending = ".csm",
               .title = "Cube script",
               .load = loadCsm,
               .save = saveCsm,
               .losses = csmLosses},
    FormatInfo{.format = Format::glb,
               .name = "glb",
               .ending = ".glb",
               .title = "glTF mesh",
               .load = loadGltf,
               .save = writeGlb,
               .losses = glbLosses},
    FormatInfo{.format = Format::gltf,
               .name = "gltf",
               .ending = ".gltf",
               .title = "glTF mesh, text",
               .load = loadGltf},
    FormatInfo{.format = Format::obj,
               .name = "obj",
               .ending = ".obj",
               .title = "Wavefront mesh",
               .load = loadObj,
               .saveFiles = writeObj,
               .losses = objLosses},
};

}  // namespace

std::span<const FormatInfo> formats() {
    return kFormats;
}

}  // namespace voxprite
