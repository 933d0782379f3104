// Sprite sheets: an entity from many directions, in many frames, in one picture, for engines that
// draw finished sprites. Every sprite is the very buffer that the game's caster makes (`voxprite
// render --ortho` with the same angles), cut to what is opaque and packed.
//
// Cell space   pixels from the left and top of a cell that holds every sprite of the sheet. The
//              anchor lies in the same pixel of the cell in all of them, so that nothing slides.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite {

struct SheetOptions {
    int directions = 8;                                // 1 ... 360, evenly round the model
    double firstYawDegrees = 0.0;                      // of direction 0; the next has a greater yaw
    std::vector<double> pitchesDegrees{30.0};          // -90 ... 90, at least one
    std::optional<std::vector<int>> frames;            // of the document; none given: all
    std::optional<std::vector<std::string>> variants;  // of the palette, by name; none given: all
    bool trim = true;                                  // else every sprite is a whole cell
    int paddingPx = 1;                                 // 0 ... 64, transparent, between sprites
    int largestEdgePx = 8192;
    // More pictures of the same layout:
    bool normals = false;  // of the faces, toward (right, up, the eye), 0 ... 255 for -1 ... 1
    bool depths = false;   // grey, 255 nearest: see Sheet::depthRangeMetres
    bool indices = false;  // grey: the palette index; the outline 0
};

struct SheetSocket {
    std::string name;
    glm::dvec2 px{0.0};    // cell space, continuous; may lie outside the cell
    bool visible = false;  // nothing stands before it
};

struct SheetSprite {
    int direction = 0;
    double yawDegrees = 0.0;
    double pitchDegrees = 0.0;
    int frame = 0;             // of the document
    glm::ivec2 at{0};          // its left and top in the sheet; equal sprites share a place
    glm::ivec2 size{1};        // of what is kept; one transparent pixel where nothing is seen
    glm::ivec2 inCell{0};      // where that lies in the cell
    glm::dvec2 anchorPx{0.0};  // cell space, continuous: floor(anchorPx + 1/4) is anchorPixel
    std::vector<SheetSocket> sockets;
};

struct SheetPicture {
    std::string name;  // "" the sprites; "variant-NAME", "normals", "depths", "indices"
    Image image;
};

struct Sheet {
    // By pitch, then direction, then frame: the frames of one view stand together.
    std::vector<SheetSprite> sprites;
    std::vector<SheetPicture> pictures;  // the first is that of the sprites
    glm::ivec2 cellPx{0};
    glm::ivec2 anchorPixel{0};      // of the cell; the same in all sprites
    double metresPerPx = 0.025;     // width of a virtual pixel
    double depthRangeMetres = 0.0;  // grey 255 is so far before the model's centre, 0 behind it
};

// The names of the pictures that a sheet in this palette would have, in order; variants that there
// are not are among them.
[[nodiscard]] std::vector<std::string> picturesOfSheet(const Palette& palette,
                                                       const SheetOptions& options);

// Of sprites; one call at a time, on any thread.
using SheetProgress = std::function<void(int done, int all)>;

// Casts, cuts and packs, on all cores; a pure function of its arguments. The profile's minification
// and view step do not count: a sheet has the sigma and the directions that were asked for. Fails
// when an option is out of range (the message names it), there is nothing to see, or the sprites do
// not fit largestEdgePx; asked to stop, it fails.
[[nodiscard]] Result<Sheet> makeSheet(const Document& document, const GameProfile& profile,
                                      const SheetOptions& options,
                                      const SheetProgress& progress = {},
                                      std::stop_token stop = {});

// One of the pictures taken apart again: every sprite on a whole cell, `magnified` times.
[[nodiscard]] std::vector<Image> cellsOf(const Sheet& sheet, const SheetPicture& picture,
                                         int magnified = 1);

}  // namespace voxprite
