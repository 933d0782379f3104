// Equal cells of a plane as few rectangles: the longest run along u, then as many equal runs as
// follow along v (Lysenko, "Meshing in a Minecraft game", 2012).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace voxprite {

// `cells` has width * height values, u fastest; 0 is no cell. They are all 0 afterwards.
// visit(u, v, width, height, value) for each rectangle, rows first.
template <class Visit>
void takeRectangles(std::span<std::uint8_t> cells, int width, int height, const Visit& visit) {
    for (int v = 0; v < height; ++v) {
        std::uint8_t* row = cells.data() + static_cast<std::ptrdiff_t>(v) * width;
        for (int u = 0; u < width; ++u) {
            std::uint8_t* run = row + u;
            const std::uint8_t value = *run;
            if (value == 0) continue;
            const auto equal = [&](std::uint8_t cell) { return cell == value; };
            const auto across = std::find_if_not(run, run + (width - u), equal) - run;
            const auto rowOf = [&](int k) { return run + static_cast<std::ptrdiff_t>(k) * width; };
            int down = 1;
            while (v + down < height && std::all_of(rowOf(down), rowOf(down) + across, equal)) {
                ++down;
            }
            for (int k = 0; k < down; ++k) std::fill_n(rowOf(k), across, std::uint8_t{0});
            visit(u, v, static_cast<int>(across), down, value);
        }
    }
}

}  // namespace voxprite
