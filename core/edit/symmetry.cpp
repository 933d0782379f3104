#include "core/edit/symmetry.h"

#include "core/edit/transforms.h"

namespace voxprite {

namespace {

// Through the plane of one axis. A mirrored axis sends the cell v to -v - 1 + translation.
Placement mirrorOf(const Symmetry& symmetry, int axis) {
    Placement mirror;
    mirror.rotation.sign[static_cast<std::size_t>(axis)] = -1;
    mirror.translation[axis] = symmetry.planeDoubled[axis];
    return mirror;
}

}  // namespace

std::vector<Placement> imagesOf(const Symmetry& symmetry) {
    std::vector<Placement> images{Placement{}};
    for (int axis = 0; axis < 3; ++axis) {
        if (!symmetry.on[static_cast<std::size_t>(axis)]) continue;
        const Placement mirror = mirrorOf(symmetry, axis);
        const std::size_t count = images.size();
        for (std::size_t i = 0; i < count; ++i) images.push_back(mirror * images[i]);
    }
    return images;
}

std::vector<glm::ivec3> mirrored(std::span<const glm::ivec3> positions, const Symmetry& symmetry) {
    std::vector<glm::ivec3> all;
    const std::vector<Placement> images = imagesOf(symmetry);
    all.reserve(positions.size() * images.size());
    for (const Placement& image : images) {
        for (const glm::ivec3 v : positions) all.push_back(image.applyToVoxel(v));
    }
    return all;
}

VoxelSet mirrored(const VoxelSet& set, const Symmetry& symmetry) {
    // Mirror by mirror, each of what there is already.
    VoxelSet all = set;
    for (int axis = 0; axis < 3; ++axis) {
        if (!symmetry.on[static_cast<std::size_t>(axis)]) continue;
        all.unite(transformed(all, mirrorOf(symmetry, axis)));
    }
    return all;
}

}  // namespace voxprite
