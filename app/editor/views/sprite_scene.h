// The game scene of the sprite view: the edited entity with the copies around it, over ground and
// sky.
#pragma once

#include <span>
#include <vector>

#include "app/editor/session/extra_models.h"
#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "app/editor/views/level_library.h"
#include "app/editor/views/scene_copies.h"
#include "render/scene_renderer.h"

namespace voxprite::editor {

class SpriteScene {
  public:
    // Brings formation and extra models up to date. Returns what could not be loaded.
    [[nodiscard]] std::vector<Error> follow(const Session& session, const SceneSettings& settings);
    // The march goes on, and so do the animations of extra models.
    void advance(double seconds, const Session& session, const SceneSettings& settings);
    // Would advance() change the picture?
    [[nodiscard]] bool moves(const SceneSettings& settings) const;

    [[nodiscard]] std::size_t entityCount() const { return 1 + formation_.copies.size(); }
    // Rises with every change that follow() and advance() make to the picture.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    // Rises when other entities may stand there: what was known of one by its place is void.
    [[nodiscard]] std::uint64_t arrangement() const { return arrangement_; }
    // From the edited model's anchor to the outermost copy's far side; 0 without copies.
    [[nodiscard]] double radiusMetres() const { return formation_.radiusMetres; }

    // The entities, the edited one first, as `profile` places them; `histories`, one each, outlive
    // the scene, which is good until the next one is made. `edited` holds the octree that the
    // session shows.
    [[nodiscard]] Scene make(const Session& session, const GpuOctree& edited,
                             const ViewSettings& view, const GameProfile& profile,
                             std::span<ViewHistory> histories);

    // The models of that scene that have voxels, for what they can be drawn by. `session` and
    // `edited` are read as long as the sources are used.
    [[nodiscard]] std::vector<LevelSource> levelSources(const Session& session,
                                                        const GpuOctree& edited) const;

  private:
    [[nodiscard]] bool walks(const SceneSettings& settings) const {
        return formation_.loopMetres > 0.0 && settings.pace > 0.0;
    }
    [[nodiscard]] std::vector<const GpuOctree*> extraFrames() const;

    ExtraModels extras_;
    std::uint64_t extrasRevision_ = 0;
    std::vector<const ExtraModel*> subjects_;  // after the edited one, which is null
    Formation formation_;
    CopySettings arrangedFor_;
    std::vector<CopySubject> arrangedSubjects_;
    std::vector<PlacedEntity> shadows_;  // of the scene made last
    double walkedMetres_ = 0.0;
    double seconds_ = 0.0;
    std::uint64_t revision_ = 0;
    std::uint64_t arrangement_ = 0;
};

}  // namespace voxprite::editor
