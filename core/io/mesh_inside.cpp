#include "core/io/mesh_inside.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/vec2.hpp>

namespace voxprite {
namespace {

struct Crossing {
    std::uint32_t line = 0;  // v * size along u + u
    float depth = 0.0f;      // along the axis
    std::int8_t turn = 0;    // +1 where the surface looks down the axis, -1 where up
};

bool before(const Crossing& a, const Crossing& b) {
    if (a.line != b.line) return a.line < b.line;
    if (a.depth != b.depth) return a.depth < b.depth;
    return a.turn > b.turn;
}

// Twice the area of a, b, p, counter-clockwise positive. Both triangles at an edge find the very
// same number, so that a line through the edge meets exactly one of them.
double sideOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    const bool swapped = a.x > b.x || (a.x == b.x && a.y > b.y);
    const glm::dvec2& from = swapped ? b : a;
    const glm::dvec2& to = swapped ? a : b;
    const double area = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    return swapped ? -area : area;
}

// Whether p is to the left of a -> b. On the edge itself: as if p were moved a little along +y and
// far less along -x (Edelsbrunner & Mucke 1990).
bool isLeft(double side, const glm::dvec2& a, const glm::dvec2& b) {
    if (side != 0.0) return side > 0.0;
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

class LineScan {
  public:
    LineScan(std::span<const MeshTriangle> triangles, glm::ivec3 size, int axis)
        : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), size_(size) {
        for (const MeshTriangle& triangle : triangles) cross(triangle);
        std::sort(crossings_.begin(), crossings_.end(), before);
    }

    // Whether every line's turns add up to nothing, or whether it crosses an even number of times.
    [[nodiscard]] bool balanced(bool winding) const {
        bool all = true;
        forEachLine([&](std::span<const Crossing> line) {
            int sum = 0;
            for (const Crossing& crossing : line) sum += winding ? crossing.turn : 1;
            all = all && (winding ? sum == 0 : sum % 2 == 0);
        });
        return all;
    }

    template <class Visit>  // visit(first cell, cell after the last) of each run inside
    void forEachRun(bool winding, const Visit& visit) const {
        forEachLine([&](std::span<const Crossing> line) {
            int around = 0;
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                around += winding ? line[k].turn : (around == 0 ? 1 : -1);
                if (around == 0) continue;
                // Cells whose centre, at + 0.5, lies between.
                const int first = cellFrom(line[k].depth), last = cellFrom(line[k + 1].depth);
                if (first >= last) continue;
                glm::ivec3 cell(0);
                cell[u_] = static_cast<int>(line[k].line) % size_[u_];
                cell[v_] = static_cast<int>(line[k].line) / size_[u_];
                cell[axis_] = first;
                glm::ivec3 end = cell;
                end[axis_] = last;
                visit(cell, end);
            }
        });
    }

    [[nodiscard]] std::uint64_t insideCount(bool winding) const {
        std::uint64_t count = 0;
        forEachRun(winding, [&](const glm::ivec3& first, const glm::ivec3& last) {
            count += static_cast<std::uint64_t>(last[axis_] - first[axis_]);
        });
        return count;
    }

  private:
    [[nodiscard]] int cellFrom(float depth) const {
        return std::clamp(static_cast<int>(std::ceil(depth - 0.5f)), 0, size_[axis_]);
    }

    template <class Visit>
    void forEachLine(const Visit& visit) const {
        for (std::size_t first = 0; first < crossings_.size();) {
            std::size_t last = first + 1;
            while (last < crossings_.size() && crossings_[last].line == crossings_[first].line) {
                ++last;
            }
            visit(std::span(crossings_).subspan(first, last - first));
            first = last;
        }
    }

    void cross(const MeshTriangle& triangle) {
        std::array<glm::dvec2, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& corner = triangle.corners[k].position;
            p[k] = {corner[u_], corner[v_]};
        }
        const double area = sideOf(p[0], p[1], p[2]);
        if (area == 0.0) return;
        const auto range = [&](int component, int size) {
            const double low = std::min({p[0][component], p[1][component], p[2][component]});
            const double high = std::max({p[0][component], p[1][component], p[2][component]});
            // One more on either side: the tie rule is the judge.
            const int first = static_cast<int>(std::clamp(std::floor(low - 0.5), 0.0, size * 1.0));
            const int last =
                static_cast<int>(std::clamp(std::ceil(high - 0.5) + 1.0, 0.0, size * 1.0));
            return std::pair(first, last);
        };
        const auto [u0, u1] = range(0, size_[u_]);
        const auto [v0, v1] = range(1, size_[v_]);
        for (int v = v0; v < v1; ++v) {
            for (int u = u0; u < u1; ++u) {
                const glm::dvec2 centre(u + 0.5, v + 0.5);
                const double a = sideOf(p[1], p[2], centre);
                const double b = sideOf(p[2], p[0], centre);
                const double c = sideOf(p[0], p[1], centre);
                const bool left = isLeft(a, p[1], p[2]);
                if (left != isLeft(b, p[2], p[0]) || left != isLeft(c, p[0], p[1])) continue;
                const double sum = a + b + c;
                if (sum == 0.0) continue;
                const auto& k = triangle.corners;
                const double depth = (a * k[0].position[axis_] + b * k[1].position[axis_] +
                                      c * k[2].position[axis_]) /
                                     sum;
                crossings_.push_back({static_cast<std::uint32_t>(v * size_[u_] + u),
                                      static_cast<float>(depth),
                                      static_cast<std::int8_t>(left ? -1 : 1)});
            }
        }
    }

    int axis_, u_, v_;
    glm::ivec3 size_;
    std::vector<Crossing> crossings_;
};

// Rounding may move a centre that lies on the surface to one side along one axis and to the other
// along the next.
bool agree(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t apart = a > b ? a - b : b - a;
    return apart <= 8 + std::max(a, b) / 256;
}

}  // namespace

CellMask::CellMask(glm::ivec3 size) : size_(size) {
    const std::size_t cells = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                              static_cast<std::size_t>(size.z);
    words_.resize((cells + 63) / 64);
}

std::uint64_t CellMask::count() const {
    std::uint64_t count = 0;
    for (const std::uint64_t word : words_) {
        count += static_cast<std::uint64_t>(std::popcount(word));
    }
    return count;
}

InsideCells insideOf(std::span<const MeshTriangle> triangles, glm::ivec3 size) {
    InsideCells inside{false, CellMask(size)};
    bool balanced[2] = {true, true};
    std::uint64_t counts[2] = {0, 0};
    for (const int axis : {0, 1, 2}) {
        const LineScan scan(triangles, size, axis);
        for (const bool winding : {false, true}) {
            const std::uint64_t count = scan.insideCount(winding);
            if (axis == 0) counts[winding] = count;
            balanced[winding] =
                balanced[winding] && scan.balanced(winding) && agree(count, counts[winding]);
        }
        if (axis != 2) continue;
        // The last axis is the one that fills.
        if (!balanced[0] && !balanced[1]) return inside;
        inside.closed = true;
        scan.forEachRun(balanced[1], [&](glm::ivec3 cell, const glm::ivec3& end) {
            for (; cell[axis] < end[axis]; ++cell[axis]) inside.cells.set(cell);
        });
    }
    return inside;
}

}  // namespace voxprite
