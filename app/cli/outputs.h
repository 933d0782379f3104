// The files that a command writes, looked at before any work is done. What is wrong with them is
// wrong usage: CLI::ValidationError, named after the option.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/formats.h"

namespace voxprite::cli {

struct Output {
    std::string option;  // that names it
    std::string path;
};

// One file, there already or not, under whatever names?
[[nodiscard]] bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

// It has a name and one of these endings, in either case. Names without an ending (/dev/stdout)
// promise nothing and pass.
void checkEnding(const Output& output, const std::vector<std::string>& endings);

// It has a name, and is none of the files that are read for `inputs`, with all layers of a stack
// and what a mesh refers to: they would be lost. Inputs that may be written again (in their own
// format, whole) are left out of the list by the caller.
void checkReplacesNone(const Output& output, const std::vector<std::string>& inputs);

// Is the model of a file read as it is, and all of it? Not of a mesh, which becomes voxels, nor
// where one of several entities is chosen. Reading it may still tell (LoadedDocument::whole).
[[nodiscard]] bool isReadWhole(const std::string& input, const ReadOptions& options);

}  // namespace voxprite::cli
