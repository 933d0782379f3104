// The colours of errors: black, violet, rose, orange, pale yellow. Their lightness rises in equal
// steps (OKLab), so that more is always brighter: in print, and for eyes that know few hues, too.
#pragma once

#include "core/base/image.h"

namespace voxprite::editor {

// `error` 0 ... 1; what lies outside, or is no number, is brought into it. Alpha 255.
[[nodiscard]] Rgba8 heatColour(double error);

}  // namespace voxprite::editor
