// By what an entity is drawn, and how that is chosen: the cheapest of what was measured to differ
// from the exact sprite by no more than the artist allows.
//
// Size        radius of the sphere around the model's box, in screen pixels at the depth of its
//             centre (representationSizePx of render/scene_choice.h).
// Error       mean FLIP error (core/measure/flip.h) over the pixels that the model covers in either
//             picture; 0 equal ... 1. It is what a viewer sees who flips between the two: a pixel
//             that is a shade off counts little, a hole or a lost outline much, and empty ground
//             around a small model makes nothing better.
// Cost        microseconds an entity and frame while the camera moves. What is kept from frame to
//             frame (snapshots, meshes) costs only its drawing.
//
// Everything here is a pure function; what was chosen before comes from the caller.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace voxprite {

enum class Representation : std::uint8_t {
    sprite,    // exact: cast for the very view that the camera has
    snapshot,  // the sprite of the nearest of a set of views
    clusters,  // the mesh, as fine as its size on the screen asks for
    coarse     // the sprite of a coarser octree
};
inline constexpr int kRepresentations = 4;

struct RepresentationChoice {
    Representation kind = Representation::sprite;
    int levels = 0;  // coarse: how many levels of the octree are left out, 1 ...; else 0
    bool operator==(const RepresentationChoice&) const = default;
};

// What was measured of one representation of one model.
struct RepresentationFigures {
    struct AtSize {
        double sizePx = 0.0;
        double error = 0.0;
        double microseconds = 0.0;
    };
    RepresentationChoice choice;
    std::vector<AtSize> bySize;  // sizes ascend
};

// Of all that a model can be drawn by. Empty: nothing is known, and the sprite is what is drawn.
using RepresentationTable = std::vector<RepresentationFigures>;

// Never less than what was measured on either side of the size; infinite beyond the largest size
// that was measured, for a size that is none, and where nothing was measured. Below the smallest
// size the figure of the smallest holds. The exact sprite has no error at any size.
[[nodiscard]] double errorAt(const RepresentationFigures& figures, double sizePx);
// Linear in the logarithm of the size between two figures, constant beyond the first and the last;
// infinite where nothing was measured.
[[nodiscard]] double microsecondsAt(const RepresentationFigures& figures, double sizePx);
// Null when there is none.
[[nodiscard]] const RepresentationFigures* figuresOf(const RepresentationTable& table,
                                                     RepresentationChoice choice);

struct ChoiceRules {
    double errorBudget = 0.2;  // 0 ... 1; what is no number allows nothing but the sprite
    // Hysteresis: something else is taken up only if it stays within the budget for sizes up to
    // this share smaller and larger, and is cheaper by this share.
    double band = 0.15;
    std::optional<RepresentationChoice> forced{};  // drawn whatever the figures say
};

// The cheapest representation whose error at this size is within the budget; of equally cheap ones
// that with the least error. `previous` is kept while it is within the budget and nothing is
// clearly better, so that a size which trembles changes nothing. Unless it is forced, the result is
// within the budget by the table, always: the sprite is when nothing else is.
[[nodiscard]] RepresentationChoice choose(const RepresentationTable& table, double sizePx,
                                          const ChoiceRules& rules,
                                          std::optional<RepresentationChoice> previous);

}  // namespace voxprite
