// Steps of very many voxels: prepared beside the document, then put in force at once.
#include <algorithm>

#include "app/editor/session/session.h"

namespace voxprite::editor {
namespace {

// Cubes of 8: to build the octree of more than these anew takes long.
constexpr std::uint64_t kManyCubes = 6'000;
// Changes: a tool has shown what it makes before it is made, history goes where nothing is shown
// yet and takes longer for as many.
constexpr std::uint64_t kLongWayBack = 100'000;

std::uint64_t cubesOf(const Document& document) {
    std::uint64_t cubes = 0;
    for (const Model& model : document.models) cubes += model.voxels.cubeCount();
    return cubes;
}

bool isLongStep(const Document& document, const Action& action, std::uint64_t mostChanges,
                SceneState SceneEdit::*after = &SceneEdit::after) {
    return std::ranges::any_of(action.parts, [&](const ActionPart& part) {
        if (const auto* patch = std::get_if<VoxelPatch>(&part)) {
            return patch->changes.size() > mostChanges;
        }
        const auto* scene = std::get_if<SceneEdit>(&part);
        return scene != nullptr && cubesOf(document) > kManyCubes &&
               !showsTheSame(sceneOf(document), scene->*after);
    });
}

}  // namespace

bool Session::isLong(const Action& action) const {
    return action.makePatches || isLongStep(document(), action, kLongStepVoxels);
}

bool Session::undoIsLong() const {
    return history_.canUndo() && isLongStep(document(), history_.steps()[history_.position() - 1],
                                            kLongWayBack, &SceneEdit::before);
}

bool Session::redoIsLong() const {
    return history_.canRedo() &&
           isLongStep(document(), history_.steps()[history_.position()], kLongWayBack);
}

Result<std::shared_ptr<Session::Prepared>> Session::derived(Result<PreparedStep> step, int shown,
                                                            const VoxelSelection* floating,
                                                            const Progress& progress) {
    if (!step) return Failure(step.error());
    if (!progress.reached(0.0)) return fail("stopped");
    const Document& after = step->workspace.document;
    const int frame = std::clamp(shown, 0, frameCount(after) - 1);
    Result<Derived> derived = derive(after, frame);
    if (!derived) return Failure(derived.error());
    if (!progress.reached(0.8)) return fail("stopped");
    Result<std::optional<VoxelSet>> landed = std::optional<VoxelSet>();
    if (floating != nullptr) landed = floating->landed();
    if (!landed) return Failure(landed.error());
    if (!progress.reached(1.0)) return fail("stopped");
    return std::make_shared<Prepared>(
        Prepared{std::move(*step), std::move(*derived), std::move(*landed)});
}

Result<std::shared_ptr<Session::Prepared>> Session::prepare(Action action,
                                                            const Progress& progress) const {
    if (Status made = makeParts(action, document()); !made) return Failure(made.error());
    return derived(History::prepare(workspace_, std::move(action), progress.part(0.3, 0.7)), frame_,
                   &selection_, progress.part(0.7, 1.0));
}

Result<std::shared_ptr<Session::Prepared>> Session::prepare(const Workspace& workspace, int frame,
                                                            Action action,
                                                            const Progress& progress) {
    return derived(History::prepare(workspace, std::move(action), progress.part(0.0, 0.6)), frame,
                   nullptr, progress.part(0.6, 1.0));
}

Result<std::shared_ptr<Session::Prepared>> Session::prepareUndo(const Progress& progress) const {
    return derived(history_.prepareUndo(workspace_, progress.part(0.0, 0.6)), frame_, &selection_,
                   progress.part(0.6, 1.0));
}

Result<std::shared_ptr<Session::Prepared>> Session::prepareRedo(const Progress& progress) const {
    return derived(history_.prepareRedo(workspace_, progress.part(0.0, 0.6)), frame_, &selection_,
                   progress.part(0.6, 1.0));
}

void Session::commit(Prepared prepared) {
    const std::size_t position = history_.position();
    const bool executes = prepared.step.way == PreparedStep::Way::execute;
    const Changed changed = history_.commit(workspace_, std::move(prepared.step));
    if (!changed.any()) return selection_.land(std::nullopt);
    selection_.land(std::move(prepared.landed));
    if (executes) {
        selection_.stepMade(position, history_.position() == position + 1, changed);
    } else {
        selection_.wentTo(position, history_.position(), changed);
    }
    ++revision_;
    ++modelRevision_;
    ++contentsRevision_;
    for (const Changed::Voxels& voxels : changed.voxels) reviseVoxels(voxels.model);
    frame_ = std::clamp(frame_, 0, prepared.derived.frames - 1);
    if (changed.palette) followPalette();
    install(std::move(prepared.derived));
    arrive(changed);
}

std::shared_ptr<const Document> Session::snapshot() {
    auto known = snapshotRevision_ == revision_ ? snapshot_.lock() : nullptr;
    if (known) return known;
    auto copy = std::make_shared<const Document>(document());
    snapshot_ = copy;
    snapshotRevision_ = revision_;
    return copy;
}

void Session::showInstead(LiveOctree octree, const IBox& filled) {
    shown_.show(std::move(octree), filled);
}

}  // namespace voxprite::editor
