#include "core/lod/representation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxprite {

namespace {

using AtSize = RepresentationFigures::AtSize;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

bool isExact(const RepresentationFigures& figures) {
    return figures.choice.kind == Representation::sprite;
}

// The first figure of at least this size.
std::vector<AtSize>::const_iterator notBelow(const std::vector<AtSize>& bySize, double sizePx) {
    return std::ranges::lower_bound(bySize, sizePx, {}, &AtSize::sizePx);
}

// A figure that is no number is worse than any that is one.
double known(double figure) {
    return std::isnan(figure) ? kUnknown : figure;
}

double greatestError(const RepresentationFigures& figures, double fromPx, double toPx) {
    double error = std::max(errorAt(figures, fromPx), errorAt(figures, toPx));
    for (const AtSize& each : figures.bySize) {
        if (each.sizePx >= fromPx && each.sizePx <= toPx)
            error = std::max(error, known(each.error));
    }
    return isExact(figures) ? 0.0 : error;
}

}  // namespace

double errorAt(const RepresentationFigures& figures, double sizePx) {
    if (isExact(figures)) return 0.0;
    const std::vector<AtSize>& bySize = figures.bySize;
    if (!(sizePx >= 0.0) || bySize.empty() || sizePx > bySize.back().sizePx) return kUnknown;
    const auto above = notBelow(bySize, sizePx);
    const double error = known(above->error);
    if (above == bySize.begin() || above->sizePx == sizePx) return error;
    return std::max(error, known(std::prev(above)->error));
}

double microsecondsAt(const RepresentationFigures& figures, double sizePx) {
    const std::vector<AtSize>& bySize = figures.bySize;
    if (!(sizePx >= 0.0) || bySize.empty()) return kUnknown;
    const auto above = notBelow(bySize, sizePx);
    if (above == bySize.end()) return known(bySize.back().microseconds);
    if (above == bySize.begin()) return known(above->microseconds);
    const AtSize& below = *std::prev(above);
    const double share = std::log(sizePx / below.sizePx) / std::log(above->sizePx / below.sizePx);
    return known(std::lerp(below.microseconds, above->microseconds, share));
}

const RepresentationFigures* figuresOf(const RepresentationTable& table,
                                       RepresentationChoice choice) {
    const auto found = std::ranges::find(table, choice, &RepresentationFigures::choice);
    return found != table.end() ? &*found : nullptr;
}

RepresentationChoice choose(const RepresentationTable& table, double sizePx,
                            const ChoiceRules& rules,
                            std::optional<RepresentationChoice> previous) {
    if (rules.forced) return *rules.forced;
    const double band = std::max(0.0, rules.band);
    const RepresentationFigures* kept = previous ? figuresOf(table, *previous) : nullptr;
    if (kept != nullptr && !(errorAt(*kept, sizePx) <= rules.errorBudget)) kept = nullptr;

    // With a past, what is new has to be within the budget all around.
    const double least = previous ? sizePx / (1.0 + band) : sizePx;
    const double most = previous ? sizePx * (1.0 + band) : sizePx;
    RepresentationChoice best;
    double bestCost = kUnknown, bestError = 0.0;
    for (const RepresentationFigures& each : table) {
        const double error = greatestError(each, least, most);
        const double cost = microsecondsAt(each, sizePx);
        if (!(error <= rules.errorBudget) && !isExact(each)) continue;
        if (cost > bestCost || (cost == bestCost && error >= bestError)) continue;
        best = each.choice;
        bestCost = cost;
        bestError = error;
    }
    if (kept == nullptr) return best;
    const bool clearlyCheaper = bestCost < (1.0 - band) * microsecondsAt(*kept, sizePx);
    return clearlyCheaper ? best : kept->choice;
}

}  // namespace voxprite
