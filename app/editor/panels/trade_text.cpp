#include "app/editor/panels/trade_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/panels/number_text.h"

namespace voxprite::editor {
namespace {

std::string formatted(const char* format, double value) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

std::string percentText(double share) {
    const double percent = 100.0 * share;
    if (percent == 0.0) return "0 %";
    return formatted(percent < 0.995 ? "%.2f %%" : percent < 9.95 ? "%.1f %%" : "%.0f %%", percent);
}

std::string millisecondsText(double ms) {
    if (!std::isfinite(ms)) return "–";
    if (ms < 0.9995) return formatted("%.0f µs", 1000.0 * ms);
    return formatted(ms < 9.995 ? "%.2f ms" : "%.1f ms", ms);
}

std::string countText(double count) {
    if (!std::isfinite(count)) return "–";
    if (count < 999'999.5) return grouped(static_cast<std::uint64_t>(std::llround(count)));
    return formatted("%.1f M", count / 1e6);
}

std::string figureText(const trade::Point* point, trade::Yardstick yardstick) {
    if (point == nullptr) return "not measured yet";
    return percentText(point->error(yardstick)) + " off  " +
           millisecondsText(point->milliseconds()) + "  " + countText(point->rays()) + " rays";
}

}  // namespace voxprite::editor
