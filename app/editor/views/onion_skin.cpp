#include "app/editor/views/onion_skin.h"

#include "core/svo/bake.h"

namespace voxprite::editor {
namespace {

constexpr Rgba8 kBefore(235, 92, 92, 104);
constexpr Rgba8 kAfter(92, 170, 235, 104);

// Equal sources are equal octrees: the same voxels in the same places.
std::vector<std::uint64_t> sourceOf(const Session& session, int frame, const IBox& bounds) {
    std::vector<std::uint64_t> source;
    const auto add = [&](glm::ivec3 v) {
        for (int axis = 0; axis < 3; ++axis) source.push_back(static_cast<std::uint32_t>(v[axis]));
    };
    add(bounds.min);
    add(bounds.max);
    for (const Instance& instance : instancesOf(session.document(), frame)) {
        source.push_back(static_cast<std::uint64_t>(instance.model));
        source.push_back(session.voxelRevision(instance.model));
        source.push_back(static_cast<std::uint64_t>(instance.entityFromModel.rotation.toVoxByte()));
        add(instance.entityFromModel.translation);
    }
    return source;
}

}  // namespace

Status OnionSkin::show(const Session& session, int frame, Skin& skin) {
    // What the pointer only shows changes no other frame.
    const IBox& bounds = session.bounds();
    std::vector<std::uint64_t> source = sourceOf(session, frame, bounds);
    if (source == skin.source) return {};
    const Result<Octree> octree = bake(flatten(session.document(), frame), bounds);
    if (!octree) return Failure(octree.error());
    skin.octree.upload(octree->view());
    skin.source = std::move(source);
    return {};
}

Result<std::vector<OnionSkin::Ghost>> OnionSkin::ghosts(const Session& session, bool on) {
    std::vector<Ghost> ghosts;
    if (!on || session.frames() < 2 || session.bounds().empty()) return ghosts;
    for (const int step : {-1, 1}) {
        const int frame = session.frame() + step;
        if (frame < 0 || frame >= session.frames()) continue;
        Skin& skin = skins_[step < 0 ? 0 : 1];
        if (Status shown = show(session, frame, skin); !shown) return Failure(shown.error());
        ghosts.push_back({&skin.octree, step < 0 ? kBefore : kAfter});
    }
    return ghosts;
}

}  // namespace voxprite::editor
