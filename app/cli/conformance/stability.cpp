#include "app/cli/conformance/stability.h"

#include <algorithm>

namespace voxprite::conformance {

void Sweep::count(bool good, const std::string& name) {
    ++cases;
    if (good) return;
    if (failures++ == 0) failed = name;
}

bool Sweep::held() const {
    return failures == 0 && std::all_of(figures.begin(), figures.end(),
                                        [](const Figure& figure) { return figure.held(); });
}

std::vector<Sweep> sweepExtremes() {
    return {sweepTurns(), sweepSizes(),   sweepScales(), sweepPositions(), sweepCameras(),
            sweepProxy(), sweepAnchors(), sweepInputs(), sweepGpu()};
}

}  // namespace voxprite::conformance
