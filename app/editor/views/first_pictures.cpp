#include "app/editor/views/first_pictures.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/parallel.h"
#include "core/sprite/composite.h"
#include "core/sprite/voxel_placement.h"
#include "core/trace/ray_packet.h"
#include "render/scene_backdrop.h"
#include "render/voxel_view.h"

namespace voxprite::editor {
namespace {

Rgba8 opaque(glm::vec3 colour) {
    return {glm::u8vec3(glm::clamp(colour, 0.0f, 1.0f) * 255.0f + 0.5f), 255};
}

Image gradient(glm::ivec2 sizePx, const BackdropColours& behind) {
    Image image(sizePx.x, sizePx.y);
    for (int y = 0; y < sizePx.y; ++y) {
        const float height = 1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(sizePx.y);
        const Rgba8 colour = opaque(glm::mix(glm::vec3(behind.bottom), glm::vec3(behind.top),
                                             glm::smoothstep(0.0f, 1.0f, height)) /
                                    255.0f);
        for (int x = 0; x < sizePx.x; ++x) image.at(x, y) = colour;
    }
    return image;
}

// As shaders/scene_backdrop.frag has it, without its grid; ray by ray of a row.
class SkyAndGround {
  public:
    SkyAndGround(const Camera& camera, const Ground& ground) : camera_(camera), ground_(ground) {}

    Rgba8 seen(const Camera::Ray& ray) {
        const double metres =
            (ground_.heightMetres - camera_.eyeMetres.y - ray.origin.y) / ray.direction.y;
        if (metres >= camera_.nearMetres) {
            // Mostly a whole row is equally far.
            if (metres != groundMetres_) groundColour_ = groundAt(metres);
            groundMetres_ = metres;
            return groundColour_;
        }
        const auto rise = static_cast<float>(glm::normalize(ray.direction).y);
        return opaque(glm::mix(glm::vec3(kSkyHorizon), glm::vec3(kSkyZenith),
                               glm::smoothstep(0.0f, 0.55f, rise)));
    }

  private:
    [[nodiscard]] Rgba8 groundAt(double metres) const {
        const float far = std::max(0.0f, static_cast<float>(metres) / kHazeMetres - 0.2f);
        return opaque(glm::mix(glm::vec3(ground_.colour) / 255.0f, glm::vec3(kSkyHorizon),
                               1.0f - std::exp(-far)));
    }

    const Camera& camera_;
    const Ground& ground_;
    double groundMetres_ = 0.0;
    Rgba8 groundColour_{0};
};

}  // namespace

Image firstVoxelPicture(const Session& session, const Camera& camera,
                        const BackdropColours& behind) {
    Image image = gradient(camera.viewportPx, behind);
    if (session.bounds().empty()) return image;
    const PlacedEntity placed = session.placedForEditing();
    const VoxelPlacement placement = voxelPlacement(placed);
    const Light& light = session.profile().light;
    const glm::dvec3 toward =
        glm::transpose(placed.worldFromVoxelAxes) * glm::normalize(light.towardLight);
    std::array<std::array<float, 2>, 3> lights{};  // by axis, then for the faces up it and down it
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        lights[static_cast<std::size_t>(axis)] = {halfLambert(normal, toward, light.ambient),
                                                  halfLambert(-normal, toward, light.ambient)};
    }
    const OctreeView octree = session.octree().view(session.bounds());
    const Palette& palette = session.shownPalette();
    const auto eachHit = [&]() -> OnRaycastHit {
        return [&](glm::ivec2 pixel, const Ray&, const RaycastHit& hit) {
            const float lit = lights[hit.axis][hit.normal[hit.axis] > 0.0 ? 0 : 1];
            image.at(pixel.x, pixel.y) =
                opaque(glm::vec3(palette.colours[hit.value]) * (lit / 255.0f));
        };
    };
    if (!camera.orthographic) {
        raycastPicture(octree, eyePicture(placement, camera), camera.viewportPx, kMaxOctreeDepth, 0,
                       eachHit);
        return image;
    }
    const auto rayThrough = [&](glm::ivec2 pixel) {
        const Camera::Ray ray = camera.rayThrough(glm::dvec2(pixel) + 0.5);
        return voxelRay(placement, {ray.origin, ray.direction});
    };
    raycastPicture(octree, camera.viewportPx, kMaxOctreeDepth, 0, rayThrough, eachHit);
    return image;
}

Image firstSpritePicture(const Session& session, const Camera& camera) {
    const glm::ivec2 size = camera.viewportPx;
    Image image(size.x, size.y);
    const Ground ground;
    parallelFor(size.y, 0, [&](int firstRow, int lastRow) {
        SkyAndGround behind(camera, ground);
        for (int y = firstRow; y < lastRow; ++y) {
            Camera::Ray ray = camera.rayFromEye({0.5, y + 0.5});
            const Camera::Ray next = camera.rayFromEye({1.5, y + 0.5});
            const Camera::Ray step{next.origin - ray.origin, next.direction - ray.direction};
            for (int x = 0; x < size.x; ++x) {
                image.at(x, y) = behind.seen(ray);
                ray = {ray.origin + step.origin, ray.direction + step.direction};
            }
        }
    });
    const GameProfile& profile = session.profile();
    ViewHistory history;
    const Result<SpriteViewResult> seen =
        viewSprite(session.placedInGame(), camera, profile, &history);
    // What is wrong with it, or hides it, is said once the view itself draws.
    if (!seen || !seen->view) return image;
    const LitPalette lit =
        litPalette(session.shownPalette(), seen->view->light8, profile.outline, profile.shading);
    const OctreeView octree = session.octree().view(session.bounds());
    const SpriteBuffer buffer = castSprite(octree, visibleLattice(*seen->view, camera), lit);
    const SpriteOnScreen sprite = onScreen(*seen->view, buffer, camera);
    for (std::size_t at = 0; at < image.pixels.size(); ++at)
        if (sprite.ids[at] != kIdEmpty) image.pixels[at] = sprite.image.pixels[at];
    return image;
}

}  // namespace voxprite::editor
