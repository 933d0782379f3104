// The table of formats, and what joins each reader and writer to it.
#include <algorithm>
#include <array>
#include <utility>

#include "core/io/csm_reader.h"
#include "core/io/csm_writer.h"
#include "core/io/formats.h"
#include "core/io/gltf_buffers.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_voxels.h"
#include "core/io/mesh_writer.h"
#include "core/io/obj_reader.h"
#include "core/io/project_file.h"
#include "core/io/qb.h"
#include "core/io/slices.h"
#include "core/io/svo_file.h"
#include "core/io/vdb.h"
#include "core/io/vox.h"
#include "core/model/entity_voxels.h"

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

Result<LoadedDocument> loadVox(const FileSource& source) {
    Result<VoxImport> import = readVox(source.bytes);
    if (!import) return Failure(import.error());
    return LoadedDocument{.document = std::move(import->document),
                          .warnings = std::move(import->warnings)};
}

Result<Bytes> saveVox(const SaveRequest& request) {
    return writeVox(request.document);
}

Result<LoadedDocument> loadSvo(const FileSource& source) {
    const Result<SvoFile> file = readSvo(source.bytes, source.options.entity);
    if (!file) return Failure(file.error());
    LoadedDocument loaded{.document = documentFromSvo(*file)};
    // At the very edge of what the file may say a document's models have no room to be moved.
    if (Status s = validate(loaded.document); !s) return Failure(s.error());
    return loaded;
}

Result<Bytes> saveSvo(const SaveRequest& request) {
    const Result<SvoFile> baked = bakeForExport(request.document, request.profile);
    if (!baked) return Failure(baked.error());
    Result<Bytes> bytes = writeSvo(*baked);
    if (!bytes) return bytes;
    if (Status same = verifyExport(*bytes, request.document); !same) return Failure(same.error());
    return bytes;
}

// Clips alone give frames their time, and sockets their place in them.
std::vector<std::string> svoLosses(const Document& document) {
    if (document.clips.empty()) return {};
    std::vector<bool> shown(static_cast<std::size_t>(frameCount(document)));
    for (const Clip& clip : document.clips) {
        for (int frame = clip.first; frame <= clip.last; ++frame) {
            shown[static_cast<std::size_t>(frame)] = true;
        }
    }
    const auto lost = std::ranges::count(shown, false);
    if (lost == 0) return {};
    std::vector<std::string> losses{
        ".svo has frames in clips alone: the " + std::to_string(lost) +
        " that no clip shows are added at the end, but for those that look like another"};
    // Frames at the end have sockets where the last clip leaves them.
    const int last = document.clips.back().last;
    const bool moved = std::ranges::any_of(document.sockets, [&](const Socket& socket) {
        for (int frame = 0; frame < frameCount(document); ++frame) {
            if (!shown[static_cast<std::size_t>(frame)] &&
                positionAt(socket, frame) != positionAt(socket, last)) {
                return true;
            }
        }
        return false;
    });
    if (moved) {
        losses.emplace_back(
            ".svo has sockets in clips alone: where they lie in other frames is left out");
    }
    return losses;
}

Result<LoadedDocument> loadCsm(const FileSource& source) {
    // A script may assign nothing, but a file without a byte is what a broken copy leaves.
    if (source.bytes.empty()) return failAtByte(0, "the file is empty");
    Result<Document> document = readCsm(source.bytes);
    if (!document) return Failure(document.error());
    LoadedDocument loaded{.document = std::move(*document)};
    if (loaded.document.models[0].voxels.empty()) {
        loaded.warnings.emplace_back("the text assigns no voxel");
    }
    return loaded;
}

Result<LoadedDocument> loadQb(const FileSource& source) {
    Result<QbImport> import = readQb(source.bytes);
    if (!import) return Failure(import.error());
    return LoadedDocument{.document = std::move(import->document),
                          .warnings = std::move(import->warnings)};
}

Result<Bytes> saveQb(const SaveRequest& request) {
    return writeQb(request.document);
}

Result<LoadedDocument> loadPng(const FileSource& source) {
    Result<SlicesImport> import = readSlices(source.path, source.options.slices);
    if (!import) return Failure(import.error());
    return LoadedDocument{.document = std::move(import->document),
                          .warnings = std::move(import->warnings)};
}

Result<std::vector<NamedBytes>> savePng(const SaveRequest& request) {
    Result<std::vector<SlicePicture>> pictures = writeSlices(request.document, request.name);
    if (!pictures) return Failure(pictures.error());
    if (Status s = checkNeighbours(request.folder / request.name, pictures->size()); !s)
        return Failure(s.error());
    std::vector<NamedBytes> files;
    for (SlicePicture& picture : *pictures) {
        files.push_back({std::move(picture.name), std::move(picture.png)});
    }
    return files;
}

Result<LoadedDocument> loadVdb(const FileSource& source) {
    Result<VdbImport> import = readVdb(source.bytes, source.options.vdb);
    if (!import) return Failure(import.error());
    // Each of its warnings tells of grids that are no longer what they were.
    return LoadedDocument{.document = std::move(import->document),
                          .whole = import->warnings.empty(),
                          .warnings = std::move(import->warnings)};
}

Result<Bytes> saveVdb(const SaveRequest& request) {
    return writeVdb(request.document, {request.profile.voxelSizeMetres, request.profile.sigma});
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

std::vector<std::string> glbLosses(const Document& /*document*/) {
    return {".glb holds surfaces: voxels that no open face shows are left out"};
}

Result<LoadedDocument> loadObj(const FileSource& source) {
    if (Status s = validate(source.options.mesh); !s) return Failure(s.error());
    return loadMesh(readObj(source.bytes, ModelFolder(source.path), source.options.mesh.objUp),
                    source.options);
}

std::vector<std::string> objLosses(const Document& /*document*/) {
    return {".obj holds surfaces: voxels that no open face shows are left out"};
}

constexpr Holds kVoxHolds{.scene = SceneHeld::all,
                          .frames = true,
                          .coordinates = true,
                          .colours = ColoursHeld::palette,
                          .alpha = true,
                          .colourNames = true,
                          .materials = true,
                          .displayOrder = true};
constexpr Holds kSvoHolds{.frames = true,
                          .clips = true,
                          .sockets = true,
                          .entityName = true,
                          .anchor = true,
                          .authored = true,
                          .coordinates = true,
                          .colours = ColoursHeld::palette,
                          .alpha = true,
                          .colourNames = true};

constexpr Holds kVdbHolds{.scene = SceneHeld::objects,
                          .sockets = true,
                          .entityName = true,
                          .anchor = true,
                          .pose = true,
                          .authored = true,
                          .coordinates = true,
                          .colours = ColoursHeld::palette,
                          .alpha = true,
                          .colourNames = true,
                          .materials = true,
                          .displayOrder = true,
                          .ramps = true,
                          .variants = true};

constexpr Holds kGlbHolds{.scene = SceneHeld::seen,
                          .entityName = true,
                          .anchor = true,
                          .coordinates = true,
                          .colours = ColoursHeld::palette};
constexpr Holds kObjHolds{.scene = SceneHeld::objects,
                          .anchor = true,
                          .coordinates = true,
                          .colours = ColoursHeld::palette};

constexpr std::array kFormats{
    FormatInfo{.format = Format::voxprite,
               .name = "voxprite",
               .ending = ".voxprite",
               .title = "voxprite project",
               .load = loadProject,
               .save = saveProject,
               .holds = Holds::everything()},
    FormatInfo{.format = Format::vox,
               .name = "vox",
               .ending = ".vox",
               .title = "MagicaVoxel",
               .load = loadVox,
               .save = saveVox,
               .holds = kVoxHolds,
               .losses = voxLosses},
    FormatInfo{.format = Format::svo,
               .name = "svo",
               .ending = ".svo",
               .title = "Octree for the runtime",
               .load = loadSvo,
               .save = saveSvo,
               .holds = kSvoHolds,
               .losses = svoLosses},
    FormatInfo{.format = Format::csm,
               .name = "csm",
               .ending = ".csm",
               .title = "Cube script",
               .load = loadCsm,
               .save = saveCsm,
               // What lies below 0 is moved, and said so by csmLosses().
               .holds = {.coordinates = true, .colours = ColoursHeld::none},
               .losses = csmLosses},
    FormatInfo{.format = Format::qb,
               .name = "qb",
               .ending = ".qb",
               .title = "Qubicle",
               .load = loadQb,
               .save = saveQb,
               .holds = {.scene = SceneHeld::objects, .coordinates = true},
               .losses = qbLosses},
    FormatInfo{.format = Format::png,
               .name = "png",
               .ending = ".png",
               .title = "Pictures of layers",
               .load = loadPng,
               .saveFiles = savePng,
               .names = sliceNames,
               .folders = true,
               .holds = {.coordinates = true, .alpha = true},
               .losses = sliceLosses},
    FormatInfo{.format = Format::vdb,
               .name = "vdb",
               .ending = ".vdb",
               .title = "OpenVDB",
               .load = loadVdb,
               .save = saveVdb,
               .holds = kVdbHolds},
    FormatInfo{.format = Format::glb,
               .name = "glb",
               .ending = ".glb",
               .title = "glTF mesh",
               .load = loadGltf,
               .save = writeGlb,
               .refersTo = gltfRefersTo,
               .keepsVoxels = false,
               .holds = kGlbHolds,
               .losses = glbLosses},
    FormatInfo{.format = Format::gltf,
               .name = "gltf",
               .ending = ".gltf",
               .title = "glTF mesh, text",
               .load = loadGltf,
               .refersTo = gltfRefersTo,
               .keepsVoxels = false},
    FormatInfo{.format = Format::obj,
               .name = "obj",
               .ending = ".obj",
               .title = "Wavefront mesh",
               .load = loadObj,
               .saveFiles = writeObj,
               .names = objNames,
               .refersTo = objRefersTo,
               .keepsVoxels = false,
               .holds = kObjHolds,
               .losses = objLosses},
};

}  // namespace

std::span<const FormatInfo> formats() {
    return kFormats;
}

}  // namespace voxprite
