#include "app/editor/session/large_preview.h"

#include <utility>

#include "core/model/entity_voxels.h"

namespace voxprite::editor {
namespace {

constexpr std::chrono::milliseconds kRest{120};

// The document with the patches in force; around the voxels that they fill, in entity space.
IBox patchAll(Document& document, int frame, const std::vector<VoxelPatch>& patches) {
    IBox filled;
    const std::vector<Instance> instances = instancesOf(document, frame);
    for (const VoxelPatch& patch : patches) {
        VoxelGrid& voxels = document.models[static_cast<std::size_t>(patch.model)].voxels;
        IBox box;
        for (const VoxelChange& change : patch.changes) {
            voxels.set(change.position, change.after);
            if (change.after != 0) box = box.united(IBox::around(change.position, change.position));
        }
        for (const Instance& instance : instances) {
            if (instance.model != patch.model || box.empty()) continue;
            filled = filled.united(instance.entityFromModel.applyToBox(box));
        }
    }
    return filled;
}

}  // namespace

void LargePreview::ask(PlanPreview plan) {
    drop();
    plan_ = std::move(plan);
    asked_ = std::chrono::steady_clock::now();
}

void LargePreview::drop() {
    job_.cancel();
    plan_ = {};
    ready_.reset();
    problem_.reset();
}

void LargePreview::begin(Session& session) {
    const auto make = std::exchange(plan_, {})(session);
    if (!make) return;
    job_.start("Preview", [this, make, document = session.snapshot(), frame = session.frame(),
                           revision = session.revision()](JobProgress& progress) {
        const std::stop_token stop = progress.stopToken();
        const BackgroundJob::Done nothing;
        const Result<std::vector<VoxelPatch>> patches = make(*document);
        if (stop.stop_requested()) return nothing;
        if (!patches) {
            return BackgroundJob::Done([this, error = patches.error()] { problem_ = error; });
        }
        Document after = *document;
        const auto picture = std::make_shared<Picture>();
        picture->filled = patchAll(after, frame, *patches);
        picture->revision = revision;
        if (stop.stop_requested() || !picture->octree.rebuild(flatten(after, frame)))
            return nothing;
        return BackgroundJob::Done([this, picture] { ready_ = picture; });
    });
}

void LargePreview::update(Session& session) {
    if (plan_ && std::chrono::steady_clock::now() - asked_ >= kRest) begin(session);
    static_cast<void>(job_.finish());
    if (const auto picture = std::exchange(ready_, nullptr)) {
        if (picture->revision != session.revision()) return;
        session.showInstead(std::move(picture->octree), picture->filled);
    }
}

void LargePreview::finish(Session& session) {
    if (plan_) begin(session);
    job_.wait();
    update(session);
}

}  // namespace voxprite::editor
