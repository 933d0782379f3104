#include "core/sprite/composite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/parallel.h"

namespace voxprite {

namespace {

// One sprite, ready to be asked what it shows at a screen position.
class ScreenSprite {
  public:
    ScreenSprite(const CompositeSprite& sprite, const Camera& camera)
        : sprite_(sprite),
          pixelFromScreen_(pixelFromScreen(*sprite.view, camera)),
          depth_(camera.reversedDepth(sprite.view->depthMetres)) {
        const SpriteBuffer& buffer = *sprite.buffer;
        glm::dvec2 least(camera.viewportPx);
        glm::dvec2 most(0.0);
        for (const glm::dvec3& corner : quadFromEye(*sprite.view, buffer.first, buffer.size)) {
            const Camera::Projected seen = camera.projectFromEye(corner);
            if (!camera.orthographic && seen.depthMetres <= 0.0) return;  // the whole screen
            least = glm::min(least, seen.screenPx);
            most = glm::max(most, seen.screenPx);
        }
        least = glm::clamp(least - 1.0, glm::dvec2(0.0), glm::dvec2(camera.viewportPx));
        most = glm::clamp(most + 1.0, glm::dvec2(0.0), glm::dvec2(camera.viewportPx));
        first_ = glm::ivec2(least);
        last_ = glm::ivec2(glm::ceil(most));
    }

    [[nodiscard]] bool reaches(int x, int y) const {
        return x >= first_.x && x < last_.x && y >= first_.y && y < last_.y;
    }

    // Where in the buffer the sprite's pixel at a screen position lies; nothing where none shows.
    [[nodiscard]] std::optional<std::size_t> shownAt(const Camera& camera,
                                                     glm::dvec2 screenPx) const {
        const glm::dvec3 p = pixelFromScreen_ * glm::dvec3(screenPx, 1.0);
        if (!(p.z > 0.0)) return std::nullopt;
        const SpriteBuffer& buffer = *sprite_.buffer;
        const double column = std::floor(p.x / p.z) - buffer.first.x;
        const double row = buffer.first.y + buffer.size.y - 1 - std::floor(p.y / p.z);
        if (!(column >= 0.0 && row >= 0.0 && column < buffer.size.x && row < buffer.size.y))
            return std::nullopt;
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.size.x) +
                        static_cast<std::size_t>(column);
        if (buffer.ids[at] == kIdEmpty) return std::nullopt;
        if (sprite_.view->proxy == ProxyShape::box &&
            !meetsProxyBox(*sprite_.view, camera.rayFromEye(screenPx)))
            return std::nullopt;
        return at;
    }

    // Draws over `colour` where the sprite is nearer than `depth`.
    void draw(const Camera& camera, glm::dvec2 screenPx, Rgba8& colour, float& depth) const {
        const std::optional<std::size_t> at = shownAt(camera, screenPx);
        if (!at) return;
        const float own = sprite_.depthMetres == nullptr
                              ? depth_
                              : camera.reversedDepth((*sprite_.depthMetres)[*at]);
        if (!(own > depth)) return;
        depth = own;
        colour = sprite_.buffer->colours[*at];
    }

    // The screen pixels that may show it, half open.
    [[nodiscard]] glm::ivec2 firstPx() const { return first_; }
    [[nodiscard]] glm::ivec2 lastPx() const { return last_; }

  private:
    CompositeSprite sprite_;
    glm::dmat3 pixelFromScreen_;
    float depth_;
    // The screen pixels that the quad may cover, half open.
    glm::ivec2 first_{0};
    glm::ivec2 last_{1 << 30};
};

// Shows the ground where it is nearer than `depth`.
void drawGroundAt(const Ground& ground, const Camera& camera, glm::dvec2 screenPx, float depth,
                  Rgba8& colour) {
    const Camera::Ray ray = camera.rayFromEye(screenPx);
    const double metres =
        (ground.heightMetres - camera.eyeMetres.y - ray.origin.y) / ray.direction.y;
    if (!(metres >= camera.nearMetres)) return;
    if (camera.reversedDepth(metres) > depth) colour = ground.colour;
}

}  // namespace

Image composite(std::span<const CompositeSprite> sprites, const Camera& camera, Rgba8 background,
                std::optional<Ground> ground) {
    Image image(camera.viewportPx.x, camera.viewportPx.y, background);
    std::vector<ScreenSprite> placed;
    placed.reserve(sprites.size());
    for (const CompositeSprite& sprite : sprites) placed.emplace_back(sprite, camera);
    parallelFor(image.height, 0, [&](int firstRow, int lastRow) {
        for (int y = firstRow; y < lastRow; ++y)
            for (int x = 0; x < image.width; ++x) {
                const glm::dvec2 screenPx = glm::dvec2(x, y) + 0.5;
                Rgba8& colour = image.at(x, y);
                float depth = 0.0f;
                for (const ScreenSprite& sprite : placed)
                    if (sprite.reaches(x, y)) sprite.draw(camera, screenPx, colour, depth);
                if (ground) drawGroundAt(*ground, camera, screenPx, depth, colour);
            }
    });
    return image;
}

SpriteOnScreen onScreen(const SpriteView& view, const SpriteBuffer& buffer, const Camera& camera) {
    const glm::ivec2 size = camera.viewportPx;
    SpriteOnScreen shown{Image(size.x, size.y), {}};
    shown.ids.assign(shown.image.pixels.size(), kIdEmpty);
    const ScreenSprite sprite({&view, &buffer, nullptr}, camera);
    const glm::ivec2 last = glm::min(sprite.lastPx(), size);
    for (int y = sprite.firstPx().y; y < last.y; ++y)
        for (int x = sprite.firstPx().x; x < last.x; ++x) {
            const std::optional<std::size_t> at = sprite.shownAt(camera, glm::dvec2(x, y) + 0.5);
            if (!at) continue;
            shown.image.at(x, y) = buffer.colours[*at];
            shown.ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                      static_cast<std::size_t>(x)] = buffer.ids[*at];
        }
    return shown;
}

void drawGround(const Ground& ground, const Camera& camera, std::span<const float> reversedDepths,
                Image& image) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(x);
            drawGroundAt(ground, camera, glm::dvec2(x, y) + 0.5, reversedDepths[at],
                         image.pixels[at]);
        }
    }
}

}  // namespace voxprite
