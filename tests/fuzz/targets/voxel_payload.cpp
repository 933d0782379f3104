#include "core/io/voxel_payload.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    GridBudget budget(bytes.size()), another(bytes.size());
    const Result<VoxelGrid> read = readVoxelPayload(bytes, budget);
    if (!read) return requireReason(read.error(), bytes.size());
    const Result<Bytes> written = writeVoxelPayload(*read);
    require(written.has_value());
    const Result<VoxelGrid> again = readVoxelPayload(*written, another);
    require(again.has_value() && *again == *read);
}
