#include "core/io/svo_file.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<std::vector<SvoFile>> read = readSvoSet(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    const Result<Bytes> written = writeSvoSet(*read);
    require(written.has_value());
    const Result<std::vector<SvoFile>> again = readSvoSet(*written);
    require(again.has_value() && *again == *read);
    for (const SvoFile& entity : *read) {
        if (entity.models.size() > 16) continue;
        // Valid but for what lies at the edge of the coordinates (loadDocument refuses that).
        const Status valid = validate(documentFromSvo(entity));
        require(valid || valid.error().message.find("reach beyond") != std::string::npos);
    }
}
