// The sprite over time: how many pixels change while the camera turns slowly, with views snapped to
// a step and without. No clock enters a figure.
#pragma once

#include <string>
#include <vector>

#include "core/model/palette.h"
#include "core/svo/octree.h"

namespace voxprite::conformance {

struct TurningModel {
    std::string name;
    Octree octree;
    Palette palette;
};

// What a camera sees that goes round a model by kTurnPerFrameDegrees a frame: at 60 frames a second
// six degrees a second. Shares are of the sprite's opaque pixels; colours are compared.
inline constexpr double kTurnPerFrameDegrees = 0.1;
struct TurnFigures {
    double stepDegrees = 0.0;       // 0: not snapped
    double framesChanged = 0.0;     // %: of all frames, those unlike the one before
    double changedAFrame = 0.0;     // %: of the pixels, in such a frame
    double changedADegree = 0.0;    // %: of the pixels, summed over the frames of a degree
    double offTheExact = 0.0;       // %: of the pixels, against the view that is not snapped
    double changedByTremble = 0.0;  // %: frames changed while the camera trembles by 1e-3 rad
};

// For each step, over all models, three ways of turning each.
[[nodiscard]] std::vector<TurnFigures> measureTurns(const std::vector<TurningModel>& models,
                                                    const std::vector<double>& stepsDegrees);

// Models made in code, for where no files are given.
[[nodiscard]] std::vector<TurningModel> turningSubjects();

}  // namespace voxprite::conformance
