#include "render/scene_look.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "core/base/parallel.h"
#include "core/sprite/view_set.h"

namespace voxprite {

namespace {

bool same(const Camera& a, const Camera& b) {
    return a.eyeMetres == b.eyeMetres && a.right == b.right && a.up == b.up &&
           a.forward == b.forward && a.orthographic == b.orthographic &&
           a.verticalFovDegrees == b.verticalFovDegrees &&
           a.orthographicHeightMetres == b.orthographicHeightMetres &&
           a.nearMetres == b.nearMetres && a.viewportPx == b.viewportPx;
}

bool same(const PlacedEntity& a, const PlacedEntity& b) {
    return a.anchorMetres == b.anchorMetres && a.worldFromVoxelAxes == b.worldFromVoxelAxes &&
           a.modelSize == b.modelSize && a.anchor == b.anchor && a.scale == b.scale &&
           a.centreFromMiddle == b.centreFromMiddle && a.voxelSizeMetres == b.voxelSizeMetres;
}

bool same(const ViewHistory& a, const ViewHistory& b) {
    return a.basis == b.basis && a.snappedSteps == b.snappedSteps && a.halvings == b.halvings &&
           a.viewOfSet == b.viewOfSet;
}

// The whole sprite where most of it is on the screen: it then stays the same while it moves across
// the edge, and others show it too. Of a sprite seen close only what is on the screen.
LatticeView shownLattice(const LatticeView& whole, const LatticeView& visible) {
    constexpr int kLargestWhole = 4096;  // less than any driver's limit
    const auto area = [](glm::ivec2 size) { return std::int64_t{size.x} * size.y; };
    const bool small = whole.size.x <= kLargestWhole && whole.size.y <= kLargestWhole;
    return small && 2 * area(visible.size) >= area(whole.size) ? whole : visible;
}

// How many fragments a single pass casts for.
std::uint64_t fragmentCount(const SpriteView& view, glm::ivec2 visibleSize, const Camera& camera) {
    const double scale = view.metresPerPx / camera.metresPerScreenPx(view.planeDepthMetres);
    const double area = scale * scale * static_cast<double>(visibleSize.x) * visibleSize.y;
    const double screen = static_cast<double>(camera.viewportPx.x) * camera.viewportPx.y;
    return static_cast<std::uint64_t>(std::min(area, screen));
}

}  // namespace

Status SceneLook::update(const Scene& scene, const Camera& camera, const GameProfile& profile) {
    const bool sameView = valid_ && same(camera, camera_) && profile == profile_;
    changed_ = !sameView || records_.size() != scene.entities.size();
    valid_ = false;
    records_.resize(scene.entities.size());
    notePalettes(scene);
    if (Status done = work(scene, camera, profile, sameView); !done) return done;
    for (Record& record : records_) {
        changed_ = changed_ || record.fresh;
        if (record.fresh && record.seen) {
            record.sprite.key.litPalette = litOf(record.sprite, profile).number;
        }
    }
    if (changed_) {
        seen_.clear();
        for (const Record& record : records_) {
            if (record.seen) seen_.push_back(&record.sprite);
        }
    }
    camera_ = camera;
    profile_ = profile;
    valid_ = true;
    return {};
}

void SceneLook::notePalettes(const Scene& scene) {
    litPalettes_.beginFrame();
    contents_.clear();
    const Palette* last = nullptr;
    for (const SceneEntity& entity : scene.entities) {
        if (entity.palette == last) continue;
        last = entity.palette;
        std::uint64_t& content = contents_[last];
        if (content == 0) content = litPalettes_.contentOf(*last);
    }
}

Status SceneLook::work(const Scene& scene, const Camera& camera, const GameProfile& profile,
                       bool sameView) {
    std::mutex mutex;
    std::optional<int> failedAt;
    Status first;
    parallelFor(static_cast<int>(records_.size()), 0, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            Record& record = records_[static_cast<std::size_t>(k)];
            const SceneEntity& entity = scene.entities[static_cast<std::size_t>(k)];
            record.fresh = !(sameView && holds(record, entity));
            if (!record.fresh) continue;
            const Status done = look(record, entity, camera, profile);
            if (done) continue;
            // Of several failures the one that comes first in the scene, whoever finds it.
            const std::lock_guard lock(mutex);
            if (!failedAt || k < *failedAt) {
                failedAt = k;
                first = done;
            }
        }
    });
    return first;
}

SceneLook::Views SceneLook::viewsOf(const SceneEntity& entity) {
    if (entity.views == nullptr) return {};
    return {entity.views->name(), entity.views->roll};
}

bool SceneLook::holds(const Record& record, const SceneEntity& entity) const {
    const SceneEntity& before = record.sprite.entity;
    return before.representation == entity.representation && record.views == viewsOf(entity) &&
           before.octree == entity.octree && before.palette == entity.palette &&
           before.history == entity.history && record.octreeRevision == entity.octree->revision() &&
           record.paletteContent == contents_.at(entity.palette) &&
           same(before.placed, entity.placed) &&
           (entity.history == nullptr || same(record.history, *entity.history));
}

Status SceneLook::look(Record& record, const SceneEntity& entity, const Camera& camera,
                       const GameProfile& profile) {
    SeenSprite& sprite = record.sprite;
    sprite.entity = entity;
    record.octreeRevision = entity.octree->revision();
    record.paletteContent = contents_.at(entity.palette);
    record.views = viewsOf(entity);
    record.seen = false;
    if (entity.representation == Representation::clusters) return {};  // no sprite
    if (entity.octree->texture() == 0) return entity.octree->status();
    const bool snapshot = entity.representation == Representation::snapshot;
    const Result<SpriteViewResult> result =
        snapshot ? viewSnapshot(entity.placed, camera, profile, *entity.views, entity.history,
                                &lattices_)
                 : viewSprite(entity.placed, camera, profile, entity.history, &lattices_);
    if (!result) return tl::unexpected(result.error());
    if (entity.history != nullptr) record.history = *entity.history;
    if (!result->view) return {};
    const SpriteView& view = *result->view;
    const LatticeView visible = visibleLattice(view, camera);
    if (visible.size.x <= 0 || visible.size.y <= 0) return {};
    record.seen = true;
    sprite.key = {record.octreeRevision, 0, shownLattice(view.lattice, visible), 0};
    sprite.block = screenBlock(view, sprite.key.lattice, entity.placed, *entity.octree, camera);
    sprite.corners = screenCorners(view, sprite.key.lattice, camera);
    sprite.light8 = view.light8;
    sprite.narrow = castsNarrow(sprite.key.lattice, entity.octree->size());
    sprite.fragments = fragmentCount(view, visible.size, camera);
    sprite.sigmaInForce = view.sigmaInForce;
    sprite.screenPxPerPx = view.screenPxPerPx;
    return {};
}

std::vector<const GpuOctree*> SceneLook::octrees() const {
    std::vector<const GpuOctree*> all;
    all.reserve(seen_.size());
    for (const SeenSprite* sprite : seen_) all.push_back(sprite->entity.octree);
    std::ranges::sort(all);
    const auto repeated = std::ranges::unique(all);
    all.erase(repeated.begin(), repeated.end());
    return all;
}

}  // namespace voxprite
