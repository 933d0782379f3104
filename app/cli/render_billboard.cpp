// The pictures of `voxprite render --mode billboard`.
#include <glm/matrix.hpp>

#include "app/cli/render_shot.h"
#include "app/cli/stopwatch.h"
#include "core/billboard/snapshot_cache.h"
#include "render/gl/context.h"
#include "render/snapshot_renderer.h"

namespace voxprite::cli {
namespace {

SnapshotChoice choiceOf(const SnapshotRequest& request) {
    return {request.depth.value_or(SnapshotDepth::centre), request.blend};
}

Result<Drawn> drawOnCpuFrom(const Shot& shot, const SeenSnapshots& seen, bool wantImage,
                            Times& times) {
    Stopwatch watch;
    const SnapshotLight light(shot.palette, shot.profile.light,
                              glm::transpose(shot.placed.worldFromVoxelAxes), shot.profile.outline,
                              shot.profile.shading);
    Result<SnapshotCache> cache =
        SnapshotCache::create(shot.snapshots.views, light, {.sizePx = shot.snapshots.sizePx});
    if (!cache) return Failure(cache.error());
    Drawn drawn;
    std::vector<std::shared_ptr<const Snapshot>> held;
    std::vector<BlitSource> sources;
    for (const ShownSnapshot& shown : seen.shown) {
        auto snapshot = cache->at(shown.view, shot.octree.view());
        if (!snapshot) return Failure(snapshot.error());
        held.push_back(std::move(*snapshot));
        sources.push_back({held.back().get(), &shown.plane, shown.weight});
    }
    drawn.buffer = held.empty() ? SpriteBuffer{} : held.front()->buffer;
    drawn.snapshots.emplace().bytes = cache->bytes();
    times.emplace_back("cast", watch.lapMilliseconds());
    if (!wantImage) return drawn;
    SnapshotCanvas canvas(shot.camera.viewportPx, shot.background);
    blitSnapshots(sources, shot.placed.metresPerVoxel(), choiceOf(shot.snapshots).depth,
                  shot.camera, canvas);
    if (shot.ground) drawGround(*shot.ground, shot.camera, canvas.depths, canvas.colours);
    drawn.image = std::move(canvas.colours);
    times.emplace_back("draw", watch.lapMilliseconds());
    return drawn;
}

Result<Drawn> drawOnGlFrom(const Shot& shot, const SeenSnapshots& seen, bool wantImage,
                           Times& times) {
    Stopwatch watch;
    const Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
    if (!context) return Failure(context.error());
    Drawn drawn;
    drawn.driver = gl::driverInfo().renderer + ", " + gl::driverInfo().version;
    if (Status fits = Frame::checkSize(shot.camera.viewportPx); !fits) {
        return Failure(fits.error());
    }
    GpuOctree octree;
    octree.upload(shot.octree.view());
    Result<SnapshotRenderer> renderer = SnapshotRenderer::create();
    if (!renderer) return Failure(renderer.error());
    times.emplace_back("start", watch.lapMilliseconds());
    const SnapshotEntity entity{&octree, &shot.palette, shot.placed, nullptr};
    const SnapshotRules rules{shot.snapshots.views, shot.snapshots.sizePx,
                              choiceOf(shot.snapshots)};
    drawn.buffer.emplace();
    if (!seen.shown.empty()) {
        Result<Snapshot> snapshot =
            renderer->cast(entity, shot.profile, rules, seen.shown.front().view);
        if (!snapshot) return Failure(snapshot.error());
        drawn.buffer = std::move(snapshot->buffer);
        times.emplace_back("cast", watch.lapMilliseconds());
    }
    Frame frame(shot.camera.viewportPx);
    frame.begin(shot.background);
    const Result<SnapshotStats> stats =
        renderer->draw(frame, {&entity, 1}, shot.camera, shot.profile, rules);
    if (!stats) return Failure(stats.error());
    drawn.snapshots.emplace().bytes = stats->bytes;
    if (wantImage) {
        drawn.image = frame.readColour();
        if (shot.ground) drawGround(*shot.ground, shot.camera, frame.readDepth(), *drawn.image);
    }
    times.emplace_back("draw", watch.lapMilliseconds());
    return drawn;
}

}  // namespace

Result<Drawn> drawSnapshots(const Shot& shot, Backend backend, bool wantImage, Times& times) {
    const Result<SeenSnapshots> seen =
        seeSnapshots(shot.placed, shot.camera, shot.snapshots.views, shot.snapshots.sizePx,
                     choiceOf(shot.snapshots));
    if (!seen) return Failure(seen.error());
    Result<Drawn> drawn = backend == Backend::gl ? drawOnGlFrom(shot, *seen, wantImage, times)
                                                 : drawOnCpuFrom(shot, *seen, wantImage, times);
    if (!drawn) return drawn;
    drawn->snapshots->unseen = seen->unseen;
    drawn->snapshots->degreesOff = seen->degreesOff;
    for (const ShownSnapshot& shown : seen->shown) {
        drawn->snapshots->views.push_back({shown.view, shown.weight});
    }
    return drawn;
}

ChosenSnapshots chosenSprite(const Shot& shot, const SpriteBuffer& buffer) {
    ChosenSnapshots chosen;
    chosen.unseen = shot.unseen;
    chosen.bytes = buffer.ids.size() * (sizeof(Rgba8) + sizeof(std::uint32_t));
    if (!shot.view) return chosen;
    chosen.views = {{*shot.view->viewOfSet, 1.0}};
    chosen.degreesOff = shot.view->degreesOff;
    return chosen;
}

}  // namespace voxprite::cli
