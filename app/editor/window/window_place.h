// Where a window is on the screen, and where it may be when displays have come or gone.
#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace voxprite::editor {

// Of what lies inside its frame. Screen coordinates; the size at content scale 1.
struct WindowPlace {
    int x = 0, y = 0;
    int width = 1280, height = 800;
    bool maximized = false;
    bool known = false;  // x and y mean something; else the desktop puts the window where it likes
    bool operator==(const WindowPlace&) const = default;
};

// What a display leaves to windows.
struct WorkArea {
    glm::ivec2 corner{0};
    glm::ivec2 size{0};
};

// `wanted` at this content scale, width and height included: no larger than the display that it
// lies on most, and wholly on it. A place on none of the displays is not known any more. Without
// displays, as wanted.
[[nodiscard]] WindowPlace placeOn(std::span<const WorkArea> displays, WindowPlace wanted,
                                  double contentScale);

}  // namespace voxprite::editor
