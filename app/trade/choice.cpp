#include "app/trade/choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace voxprite::trade {
namespace {

bool comparable(const Curve& curve, const Point& point, Cost cost) {
    const auto foreign = [&](const AtSize& size) {
        return !size.costs || size.costs->backend != curve.backend;
    };
    if (std::any_of(point.bySize.begin(), point.bySize.end(), foreign)) return false;
    return std::isfinite(costOf(point, cost));
}

// Do both show the same and cast the same? Then what their times differ by is chance. (A larger
// sigma that is halved until it fits the screen is such a one.)
bool sameWork(const Point& a, const Point& b) {
    return std::equal(a.bySize.begin(), a.bySize.end(), b.bySize.begin(), b.bySize.end(),
                      [](const AtSize& one, const AtSize& other) {
                          return one.costs && other.costs && one.sizePx == other.sizePx &&
                                 one.sprite.flip == other.sprite.flip &&
                                 one.perspective.flip == other.perspective.flip &&
                                 one.costs->rays == other.costs->rays &&
                                 one.costs->bytes == other.costs->bytes &&
                                 one.costs->backend == other.costs->backend;
                      });
}

// Of points that do the same work the first counts, and the others do not.
bool repeatsEarlier(const Curve& curve, std::size_t k) {
    const auto end = curve.points.begin() + static_cast<std::ptrdiff_t>(k);
    return std::any_of(curve.points.begin(), end, [&](const Point& earlier) {
        return sameWork(earlier, curve.points[k]) && curve.points[k].rays() > 0.0;
    });
}

template <class Key, class Allowed>
std::optional<std::size_t> leastOf(const Curve& curve, const Wish& wish, Allowed allowed, Key key) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const Point& point = curve.points[k];
        if (wish.profileOnly && !fitsProfile(point.setting)) continue;
        if (repeatsEarlier(curve, k)) continue;
        if (!comparable(curve, point, wish.cost) || !allowed(point)) continue;
        if (!best || key(point) < key(curve.points[*best])) best = k;
    }
    return best;
}

}  // namespace

double costOf(const Point& point, Cost cost) {
    return cost == Cost::milliseconds ? point.milliseconds() : point.rays();
}

std::vector<std::size_t> paretoFront(const Curve& curve, Yardstick yardstick, Cost cost) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < curve.points.size(); ++k)
        if (comparable(curve, curve.points[k], cost) && !repeatsEarlier(curve, k))
            order.push_back(k);
    const auto key = [&](std::size_t k) {
        return std::tuple(costOf(curve.points[k], cost), curve.points[k].error(yardstick), k);
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<std::size_t> front;
    for (const std::size_t k : order) {
        const double error = curve.points[k].error(yardstick);
        if (front.empty() || error < curve.points[front.back()].error(yardstick))
            front.push_back(k);
    }
    return front;
}

std::optional<std::size_t> cheapestWithin(const Curve& curve, double mostError, const Wish& wish) {
    return leastOf(
        curve, wish, [&](const Point& point) { return point.error(wish.yardstick) <= mostError; },
        [&](const Point& point) {
            return std::pair(costOf(point, wish.cost), point.error(wish.yardstick));
        });
}

std::optional<std::size_t> bestWithin(const Curve& curve, double mostCost, const Wish& wish) {
    return leastOf(
        curve, wish, [&](const Point& point) { return costOf(point, wish.cost) <= mostCost; },
        [&](const Point& point) {
            return std::pair(point.error(wish.yardstick), costOf(point, wish.cost));
        });
}

}  // namespace voxprite::trade
