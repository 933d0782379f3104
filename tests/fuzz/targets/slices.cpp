#include "core/io/slices.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<SlicesImport> read = readStrip(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    requireValid(read->document);
}
