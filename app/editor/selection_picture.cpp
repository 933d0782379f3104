#include "app/editor/selection_picture.h"

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

// In entity space. What is being reshaped is seen without any mark on it.
VoxelGrid marked(const Session& session, const std::optional<Placement>& place) {
    const VoxelSelection& selection = session.selection();
    if (const auto& floating = selection.floating()) {
        if (floating->kind != Floating::Kind::move) return {};
        const Result<VoxelClip> made = floating->made();
        return made ? made->placed() : VoxelGrid();
    }
    if (selection.empty() || !place) return {};
    return *place == Placement{} ? selection.voxels().grid()
                                 : transformed(selection.voxels().grid(), *place);
}

}  // namespace

std::uint64_t SelectionPicture::follow(const Session& session) {
    const std::optional<Placement> place = placeOf(session);
    const Source now{place || session.selection().floating() ? session.selection().revision() : 0,
                     place.value_or(Placement{})};
    if (source_ != now) {
        source_ = now;
        const VoxelGrid grid = marked(session, place);
        box_ = grid.bounds();
        const Result<Octree> octree =
            box_.empty() ? Result<Octree>(fail("nothing")) : bake(grid, box_);
        if (octree) {
            octree_.upload(octree->view());
        } else {
            box_ = {};
        }
    }
    return box_.empty() ? 0 : octree_.revision();
}

void SelectionPicture::draw(VoxelView& view, Frame& frame, const Session& session,
                            const Camera& camera, float scale) const {
    if (box_.empty()) return;
    view.drawMarked(frame, octree_, session.shownPalette(), Session::placedForEditing(box_), camera,
                    kTint, scale);
}

}  // namespace voxprite::editor
