#include "core/io/project_file.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<Document> read = readProject(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    requireValid(*read);
    const Result<Bytes> written = writeProject(*read);
    require(written.has_value());
    const Result<Document> again = readProject(*written);
    require(again.has_value() && *again == *read);
}
