#include "core/sheet/pack.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <optional>
#include <string>
#include <utility>

#define STBRP_STATIC
#define STB_RECT_PACK_IMPLEMENTATION
#include <stb_rect_pack.h>

namespace voxprite {
namespace {

// Everything in columns of `width`, which holds the widest; nothing when it becomes too high.
std::optional<Packing> packInto(int width, const std::vector<glm::ivec2>& sizes, int padding,
                                int largestEdge) {
    // Each brings its padding along, on the right and below; the last ones' may stand over.
    const int height = largestEdge + padding;
    std::vector<stbrp_node> nodes(static_cast<std::size_t>(width + padding));
    stbrp_context context;
    stbrp_init_target(&context, width + padding, height, nodes.data(),
                      static_cast<int>(nodes.size()));
    std::vector<stbrp_rect> rectangles(sizes.size());
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        rectangles[k].id = static_cast<int>(k);
        rectangles[k].w = sizes[k].x + padding;
        rectangles[k].h = sizes[k].y + padding;
    }
    if (stbrp_pack_rects(&context, rectangles.data(), static_cast<int>(rectangles.size())) == 0) {
        return std::nullopt;
    }
    Packing packing;
    packing.corners.resize(sizes.size());
    for (const stbrp_rect& rectangle : rectangles) {
        const auto k = static_cast<std::size_t>(rectangle.id);
        packing.corners[k] = {rectangle.x, rectangle.y};
        packing.size = glm::max(packing.size, packing.corners[k] + sizes[k]);
    }
    return packing;
}

}  // namespace

Result<Packing> packRectangles(const std::vector<glm::ivec2>& sizes, int padding, int largestEdge) {
    int widest = 1;
    double area = 0.0;
    for (const glm::ivec2 size : sizes) {
        widest = std::max(widest, size.x);
        area += static_cast<double>(size.x + padding) * (size.y + padding);
    }
    // From a square of the area to half as wide again, in steps: the smallest area wins, of equals
    // the first, which is the squarest.
    std::optional<Packing> best;
    const auto areaOf = [](const Packing& packing) {
        return static_cast<std::int64_t>(packing.size.x) * packing.size.y;
    };
    const int square = static_cast<int>(std::min<double>(std::ceil(std::sqrt(area)), largestEdge));
    int tried = 0;
    for (int step = 0; step <= 8; ++step) {
        const int width =
            std::clamp(square + square * step / 16, std::min(widest, largestEdge), largestEdge);
        if (width == tried || width < widest) continue;
        tried = width;
        std::optional<Packing> packing = packInto(width, sizes, padding, largestEdge);
        if (packing && (!best || areaOf(*packing) < areaOf(*best))) best = std::move(packing);
    }
    if (!best) {
        best = widest <= largestEdge ? packInto(largestEdge, sizes, padding, largestEdge)
                                     : std::nullopt;
    }
    if (!best) {
        return fail(std::to_string(sizes.size()) + " sprites do not fit a picture of " +
                    std::to_string(largestEdge) + "x" + std::to_string(largestEdge));
    }
    return std::move(*best);
}

}  // namespace voxprite
