// A file's bytes, or none where there is no file.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace voxprite::test {

[[nodiscard]] inline std::string contentOf(const std::filesystem::path& path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

}  // namespace voxprite::test
