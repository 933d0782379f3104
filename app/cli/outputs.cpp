#include "app/cli/outputs.h"

#include <CLI/Error.hpp>
#include <algorithm>
#include <system_error>

#include "core/base/ending.h"

namespace voxprite::cli {
namespace {

namespace fs = std::filesystem;

fs::path wholeNameOf(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path.lexically_normal() : whole;
}

void requireName(const Output& output) {
    if (output.path.empty()) throw CLI::ValidationError(output.option, "the name is empty");
}

// Is `path` read when `input` is?
bool isReadFor(const fs::path& input, const fs::path& path) {
    if (isSameFile(input, path)) return true;
    std::error_code error;
    if (!fs::exists(path, error)) return false;
    return std::ranges::any_of(filesReadFor(input),
                               [&](const fs::path& file) { return isSameFile(file, path); });
}

}  // namespace

bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code missing;
    return fs::equivalent(a, b, missing) || wholeNameOf(a) == wholeNameOf(b);
}

void checkEnding(const Output& output, const std::vector<std::string>& endings) {
    requireName(output);
    const std::string ending = lowerEndingOf(output.path);
    if (ending.empty() || std::ranges::find(endings, ending) != endings.end()) return;
    throw CLI::ValidationError(output.option,
                               "'" + output.path + "' must end in " + listed(endings));
}

void checkReplacesNone(const Output& output, const std::vector<std::string>& inputs) {
    requireName(output);
    for (const std::string& input : inputs) {
        if (!isReadFor(input, output.path)) continue;
        throw CLI::ValidationError(output.option,
                                   "'" + output.path + "' is read" +
                                       (input == output.path ? "" : " for '" + input + "'") +
                                       " and would be lost; choose another name");
    }
}

bool isReadWhole(const std::string& input, const ReadOptions& options) {
    const Result<Format> format = formatOf(input);  // a folder of layers has none
    return !options.entity && (!format || infoOf(*format).keepsVoxels);
}

}  // namespace voxprite::cli
