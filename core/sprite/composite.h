// A scene of sprites as a picture, on the CPU: the yardstick of the GL scene.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/image.h"
#include "core/sprite/sprite_view.h"

namespace voxprite {

struct CompositeSprite {
    const SpriteView* view = nullptr;
    const SpriteBuffer* buffer = nullptr;
    // For the depth rule perPixel: metres along the camera's forward, one a buffer pixel; else
    // null.
    const std::vector<float>* depthMetres = nullptr;
};

struct Ground {
    double heightMetres = 0.0;  // a horizontal plane of the world
    Rgba8 colour{92, 112, 84, 255};
};

// Nearest blit with depth test; of equal depths the earlier sprite in the span stays.
[[nodiscard]] Image composite(std::span<const CompositeSprite> sprites, const Camera& camera,
                              Rgba8 background, std::optional<Ground> ground = std::nullopt);

// One sprite alone over nothing, with what its pixels show (SpriteBuffer::ids) at each of the
// screen's, row by row from the top; kIdEmpty where it does not show. Depths take no part.
struct SpriteOnScreen {
    Image image;
    std::vector<std::uint32_t> ids;
};
[[nodiscard]] SpriteOnScreen onScreen(const SpriteView& view, const SpriteBuffer& buffer,
                                      const Camera& camera);

// Draws the ground over a picture of `camera` wherever it is nearer than what the picture shows:
// `reversedDepths` holds a depth for each pixel (Camera::reversedDepth; 0 where there is nothing).
void drawGround(const Ground& ground, const Camera& camera, std::span<const float> reversedDepths,
                Image& image);

}  // namespace voxprite
