// A sheet as the files that it is written as: its pictures, the text beside them, and a turntable.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/sheet/sheet.h"

namespace voxprite {

// An animated picture of all sprites in turn: of a still model it turns.
struct Turntable {
    std::filesystem::path path;  // a GIF where it ends in .gif, else a PNG, which loses nothing
    int milliseconds = 80;       // a view, where no clip says how long a frame lasts
    int magnify = 4;             // pixels a virtual pixel
};

// A file that is written when all of them are made.
struct SheetFile {
    std::filesystem::path path;
    Bytes bytes;
    std::optional<std::string> loss{};  // what of the pictures is not in it, a sentence
    // Was it named by whoever wants the sheet: that of the sprites, and the turntable? The others
    // lie beside it.
    bool asked = false;
};

// `output`, which ends in .png, is the sprites' picture; the others and the text are named after
// it. Fails when a picture cannot be encoded, and where two files would have one path.
[[nodiscard]] Result<std::vector<SheetFile>> sheetFiles(
    const Sheet& sheet, const Document& document, const GameProfile& profile,
    const SheetOptions& options, const std::filesystem::path& output,
    const std::optional<Turntable>& turntable = {});
// The files that these would replace, `output` last: what a person has to agree to.
[[nodiscard]] std::vector<std::filesystem::path> replacedBySheet(
    const Palette& palette, const SheetOptions& options, const std::filesystem::path& output,
    const std::optional<Turntable>& turntable = {});
// Each atomically, in order; ends at the first that fails. Nothing is written where one of them
// surely could not be. What sheetFiles() made: of the files that were not asked for, those there
// belong to an earlier sheet where its text refers to them. Another's are kept, and nothing is
// written, unless `replaceNeighbours`.
[[nodiscard]] Status writeSheetFiles(std::span<const SheetFile> files,
                                     bool replaceNeighbours = false);

// --- options as an artist types them
// "30, 60"
[[nodiscard]] std::optional<std::vector<double>> numbersFromList(std::string_view text);
// "0,2,5-9"
[[nodiscard]] std::optional<std::vector<int>> framesFromList(std::string_view text);

}  // namespace voxprite
