#include "app/trade/figures.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace voxprite::trade {
namespace {

template <class Of>
double meanOver(const std::vector<AtSize>& sizes, Of of) {
    double sum = 0.0;
    for (const AtSize& size : sizes) sum += of(size);
    return sum / static_cast<double>(sizes.size());
}

constexpr double kUnknown = std::numeric_limits<double>::infinity();

}  // namespace

const char* nameOf(Yardstick yardstick) {
    return yardstick == Yardstick::sprite ? "sprite" : "perspective";
}

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    return {values.front(), median, values.back(), static_cast<int>(values.size())};
}

Spread spreadOfParts(const std::vector<std::vector<double>>& runs) {
    if (runs.empty()) return {};
    std::vector<double> wholes;
    std::vector<double> fastest = runs.front();
    for (const std::vector<double>& run : runs) {
        wholes.push_back(std::accumulate(run.begin(), run.end(), 0.0));
        for (std::size_t part = 0; part < fastest.size(); ++part)
            fastest[part] = std::min(fastest[part], run[part]);
    }
    Spread spread = spreadOf(std::move(wholes));
    spread.least = std::accumulate(fastest.begin(), fastest.end(), 0.0);
    return spread;
}

double Point::error(Yardstick yardstick) const {
    return meanOver(bySize, [&](const AtSize& size) { return size.against(yardstick).flip; });
}

double Point::milliseconds() const {
    return meanOver(bySize, [](const AtSize& size) {
        return size.costs ? size.costs->milliseconds.least : kUnknown;
    });
}

double Point::rays() const {
    return meanOver(bySize,
                    [](const AtSize& size) { return size.costs ? size.costs->rays : kUnknown; });
}

}  // namespace voxprite::trade
