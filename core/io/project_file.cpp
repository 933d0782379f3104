#include "core/io/project_file.h"

#include "core/base/hash.h"
#include "core/io/project_json.h"
#include "core/io/voxel_payload.h"
#include "core/io/zip_archive.h"

namespace voxprite {
namespace {

constexpr const char* kProjectEntry = "project.json";

// An error inside an entry of the archive: lines stay, bytes are those of the inflated entry.
Failure failInEntry(const std::string& entry, Error error) {
    if (error.offset) {
        error.message = "byte " + std::to_string(*error.offset) + ": " + error.message;
        error.offset.reset();
    }
    error.message = entry + ": " + error.message;
    return Failure(std::move(error));
}

Result<VoxelGrid> readVoxels(const VoxelEntry& entry, ByteView bytes, GridBudget& budget) {
    if (kChecksumsCount && crc32(bytes) != entry.crc32)
        return fail("the checksum in project.json does not match");
    Result<VoxelGrid> voxels = readVoxelPayload(bytes, budget);
    if (voxels && voxels->solidCount() != entry.solidVoxels) {
        return fail("the number of voxels in project.json does not match");
    }
    return voxels;
}

}  // namespace

Result<Bytes> writeProject(const Document& document) {
    return writeProject(document, document.authored);
}

Result<Bytes> writeProject(const Document& document, const AuthoredValues& authored) {
    if (Status valid = validate(document); !valid) return Failure(valid.error());
    std::vector<VoxelEntry> voxelEntries;
    std::vector<ZipEntry> entries(1);
    std::uint64_t bytesLeft = kMaxProjectVoxelBytes;
    for (const Model& model : document.models) {
        Result<Bytes> payload = writeVoxelPayload(model.voxels);
        if (!payload) return Failure(payload.error());
        if (payload->size() > bytesLeft) {
            return fail("the voxels of all models would take more than the " +
                        std::to_string(kMaxProjectVoxelBytes >> 30) + " GiB that can be read back");
        }
        bytesLeft -= payload->size();
        const std::string name = "models/" + std::to_string(voxelEntries.size()) + ".voxels";
        voxelEntries.push_back({name, crc32(*payload), model.voxels.solidCount()});
        entries.push_back({name, std::move(*payload)});
    }
    const std::string json = writeProjectJson(document, authored, voxelEntries);
    if (json.size() > kMaxProjectJsonBytes) {
        return fail("the scene, without voxels, would take " + std::to_string(json.size() >> 20) +
                    " MiB; " + std::to_string(kMaxProjectJsonBytes >> 20) +
                    " MiB can be read back. Fewer objects or keys take less");
    }
    entries.front() = {kProjectEntry, Bytes(json.begin(), json.end())};
    return writeZip(entries);
}

Result<Document> readProject(ByteView bytes) {
    const Result<ZipReader> archive = ZipReader::open(bytes);
    if (!archive) return Failure(archive.error());
    const Result<Bytes> text = archive->read(kProjectEntry, kMaxProjectJsonBytes);
    if (!text) return Failure(text.error());
    Result<ProjectJson> project =
        readProjectJson({reinterpret_cast<const char*>(text->data()), text->size()});
    if (!project) return failInEntry(kProjectEntry, project.error());

    Document& document = project->document;
    std::uint64_t bytesLeft = kMaxProjectVoxelBytes;
    GridBudget budget(bytes.size());
    for (std::size_t k = 0; k < document.models.size(); ++k) {
        const VoxelEntry& entry = project->entries[k];
        const Result<Bytes> payload = archive->read(entry.file, bytesLeft);
        if (!payload) return Failure(payload.error());
        bytesLeft -= payload->size();
        Result<VoxelGrid> voxels = readVoxels(entry, *payload, budget);
        if (!voxels) return failInEntry(entry.file, voxels.error());
        document.models[k].voxels = std::move(*voxels);
    }
    if (Status valid = validate(document); !valid) {
        return failInEntry(kProjectEntry, valid.error());
    }
    return std::move(document);
}

}  // namespace voxprite
