#include "core/sprite/view_set.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/sprite/view_axes.h"

namespace voxprite {

namespace {

// Below this sine of the angle between Z and the ray, Z decides nothing.
constexpr double kVertical = 1e-6;
// Of spacing(): so far past the middle between two views the old one is kept.
constexpr double kMargin = 0.1;
// How far, in cells of the map, the nearest direction may be from the cell that is asked for.
constexpr int kReach = 2;

double signOf(double x) {
    return x < 0.0 ? -1.0 : 1.0;
}

// The lower half of the octahedron, folded over its diagonals.
glm::dvec2 folded(glm::dvec2 uv) {
    return {(1.0 - std::abs(uv.y)) * signOf(uv.x), (1.0 - std::abs(uv.x)) * signOf(uv.y)};
}

// Places on the map run from -1 to 1.
glm::dvec3 fromOctahedral(glm::dvec2 uv) {
    const double z = 1.0 - std::abs(uv.x) - std::abs(uv.y);
    return glm::normalize(glm::dvec3(z < 0.0 ? folded(uv) : uv, z));
}
glm::dvec2 toOctahedral(glm::dvec3 direction) {
    direction /= std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    const glm::dvec2 uv(direction);
    return direction.z < 0.0 ? folded(uv) : uv;
}

// The same for the upper half, whose diamond is turned to fill the square.
glm::dvec3 fromHemisphere(glm::dvec2 uv) {
    const double x = 0.5 * (uv.x + uv.y);
    const double y = 0.5 * (uv.x - uv.y);
    return glm::normalize(glm::dvec3(x, y, std::max(0.0, 1.0 - std::abs(x) - std::abs(y))));
}
glm::dvec2 toHemisphere(glm::dvec3 direction) {
    direction /= std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    return {direction.x + direction.y, direction.x - direction.y};
}

std::vector<glm::dvec3> canonical() {
    std::vector<glm::dvec3> all{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-1.0, 1.0}) {
            for (const glm::dvec3 edge :
                 {glm::dvec3(a, b, 0), glm::dvec3(a, 0, b), glm::dvec3(0, a, b)}) {
                all.push_back(glm::normalize(edge));
            }
        }
    }
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) all.push_back(glm::normalize(glm::dvec3(x, y, z)));
        }
    }
    return all;
}

// A cell beside the map of the sphere is one of its own: opposite halves of each side are one line.
glm::ivec2 inMap(glm::ivec2 cell, int edge) {
    for (const int axis : {0, 1}) {
        if (cell[axis] >= 0 && cell[axis] < edge) continue;
        cell[axis] = cell[axis] < 0 ? -1 - cell[axis] : 2 * edge - 1 - cell[axis];
        cell[1 - axis] = edge - 1 - cell[1 - axis];
    }
    return glm::clamp(cell, 0, edge - 1);
}

// Scaled by its largest component, so that squares neither overflow nor vanish.
std::optional<glm::dvec3> unit(glm::dvec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    // Written so that NaN fails.
    if (!(largest > 0.0 && std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
        return std::nullopt;
    return glm::normalize(v / largest);
}

constexpr std::array<std::pair<ViewSet::Layout, std::string_view>, 3> kLayouts{
    {{ViewSet::Layout::canonical26, "canonical26"},
     {ViewSet::Layout::octahedral, "octahedral"},
     {ViewSet::Layout::hemisphere, "hemisphere"}}};

Status checkEdge(int edge) {
    if (edge >= ViewSet::kLeastEdge && edge <= ViewSet::kMostEdge) return {};
    return fail("a set of views has " + std::to_string(ViewSet::kLeastEdge) + " ... " +
                std::to_string(ViewSet::kMostEdge) + " views an edge, not " + std::to_string(edge));
}

}  // namespace

ViewSet::ViewSet() : directions_(canonical()) {}

ViewSet::ViewSet(Layout layout, int edge) : layout_(layout), edge_(edge) {
    directions_.reserve(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge));
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            const glm::dvec2 cell(x, y);
            directions_.push_back(layout == Layout::octahedral
                                      ? fromOctahedral((2.0 * cell + 1.0) / double(edge) - 1.0)
                                      : fromHemisphere(2.0 * cell / double(edge - 1) - 1.0));
        }
    }
}

Result<ViewSet> ViewSet::octahedral(int edge) {
    if (Status ok = checkEdge(edge); !ok) return Failure(ok.error());
    return ViewSet(Layout::octahedral, edge);
}

Result<ViewSet> ViewSet::hemisphere(int edge) {
    if (Status ok = checkEdge(edge); !ok) return Failure(ok.error());
    return ViewSet(Layout::hemisphere, edge);
}

Result<ViewSet> ViewSet::named(std::string_view name) {
    const std::size_t colon = name.find(':');
    const std::string_view layout = name.substr(0, colon);
    if (name == "canonical26") return ViewSet();
    int edge = 0;
    if (colon != std::string_view::npos) {
        const char* end = name.data() + name.size();
        const auto [last, error] = std::from_chars(name.data() + colon + 1, end, edge);
        if (error == std::errc() && last == end) {
            if (layout == "octahedral") return octahedral(edge);
            if (layout == "hemisphere") return hemisphere(edge);
        }
    }
    return fail("a set of views is canonical26, octahedral:N or hemisphere:N, not '" +
                std::string(name) + "'");
}

std::string ViewSet::name() const {
    std::string text(kLayouts[static_cast<std::size_t>(layout_)].second);
    if (layout_ != Layout::canonical26) text += ":" + std::to_string(edge_);
    return text;
}

glm::dmat3 ViewSet::axes(int view) const {
    const glm::dvec3 forward = -direction(view);
    const glm::dvec3 up =
        std::hypot(forward.x, forward.y) > kVertical ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    return {right, glm::cross(right, forward), forward};
}

double ViewSet::spacing() const {
    const double sphere = layout_ == Layout::hemisphere ? 2.0 : 4.0;
    return std::sqrt(sphere * std::numbers::pi / count());
}

glm::dvec3 ViewSet::asked(glm::dvec3 direction) const {
    if (layout_ != Layout::hemisphere || direction.z >= 0.0) return direction;
    return unit({direction.x, direction.y, 0.0}).value_or(glm::dvec3(0, -1, 0));
}

int ViewSet::nearestInGrid(glm::dvec3 direction) const {
    const bool sphere = layout_ == Layout::octahedral;
    const glm::dvec2 place = sphere ? (toOctahedral(direction) + 1.0) * (0.5 * edge_) - 0.5
                                    : (toHemisphere(direction) + 1.0) * (0.5 * (edge_ - 1));
    const glm::ivec2 middle(glm::floor(place + 0.5));
    int best = count();
    double largest = -2.0;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            const glm::ivec2 beside = middle + glm::ivec2(x, y);
            const glm::ivec2 cell =
                sphere ? inMap(beside, edge_) : glm::clamp(beside, 0, edge_ - 1);
            const int view = cell.y * edge_ + cell.x;
            const double product = glm::dot(this->direction(view), direction);
            if (product < largest || (product == largest && view > best)) continue;
            largest = product;
            best = view;
        }
    }
    return best;
}

std::optional<int> ViewSet::nearest(glm::dvec3 towardEye) const {
    const std::optional<glm::dvec3> towards = unit(towardEye);
    if (!towards) return std::nullopt;
    const glm::dvec3 query = asked(*towards);
    if (layout_ != Layout::canonical26) return nearestInGrid(query);
    const auto first = std::ranges::max_element(
        directions_, {}, [&](const glm::dvec3& one) { return glm::dot(one, query); });
    return static_cast<int>(first - directions_.begin());
}

std::optional<int> ViewSet::nearest(glm::dvec3 towardEye, const std::optional<int>& before) const {
    const std::optional<int> now = nearest(towardEye);
    if (!now || !before || *before < 0 || *before >= count()) return now;
    const glm::dvec3 query = asked(*unit(towardEye));
    const double gained =
        angleBetween(direction(*before), query) - angleBetween(direction(*now), query);
    return gained <= 2.0 * kMargin * spacing() ? before : now;
}

std::vector<ViewSet::Weighted> ViewSet::blend(glm::dvec3 towardEye) const {
    const std::optional<glm::dvec3> towards = unit(towardEye);
    if (!towards) return {};
    const glm::dvec3 query = asked(*towards);
    std::vector<Weighted> all;
    all.reserve(directions_.size());
    for (int view = 0; view < count(); ++view) {
        all.push_back({view, angleBetween(direction(view), query)});
    }
    // Of equal angles the first in order.
    std::ranges::partial_sort(all, all.begin() + 4, {},
                              [](const Weighted& one) { return std::pair(one.weight, one.view); });
    const double fourth = all[3].weight;
    all.resize(3);
    constexpr double kAtView = 1e-9;
    double sum = 0.0;
    for (Weighted& one : all) {
        one.weight = (fourth - one.weight) / std::max(one.weight, kAtView);
        sum += one.weight;
    }
    // All four equally near: the nearest alone.
    if (!(sum > 0.0)) return {{all.front().view, 1.0}};
    for (Weighted& one : all) one.weight /= sum;
    std::erase_if(all, [](const Weighted& one) { return !(one.weight > 0.0); });
    return all;
}

}  // namespace voxprite
