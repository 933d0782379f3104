#include "app/cli/conformance/outline_lost.h"

#include <array>
#include <cmath>

namespace voxprite::conformance {

int outlineLost(const SpriteView& view, const SpriteBuffer& buffer, const Camera& camera) {
    const std::array<CompositeSprite, 1> sprites{CompositeSprite{&view, &buffer, nullptr}};
    const Image image = composite(sprites, camera, Rgba8(10, 20, 200, 255));
    int lost = 0;
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column) {
            if (buffer.ids[static_cast<std::size_t>(row * buffer.size.x + column)] != kIdOutline)
                continue;
            const glm::dvec2 pixel{buffer.first.x + column + 0.5,
                                   buffer.first.y + buffer.size.y - 1 - row + 0.5};
            const glm::dvec2 metres = (pixel - view.pixelFromCentre) * view.metresPerPx;
            const glm::dvec3 fromEye =
                view.centreFromEyeMetres + view.right * metres.x + view.up * metres.y;
            const Camera::Projected seen = camera.projectFromEye(fromEye);
            const glm::dvec2 at = glm::floor(seen.screenPx);
            const bool onScreen = seen.depthMetres > 0.0 && at.x >= 0 && at.y >= 0 &&
                                  at.x < image.width && at.y < image.height;
            if (onScreen && image.at(static_cast<int>(at.x), static_cast<int>(at.y)) != kInk)
                ++lost;
        }
    return lost;
}

}  // namespace voxprite::conformance
