// What the sprite specification's literal reading costs against ours, row by row of the decisions.
// Every figure is computed here and now, without a clock, and the same on every run; what is
// promised never comes from ours.
#pragma once

#include <string>
#include <vector>

namespace voxprite::conformance {

// Smaller is better in all of them.
struct Comparison {
    int row = 0;         // of the decisions, 1 ... 19
    std::string key;     // short and unique
    std::string what;    // is measured
    double literal = 0;  // the seed's reading
    double ours = 0;
    double promised = 0;  // what ours may be at most
    std::string unit;
    std::string how;  // on which subjects

    [[nodiscard]] bool held() const { return ours <= promised && literal > promised; }
};

[[nodiscard]] std::vector<Comparison> compareReadings();

using Comparisons = std::vector<Comparison>;
void comparePlace(Comparisons& all);      // rows 1, 2, 3, 5, 6, 14: where and how large it stands
void compareView(Comparisons& all);       // rows 4, 13: from which way it is seen
void comparePixels(Comparisons& all);     // rows 8, 9, 16: which voxel a pixel shows
void compareScreen(Comparisons& all);     // rows 7, 12, 15: what reaches the screen, and its cost
void compareDepth(Comparisons& all);      // rows 10, 11, 19: depth and large worlds
void compareClusters(Comparisons& all);   // row 17: which clusters stand for a surface
void compareSnapshots(Comparisons& all);  // row 18: how a model looks from its snapshots

}  // namespace voxprite::conformance
