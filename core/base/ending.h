// The ending of a file's name, by which formats are told apart.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

namespace voxprite {

// With the dot, in lower case: ".vox" of "HUT.VOX"; empty where there is none.
[[nodiscard]] inline std::string lowerEndingOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return ending;
}

}  // namespace voxprite
