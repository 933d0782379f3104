#include "app/cli/text_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace voxprite::cli {
namespace {

// Columns as wide as their widest cell, two blanks between.
std::string plainText(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            text += row[k];
            if (k + 1 < row.size()) text += std::string(widths[k] - row[k].size() + 2, ' ');
        }
        text += '\n';
    }
    return text;
}

std::string markdownText(const std::vector<std::vector<std::string>>& rows) {
    std::string text;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (const std::string& cell : rows[k]) text += "| " + cell + " ";
        text += "|\n";
        if (k > 0) continue;
        for (std::size_t column = 0; column < rows[0].size(); ++column) text += "|---";
        text += "|\n";
    }
    return text;
}

}  // namespace

std::string textOf(const std::vector<std::vector<std::string>>& rows, TableStyle style) {
    return style == TableStyle::plain ? plainText(rows) : markdownText(rows);
}

std::string textOf(double number) {
    std::ostringstream text;
    const double size = std::abs(number);
    if (size >= 9999.5 && size < 1e15)
        text << std::fixed << std::setprecision(0) << number;
    else
        text << std::setprecision(4) << number;
    return text.str();
}

std::string percentText(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), share < 0.0995 && share > 0.0 ? "%.2f %%" : "%.1f %%",
                  100.0 * share);
    return text.data();
}

}  // namespace voxprite::cli
