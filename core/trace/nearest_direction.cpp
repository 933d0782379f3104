#include "core/trace/nearest_direction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace voxprite {
namespace {

// The components by falling magnitude: direction[axis[0]] is the largest.
struct Order {
    int axis[3];
};

Order orderOf(glm::dvec3 magnitude) {
    Order order{{0, 1, 2}};
    const auto swapIfLess = [&](int a, int b) {
        if (magnitude[order.axis[a]] < magnitude[order.axis[b]])
            std::swap(order.axis[a], order.axis[b]);
    };
    swapIfLess(0, 1);
    swapIfLess(1, 2);
    swapIfLess(0, 1);
    return order;
}

// Rules out scales by a few integer operations: those at which s b or s c is farther from the next
// integer than any better vector may be. Offsets in units of 2^-32, which wrap as fractions do.
class FirstLook {
  public:
    // An offset x is within reach where x + half does not exceed 2 half, wrapping.
    struct Reach {
        std::uint32_t half = 0;
        std::uint32_t whole = ~std::uint32_t{0};  // at first all is
    };
    FirstLook(double b, double c, int most)
        : stepB_(fraction(b)), stepC_(fraction(c)), slack_(most + 16.0) {}

    [[nodiscard]] Reach reach(double offset) const {
        // Each step was rounded by up to a unit, s times.
        const double half = offset * kUnits + slack_;
        if (!(half < 0.49 * kUnits)) return {};
        const auto units = static_cast<std::uint32_t>(half);
        return {units, 2 * units};
    }
    [[nodiscard]] bool mayBeBetter(int s, Reach reach) const {
        const auto scale = static_cast<std::uint32_t>(s);
        return scale * stepB_ + reach.half <= reach.whole &&
               scale * stepC_ + reach.half <= reach.whole;
    }

  private:
    static constexpr double kUnits = 4294967296.0;
    static std::uint32_t fraction(double x) {
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x * kUnits));
    }
    std::uint32_t stepB_, stepC_;
    double slack_;
};

constexpr int kBlock = 32;  // scales between which what is within reach is not worked out again

}  // namespace

// The direction, scaled to (1, b, c) with 1 >= b >= c >= 0, pierces the plane x = s of integer
// points at (s, s b, s c). For every scale s the nearest vector is one of the four integer points
// around there: seen in angle their distances are those of a lattice whose basis is reduced, and
// such a lattice's nearest point is a corner of the cell. With the offset (db, dc) from the
// piercing point, the cross product gives
//     sin^2 ~ Q / |v|^2,   Q = db^2 + dc^2 + (db c - dc b)^2,
// which loses no digits however small the angle.
glm::ivec3 nearestDirection(glm::dvec3 direction, int bits) {
    const glm::dvec3 magnitude{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    const Order order = orderOf(magnitude);
    const double b = magnitude[order.axis[1]] / magnitude[order.axis[0]];
    const double c = magnitude[order.axis[2]] / magnitude[order.axis[0]];

    const int most = 1 << bits;
    const FirstLook firstLook(b, c, most);
    glm::ivec3 best{1, 0, 0};
    double bestQ = 0.0;
    double bestNorm = 0.0;  // |best|^2; 0: none yet
    const auto tryScale = [&](int s) {
        const double scale = s;
        const double floorB = static_cast<int>(scale * b);
        const double floorC = static_cast<int>(scale * c);
        const double restB = scale * b - floorB;
        const double restC = scale * c - floorC;
        // Q >= db^2 + dc^2 and |v|^2 <= 3 s^2 rule most scales out at once.
        const double offB = restB < 0.5 ? restB : 1.0 - restB;
        const double offC = restC < 0.5 ? restC : 1.0 - restC;
        if ((offB * offB + offC * offC) * bestNorm > bestQ * (3.0 * scale * scale)) return;
        for (int corner = 0; corner < 4; ++corner) {
            const double stepB = corner & 1;
            const double stepC = corner >> 1;
            const double db = stepB - restB;
            const double dc = stepC - restC;
            const double skew = db * c - dc * b;
            const double q = db * db + dc * dc + skew * skew;
            const double vb = floorB + stepB;
            const double vc = floorC + stepC;
            const double norm = scale * scale + vb * vb + vc * vc;
            if (bestNorm != 0.0 && q * bestNorm >= bestQ * norm) continue;
            best = {s, static_cast<int>(vb), static_cast<int>(vc)};
            bestQ = q;
            bestNorm = norm;
        }
    };
    const auto exact = [&] { return bestNorm != 0.0 && bestQ == 0.0; };
    for (int first = 1; first <= most && !exact(); first += kBlock) {
        const int end = std::min(first + kBlock, most + 1);
        const FirstLook::Reach reach =
            bestNorm != 0.0 ? firstLook.reach(std::sqrt(3.0 * bestQ / bestNorm) * end)
                            : FirstLook::Reach{};
        for (int s = first; s < end; ++s) {
            if (!firstLook.mayBeBetter(s, reach)) continue;
            tryScale(s);
            if (exact()) break;
        }
    }

    // The shortest of equals: rounding may have preferred a multiple.
    best /= std::gcd(best.x, std::gcd(best.y, best.z));
    glm::ivec3 result{0};
    for (int k = 0; k < 3; ++k) {
        const int axis = order.axis[k];
        result[axis] = direction[axis] < 0.0 ? -best[k] : best[k];
    }
    return result;
}

}  // namespace voxprite
