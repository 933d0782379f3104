// Pastes what a program holds in the clipboard of an X server, as any other program would.
#pragma once

#include <string>

#include "core/base/bytes.h"

namespace voxprite::test {

// The bytes of the selection CLIPBOARD as `target` ("image/png"); empty when nobody offers that.
[[nodiscard]] Bytes pasted(const std::string& display, const std::string& target);

}  // namespace voxprite::test
