#include "app/editor/session/selection.h"

#include <algorithm>
#include <utility>

#include "core/edit/transforms.h"
#include "core/model/voxel_morphology.h"

namespace voxprite::editor {
namespace {

constexpr int kMaxScale = 16, kMaxPasses = 16;

VoxelClip inModel(VoxelClip clip, const Placement& entityFromModel) {
    clip.modelFromClip = entityFromModel.inverse() * clip.modelFromClip;
    return clip;
}

}  // namespace

int Floating::greatestAmount(Kind kind) {
    switch (kind) {
        case Kind::move:
            return kMaxScale;
        case Kind::smooth:
            return kMaxPasses;
        default:
            return kMaxMorphologyLayers;
    }
}

IBox Floating::bounds() const {
    const IBox box = clip.bounds();
    if (kind != Kind::move || box.empty()) return box;
    return {box.min, box.min + box.size() * amount};
}

void Floating::moveTo(glm::ivec3 min) {
    moveBy(min - bounds().min);
}

void Floating::place(const SignedPermutation& rotation) {
    // The voxels turn unscaled; the corner goes where that of the scaled ones does.
    const IBox box = bounds();
    const glm::ivec3 corner = inPlace(rotation, box).applyToBox(box).min;
    clip.modelFromClip = inPlace(rotation, clip.bounds()) * clip.modelFromClip;
    moveTo(corner);
}

void Floating::turn(int axis, int turns) {
    for (int i = 0; i < (turns % 4 + 4) % 4; ++i) place(quarterTurns(axis, 1));
}

void Floating::flip(int axis) {
    place(voxprite::flip(axis));
}

Result<VoxelClip> Floating::made() const {
    VoxelClip result = clip;
    if (kind == Kind::move) {
        if (amount == 1) return result;
        Status scaled = scale(result, amount);
        return scaled ? Result<VoxelClip>(std::move(result)) : Failure(scaled.error());
    }
    Result<VoxelGrid> voxels = kind == Kind::hollow   ? hollowed(clip.voxels, amount)
                               : kind == Kind::dilate ? dilated(clip.voxels, amount)
                               : kind == Kind::erode  ? eroded(clip.voxels, amount)
                                                      : smoothed(clip.voxels, amount);
    if (!voxels) return Failure(voxels.error());
    result.voxels = std::move(*voxels);
    return result;
}

Result<VoxelPatch> Floating::patch(const Document& document) const {
    Result<VoxelClip> laid = made();
    if (!laid) return Failure(laid.error());
    EditLimits inside;
    if (limits) inside.box = entityFromModel.inverse().applyToBox(*limits);
    // What grows fills the air around it; it never eats its neighbours.
    const bool grows = kind == Kind::dilate || kind == Kind::smooth;
    return patchMove(document, model, from, inModel(std::move(*laid), entityFromModel),
                     grows ? PasteRule::under : PasteRule::over, inside);
}

Result<VoxelSet> Floating::footprint() const {
    Result<VoxelClip> laid = made();
    if (!laid) return Failure(laid.error());
    return inModel(std::move(*laid), entityFromModel).footprint();
}

bool Floating::isLarge() const {
    const auto each = static_cast<std::uint64_t>(kind == Kind::move ? amount * amount * amount : 1);
    return clip.voxels.solidCount() * each > kLongStepVoxels;
}

void VoxelSelection::select(int node, int model, VoxelSet with, SelectMode mode) {
    if (mode != SelectMode::replace) {
        const bool same = node == now_.node && model == now_.model;
        with = combined(same ? voxels() : VoxelSet(), with, mode);
    }
    now_ = {node, model, std::make_shared<const VoxelSet>(std::move(with))};
    ++revision_;
}

void VoxelSelection::setFloating(std::optional<Floating> floating) {
    floating_ = std::move(floating);
    lands_ = false;
    ++revision_;
}

void VoxelSelection::selectWithNextStep(int node, int model, VoxelSet voxels) {
    next_ = State{node, model, std::make_shared<const VoxelSet>(std::move(voxels))};
}

Result<std::optional<VoxelSet>> VoxelSelection::landed() const {
    if (!lands_ || !floating_ || !floating_->selects) return std::optional<VoxelSet>();
    Result<VoxelSet> footprint = floating_->footprint();
    if (!footprint) return Failure(footprint.error());
    return std::optional<VoxelSet>(std::move(*footprint));
}

void VoxelSelection::land(std::optional<VoxelSet> landed) {
    if (!std::exchange(lands_, false)) return;
    if (landed) selectWithNextStep(floating_->node, floating_->model, std::move(*landed));
    setFloating(std::nullopt);
}

void VoxelSelection::followNodes(const Changed& changed) {
    if (changed.nodesAfter.empty()) return;
    ++revision_;
    now_.node = changed.nodeNow(now_.node);
    if (floating_) floating_->node = changed.nodeNow(floating_->node);
}

void VoxelSelection::stepMade(std::size_t position, bool asANewStep, const Changed& changed) {
    // Steps that were merged or forgotten would give positions other meanings.
    if (!asANewStep) before_.clear();
    before_.erase(before_.lower_bound(position), before_.end());
    if (asANewStep) before_[position] = now_;
    followNodes(changed);
    if (next_) {
        now_ = *std::exchange(next_, std::nullopt);
        ++revision_;
    }
}

void VoxelSelection::wentTo(std::size_t from, std::size_t to, const Changed& changed) {
    before_[from] = now_;
    followNodes(changed);
    const auto then = before_.find(to);
    if (then == before_.end()) return;
    now_ = then->second;
    ++revision_;
}

void VoxelSelection::follow(const Document& document, const Changed& changed) {
    // In some frame: models stay when nothing shows them any more.
    const auto isThere = [&](int node, int model) {
        if (node < 0 || static_cast<std::size_t>(node) >= document.nodes.size()) return false;
        const std::vector<ModelKey>& shown = document.nodes[static_cast<std::size_t>(node)].models;
        return std::ranges::find(shown, model, &ModelKey::model) != shown.end();
    };
    if (floating_ && !isThere(floating_->node, floating_->model)) setFloating(std::nullopt);
    if (empty()) return;
    if (!isThere(now_.node, now_.model)) return clear();
    const auto isOurs = [&](const Changed::Voxels& edit) { return edit.model == now_.model; };
    if (!changed.scene && std::ranges::none_of(changed.voxels, isOurs)) return;
    const auto& grid = document.models[static_cast<std::size_t>(now_.model)].voxels;
    VoxelSet left = stillSolid(grid, voxels());
    if (left.count() != voxels().count()) select(now_.node, now_.model, std::move(left));
}

void VoxelSelection::forget() {
    clear();
    next_.reset();
    before_.clear();
    floating_.reset();
    lands_ = false;
}

}  // namespace voxprite::editor
