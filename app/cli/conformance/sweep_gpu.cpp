// Sprite buffers of the CPU and of OpenGL, pixel by pixel, and frames on a screen.
#include <cmath>
#include <cstdint>

#include "app/cli/conformance/gpu_probe.h"
#include "app/cli/conformance/stability.h"

namespace voxprite::conformance {
namespace {

// Keeps software drawing quick.
constexpr std::int64_t kMostPixels = 60'000;

double number(std::uint64_t count) {
    return static_cast<double>(count);
}

}  // namespace

Sweep sweepGpu(GpuProbe& probe) {
    Sweep sweep{"gpu",
                "whole buffers of exact views and those turned by 1e-7 and 1e-2 rad, sigma "
                "0.5 ... 16; windows and frames of the sweeps above"};
    if (!probe.missing().empty()) {
        sweep.notRun = probe.missing();
        return sweep;
    }
    sweep.what += ", on " + gl::driverInfo().renderer;
    const double isometric = std::atan(std::sqrt(0.5)) * 57.29577951308232;
    for (const Subject& subject :
         {letters(), figure(), noise(32), solidBox({1, 1, 1}), solidBox({1, 1, 256})})
        for (const OrbitAngles angles :
             {OrbitAngles{0, 0, 0}, {90, 0, 0}, {0, 90, 0}, {45, 0, 0}, {45, isometric, 0}})
            for (const double turn : {0.0, 1e-7, 1e-2})
                for (const double sigma : {0.5, 1.5, 4.0, 16.0}) {
                    const OrthoView view = turned(orthoView(angles, sigma), turn);
                    const LatticeView lattice = quantised(view, subject.octree.size);
                    if (std::int64_t{lattice.size.x} * lattice.size.y > kMostPixels) continue;
                    probe.compareWhole(subject, lattice);
                }
    const GpuProbe::Buffers& whole = probe.wholes();
    const GpuProbe::Buffers& windows = probe.windows();
    const GpuProbe::Screens& screens = probe.screens();
    sweep.cases = whole.buffers + windows.buffers + screens.frames;
    sweep.failed = probe.firstFailure();
    sweep.failures = sweep.failed.empty() ? 0 : 1;
    const double unbounded = std::numeric_limits<double>::infinity();
    const double shown = number(screens.pixels);
    sweep.figures = {
        {"differing", "pixels of buffers that differ between CPU and OpenGL",
         number(whole.differing + windows.differing), 0.0, "pixels"},
        {"compared", "pixels compared", number(whole.pixels + windows.pixels), unbounded, "pixels"},
        {"modes", "screen pixels that differ between sprite buffers and single pass",
         number(screens.modesDiffer), 0.0, "pixels"},
        {"not_a_number", "screen pixels whose depth is no number, or whose colour nothing has",
         number(screens.notANumber), 0.0, "pixels"},
        {"screen", "screen pixels unlike the processor's picture",
         shown > 0.0 ? 100.0 * number(screens.unlikeProcessor) / shown : 100.0, 1.0, "%"},
        {"shown", "screen pixels that show a sprite", shown, unbounded, "pixels"}};
    return sweep;
}

}  // namespace voxprite::conformance
