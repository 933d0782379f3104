#include "app/cli/conformance/conformance.h"

#include <algorithm>

namespace voxprite::conformance {

std::vector<Comparison> compareReadings() {
    Comparisons all;
    comparePlace(all);
    compareView(all);
    comparePixels(all);
    compareScreen(all);
    compareDepth(all);
    compareClusters(all);
    compareSnapshots(all);
    std::stable_sort(all.begin(), all.end(),
                     [](const Comparison& a, const Comparison& b) { return a.row < b.row; });
    return all;
}

}  // namespace voxprite::conformance
