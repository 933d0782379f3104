// What the sprite promises at the extremes, swept and counted. No clock enters a figure.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace voxprite::conformance {

// Smaller is better.
struct Figure {
    std::string key;
    std::string what;
    double value = 0.0;
    double promised = std::numeric_limits<double>::infinity();  // at most
    std::string unit;

    [[nodiscard]] bool held() const { return value <= promised; }
};

struct Sweep {
    std::string key;
    std::string what;  // is swept
    int cases = 0;
    int refused = 0;       // with a message that says why: an answer, not a failure
    int failures = 0;      // an error where there must be none, or a result that is not finite
    std::string failed{};  // the first of them
    std::vector<Figure> figures{};
    std::string notRun{};  // why it could not run here

    // Counts a case, and a failure if it is not `good`.
    void count(bool good, const std::string& name);
    [[nodiscard]] bool held() const;
};

[[nodiscard]] std::vector<Sweep> sweepExtremes();

// What a sweep looks at goes through the probe too, so that OpenGL meets the same extremes.
class GpuProbe;

// Views along axes and diagonals, and those turned by 1e-9 ... 1e-2 rad, against the ideal caster.
[[nodiscard]] Sweep sweepTurns(GpuProbe& probe);
// sigma 1/64 ... 64 on models of one voxel to 256 cubed, empty and full.
[[nodiscard]] Sweep sweepSizes(GpuProbe& probe);
// VoxelSize 1e-6 ... 1e6, scale 1e-3 ... 1e3
[[nodiscard]] Sweep sweepScales(GpuProbe& probe);
// Entities 0 ... 1e9 m from the world's origin.
[[nodiscard]] Sweep sweepPositions(GpuProbe& probe);
// Distances to 1e7 radii, fields of view, orthographic.
[[nodiscard]] Sweep sweepCameras(GpuProbe& probe);
// Does the whole outline reach the screen?
[[nodiscard]] Sweep sweepProxy(GpuProbe& probe);
// Anchors far outside the model, and up along the view.
[[nodiscard]] Sweep sweepAnchors(GpuProbe& probe);
// NaN, infinity, denormals and huge numbers in every input.
[[nodiscard]] Sweep sweepInputs(GpuProbe& probe);
// A view that came from elsewhere, with each of its integers out of place.
[[nodiscard]] Sweep sweepLattices(GpuProbe& probe);
// A camera that trembles, and one that turns slowly and back.
[[nodiscard]] Sweep sweepStillness();
// Whole sprite buffers, and what the probe saw in the sweeps before.
[[nodiscard]] Sweep sweepGpu(GpuProbe& probe);

}  // namespace voxprite::conformance
