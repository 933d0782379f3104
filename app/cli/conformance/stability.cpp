#include "app/cli/conformance/stability.h"

#include <algorithm>

#include "app/cli/conformance/gpu_probe.h"

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
    GpuProbe probe;
    std::vector<Sweep> sweeps;
    for (Sweep (*const sweep)(GpuProbe&) :
         {sweepTurns, sweepSizes, sweepScales, sweepPositions, sweepCameras, sweepProxy,
          sweepAnchors, sweepInputs, sweepLattices})
        sweeps.push_back(sweep(probe));
    sweeps.push_back(sweepStillness());
    sweeps.push_back(sweepGpu(probe));
    return sweeps;
}

}  // namespace voxprite::conformance
