// Tables for people: columns of blanks on a terminal, or Markdown for a page.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voxprite::cli {

enum class TableStyle : std::uint8_t { plain, markdown };

// Every row has as many cells as the first, which is the head.
[[nodiscard]] std::string textOf(const std::vector<std::vector<std::string>>& rows,
                                 TableStyle style);

// Four digits, without trailing zeros; 10,000 and more whole, without an exponent.
[[nodiscard]] std::string textOf(double number);
// "0.42 %", "12.3 %"
[[nodiscard]] std::string percentText(double share);

}  // namespace voxprite::cli
