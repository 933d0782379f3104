#include "app/editor/variant_pictures.h"

#include <algorithm>

#include "core/sprite/camera.h"

namespace voxprite::editor {
namespace {

constexpr OrbitAngles kAngles{30.0, 20.0, 0.0};
constexpr double kLeastSigma = 1.0 / 64.0;

}  // namespace

std::optional<SpriteBuffer> smallSprite(const Session& session, const Palette& palette,
                                        int edgePx) {
    if (session.bounds().empty()) return std::nullopt;
    GameProfile profile = session.profile();
    profile.view = ViewRule::cameraForward;
    profile.minification = false;
    profile.viewStepDegrees = 0.0;
    const OctreeView octree = session.octree().view(session.bounds());
    for (; profile.sigma >= kLeastSigma; profile.sigma /= 2.0) {
        const PlacedEntity placed =
            placeEntity(session.document().entity, session.bounds(), profile);
        const double away = 4.0 * placed.radiusMetres();
        const Camera camera =
            orbitCamera(kAngles, placed.centreMetres(), away, 45.0, {edgePx, edgePx});
        const Result<SpriteViewResult> seen = viewSprite(placed, camera, profile);
        if (!seen || !seen->view) continue;
        const SpriteView& view = *seen->view;
        if (std::max(view.lattice.size.x, view.lattice.size.y) > edgePx) continue;
        return castSprite(octree, view.lattice,
                          litPalette(palette, view.light8, profile.outline, profile.shading));
    }
    return std::nullopt;
}

void VariantPictures::update(const Session& session) {
    const Palette& palette = session.document().palette;
    const std::size_t wanted = palette.variants.size() + 1;
    if (modelRevision_ == session.modelRevision() && pictures_.size() == wanted &&
        profile_ == session.profile() && entity_ == session.document().entity) {
        return;
    }
    modelRevision_ = session.modelRevision();
    profile_ = session.profile();
    entity_ = session.document().entity;
    pictures_.resize(wanted);
    for (std::size_t k = 0; k < wanted; ++k) {
        const auto sprite =
            smallSprite(session, k == 0 ? palette : palette.withVariant(k - 1), kEdgePx);
        pictures_[k].set(sprite ? sprite->image() : Image{});
    }
}

}  // namespace voxprite::editor
