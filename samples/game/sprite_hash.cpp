// A tool of a game: casts the sprite of a model as its camera would see it from the front and
// prints what `voxprite render MODEL --ortho --json` calls buffer.sha256.
//     sprite_hash MODEL
#include <cstdio>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/bake.h"

using namespace voxprite;

namespace {

int failed(const Error& error) {
    std::fprintf(stderr, "%s\n", error.describe().c_str());
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: sprite_hash MODEL\n");
        return 2;
    }
    const Result<LoadedDocument> loaded = loadDocument(argv[1]);
    if (!loaded) return failed(loaded.error());
    const Document& document = loaded->document;
    const IBox bounds = entityBounds(document);
    const Result<Octree> octree = bake(flatten(document, 0), bounds);
    if (!octree) return failed(octree.error());

    GameProfile profile;
    profile.minification = false;
    const PlacedEntity placed = placeEntity(document.entity, bounds, profile);
    Camera camera = orbitCamera({}, placed.centreMetres(), 10.0, 45.0, {512, 512});
    camera.orthographic = true;  // the buffer holds the whole sprite, whatever the picture shows
    const Result<SpriteViewResult> seen = viewSprite(placed, camera, profile);
    if (!seen) return failed(seen.error());
    if (!seen->view) {
        std::fprintf(stderr, "%s: nothing to see\n", argv[1]);
        return 1;
    }
    const LitPalette lit =
        litPalette(document.palette, seen->view->light8, profile.outline, profile.shading);
    std::printf("%s\n", castSprite(octree->view(), seen->view->lattice, lit).sha256().c_str());
    return 0;
}
