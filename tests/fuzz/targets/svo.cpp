#include "core/io/svo_file.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<SvoFile> read = readSvo(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    const Result<Bytes> written = writeSvo(*read);
    require(written.has_value());
    const Result<SvoFile> again = readSvo(*written);
    require(again.has_value() && *again == *read);
    if (read->models.size() <= 16) requireValid(documentFromSvo(*read));
}
