// The views that an exact renderer must survive: along the axes, along face and space diagonals
// (where rays meet edges and corners exactly), and anywhere.
#pragma once

#include <cmath>
#include <vector>

#include "core/sprite/camera.h"
#include "core/sprite/lit_palette.h"
#include "tests/support/random.h"

namespace voxprite::test {

[[nodiscard]] inline std::vector<OrbitAngles> allKindsOfViews(int randomViews, std::uint64_t seed) {
    const double isometricPitch = std::atan(std::sqrt(0.5)) * 180.0 / 3.14159265358979323846;
    std::vector<OrbitAngles> views;
    for (const double pitch : {0.0, 45.0, isometricPitch, -isometricPitch, -45.0}) {
        for (int eighth = 0; eighth < 8; ++eighth) views.push_back({45.0 * eighth, pitch, 0.0});
    }
    for (const double pitch : {90.0, -90.0}) {
        for (int quarter = 0; quarter < 4; ++quarter) views.push_back({90.0 * quarter, pitch, 0.0});
    }
    Random random(seed);
    for (int i = 0; i < randomViews; ++i) {
        views.push_back({360.0 * random.unit(), 180.0 * random.unit() - 90.0,
                         i % 3 == 0 ? 360.0 * random.unit() : 0.0});
    }
    return views;
}

// Lights of faces that cast all rays there are, shadows toward `towardLight` in voxel space.
[[nodiscard]] inline FaceLights shadedLights(glm::dvec3 towardLight) {
    FaceLights lights(255, 190, 120);
    lights.shadowed = {140, 120, 90};
    lights.occlusion = 200;
    lights.rays = {true, shadowDirection(towardLight)};
    return lights;
}

}  // namespace voxprite::test
