// Shared libraries of ours that a program loads when it first needs them, not before it starts.
#pragma once

#include <string>

#include "core/base/result.h"

namespace voxprite {

// The function that `library` is entered by. It is looked for where the program's run path says
// (beside it in a build, in lib/voxprite once installed) and stays loaded. Fails with what the
// loader says.
[[nodiscard]] Result<void*> entryOf(const std::string& library, const char* entry);

}  // namespace voxprite
