// Lists of colours as other programs keep them, by the file's ending.
//
// .gpl  GIMP palettes (also Krita, Inkscape, Aseprite): "GIMP Palette", lines "Name: ..." and
//       "Columns: ...", comments from '#', then "red green blue  name" a line; after Aseprite's
//       "Channels: RGBA" a fourth number, alpha, is read over.
// .pal  JASC palettes (Paint Shop Pro, Aseprite, lospec): "JASC-PAL", "0100", the count, then
//       "red green blue" a line; a fourth number, alpha, is read over.
// .png  a pixel a colour, row by row. Written 256 x 1, the last pixel transparent, as MagicaVoxel
//       has it. Read: of up to 256 pixels each is a colour (but the 256th, which has no place), a
//       transparent one a vacant place, and so is each of squares side by side, drawn large
//       (lospec's 8x and 32x); of a larger picture of another kind every different opaque colour
//       once, in the order of reading, 255 at most.
//
// Text may end its lines either way and is taken byte by byte; errors name the line, and in a
// picture the byte.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/palette.h"

namespace voxprite {

[[nodiscard]] Result<ColourList> readGimpPalette(std::string_view text);
[[nodiscard]] std::string writeGimpPalette(const ColourList& colours, const std::string& name);
[[nodiscard]] Result<ColourList> readJascPalette(std::string_view text);
[[nodiscard]] std::string writeJascPalette(const ColourList& colours);
[[nodiscard]] Result<ColourList> readPalettePicture(ByteView png);
[[nodiscard]] Result<Bytes> writePalettePicture(const ColourList& colours);

// By the ending: .gpl, .pal or .png, which may be a model, too.
[[nodiscard]] bool isFileOfColours(const std::filesystem::path& path);
[[nodiscard]] Result<ColourList> loadColours(const std::filesystem::path& path);
// Text files have no vacant places: those are left out there.
[[nodiscard]] Status saveColours(const std::filesystem::path& path, const ColourList& colours);

}  // namespace voxprite
