#include "core/sheet/sheet_files.h"

#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/ending.h"
#include "core/base/file.h"
#include "core/io/apng.h"
#include "core/io/gif.h"
#include "core/io/neighbours.h"
#include "core/io/png.h"
#include "core/sheet/sheet_json.h"

namespace voxprite {
namespace {

std::vector<std::string_view> parts(std::string_view text, char between) {
    std::vector<std::string_view> found;
    while (true) {
        const std::size_t end = text.find(between);
        std::string_view part = text.substr(0, end);
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        found.push_back(part);
        if (end == std::string_view::npos) return found;
        text.remove_prefix(end + 1);
    }
}

template <class Number>
std::optional<Number> numberIn(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

Status addPng(std::vector<SheetFile>& files, const std::filesystem::path& path,
              const Image& image) {
    Result<Bytes> bytes = inFile(writePng(image), path.string());
    if (!bytes) return Failure(bytes.error());
    files.push_back({path, std::move(*bytes)});
    return {};
}

Status addTurntable(std::vector<SheetFile>& files, const Turntable& turntable, const Sheet& sheet,
                    const Document& document) {
    std::vector<AnimationFrame> frames;
    std::vector<Image> cells = cellsOf(sheet, sheet.pictures.front(), turntable.magnify);
    const bool moving = !document.clips.empty();
    for (std::size_t k = 0; k < cells.size(); ++k) {
        frames.push_back(
            {std::move(cells[k]), moving ? frameMilliseconds(document, sheet.sprites[k].frame)
                                         : turntable.milliseconds});
    }
    if (lowerEndingOf(turntable.path) == ".gif") {
        Result<GifImage> gif = inFile(writeGif(frames), turntable.path.string());
        if (!gif) return Failure(gif.error());
        files.push_back({turntable.path, std::move(gif->bytes), std::move(gif->loss), true});
        return {};
    }
    Result<Bytes> bytes = inFile(writeApng(frames), turntable.path.string());
    if (!bytes) return Failure(bytes.error());
    files.push_back({turntable.path, std::move(*bytes), std::nullopt, true});
    return {};
}

std::filesystem::path textOf(std::filesystem::path output) {
    return output.replace_extension(".json");
}

// Would one be written over another?
Status checkPaths(const std::vector<SheetFile>& files) {
    std::set<std::filesystem::path> paths;
    for (const SheetFile& file : files) {
        std::error_code unknown;
        const std::filesystem::path whole = std::filesystem::absolute(file.path, unknown);
        if (paths.insert(whole.lexically_normal()).second) continue;
        return fail("two files of the sheet would have the name " +
                    onOneLine(file.path.filename().string()) +
                    ": pictures are named after variants, and a turntable needs a name of its own");
    }
    return {};
}

// The text that lies there says what belongs to the sheet before this one, itself included.
Status keepNeighbours(std::span<const SheetFile> files) {
    const std::filesystem::path output = files.front().path;
    const Result<std::string> text = readTextFile(textOf(output));
    for (const SheetFile& file : files) {
        if (file.asked) continue;
        const bool isText = &file == &files.back();
        const std::string name = (isText ? output : file.path).filename().string();
        Status may = mayReplaceNeighbour(file.path, file.bytes, output, [&] {
            return text && sheetJsonNames(*text, output.filename().string(), name);
        });
        if (!may) return may;
    }
    return {};
}

}  // namespace

Result<std::vector<SheetFile>> sheetFiles(const Sheet& sheet, const Document& document,
                                          const GameProfile& profile, const SheetOptions& options,
                                          const std::filesystem::path& output,
                                          const std::optional<Turntable>& turntable) {
    std::vector<SheetFile> files;
    for (const SheetPicture& picture : sheet.pictures) {
        const Status added =
            addPng(files, pictureName(output.string(), picture.name), picture.image);
        if (!added) return Failure(added.error());
    }
    files.front().asked = true;
    if (turntable) {
        const Status added = addTurntable(files, *turntable, sheet, document);
        if (!added) return Failure(added.error());
    }
    const std::string text =
        sheetJson(sheet, document, profile, options, output.filename().string());
    files.push_back({textOf(output), Bytes(text.begin(), text.end())});
    if (Status apart = checkPaths(files); !apart) return Failure(apart.error());
    return files;
}

std::vector<std::filesystem::path> replacedBySheet(const Palette& palette,
                                                   const SheetOptions& options,
                                                   const std::filesystem::path& output,
                                                   const std::optional<Turntable>& turntable) {
    std::vector<std::filesystem::path> files;
    for (const std::string& picture : picturesOfSheet(palette, options)) {
        if (!picture.empty()) files.emplace_back(pictureName(output.string(), picture));
    }
    if (turntable) files.push_back(turntable->path);
    files.push_back(textOf(output));
    files.push_back(output);
    std::erase_if(files, [](const std::filesystem::path& file) {
        std::error_code unknown;
        return !std::filesystem::exists(file, unknown);
    });
    return files;
}

Status writeSheetFiles(std::span<const SheetFile> files, bool replaceNeighbours) {
    if (!files.empty() && !replaceNeighbours) {
        if (Status kept = keepNeighbours(files); !kept) return kept;
    }
    // The turntable may lie elsewhere; without it the old text would stand beside a new picture.
    for (const SheetFile& file : files) {
        if (Status may = checkWritable(file.path); !may) return may;
    }
    for (const SheetFile& file : files) {
        if (Status written = writeFileAtomically(file.path, file.bytes); !written) return written;
    }
    return {};
}

std::optional<std::vector<double>> numbersFromList(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view part : parts(text, ',')) {
        const std::optional<double> number = numberIn<double>(part);
        if (!number || !std::isfinite(*number)) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<std::vector<int>> framesFromList(std::string_view text) {
    std::vector<int> frames;
    for (const std::string_view part : parts(text, ',')) {
        const std::vector<std::string_view> ends = parts(part, '-');
        const std::optional<int> first = numberIn<int>(ends.front());
        const std::optional<int> last = numberIn<int>(ends.back());
        if (!first || !last || ends.size() > 2 || *last < *first || *last >= kMaxFrames) {
            return std::nullopt;
        }
        for (int frame = *first; frame <= *last; ++frame) frames.push_back(frame);
    }
    return frames;
}

}  // namespace voxprite
