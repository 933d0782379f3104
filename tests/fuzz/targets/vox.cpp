#include "core/io/vox.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<VoxImport> read = readVox(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    requireValid(read->document);
    if (!isSmall(read->document)) return;
    const Result<Bytes> written = writeVox(read->document);
    if (!written) return requireReason(written.error(), 0);
    require(readVox(*written).has_value());
}
