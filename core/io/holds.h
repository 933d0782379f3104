// What a file format has words for, and what that means for one document: everything else is left
// out on writing, and said before.
#pragma once

#include <string>
#include <vector>

#include "core/model/document.h"

namespace voxprite {

// How much of a document's scene a format keeps.
enum class SceneHeld : std::uint8_t {
    merged,   // one body of voxels: what is seen
    objects,  // what is seen, object by object with its name, each turned as it stands
    seen,     // what is seen, in its groups, with its placements and shared models
    all       // groups, hidden objects, shared models, layers, placements, attributes, ...
};

enum class ColoursHeld : std::uint8_t {
    none,     // indices alone
    byValue,  // the colour of each voxel; indices are handed out anew on reading
    palette   // indices, and the colour of every one
};

// Canvases, which bind nothing, and ids of render settings are nobody's promise and not counted
// here.
struct Holds {
    SceneHeld scene = SceneHeld::merged;
    bool frames = false;  // else the first alone
    bool clips = false;
    bool sockets = false;
    bool entityName = false;
    bool anchor = false;
    bool pose = false;         // the entity's rotation, scale and place
    bool authored = false;     // VoxelSize and sigma
    bool coordinates = false;  // where the voxels lie; else they begin at the origin
    ColoursHeld colours = ColoursHeld::byValue;
    bool alpha = false;
    bool colourNames = false;
    bool materials = false;
    bool displayOrder = false;
    bool ramps = false;
    bool variants = false;

    [[nodiscard]] static constexpr Holds everything() {
        return {SceneHeld::all,       true, true, true, true, true, true, true, true,
                ColoursHeld::palette, true, true, true, true, true, true};
    }
};

// One sentence for each thing that the document has and the format has not; `ending` (".qb") names
// the format.
[[nodiscard]] std::vector<std::string> lossesBy(const Holds& holds, const Document& document,
                                                const std::string& ending);

}  // namespace voxprite
