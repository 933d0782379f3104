#include "app/editor/views/selection_picture.h"

#include <memory>
#include <utility>

#include "core/edit/transforms.h"
#include "core/svo/bake.h"

namespace voxprite::editor {
namespace {

constexpr Rgba8 kTint(76, 154, 255, 84);
// Cubes of 8: what is made of so many is made at once.
constexpr std::uint64_t kFewCubes = 4'096;

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

SelectionPicture::Baked SelectionPicture::bakeOf(const Source& source) {
    VoxelClip clip{source.voxels, {source.rotation, glm::ivec3(0)}};
    if (source.scale > 1 && !scale(clip, source.scale)) return {};
    // Marks have no colours of their own: most of an octree is one value, and few nodes.
    const VoxelSet marked = clip.footprint();
    if (marked.empty()) return {};
    Result<Octree> octree = bake(marked.grid());
    if (!octree) return {};
    return {std::move(*octree), marked.bounds()};
}

void SelectionPicture::show(const Baked& baked) {
    box_ = baked.box;
    if (!box_.empty()) octree_.upload(baked.octree.view());
}

void SelectionPicture::showNothing() {
    job_.cancel();
    box_ = {};
    source_ = {};
    revision_ = shown_ = 0;
}

void SelectionPicture::make(Source source) {
    job_.cancel();
    Source before = std::exchange(source_, std::move(source));
    const auto factor = static_cast<std::uint64_t>(source_.scale);
    if (source_.voxels.cubeCount() * factor * factor * factor <= kFewCubes) {
        return show(bakeOf(source_));
    }
    job_.start(
        "Marking what is selected",
        // What was marked before goes with the job: to free very many voxels takes time, too.
        [this, source = source_,
         before = std::move(before)](JobProgress&) mutable -> BackgroundJob::Done {
            before = {};
            const auto baked = std::make_shared<const Baked>(bakeOf(source));
            return [this, baked] { show(*baked); };
        });
}

void SelectionPicture::finish() {
    job_.wait();
}

std::uint64_t SelectionPicture::follow(const Session& session) {
    const VoxelSelection& selection = session.selection();
    const auto& floating = selection.floating();
    const std::optional<Placement> place = placeOf(session);
    const Placement entityFromModel = floating ? Placement{} : place.value_or(Placement{});
    const bool shows =
        floating ? floating->kind == Floating::Kind::move : place.has_value() && !selection.empty();
    if (!shows) {
        showNothing();
        return 0;
    }
    const bool changed = selection.revision() != revision_ || entityFromModel != entityFromModel_;
    const bool ready = job_.finish();
    if (!changed && !ready) return shown_;
    if (changed) {
        revision_ = selection.revision();
        entityFromModel_ = entityFromModel;
        Source now{selection.voxels().grid(), entityFromModel.rotation, 1};
        if (floating) {
            now = {floating->clip.voxels, floating->clip.modelFromClip.rotation, floating->amount};
        }
        if (source_ != now) make(std::move(now));
    }
    // What was marked before stays where it was.
    if (job_.running()) return shown_;
    if (box_.empty()) return shown_ = 0;
    const glm::ivec3 corner = floating
                                  ? floating->bounds().min
                                  : entityFromModel.applyToBox(selection.voxels().bounds()).min;
    box_ = {corner, corner + box_.size()};
    return shown_ = revision_;
}

void SelectionPicture::draw(VoxelView& view, Frame& frame, const Camera& camera,
                            float scale) const {
    if (box_.empty()) return;
    view.drawMarked(frame, octree_, Session::placedForEditing(box_), camera, kTint, scale);
}

}  // namespace voxprite::editor
