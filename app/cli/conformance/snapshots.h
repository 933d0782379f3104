// Snapshots against the exact sprite: how unlike they look, by their set of views and by distance,
// what they hold and how long they take to make. Only the milliseconds depend on the machine.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/cli/conformance/temporal.h"

namespace voxprite::conformance {

// Screen pixels a virtual pixel: near, middle and far.
inline constexpr std::array<double, 3> kSnapshotDistances{2.0, 1.0, 0.5};

struct SnapshotFigures {
    std::string kind;  // "sprite", "seed", "seed, blended"
    std::string set;
    int views = 0;
    double meanDegreesOff = 0.0;  // over the directions that were looked from
    // At each distance, against the exact sprite.
    struct Unlike {
        double flip = 0.0;        // inside, see core/measure/compare.h
        double silhouette = 0.0;  // %: pixels shown by one alone, of those shown by either
        double voxels = 0.0;  // %: pixels of another voxel, or none, of those that either shows;
                              // a blend has no voxels
    };
    std::array<Unlike, kSnapshotDistances.size()> unlike{};
    double bytes = 0.0;         // of all views of a model, on average over the models
    double milliseconds = 0.0;  // to cast all of them, from a part
};

// Seen from the same random directions, between 10 degrees below the horizon and straight above.
[[nodiscard]] std::vector<SnapshotFigures> measureSnapshots(
    const std::vector<TurningModel>& models);

}  // namespace voxprite::conformance
