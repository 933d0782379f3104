#include "core/io/gltf_reader.h"
#include "core/io/mesh_voxels.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    Result<MeshImport> read = readGltf(bytes, ModelFolder());
    if (!read) return requireReason(read.error(), bytes.size());
    // Voxelising takes a hundred times as long as reading.
    if (!isOneIn(8, bytes)) return;
    MeshReadOptions options;
    options.resolution = 8;
    options.threads = 1;
    const Result<LoadedDocument> voxels = voxelsOf(std::move(read->mesh), options);
    if (!voxels) return requireReason(voxels.error(), bytes.size());
    requireValid(voxels->document);
}
