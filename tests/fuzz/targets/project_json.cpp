#include "core/io/project_json.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<ProjectJson> read = readProjectJson(textOf(bytes));
    if (!read) return requireReason(read.error(), bytes.size());
    // readProject() checks the document as a whole, with its voxels.
    const Document& document = read->document;
    if (!validate(document)) return;
    const std::string written = writeProjectJson(document, document.authored, read->entries);
    require(readProjectJson(written).has_value());
}
