// What this program is made of: versions of itself, its libraries and the driver it runs on.
#pragma once

#include <vector>

#include "app/editor/panels/dialogs.h"

namespace voxprite::editor {

[[nodiscard]] std::vector<AboutLine> aboutLines();  // needs a current GL context

}  // namespace voxprite::editor
