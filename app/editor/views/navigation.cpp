#include "app/editor/views/navigation.h"

namespace voxprite::editor {
namespace {

constexpr int kLeft = 0, kRight = 1, kMiddle = 2;

}  // namespace

CameraMove moveByDrag(NavigationPreset preset, int button, const HeldKeys& keys) {
    if (button == kLeft) {
        if (!keys.space) return CameraMove::none;
        return keys.control ? CameraMove::zoom : keys.shift ? CameraMove::orbit : CameraMove::pan;
    }
    switch (preset) {
        case NavigationPreset::magicaVoxel:
        case NavigationPreset::trackpad:
            return button == kRight ? CameraMove::orbit : CameraMove::pan;
        case NavigationPreset::blender:
            if (button != kMiddle) return CameraMove::none;
            return keys.shift     ? CameraMove::pan
                   : keys.control ? CameraMove::zoom
                                  : CameraMove::orbit;
        case NavigationPreset::goxel:
            return button == kMiddle ? CameraMove::orbit : CameraMove::pan;
    }
    return CameraMove::none;
}

CameraMove moveByWheel(NavigationPreset preset, const HeldKeys& keys) {
    if (preset != NavigationPreset::trackpad) return CameraMove::zoom;
    if (keys.control) return CameraMove::zoom;
    return keys.shift ? CameraMove::pan : CameraMove::orbit;
}

}  // namespace voxprite::editor
