// Many entities of a few models on a field: what benchCrowds draws.
#pragma once

#include <vector>

#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/placed_entity.h"
#include "core/svo/octree.h"

namespace voxprite::bench {

inline constexpr int kCrowdModels = 16;

// People: legs, a body, arms and a head; no two of the same build.
[[nodiscard]] Result<std::vector<Octree>> crowdModels();

struct CrowdMember {
    int model = 0;
    PlacedEntity placed;
};

// In rows on a square field about the origin, each turned by a multiple of 45 degrees.
[[nodiscard]] std::vector<CrowdMember> crowd(const std::vector<Octree>& models, int entities,
                                             const GameProfile& profile);
[[nodiscard]] double crowdExtentMetres(int entities);

}  // namespace voxprite::bench
