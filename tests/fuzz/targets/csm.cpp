#include "core/io/csm_reader.h"
#include "core/io/csm_writer.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<Octree> octree = octreeFromCsm(bytes);
    if (!octree) return requireReason(octree.error(), bytes.size());
    if (octree->maxDepth > 7) return;  // what unfolds into much is bounded, and slow
    const Result<Document> read = readCsm(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    requireValid(*read);
    const Result<Bytes> written = writeCsm(*read);
    if (!written) return requireReason(written.error(), 0);
    require(octreeFromCsm(*written).has_value());
}
