// How the hand moves a view's camera: which button, key and wheel mean what. The presets are the
// habits of other programs.
#pragma once

#include <cstdint>

namespace voxprite::editor {

enum class NavigationPreset : std::uint8_t {
    magicaVoxel,  // right: orbit; middle or Space + left: pan; wheel: zoom
    blender,      // middle: orbit; Shift + middle: pan; Ctrl + middle, wheel: zoom
    goxel,        // middle: orbit; right: pan; wheel: zoom
    trackpad      // two fingers: orbit; with Shift: pan; with Ctrl, as a pinch says: zoom
};

enum class CameraMove : std::uint8_t { none, orbit, pan, zoom };

struct HeldKeys {
    bool shift = false;
    bool control = false;
    bool space = false;
};

// Of a drag that begins with `button`: 0 left, 1 right, 2 middle. What it does not name is a
// tool's. Space with the left button pans in all of them.
[[nodiscard]] CameraMove moveByDrag(NavigationPreset preset, int button, const HeldKeys& keys);
[[nodiscard]] CameraMove moveByWheel(NavigationPreset preset, const HeldKeys& keys);

}  // namespace voxprite::editor
