#include "core/io/png.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<Image> read = readPng(bytes);
    if (!read) return requireReason(read.error(), bytes.size());
    const Result<Bytes> written = writePng(*read);
    require(written.has_value());
    const Result<Image> again = readPng(*written);
    require(again.has_value() && again->pixels == read->pixels);
}
