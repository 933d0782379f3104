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
    std::stable_sort(all.begin(), all.end(),
                     [](const Comparison& a, const Comparison& b) { return a.row < b.row; });
    return all;
}

std::vector<LeftOut> rowsLeftOut() {
    return {{18, "the snapshot cache is not built yet"}};
}

}  // namespace voxprite::conformance
