// Which files are a stack of layers: by their names alone.
#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <system_error>

#include "core/base/ending.h"
#include "core/io/slice_names.h"
#include "core/io/slices.h"

namespace voxprite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSurelyNumbered = 3;  // digits

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

struct Series {
    std::map<int, fs::path> files;  // by number
    Status numbersDiffer{};         // fails where two of the pictures have one number
};

// The numbered pictures of a folder, by what their names begin with.
Result<std::map<std::string, Series>> seriesIn(const fs::path& folder, bool all) {
    std::map<std::string, Series> series;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        if (lowerEndingOf(it->path()) != ".png") continue;
        const std::optional<SliceName> name = sliceNameOf(it->path());
        if (!name && all) {
            return failInFile(it->path().string(),
                              "is no numbered layer like the folder's others should be");
        }
        if (!name) continue;
        Series& its = series[name->beginning];
        const auto [place, isNew] = its.files.try_emplace(name->number, it->path());
        if (!isNew) {
            its.numbersDiffer = failInFile(
                it->path().string(), "has the same number as " + place->second.filename().string());
        }
    }
    if (error) return failInFile(folder.string(), "cannot be listed: " + error.message());
    return series;
}

Result<SliceFiles> stackOf(const std::string& beginning, const Series& series) {
    if (!series.numbersDiffer) return Failure(series.numbersDiffer.error());
    SliceFiles stack;
    int next = series.files.begin()->first;
    for (const auto& [number, file] : series.files) {
        if (number != next) {
            return failInFile(file.string(), "the layer before it is missing, number " +
                                                 std::to_string(number - 1) + " of " + beginning);
        }
        stack.files.push_back(file);
        ++next;
    }
    if (stack.files.size() > kMaxSlices) {
        return failInFile(stack.files[0].string(),
                          "is one of " + std::to_string(stack.files.size()) + " layers; at most " +
                              std::to_string(kMaxSlices) + " can be read");
    }
    return stack;
}

Result<SliceFiles> stackInFolder(const fs::path& folder) {
    const auto series = seriesIn(folder, true);
    if (!series) return Failure(series.error());
    if (series->empty()) return failInFile(folder.string(), "there is no .png in this folder");
    if (series->size() > 1) {
        return failInFile(folder.string(),
                          "the folder holds layers of several names: " + series->begin()->first +
                              " and " + std::next(series->begin())->first);
    }
    return stackOf(series->begin()->first, series->begin()->second);
}

}  // namespace

std::optional<SliceName> sliceNameOf(const fs::path& path) {
    const std::string stem = path.stem().string();
    std::size_t digits = 0;
    while (digits < stem.size() && stem[stem.size() - 1 - digits] >= '0' &&
           stem[stem.size() - 1 - digits] <= '9') {
        ++digits;
    }
    SliceName name;
    name.beginning = stem.substr(0, stem.size() - digits);
    name.digits = digits;
    const char* const end = stem.data() + stem.size();
    if (std::from_chars(end - digits, end, name.number).ptr != end || digits == 0 || digits > 9) {
        return std::nullopt;
    }
    return name;
}

bool isSurelyNumbered(const SliceName& name) {
    return name.digits >= kSurelyNumbered;
}

Result<SliceFiles> sliceFilesOf(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) return stackInFolder(path);
    const SliceFiles alone{.files = {path}, .strip = true};
    const std::optional<SliceName> name = sliceNameOf(path);
    if (!name) return alone;
    const auto series = seriesIn(folderOf(path), false);
    if (!series)
        return isSurelyNumbered(*name) ? Result<SliceFiles>(Failure(series.error())) : alone;
    const auto found = series->find(name->beginning);
    if (found == series->end()) return alone;
    const std::map<int, fs::path>& files = found->second.files;
    const bool neighbours = files.contains(name->number - 1) || files.contains(name->number + 1);
    if (!isSurelyNumbered(*name) && !neighbours) return alone;
    return stackOf(name->beginning, found->second);
}

Status checkNeighbours(const fs::path& path, std::size_t layers) {
    const std::optional<SliceName> name = sliceNameOf(path);
    if (!name || !isSurelyNumbered(*name)) return {};
    const auto series = seriesIn(folderOf(path), false);
    if (!series) return {};  // what cannot be listed will say so when it is written to
    const auto found = series->find(name->beginning);
    if (found == series->end()) return {};
    if (!found->second.numbersDiffer) return found->second.numbersDiffer;
    const int end = name->number + static_cast<int>(layers);
    for (const auto& [number, file] : found->second.files) {
        if (number >= name->number && number < end) continue;
        return failInFile(file.string(),
                          "is of another stack of the same name and would be read as a layer of "
                          "this one; remove it or choose another name");
    }
    return {};
}

}  // namespace voxprite
