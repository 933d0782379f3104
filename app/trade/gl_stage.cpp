#include "app/trade/gl_stage.h"

#include <glad/gl.h>

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/base/stopwatch.h"
#include "render/frame.h"
#include "render/gpu_clusters.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"
#include "render/snapshot_renderer.h"

namespace voxprite::trade {

struct GlStage::Impl {
    SceneRenderer scenes;
    SnapshotRenderer snapshots;
    ModelParts* parts = nullptr;
    std::map<int, GpuOctree> octrees;  // by the levels left out
    std::optional<GpuClusters> clusters;
    Frame frame{glm::ivec2(1)};
    std::map<std::string, ViewSet> views;  // their places in memory stay

    [[nodiscard]] Result<GpuOctree*> octreeOf(const Setting& setting);
    [[nodiscard]] Result<OctreeView> voxelsOf(int levels);
    [[nodiscard]] Result<const ViewSet*> viewsOf(const std::string& name);
    [[nodiscard]] Result<SceneEntity> entityOf(const Setting& setting, ViewHistory* history);
    [[nodiscard]] Status drawScene(const Setting& setting, const GameProfile& profile,
                                   const Camera& camera, ViewHistory* history);
    [[nodiscard]] Status drawSeed(const Setting& setting, const GameProfile& profile,
                                  const Camera& camera, ViewHistory& history);
};

Result<OctreeView> GlStage::Impl::voxelsOf(int levels) {
    if (levels == 0) return parts->model().octree.view();
    const Result<const ModelParts::Coarse*> coarse = parts->coarse(levels);
    if (!coarse) return Failure(coarse.error());
    return (*coarse)->octree.view();
}

Result<GpuOctree*> GlStage::Impl::octreeOf(const Setting& setting) {
    const int levels = setting.drawnBy == Representation::coarse ? setting.coarseLevels : 0;
    const auto known = octrees.find(levels);
    if (known != octrees.end()) return &known->second;
    const Result<OctreeView> voxels = voxelsOf(levels);
    if (!voxels) return Failure(voxels.error());
    GpuOctree& octree = octrees[levels];
    octree.upload(*voxels);
    if (!octree.status()) return Failure(octree.status().error());
    return &octree;
}

Result<const ViewSet*> GlStage::Impl::viewsOf(const std::string& name) {
    const auto known = views.find(name);
    if (known != views.end()) return &known->second;
    Result<ViewSet> set = ViewSet::named(name);
    if (!set) return Failure(set.error());
    return &views.emplace(name, std::move(*set)).first->second;
}

Result<SceneEntity> GlStage::Impl::entityOf(const Setting& setting, ViewHistory* history) {
    const Result<GpuOctree*> octree = octreeOf(setting);
    if (!octree) return Failure(octree.error());
    SceneEntity entity{*octree, &parts->model().palette, parts->placed(), history};
    entity.representation = setting.drawnBy;
    if (setting.drawnBy == Representation::coarse) {
        const Result<const ModelParts::Coarse*> coarse = parts->coarse(setting.coarseLevels);
        if (!coarse) return Failure(coarse.error());
        entity.placed = (*coarse)->placed;
    }
    if (setting.drawnBy == Representation::snapshot) {
        const Result<const ViewSet*> set = viewsOf(setting.viewSet);
        if (!set) return Failure(set.error());
        entity.views = *set;
    }
    if (setting.drawnBy == Representation::clusters) {
        if (!clusters) {
            const Result<const ModelParts::Clusters*> mesh = parts->clusters();
            if (!mesh) return Failure(mesh.error());
            clusters.emplace().upload((*mesh)->mesh);
        }
        entity.clusters = &*clusters;
    }
    return entity;
}

Status GlStage::Impl::drawScene(const Setting& setting, const GameProfile& profile,
                                const Camera& camera, ViewHistory* history) {
    const Result<SceneEntity> entity = entityOf(setting, history);
    if (!entity) return Failure(entity.error());
    frame.resize(camera.viewportPx);
    Scene scene;
    scene.clusterBudgetPx = setting.clusterBudgetPx;
    scene.entities = {*entity};
    const Result<SceneStats> drawn = scenes.draw(frame, scene, camera, profile, profile.mode);
    return drawn ? Status() : Failure(drawn.error());
}

Status GlStage::Impl::drawSeed(const Setting& setting, const GameProfile& profile,
                               const Camera& camera, ViewHistory& history) {
    const Result<GpuOctree*> octree = octreeOf(setting);
    if (!octree) return Failure(octree.error());
    const Result<const ViewSet*> set = viewsOf(setting.viewSet);
    if (!set) return Failure(set.error());
    const std::array entities{
        SnapshotEntity{*octree, &parts->model().palette, parts->placed(), &history}};
    frame.resize(camera.viewportPx);
    frame.begin(Rgba8(0));
    const Result<SnapshotStats> drawn =
        snapshots.draw(frame, entities, camera, profile, {**set, setting.snapshotPx, {}});
    return drawn ? Status() : Failure(drawn.error());
}

GlStage::GlStage(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GlStage::~GlStage() = default;
GlStage::GlStage(GlStage&&) noexcept = default;
GlStage& GlStage::operator=(GlStage&&) noexcept = default;

Result<GlStage> GlStage::create() {
    Result<SceneRenderer> scenes = SceneRenderer::create();
    if (!scenes) return Failure(scenes.error());
    Result<SnapshotRenderer> snapshots = SnapshotRenderer::create();
    if (!snapshots) return Failure(snapshots.error());
    return GlStage(std::make_unique<Impl>(std::move(*scenes), std::move(*snapshots)));
}

void GlStage::setModel(ModelParts& parts) {
    impl_->parts = &parts;
    impl_->octrees.clear();
    impl_->clusters.reset();
}

Result<SpriteBuffer> GlStage::castBuffer(const Setting& setting, const LatticeView& lattice,
                                         const LitPalette& lit) {
    const Result<GpuOctree*> octree = impl_->octreeOf(setting);
    if (!octree) return Failure(octree.error());
    return impl_->scenes.castBuffer(**octree, lattice, lit, setting.mode);
}

Result<Shown> GlStage::show(const Setting& setting, const GameProfile& profile,
                            const Camera& camera) {
    const Status drawn = impl_->drawScene(setting, profile, camera, nullptr);
    if (!drawn) return Failure(drawn.error());
    return Shown{impl_->frame.readColour(), {}, 0.0, 0.0};
}

void GlStage::forget() {
    // Another upload is another model to every cache.
    for (auto& [levels, octree] : impl_->octrees)
        if (const Result<OctreeView> voxels = impl_->voxelsOf(levels)) octree.upload(*voxels);
}

Result<double> GlStage::frame(const Setting& setting, const GameProfile& profile,
                              const Camera& camera, ViewHistory& history) {
    const Stopwatch watch;
    const bool seed =
        setting.drawnBy == Representation::snapshot && setting.snapshotKind == SnapshotKind::seed;
    const Status drawn = seed ? impl_->drawSeed(setting, profile, camera, history)
                              : impl_->drawScene(setting, profile, camera, &history);
    if (!drawn) return Failure(drawn.error());
    glFinish();
    return watch.milliseconds();
}

}  // namespace voxprite::trade
