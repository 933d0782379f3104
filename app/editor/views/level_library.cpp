#include "app/editor/views/level_library.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace voxprite::editor {
namespace {

// A model that changed is left alone for so long.
constexpr double kRestSeconds = 0.4;
// Measuring takes this much of a frame, and whatever its last step takes.
constexpr double kSliceSeconds = 0.008;
// Of more frames of a model no levels are kept.
constexpr int kMostFrames = 64;
// The editor has an artist waiting: fewer views than the command line looks from.
const MeasuringPlan kPlan{.sizesPx = {4, 8, 16, 32, 64, 128}, .views = 4, .seed = 1};

const RepresentationTable kNothingKnown;

}  // namespace

const LevelSource* LevelLibrary::sourceOf(const GpuOctree* octree) const {
    const auto found = std::ranges::find(sources_, octree, &LevelSource::octree);
    return found != sources_.end() ? &*found : nullptr;
}

const LevelLibrary::Levels* LevelLibrary::find(const LevelSource& source) const {
    const auto found = std::ranges::find_if(levels_, [&](const Levels& levels) {
        return levels.model == source.model && levels.frame == source.frame;
    });
    return found != levels_.end() ? &*found : nullptr;
}

const LevelLibrary::Table* LevelLibrary::tableFor(std::uint64_t model) const {
    const auto found = std::ranges::find(tables_, model, &Table::model);
    return found != tables_.end() ? &*found : nullptr;
}

const GpuModelLevels* LevelLibrary::levelsOf(const GpuOctree* octree) const {
    const LevelSource* source = sourceOf(octree);
    const Levels* levels = source != nullptr ? find(*source) : nullptr;
    return levels != nullptr && levels->built ? &*levels->built : nullptr;
}

const RepresentationTable& LevelLibrary::tableOf(const GpuOctree* octree) const {
    const LevelSource* source = sourceOf(octree);
    const Table* table = source != nullptr ? tableFor(source->model) : nullptr;
    return table != nullptr ? table->figures : kNothingKnown;
}

void LevelLibrary::follow(std::vector<LevelSource> sources, const RepresentationSettings& settings,
                          const GameProfile& profile, bool measured, double now) {
    const auto sameFrames = [](const LevelSource& a, const LevelSource& b) {
        return a.model == b.model && a.frame == b.frame && a.octree == b.octree;
    };
    // An animation that plays changes no model.
    if (!std::ranges::equal(sources, sources_, {}, &LevelSource::model, &LevelSource::model)) {
        changedAt_ = now;
    }
    if (!std::ranges::equal(sources, sources_, sameFrames)) ++revision_;
    const bool refilled = std::ranges::any_of(sources, [&](const LevelSource& source) {
        const LevelSource* before = sourceOf(source.octree);
        return before != nullptr && !sameFrames(*before, source);
    });
    if (refilled) refilledAt_ = now;
    sources_ = std::move(sources);
    still_ = now - changedAt_ >= kRestSeconds;
    measured_ = measured;
    const auto gone = [this](const auto& kept) {
        return std::ranges::find(sources_, kept.model, &LevelSource::model) == sources_.end();
    };
    std::erase_if(levels_, gone);
    std::erase_if(tables_, gone);
    const Terms terms{profile, settings.views, settings.clusterBudgetPx};
    if (terms != terms_) {
        if (terms.views != terms_.views) views_ = ViewSet::named(terms.views).value_or(ViewSet());
        terms_ = terms;
        tables_.clear();
        meter_.reset();
        ++revision_;
    }
    // What is measured has to stay what it is. The octree of a frame that is not followed now does.
    const LevelSource* measuredNow = sourceOf(measuredSource_.octree);
    if (meter_ && (!measured_ || gone(measuredSource_) ||
                   (measuredNow != nullptr && !sameFrames(*measuredNow, measuredSource_)))) {
        meter_.reset();
    }
    if (job_.finish()) ++revision_;
    if (still_) buildNext();
    if (still_ && measured_ && now - refilledAt_ >= kRestSeconds) measureNext();
}

void LevelLibrary::clear() {
    if (sources_.empty()) return;
    job_.cancel();
    meter_.reset();
    sources_.clear();
    levels_.clear();
    tables_.clear();
    ++revision_;
}

void LevelLibrary::buildNext() {
    if (job_.running()) return;
    for (const LevelSource& source : sources_) {
        if (find(source) != nullptr) continue;
        Result<Octree> octree = source.bake();
        if (!octree) {
            levels_.push_back({source.model, source.frame, std::nullopt});
            continue;
        }
        job_.start("Levels of detail",
                   [this, model = source.model, frame = source.frame,
                    octree = std::move(*octree)](JobProgress&) -> BackgroundJob::Done {
                       // One thread, so that the others are left to the views.
                       auto built =
                           std::make_shared<Result<ModelLevels>>(buildModelLevels(octree, 1));
                       return [this, model, frame, built] {
                           Levels& levels = levels_.emplace_back();
                           levels.model = model;
                           levels.frame = frame;
                           if (*built) levels.built.emplace(**built);
                           forgetOldest(model);
                       };
                   });
        return;
    }
}

void LevelLibrary::forgetOldest(std::uint64_t model) {
    if (std::ranges::count(levels_, model, &Levels::model) <= kMostFrames) return;
    const auto oldest = std::ranges::find_if(levels_, [&](const Levels& levels) {
        const bool measured =
            meter_ && measuredSource_.model == model && measuredSource_.frame == levels.frame;
        return levels.model == model && !measured;
    });
    levels_.erase(oldest);
}

void LevelLibrary::measureNext() {
    if (meter_) return;
    for (const LevelSource& source : sources_) {
        const Levels* levels = find(source);
        if (levels == nullptr || !levels->built || tableFor(source.model) != nullptr) continue;
        measuredSource_ = source;
        meter_.emplace(MeasuredModel{source.octree, source.palette, source.placed, &*levels->built,
                                     &views_, terms_.clusterBudgetPx},
                       terms_.profile, kPlan);
        return;
    }
}

void LevelLibrary::work(SceneRenderer& renderer) {
    if (!meter_) return;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(kSliceSeconds);
    Status measured;
    while (measured && !meter_->done() && Clock::now() < end) measured = meter_->step(renderer);
    if (measured && !meter_->done()) return;
    // What cannot be measured is known to be nothing, and is not tried again.
    tables_.push_back({measuredSource_.model, measured ? meter_->table() : RepresentationTable()});
    meter_.reset();
    ++revision_;
}

bool LevelLibrary::busy() const {
    if (job_.running() || meter_) return true;
    return std::ranges::any_of(sources_, [this](const LevelSource& source) {
        const Levels* levels = find(source);
        if (levels == nullptr) return true;
        return measured_ && levels->built && tableFor(source.model) == nullptr;
    });
}

std::string LevelLibrary::progress() const {
    if (meter_) {
        const int percent = static_cast<int>(std::floor(100.0 * meter_->share()));
        return "Measuring, " + std::to_string(percent) + " %";
    }
    return busy() ? "Building levels" : "";
}

}  // namespace voxprite::editor
