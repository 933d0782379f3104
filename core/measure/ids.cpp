#include "core/measure/ids.h"

#include <string>

namespace voxprite {

Result<IdComparison> compareIds(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
                                std::uint32_t firstThing) {
    if (a.size() != b.size())
        return fail("the pictures differ in size: " + std::to_string(a.size()) + " and " +
                    std::to_string(b.size()) + " pixels");
    IdComparison result;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const bool inA = a[k] >= firstThing, inB = b[k] >= firstThing;
        if (!inA && !inB) continue;
        ++result.covered;
        result.differing += inA != inB || a[k] != b[k] ? 1 : 0;
        result.onlyOne += inA != inB ? 1 : 0;
    }
    return result;
}

}  // namespace voxprite
