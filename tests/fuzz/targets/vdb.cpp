#include "core/io/vdb.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<VdbImport> read = readVdb(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    requireValid(read->document);
    if (!isSmall(read->document)) return;
    const Result<Bytes> written = writeVdb(read->document, read->document.authored);
    if (!written) return requireReason(written.error(), 0);
    require(readVdb(*written).has_value());
}
