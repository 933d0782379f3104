#include "core/io/mesh_writer.h"

#include "core/io/png.h"
#include "core/model/entity_voxels.h"

namespace voxprite {

Result<Bytes> paletteTexture(const Palette& palette) {
    Image image(256, 1);
    for (int k = 1; k < 256; ++k) {
        image.at(k, 0) = palette.colours[static_cast<std::size_t>(k)];
        image.at(k, 0).w = 255;
    }
    return writePng(image);
}

glm::dvec3 originOf(const Document& document) {
    return anchorVoxels(document.entity, entityBounds(document));
}

}  // namespace voxprite
