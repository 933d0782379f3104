// What a model can be drawn by beside its exact sprite, and what that is worth: error and cost by
// size on the screen, drawn and measured on OpenGL (render/measure_representations.h).
#pragma once

#include <string>
#include <vector>

#include "app/cli/conformance/temporal.h"
#include "core/base/result.h"
#include "core/lod/representation.h"

namespace voxprite::conformance {

// One representation of one model, with the views that snapshots are taken from.
struct RepresentationRow {
    std::string model;
    std::string name;  // "snapshot, 26 views"
    RepresentationFigures figures;
};

// Of each model what there is, the exact sprite first. Fails without OpenGL.
[[nodiscard]] Result<std::vector<RepresentationRow>> measureRepresentationRows(
    const std::vector<TurningModel>& models, const std::vector<double>& sizesPx, int views);

}  // namespace voxprite::conformance
