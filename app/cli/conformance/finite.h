// Is a sprite's view one that can be drawn?
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/finite.h"
#include "core/sprite/sprite_view.h"

namespace voxprite::conformance {

using voxprite::finite;
[[nodiscard]] inline bool finite(const SpriteView& view, const Camera& camera) {
    const glm::dmat3 m = pixelFromScreen(view, camera);
    return finite(view.centreFromEyeMetres) && finite(view.right) && finite(view.up) &&
           finite(view.forward) && finite(view.depthPerVoxelMetres) && finite(m[0]) &&
           finite(m[1]) && finite(m[2]) && std::isfinite(view.metresPerPx) &&
           view.metresPerPx > 0.0 && std::isfinite(view.depthMetres) &&
           std::isfinite(view.planeDepthMetres) && std::isfinite(view.pixelFromCentre.x) &&
           std::isfinite(view.pixelFromCentre.y) && std::isfinite(view.screenPxPerPx) &&
           std::isfinite(camera.reversedDepth(view.depthMetres));
}

// How far corners of the sprite miss themselves, sent to the screen and back, in virtual pixels.
// Corners behind the eye, or more than a million pixels off the screen (a registration at an anchor
// near the horizon takes them there), do not count.
[[nodiscard]] inline double roundTripPx(const SpriteView& view, const Camera& camera) {
    const glm::dmat3 m = pixelFromScreen(view, camera);
    const auto corners = quadFromEye(view, view.lattice.first, view.lattice.size);
    double worst = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Camera::Projected seen = camera.projectFromEye(corners[k]);
        if (!camera.orthographic && seen.depthMetres <= 0.0) continue;
        if (glm::length(seen.screenPx) > 1e6) continue;
        const glm::dvec3 p = m * glm::dvec3(seen.screenPx, 1.0);
        const glm::dvec2 corner(view.lattice.first +
                                view.lattice.size *
                                    glm::ivec2(static_cast<int>(k) & 1, static_cast<int>(k) >> 1));
        const double off = glm::length(glm::dvec2(p.x, p.y) / p.z - corner);
        // Written so that NaN is the worst.
        worst = off <= worst ? worst : off;
    }
    return worst;
}

}  // namespace voxprite::conformance
