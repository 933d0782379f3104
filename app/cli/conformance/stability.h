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

// Views along axes and diagonals, and those turned by 1e-9 ... 1e-2 rad, against the ideal caster.
[[nodiscard]] Sweep sweepTurns();
// sigma 1/64 ... 64 on models of one voxel to 256 cubed, empty and full.
[[nodiscard]] Sweep sweepSizes();
[[nodiscard]] Sweep sweepScales();     // VoxelSize 1e-6 ... 1e6, scale 1e-3 ... 1e3
[[nodiscard]] Sweep sweepPositions();  // entities 0 ... 1e9 m from the world's origin
[[nodiscard]] Sweep sweepCameras();    // distances to 1e7 radii, fields of view, orthographic
[[nodiscard]] Sweep sweepProxy();      // does the whole outline reach the screen
[[nodiscard]] Sweep sweepAnchors();    // anchors far outside the model, and up along the view
[[nodiscard]] Sweep sweepInputs();     // NaN, infinity, denormals and huge numbers in every input
[[nodiscard]] Sweep sweepGpu();        // sprite buffers of the CPU and of OpenGL

}  // namespace voxprite::conformance
