#include "core/io/qb.h"
#include "core/io/grid_budget.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<QbImport> read = readQb(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    requireValid(read->document);
    if (!isSmall(read->document)) return;
    const Result<Bytes> written = writeQb(read->document);
    if (!written) return requireReason(written.error(), 0);
    // The same voxels may lie in more blocks when their object begins elsewhere.
    const Result<QbImport> again = readQb(*written);
    require(again.has_value() || again.error().message == GridBudget::refusal());
}
