// What the artist set for the tools: the options bar edits these, tools read them.
#pragma once

#include "core/base/box.h"
#include "core/edit/brush.h"
#include "core/edit/regions.h"
#include "core/edit/symmetry.h"

namespace voxprite::editor {

struct ToolOptions {
    TipShape tip = TipShape::cube;
    int tipEdge = 1;      // 1 ... kMaxTipEdge
    bool hollow = false;  // shapes: the wall alone
    // What belongs together, for fills, faces and the magic wand.
    Neighbours neighbours = Neighbours::six;
    bool sameColour = true;

    // Entity space, as the view shows it. The planes go to the model's middle when the first axis
    // is switched on, until they have been placed.
    Symmetry symmetry;
    bool symmetryPlaced = false;
    // Edits reach no further than this box, entity space.
    bool limited = false;
    IBox limits;
    // Paint and erase what is selected alone, while something is.
    bool insideSelection = false;
    // Selecting on screen takes what is in sight, and not what lies behind it.
    bool inSight = false;

    [[nodiscard]] RegionRule region() const { return {neighbours, sameColour}; }
    bool operator==(const ToolOptions&) const = default;
};

}  // namespace voxprite::editor
