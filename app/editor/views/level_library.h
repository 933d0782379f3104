// What the models of the scene can be drawn by beside their exact sprites, and what that is worth:
// coarser octrees and clusters are built on a thread of their own, errors and costs are measured
// between frames, a little at a time.
//
// Nothing is built of a model that is being edited: a moment after the last change.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/session/background_job.h"
#include "app/editor/settings/representation_settings.h"
#include "core/model/game_profile.h"
#include "render/measure_representations.h"

namespace voxprite::editor {

// One frame of a model of the scene.
struct LevelSource {
    std::uint64_t model = 0;  // never the same for two models, or two states of one
    int frame = 0;
    // There as long as any frame of the model is followed. One octree may hold one frame after the
    // other.
    const GpuOctree* octree = nullptr;
    const Palette* palette = nullptr;
    PlacedEntity placed;
    std::function<Result<Octree>()> bake;  // what the levels are made from
};

class LevelLibrary {
  public:
    // Looks after these models, on the window's thread and with its GL context; forgets all others.
    // `measured`: figures are wanted, too. `now` in seconds.
    void follow(std::vector<LevelSource> sources, const RepresentationSettings& settings,
                const GameProfile& profile, bool measured, double now);
    // Measures for a moment, if there is something to measure.
    void work(SceneRenderer& renderer);
    // Follows nothing: all is forgotten.
    void clear();

    // Null until they are built. Valid until the next follow().
    [[nodiscard]] const GpuModelLevels* levelsOf(const GpuOctree* octree) const;
    // Empty until all is measured. One table stands for all frames of a model.
    [[nodiscard]] const RepresentationTable& tableOf(const GpuOctree* octree) const;
    [[nodiscard]] const ViewSet& views() const { return views_; }

    [[nodiscard]] bool busy() const;
    // What is going on: "Measuring knight, 40 %"; empty when nothing is.
    [[nodiscard]] std::string progress() const;
    // Rises with everything that changes what levelsOf() and tableOf() say.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

  private:
    struct Levels {
        std::uint64_t model = 0;
        int frame = 0;
        std::optional<GpuModelLevels> built;  // nothing: could not be
    };
    // What a table depends on.
    struct Terms {
        GameProfile profile;
        std::string views;
        double clusterBudgetPx = 1.0;
        bool operator==(const Terms&) const = default;
    };
    struct Table {
        std::uint64_t model = 0;
        RepresentationTable figures;
    };
    [[nodiscard]] const LevelSource* sourceOf(const GpuOctree* octree) const;
    [[nodiscard]] const Levels* find(const LevelSource& source) const;
    [[nodiscard]] const Table* tableFor(std::uint64_t model) const;
    void buildNext();
    void forgetOldest(std::uint64_t model);
    void measureNext();

    std::vector<LevelSource> sources_;
    std::list<Levels> levels_;
    std::list<Table> tables_;
    Terms terms_;
    ViewSet views_;
    double changedAt_ = 0.0;   // when the models were last others than before
    double refilledAt_ = 0.0;  // when an octree last held another frame than before
    bool still_ = false;
    bool measured_ = false;
    std::optional<RepresentationMeter> meter_;
    LevelSource measuredSource_;
    std::uint64_t revision_ = 0;
    BackgroundJob job_;  // last: what it uses goes after it
};

}  // namespace voxprite::editor
