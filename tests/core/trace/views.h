// Views for the tests of this folder.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "core/trace/lattice.h"

namespace voxprite::test {

// Orthonormal, looking along `forward`, with up as near to Z as can be.
inline OrthoView viewAlong(glm::dvec3 forward, double sigma) {
    OrthoView view;
    view.forward = glm::normalize(forward);
    const glm::dvec3 pole =
        std::abs(view.forward.z) > 0.999999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    view.right = glm::normalize(glm::cross(view.forward, pole));
    view.up = glm::cross(view.right, view.forward);
    view.sigmaInForce = sigma;
    return view;
}

// Turned about the line of sight as well.
inline OrthoView rolled(OrthoView view, double radians) {
    const glm::dvec3 right = view.right;
    view.right = right * std::cos(radians) + view.up * std::sin(radians);
    view.up = view.up * std::cos(radians) - right * std::sin(radians);
    return view;
}

inline OrthoView randomView(std::mt19937& random, double sigma) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> angle(-3.14159, 3.14159);
    return rolled(viewAlong({normal(random), normal(random), normal(random)}, sigma),
                  angle(random));
}

// The 26 views along axes, face diagonals and space diagonals.
inline std::vector<glm::dvec3> canonicalDirections() {
    std::vector<glm::dvec3> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) directions.push_back({x, y, z});
    return directions;
}

}  // namespace voxprite::test
