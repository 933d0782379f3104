#include "core/io/mesh_writer.h"

#include <algorithm>

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

std::vector<std::string> meshLosses(const Document& document, const std::string& where) {
    std::vector<std::string> losses;
    const auto tell = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        losses.push_back(where + " has no " + what + ": " + std::to_string(count) + " left out");
    };
    const Palette& palette = document.palette;
    losses.push_back(where + " holds surfaces: voxels that no open face shows are left out");
    tell(static_cast<std::size_t>(frameCount(document)) - 1, "frames");
    tell(document.clips.size(), "clips");
    tell(document.sockets.size(), "sockets");
    tell(instancesOf(document, 0, true).size() - instancesOf(document, 0).size(), "hidden objects");
    tell(static_cast<std::size_t>(
             std::ranges::count_if(palette.names, [](const auto& name) { return !name.empty(); })),
         "colour names");
    tell(static_cast<std::size_t>(std::ranges::count_if(
             palette.materials, [](const auto& material) { return !material.empty(); })),
         "voxel materials");
    tell(palette.ramps.size(), "colour ramps");
    tell(palette.variants.size(), "palette variants");
    const Entity& entity = document.entity;
    Entity placed;
    placed.name = entity.name;
    placed.anchorVoxels = entity.anchorVoxels;
    if (entity != placed) {
        losses.push_back(where + " has no entity: its rotation, scale and place are left out");
    }
    return losses;
}

}  // namespace voxprite
