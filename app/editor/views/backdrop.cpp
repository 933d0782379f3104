#include "app/editor/views/backdrop.h"

namespace voxprite::editor {
namespace {

const Rgba8 kLightInk(226, 230, 238, 200), kDarkInk(40, 44, 52, 200);

}  // namespace

BackdropColours backdropColours(Backdrop backdrop, ThemeKind theme) {
    switch (backdrop) {
        case Backdrop::theme:
            break;
        case Backdrop::black:
            return {Rgba8(8, 8, 10, 255), Rgba8(8, 8, 10, 255), kLightInk};
        case Backdrop::grey:
            return {Rgba8(118, 118, 118, 255), Rgba8(118, 118, 118, 255), kLightInk};
        case Backdrop::white:
            return {Rgba8(255, 255, 255, 255), Rgba8(244, 244, 246, 255), kDarkInk};
        case Backdrop::sky:
            return {Rgba8(112, 164, 222, 255), Rgba8(206, 224, 240, 255), kDarkInk};
    }
    if (theme == ThemeKind::light) {
        return {Rgba8(214, 217, 222, 255), Rgba8(176, 180, 188, 255), kDarkInk};
    }
    return {Rgba8(58, 62, 70, 255), Rgba8(34, 36, 41, 255), kLightInk};
}

}  // namespace voxprite::editor
