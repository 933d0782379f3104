#include <algorithm>
#include <exception>

#include "core/base/hash.h"
#include "core/io/project_json.h"
#include "core/io/vdb.h"
#include "core/model/entity_voxels.h"
#include "core/volume/volume_library.h"

namespace voxprite {
namespace {

constexpr std::size_t kIdentityAt = 21;  // in the file
constexpr std::size_t kIdentityLength = 36;

void addGrid(VdbWriter& writer, const Document& document, const Instance& instance,
             double voxelSizeMetres) {
    writer.beginGrid(document.nodes[static_cast<std::size_t>(instance.node)].name, voxelSizeMetres);
    const VoxelGrid& voxels = document.models[static_cast<std::size_t>(instance.model)].voxels;
    const Placement& placement = instance.entityFromModel;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        const IBox cube{block.origin, block.origin + block.edgeVoxels};
        if (block.voxels == nullptr) {
            writer.fill(placement.applyToBox(cube), block.uniformValue);
            return;
        }
        for (int n = 0; n < 512; ++n) {
            if (block.voxels[n] == 0) continue;
            const glm::ivec3 v = block.origin + glm::ivec3(n >> 6, n >> 3 & 7, n & 7);
            writer.set(placement.applyToVoxel(v), block.voxels[n]);
        }
    });
}

// All that a project has but the scene, as text.
std::string restOf(const Document& document, const AuthoredValues& authored) {
    Document rest = Document::withEmptyModel();
    rest.palette = document.palette;
    rest.entity = document.entity;
    for (const Socket& socket : document.sockets) {
        rest.sockets.push_back({socket.name, {{0, positionAt(socket, 0)}}});
    }
    return writeProjectJson(rest, authored, {VoxelEntry{"grids", 0, 0}});
}

}  // namespace

Result<Bytes> writeVdb(const Document& document, const AuthoredValues& authored) {
    if (Status s = validate(document); !s) return Failure(s.error());
    const Result<const VolumeLibrary*> library = volumeLibrary();
    if (!library) return Failure(library.error());
    std::string text;
    try {
        const std::unique_ptr<VdbWriter> writer = (*library)->vdbWriter();
        for (const Instance& instance : instancesOf(document, 0)) {
            addGrid(*writer, document, instance, authored.voxelSizeMetres);
        }
        text = writer->file("voxprite", restOf(document, authored));
    } catch (const std::exception& error) {
        return fail(std::string("OpenVDB cannot write the grids: ") + error.what());
    }
    if (text.size() < kIdentityAt + kIdentityLength) return fail("OpenVDB wrote no file");
    // OpenVDB gives each file a random identity: 8-4-4-4-12 digits. Ours is that of the content.
    const auto identity = [&] { return text.begin() + static_cast<std::ptrdiff_t>(kIdentityAt); };
    std::fill_n(identity(), kIdentityLength, '0');
    std::string digits =
        sha256Hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    for (const std::size_t dash : {8u, 13u, 18u, 23u}) digits[dash] = '-';
    std::copy_n(digits.begin(), kIdentityLength, identity());
    return Bytes(text.begin(), text.end());
}

}  // namespace voxprite
