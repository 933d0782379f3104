// Roots by + - * / alone: the same digits on every machine.
#pragma once

namespace voxprite {

// The n-th root of 0 < x <= 1 by Newton's method from 1, which comes down to it without ever
// passing it; rounding alone can make it turn.
[[nodiscard]] inline double rootOf(double x, int n) {
    double root = 1.0;
    for (;;) {
        double power = 1.0;
        for (int k = 1; k < n; ++k) power *= root;
        const double next = ((n - 1) * root + x / power) / n;
        if (!(next < root)) return root;
        root = next;
    }
}

}  // namespace voxprite
