#include "app/editor/views/sprite_picture.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/io/png.h"
#include "core/trace/lattice_caster.h"

namespace voxprite::editor {

namespace {

// The document's entity as the view shows it.
Result<SpriteView> viewOf(const Session& session, const GameProfile& profile, const Camera& camera,
                          ViewHistory& history) {
    PlacedEntity placed = placeEntity(session.document().entity, session.bounds(), profile);
    placed.anchorMetres.y += groundClearanceMetres(profile);
    const Result<SpriteViewResult> seen = viewSprite(placed, camera, profile, &history);
    if (!seen) return Failure(seen.error());
    if (!seen->view) return fail("There is no sprite in view");
    return *seen->view;
}

}  // namespace

Result<Image> spritePicture(const Session& session, const GameProfile& profile,
                            const Camera& camera, ViewHistory history, int scale) {
    const Result<SpriteView> seen = viewOf(session, profile, camera, history);
    if (!seen) return Failure(seen.error());
    const SpriteView& view = *seen;
    const LitPalette lit =
        litPalette(session.shownPalette(), view.light8, profile.outline, profile.shading);
    const SpriteBuffer buffer =
        castSprite(session.octree().view(session.bounds()), view.lattice, lit);
    const Image sprite = trimmed(buffer.image());
    if (sprite.pixels.empty()) return fail("There is no sprite in view");
    if (std::max(sprite.width, sprite.height) > kMaxPngEdge / scale) {
        return fail("The sprite, magnified " + std::to_string(scale) +
                    " times, would have an edge of more than " + std::to_string(kMaxPngEdge) +
                    " pixels");
    }
    return magnified(sprite, scale);
}

std::uint8_t colourUnder(const Session& session, const Camera& camera, ViewHistory history,
                         glm::dvec2 viewPx) {
    const Result<SpriteView> view = viewOf(session, session.profile(), camera, history);
    if (!view) return 0;
    const std::optional<glm::ivec2> pixel = pixelUnder(*view, camera, viewPx);
    if (!pixel) return 0;
    const OctreeView octree = session.octree().view(session.bounds());
    return castLattice(octree, rayOf(view->lattice, *pixel)).material;
}

Image magnified(const Image& image, int scale) {
    Image large(image.width * scale, image.height * scale);
    for (int y = 0; y < large.height; ++y) {
        for (int x = 0; x < large.width; ++x) large.at(x, y) = image.at(x / scale, y / scale);
    }
    return large;
}

Image trimmed(const Image& image) {
    glm::ivec2 least(image.width, image.height), end(0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y).w == 0) continue;
            least = glm::min(least, glm::ivec2(x, y));
            end = glm::max(end, glm::ivec2(x, y) + 1);
        }
    }
    if (end.x == 0) return {};
    Image cut(end.x - least.x, end.y - least.y);
    for (int y = 0; y < cut.height; ++y) {
        for (int x = 0; x < cut.width; ++x) cut.at(x, y) = image.at(least.x + x, least.y + y);
    }
    return cut;
}

}  // namespace voxprite::editor
