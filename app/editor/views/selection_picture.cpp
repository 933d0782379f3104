#include "app/editor/views/selection_picture.h"

#include "core/edit/transforms.h"
#include "core/svo/bake.h"

namespace voxprite::editor {
namespace {

constexpr Rgba8 kTint(76, 154, 255, 84);

// Where the selected object lies in the frame that is shown; nothing while it does not show.
std::optional<Placement> placeOf(const Session& session) {
    const VoxelSelection& selection = session.selection();
    for (const Instance& instance : session.instances()) {
        if (instance.node == selection.node() && instance.model == selection.model()) {
            return instance.entityFromModel;
        }
    }
    return std::nullopt;
}

}  // namespace

void SelectionPicture::bakeAgain() {
    VoxelClip clip{source_.voxels, {source_.rotation, glm::ivec3(0)}};
    box_ = {};
    if (source_.scale > 1 && !scale(clip, source_.scale)) return;
    const VoxelGrid grid = clip.placed();
    if (grid.empty()) return;
    const Result<Octree> octree = bake(grid);
    if (!octree) return;
    octree_.upload(octree->view());
    box_ = grid.bounds();
}

std::uint64_t SelectionPicture::follow(const Session& session) {
    const VoxelSelection& selection = session.selection();
    const auto& floating = selection.floating();
    const std::optional<Placement> place = placeOf(session);
    const Placement entityFromModel = floating ? Placement{} : place.value_or(Placement{});
    const bool shows =
        floating ? floating->kind == Floating::Kind::move : place.has_value() && !selection.empty();
    const std::uint64_t wanted = shows ? selection.revision() : 0;
    if (wanted == revision_ && entityFromModel == entityFromModel_) return revision_;
    revision_ = wanted;
    entityFromModel_ = entityFromModel;
    Source now;
    if (shows && floating) {
        now = {floating->clip.voxels, floating->clip.modelFromClip.rotation, floating->amount};
    } else if (shows) {
        now = {selection.voxels().grid(), entityFromModel.rotation, 1};
    }
    if (source_ != now) {
        source_ = std::move(now);
        bakeAgain();
    }
    if (box_.empty()) return 0;
    const glm::ivec3 corner = floating
                                  ? floating->bounds().min
                                  : entityFromModel.applyToBox(selection.voxels().bounds()).min;
    box_ = {corner, corner + box_.size()};
    return revision_;
}

void SelectionPicture::draw(VoxelView& view, Frame& frame, const Session& session,
                            const Camera& camera, float scale) const {
    if (box_.empty()) return;
    view.drawMarked(frame, octree_, session.shownPalette(), Session::placedForEditing(box_), camera,
                    kTint, scale);
}

}  // namespace voxprite::editor
