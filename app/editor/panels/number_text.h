// Numbers as people read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace voxprite::editor {

[[nodiscard]] std::string grouped(std::uint64_t number);  // 1234567 -> "1,234,567"
[[nodiscard]] std::string byteText(std::uint64_t bytes);  // "12.3 KiB"

}  // namespace voxprite::editor
