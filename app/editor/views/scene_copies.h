// Where the copies around the edited model stand: a pure function of a few numbers.
//
// The formation's own axes, in metres from the edited model's anchor: `across` toward that model's
// +X side, `ahead` the way it faces (its -Y side).
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "app/editor/settings/scene_settings.h"
#include "core/sprite/placed_entity.h"

namespace voxprite::editor {

// A model that can be copied: how far it reaches from its anchor along the ground, whichever way it
// is turned.
struct CopySubject {
    double reachMetres = 1.0;
    bool used = true;
    bool operator==(const CopySubject&) const = default;
};

struct SceneCopy {
    int subject = 0;  // index into the subjects
    double acrossMetres = 0.0;
    double aheadMetres = 0.0;
    double turnDegrees = 0.0;
};

struct Formation {
    std::vector<SceneCopy> copies;
    // March: whoever walks out at the front comes in again at the back, this far behind; else 0.
    double loopMetres = 0.0;
    // From the edited model's anchor to the outermost anchor, plus the reach of what stands there.
    double radiusMetres = 0.0;
};

// subjects[0] is the edited model, which stands in the middle whether it is used or not; nothing
// comes nearer to it, or to another copy, than both reach. Deterministic; empty without a subject
// that is used.
[[nodiscard]] Formation arrangeCopies(const CopySettings& settings,
                                      std::span<const CopySubject> subjects);

// The copy after the march went on by `walkedMetres`.
[[nodiscard]] SceneCopy walked(const SceneCopy& copy, const Formation& formation,
                               double walkedMetres);

// `subject` standing where `copy` says. It comes as it would stand in the edited model's place,
// faced as that one is: turned by `facingDegrees` about the world's up axis.
[[nodiscard]] PlacedEntity standing(const PlacedEntity& subject, const SceneCopy& copy,
                                    double facingDegrees);

// How far a model reaches from its anchor along the ground.
[[nodiscard]] double reachMetres(const PlacedEntity& placed);

}  // namespace voxprite::editor
