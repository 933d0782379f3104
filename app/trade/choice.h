// Which of the measured settings are worth choosing.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/trade/figures.h"

namespace voxprite::trade {

enum class Cost : std::uint8_t { milliseconds, rays };
[[nodiscard]] double costOf(const Point& point, Cost cost);

// The points that no other beats: none is cheaper and as accurate, or more accurate and as cheap.
// Cheapest first; of points alike in both the first in order. Points without a cost, and those that
// another backend than the curve's measured, are not looked at; of points that show the same and
// cast the same only the first is, for what their times differ by is chance. So it is below.
[[nodiscard]] std::vector<std::size_t> paretoFront(const Curve& curve, Yardstick yardstick,
                                                   Cost cost = Cost::milliseconds);

// How to choose.
struct Wish {
    Yardstick yardstick = Yardstick::sprite;
    Cost cost = Cost::milliseconds;
    bool profileOnly = false;  // only what fitsProfile()
};
// The cheapest whose error is at most `mostError`; of equally cheap ones the more accurate.
[[nodiscard]] std::optional<std::size_t> cheapestWithin(const Curve& curve, double mostError,
                                                        const Wish& wish = {});
// The most accurate that costs at most `mostCost`; of equally accurate ones the cheaper.
[[nodiscard]] std::optional<std::size_t> bestWithin(const Curve& curve, double mostCost,
                                                    const Wish& wish = {});

}  // namespace voxprite::trade
