// The text beside a sheet's picture, in the layout that Aseprite writes (array form), which most
// engines read: frames with their rectangles, trim offsets and durations, tags for the animations,
// a slice whose pivot is the anchor. What that layout has no place for stands under "voxprite".
//
// As engines want it: a frame's "filename" is its number (Phaser looks for that), a tag is called
// "clip_yaw45" (Godot and Unity make resources and files of it), "_pitch30" at its end where there
// are several pitches, and "repeat" is "1" where the clip does not loop. Of clips that share frames
// the first says how long these show; "voxprite" has the durations of each.
#pragma once

#include <string>

#include "core/sheet/sheet.h"

namespace voxprite {

// `imageName` is the file of the sheet's first picture as the text shall name it; the others are
// named after it, see pictureName.
[[nodiscard]] std::string sheetJson(const Sheet& sheet, const Document& document,
                                    const GameProfile& profile, const SheetOptions& options,
                                    const std::string& imageName);

// Is this such a text of a sheet whose first picture is `imageName`, and does it name `picture` (a
// file's name, as that one is) among its pictures?
[[nodiscard]] bool sheetJsonNames(const std::string& text, const std::string& imageName,
                                  const std::string& picture);

// "knight.png" and "normals" make "knight.normals.png", in the same folder.
[[nodiscard]] std::string pictureName(const std::string& imageName, const std::string& picture);

// How long a frame of the document shows: as the first clip says that has it, else at the rate of a
// new clip.
[[nodiscard]] int frameMilliseconds(const Document& document, int frame);

}  // namespace voxprite
