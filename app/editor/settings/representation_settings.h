// By what the scene draws its entities, and the comparison of what there is to choose from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "core/lod/representation.h"

namespace voxprite::editor {

enum class DrawRule : std::uint8_t {
    exact,      // the sprite, always
    automatic,  // the cheapest within the budget
    snapshot,
    clusters,
    coarse
};

inline constexpr double kLeastErrorBudget = 0.01, kMostErrorBudget = 0.6;
inline constexpr int kMostCoarserLevels = 3;
inline constexpr double kMostClusterBudgetPx = 16.0;
// The model's radius on the screen, in the comparison.
inline constexpr double kLeastComparedPx = 4.0, kMostComparedPx = 128.0;

struct RepresentationSettings {
    DrawRule rule = DrawRule::exact;
    double errorBudget = 0.35;
    int coarserLevels = 1;                // of what is drawn coarse by choice
    std::string views = "octahedral:16";  // of snapshots, see core/sprite/view_set.h
    double clusterBudgetPx = 1.0;         // 0 ... kMostClusterBudgetPx
    bool tint = false;                    // entities tell by their colour what was chosen
    bool compared = false;                // the sprite view shows them side by side
    double comparedSizePx = 24.0;         // from how far
    bool flying = false;                  // ... which changes by itself
    bool operator==(const RepresentationSettings&) const = default;

    [[nodiscard]] std::optional<RepresentationChoice> forced() const {
        switch (rule) {
            case DrawRule::automatic:
                return std::nullopt;
            case DrawRule::exact:
                return RepresentationChoice{Representation::sprite, 0};
            case DrawRule::snapshot:
                return RepresentationChoice{Representation::snapshot, 0};
            case DrawRule::clusters:
                return RepresentationChoice{Representation::clusters, 0};
            case DrawRule::coarse:
                return RepresentationChoice{Representation::coarse, coarserLevels};
        }
        return std::nullopt;
    }
    [[nodiscard]] ChoiceRules rules() const {
        return {.errorBudget = errorBudget, .forced = forced()};
    }
};

}  // namespace voxprite::editor
