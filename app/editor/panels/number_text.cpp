#include "app/editor/panels/number_text.h"

#include <array>
#include <cstdio>

namespace voxprite::editor {

std::string grouped(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string byteText(std::uint64_t bytes) {
    if (bytes < 1024) return std::to_string(bytes) + " B";
    const double kib = static_cast<double>(bytes) / 1024.0;
    const double mib = kib / 1024.0;
    std::array<char, 32> text{};
    if (kib < 1024.0) {
        std::snprintf(text.data(), text.size(), "%.1f KiB", kib);
    } else if (mib < 1024.0) {
        std::snprintf(text.data(), text.size(), "%.1f MiB", mib);
    } else {
        std::snprintf(text.data(), text.size(), "%.4g GiB", mib / 1024.0);
    }
    return text.data();
}

}  // namespace voxprite::editor
