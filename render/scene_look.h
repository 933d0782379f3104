// Which sprites a scene shows to a camera, and how each stands on the screen. What was worked out
// for an entity is remembered: while it, the camera and the profile stay as they are nothing is
// worked out again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/sprite/lattice_memo.h"
#include "core/sprite/sprite_key.h"
#include "core/sprite/view_set.h"
#include "render/scene_renderer.h"
#include "render/sprite_blocks.h"

namespace voxprite {

// An entity's sprite.
struct SeenSprite {
    SceneEntity entity;
    SpriteKey key;      // what is cast: the part of the lattice that is shown
    SpriteBlock block;  // all but the places of octree, palette and atlas
    SpriteCorners corners{};
    FaceLights light8;
    bool narrow = true;           // see castsNarrow
    std::uint64_t fragments = 0;  // the screen pixels of the sprite's rectangle
    double sigmaInForce = 0.0;
    double screenPxPerPx = 0.0;
};

class SceneLook {
  public:
    // Looks at the scene, on all cores.
    [[nodiscard]] Status update(const Scene& scene, const Camera& camera,
                                const GameProfile& profile);

    // Is there anything to see that the update before did not see just so?
    [[nodiscard]] bool changed() const { return changed_; }
    // In the order of the scene, until the next update.
    [[nodiscard]] const std::vector<const SeenSprite*>& seen() const { return seen_; }
    [[nodiscard]] int unseen() const { return static_cast<int>(records_.size() - seen_.size()); }
    // The octrees of what is seen, each once.
    [[nodiscard]] std::vector<const GpuOctree*> octrees() const;
    [[nodiscard]] LitPalettes::Numbered litOf(const SeenSprite& sprite,
                                              const GameProfile& profile) {
        return litPalettes_.of(*sprite.entity.palette, sprite.light8, profile.outline,
                               profile.shading);
    }

  private:
    // The set of views that snapshots are snapped to: what it holds, wherever it lies.
    struct Views {
        std::string name;
        SnapshotRoll roll{};
        bool operator==(const Views&) const = default;
    };
    // An entity, and what was worked out for it.
    struct Record {
        std::uint64_t octreeRevision = 0;
        std::uint64_t paletteContent = 0;
        Views views;
        ViewHistory history;  // as it was left
        bool fresh = false;   // worked out by this update
        bool seen = false;
        SeenSprite sprite;
    };
    void notePalettes(const Scene& scene);
    [[nodiscard]] Status work(const Scene& scene, const Camera& camera, const GameProfile& profile,
                              bool sameView);
    [[nodiscard]] static Views viewsOf(const SceneEntity& entity);
    [[nodiscard]] bool holds(const Record& record, const SceneEntity& entity) const;
    [[nodiscard]] Status look(Record& record, const SceneEntity& entity, const Camera& camera,
                              const GameProfile& profile);

    LatticeMemo lattices_;
    LitPalettes litPalettes_;
    std::unordered_map<const Palette*, std::uint64_t> contents_;  // of this update
    std::vector<Record> records_;                                 // by place in the scene
    std::vector<const SeenSprite*> seen_;
    Camera camera_;
    GameProfile profile_;
    bool valid_ = false;  // the records are those of camera_ and profile_
    bool changed_ = true;
};

}  // namespace voxprite
