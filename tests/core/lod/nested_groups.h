// Random clusters as a simplifier could make them, and what is true of a cut through them. The
// groups form a tree; a region of the surface is a way from a finest cluster up to the root.
#pragma once

#include <span>
#include <vector>

#include "core/lod/cluster_page.h"
#include "tests/support/random.h"

namespace voxprite::test {

struct NestedGroups {
    std::vector<ClusterPage> pages;
    // The pages of each way, finest first: neighbours replace each other.
    std::vector<std::vector<std::uint32_t>> regions;
};

// Up to `levels` of groups in each other, spheres and errors drawn at random within what
// validateClusters allows: errors just double or grow a thousandfold, spheres touch from within or
// are tiny, children lie off the middle.
[[nodiscard]] NestedGroups randomGroups(Random& random, int levels);

// Seed 003's example: four clusters of 10 triangles become two of 12, then one of 8; all errors are
// seen near one sphere of radius 1.
[[nodiscard]] std::vector<ClusterPage> threeLevels();

struct Coverage {
    int holes = 0;     // regions that no cluster of the cut stands for
    int overlaps = 0;  // regions that several stand for
};
[[nodiscard]] Coverage coverage(const NestedGroups& groups, std::span<const std::uint32_t> cut);

}  // namespace voxprite::test
