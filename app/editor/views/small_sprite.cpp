#include "app/editor/views/small_sprite.h"

#include <algorithm>

#include "core/sprite/camera.h"
#include "core/sprite/sprite_view.h"

namespace voxprite::editor {
namespace {

constexpr OrbitAngles kAngles{30.0, 20.0, 0.0};

}  // namespace

std::optional<SpriteBuffer> smallSprite(const SmallSubject& subject, int edgePx) {
    if (subject.bounds.empty()) return std::nullopt;
    GameProfile profile = subject.profile;
    profile.view = ViewRule::cameraForward;
    profile.minification = false;
    profile.viewStepDegrees = 0.0;
    for (; profile.sigma >= kLeastSigma; profile.sigma /= 2.0) {
        const PlacedEntity placed = placeEntity(subject.entity, subject.bounds, profile);
        const double away = 4.0 * placed.radiusMetres();
        const Camera camera =
            orbitCamera(kAngles, placed.centreMetres(), away, 45.0, {edgePx, edgePx});
        const Result<SpriteViewResult> seen = viewSprite(placed, camera, profile);
        if (!seen || !seen->view) continue;
        const SpriteView& view = *seen->view;
        if (std::max(view.lattice.size.x, view.lattice.size.y) > edgePx) continue;
        return castSprite(
            subject.octree, view.lattice,
            litPalette(subject.palette, view.light8, profile.outline, profile.shading));
    }
    return std::nullopt;
}

}  // namespace voxprite::editor
