// Drops files on a window of an X server, as a file manager does (XDND, version 5).
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace voxprite::test {

// On the window that takes drops, at a place of the screen. True once the program says that it has
// taken them; false when there is no such window, or it does not want them.
[[nodiscard]] bool dropped(const std::string& display, glm::ivec2 at,
                           const std::vector<std::filesystem::path>& files);

}  // namespace voxprite::test
