// Snapshots of small models, in a light of their own.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/billboard/snapshot.h"
#include "core/model/game_profile.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "core/svo/bake.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {

inline Octree baked(const VoxelGrid& voxels, glm::ivec3 size) {
    return must(bake(voxels, {glm::ivec3(0), size}));
}

// Colours that differ from each other.
inline Palette manyColours() {
    Palette palette;
    for (int index = 1; index < 256; ++index)
        palette.colours[static_cast<std::size_t>(index)] =
            Rgba8(index, (index * 37) % 255, 255 - index, 255);
    return palette;
}

inline glm::dmat3 voxelAxesFromWorld() {
    return glm::transpose(entityRotation(Entity{}) * glm::dmat3(worldFromVoxel({1, 0, 0}),
                                                                worldFromVoxel({0, 1, 0}),
                                                                worldFromVoxel({0, 0, 1})));
}

inline SnapshotLight lightOf(const GameProfile& profile, const Palette& palette = manyColours()) {
    return {palette, profile.light, voxelAxesFromWorld(), profile.outline, profile.shading};
}

inline std::vector<std::pair<std::string, Octree>> smallModels() {
    std::vector<std::pair<std::string, Octree>> models;
    models.emplace_back("figure", must(bake(figure())));
    models.emplace_back("letters", must(bake(asymmetric())));
    models.emplace_back("noise", baked(randomVoxels(7, {11, 7, 9}, 0.2, 200), {11, 7, 9}));
    models.emplace_back("one voxel", must(bake(solidBox({1, 1, 1}, 9))));
    return models;
}

// The entity of a model, its centre at the world's origin, turned by nothing.
inline PlacedEntity centred(const Octree& octree, const GameProfile& profile) {
    PlacedEntity entity = placeEntity(Entity{}, {glm::ivec3(0), octree.size}, profile);
    entity.anchorMetres -= entity.centreMetres();
    return entity;
}

// A camera that sees an entity at the origin from a view of the set, `metres` away.
inline Camera cameraAt(const ViewSet& views, int view, double metres, glm::ivec2 viewportPx) {
    const glm::dmat3 axes = views.axes(view);
    Camera camera;
    camera.right = worldFromVoxel(axes[0]);
    camera.up = worldFromVoxel(axes[1]);
    camera.forward = worldFromVoxel(axes[2]);
    camera.eyeMetres = camera.forward * -metres;
    camera.viewportPx = viewportPx;
    return camera;
}

inline bool same(const Snapshot& a, const Snapshot& b) {
    return a.view == b.view && a.buffer.first == b.buffer.first && a.buffer.size == b.buffer.size &&
           a.buffer.colours == b.buffer.colours && a.buffer.ids == b.buffer.ids &&
           a.depth == b.depth;
}

}  // namespace voxprite::test
