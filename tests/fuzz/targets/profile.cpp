#include "core/io/profile_json.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    const Result<GameProfile> read = readProfile(textOf(bytes));
    if (!read) return requireReason(read.error(), bytes.size());
    require(validate(*read).has_value());
    const Result<GameProfile> again = readProfile(writeProfile(*read));
    require(again.has_value() && *again == *read);
}
