#include "core/io/palette_files.h"
#include "tests/fuzz/fuzz.h"

using namespace voxprite;
using namespace voxprite::fuzz;

VOXPRITE_FUZZ_TARGET(bytes) {
    for (const Result<ColourList>& read :
         {readGimpPalette(textOf(bytes)), readJascPalette(textOf(bytes))}) {
        if (!read) requireReason(read.error(), bytes.size());
    }
    const Result<ColourList> picture = readPalettePicture(bytes);
    if (!picture) return requireReason(picture.error(), bytes.size());
    const Result<Bytes> written = writePalettePicture(*picture);
    require(written.has_value() && readPalettePicture(*written).has_value());
}
