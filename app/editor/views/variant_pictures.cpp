#include "app/editor/views/variant_pictures.h"

#include "app/editor/views/small_sprite.h"

namespace voxprite::editor {

std::optional<SpriteBuffer> smallSprite(const Session& session, const Palette& palette,
                                        int edgePx) {
    return smallSprite({session.octree().view(session.bounds()), session.bounds(),
                        session.document().entity, session.profile(), palette},
                       edgePx);
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
