#include "core/io/colour_reduction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <tuple>

#include "core/base/oklab.h"

namespace voxprite {
namespace {

// More colours than these are looked at in cubes of 8 x 8 x 8 neighbours.
constexpr std::size_t kMaxPoints = 1 << 15;
constexpr int kRounds = 8;

using Vector = std::array<double, 3>;

std::uint32_t keyOf(Rgba8 colour) {
    return std::uint32_t{colour.x} << 24 | std::uint32_t{colour.y} << 16 |
           std::uint32_t{colour.z} << 8 | colour.w;
}

std::uint32_t cubeOf(Rgba8 colour) {
    return std::uint32_t{colour.x} >> 3 << 10 | std::uint32_t{colour.y} >> 3 << 5 |
           std::uint32_t{colour.z} >> 3;
}

Rgba8 centreOfCube(Rgba8 colour) {
    const auto centre = [](std::uint8_t byte) {
        return static_cast<std::uint8_t>((byte & ~7) | 4);
    };
    return {centre(colour.x), centre(colour.y), centre(colour.z), 255};
}

struct Point {
    Rgba8 colour{0};
    double weight = 0.0;
    OkLab lab;
    [[nodiscard]] Vector at() const { return {lab.lightness, lab.greenRed, lab.blueYellow}; }
};

// Weight, weighted sum and weighted sum of squares: what tells how far points are from their mean.
struct Moments {
    double weight = 0.0;
    Vector sum{};
    Vector squares{};

    void add(const Point& point) {
        const Vector at = point.at();
        weight += point.weight;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sum[axis] += point.weight * at[axis];
            squares[axis] += point.weight * at[axis] * at[axis];
        }
    }
    [[nodiscard]] Moments without(const Moments& part) const {
        Moments rest = *this;
        rest.weight -= part.weight;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            rest.sum[axis] -= part.sum[axis];
            rest.squares[axis] -= part.squares[axis];
        }
        return rest;
    }
    [[nodiscard]] double errorAlong(std::size_t axis) const {
        return weight > 0.0 ? std::max(0.0, squares[axis] - sum[axis] * sum[axis] / weight) : 0.0;
    }
    [[nodiscard]] double error() const { return errorAlong(0) + errorAlong(1) + errorAlong(2); }
    [[nodiscard]] OkLab mean() const { return {sum[0] / weight, sum[1] / weight, sum[2] / weight}; }
};

Moments momentsOf(std::span<const Point> points) {
    Moments moments;
    for (const Point& point : points) moments.add(point);
    return moments;
}

struct Group {
    std::span<Point> points;
    Moments moments;
    double error = 0.0;

    explicit Group(std::span<Point> of) : points(of), moments(momentsOf(of)) {
        error = points.size() > 1 ? moments.error() : 0.0;
    }
};

// Sorts the group's points along its longest axis and cuts them where the two parts are most at one
// with themselves.
std::size_t bestCut(Group& group) {
    std::size_t axis = 0;
    for (std::size_t other = 1; other < 3; ++other) {
        if (group.moments.errorAlong(other) > group.moments.errorAlong(axis)) axis = other;
    }
    std::ranges::sort(group.points, [axis](const Point& a, const Point& b) {
        return std::tuple(a.at()[axis], keyOf(a.colour)) <
               std::tuple(b.at()[axis], keyOf(b.colour));
    });
    Moments left;
    double least = std::numeric_limits<double>::infinity();
    std::size_t cut = 1;
    for (std::size_t k = 0; k + 1 < group.points.size(); ++k) {
        left.add(group.points[k]);
        const double error = left.error() + group.moments.without(left).error();
        if (error < least) {
            least = error;
            cut = k + 1;
        }
    }
    return cut;
}

std::vector<OkLab> firstMeans(std::span<Point> points, int limit) {
    std::vector<Group> groups{Group(points)};
    while (static_cast<int>(groups.size()) < limit) {
        const auto worst = std::ranges::max_element(groups, {}, &Group::error);
        if (worst->error <= 0.0) break;
        const std::span<Point> whole = worst->points;
        const std::size_t cut = bestCut(*worst);
        *worst = Group(whole.first(cut));
        groups.emplace_back(whole.subspan(cut));
    }
    std::vector<OkLab> means;
    for (const Group& group : groups) means.push_back(group.moments.mean());
    return means;
}

std::size_t nearest(const std::vector<OkLab>& places, const OkLab& lab) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double distance = squaredDistance(places[k], lab);
        if (distance < least) {
            least = distance;
            best = k;
        }
    }
    return best;
}

void improve(std::vector<OkLab>& means, std::span<const Point> points) {
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Moments> groups(means.size());
        for (const Point& point : points) groups[nearest(means, point.lab)].add(point);
        for (std::size_t k = 0; k < means.size(); ++k) {
            if (groups[k].weight > 0.0) means[k] = groups[k].mean();
        }
    }
}

// The colours that stand for the groups.
std::vector<Rgba8> representatives(const std::vector<OkLab>& means, std::span<const Point> points) {
    std::vector<double> least(means.size(), std::numeric_limits<double>::infinity());
    std::vector<Rgba8> chosen(means.size());
    for (const Point& point : points) {
        const std::size_t group = nearest(means, point.lab);
        const double distance = squaredDistance(means[group], point.lab);
        if (distance < least[group]) {
            least[group] = distance;
            chosen[group] = point.colour;
        }
    }
    std::vector<Rgba8> colours;
    for (std::size_t k = 0; k < means.size(); ++k) {
        if (std::isfinite(least[k])) colours.push_back(chosen[k]);
    }
    return colours;
}

// Greys first, then round the hues; each from dark to light.
void layOut(std::vector<Rgba8>& colours) {
    const auto place = [](Rgba8 colour) {
        constexpr double kGrey = 0.02;
        constexpr double kSectorDegrees = 30.0;
        const OkLab lab = okLabFrom(colour);
        const int sector =
            chromaOf(lab) < kGrey ? -1 : static_cast<int>(hueDegreesOf(lab) / kSectorDegrees);
        return std::tuple(sector, lab.lightness, keyOf(colour));
    };
    std::ranges::sort(colours, {}, place);
}

std::vector<Point> pointsOf(std::vector<ColourCount::Entry> entries) {
    std::ranges::sort(entries, {}, [](const ColourCount::Entry& e) { return keyOf(e.colour); });
    std::vector<Point> points;
    if (entries.size() <= kMaxPoints) {
        for (const ColourCount::Entry& entry : entries) {
            points.push_back({entry.colour, static_cast<double>(entry.times), {}});
        }
    } else {
        // The commonest colour of a cube stands for all of it.
        std::vector<ColourCount::Entry> commonest(std::size_t{1} << 15);
        std::vector<double> weights(commonest.size());
        for (const ColourCount::Entry& entry : entries) {
            const std::uint32_t cube = cubeOf(entry.colour);
            weights[cube] += static_cast<double>(entry.times);
            if (entry.times > commonest[cube].times) commonest[cube] = entry;
        }
        for (std::size_t cube = 0; cube < commonest.size(); ++cube) {
            if (weights[cube] > 0.0) points.push_back({commonest[cube].colour, weights[cube], {}});
        }
    }
    for (Point& point : points) point.lab = okLabFrom(point.colour);
    return points;
}

std::vector<Rgba8> chosenColours(const ColourCount& count, int limit) {
    std::vector<Point> points = pointsOf(count.entries());
    std::vector<OkLab> means = firstMeans(points, limit);
    improve(means, points);
    std::vector<Rgba8> colours = representatives(means, points);
    layOut(colours);
    return colours;
}

}  // namespace

void ColourCount::add(Rgba8 colour, std::uint64_t times) {
    if (times == 0) return;
    const auto [place, isNew] = places_.try_emplace(keyOf(colour), entries_.size());
    if (isNew) entries_.push_back({colour, 0});
    entries_[place->second].times += times;
}

std::uint8_t ReducedColours::indexOf(Rgba8 colour) const {
    if (const auto found = indices_.find(keyOf(colour)); found != indices_.end()) {
        return found->second;
    }
    const OkLab lab = okLabFrom(colour);
    int best = 1;
    for (int index = 2; index <= used; ++index) {
        const auto labAt = [&](int k) {
            return okLabFrom(palette.colours[static_cast<std::size_t>(k)]);
        };
        if (squaredDistance(labAt(index), lab) < squaredDistance(labAt(best), lab)) best = index;
    }
    return static_cast<std::uint8_t>(best);
}

std::optional<std::string> ReducedColours::warning() const {
    if (exact()) return std::nullopt;
    char distances[96];
    std::snprintf(distances, sizeof(distances), "%.1f %% on average, %.1f %% at most",
                  100.0 * meanDistance, 100.0 * maxDistance);
    return std::to_string(distinct) + " colours are reduced to the " + std::to_string(used) +
           " nearest that a palette holds (off by " + distances +
           " of the way from black to white)";
}

ReducedColours reduceColours(const ColourCount& count, int limit) {
    ReducedColours reduced;
    reduced.distinct = count.distinct();
    std::vector<Rgba8> colours;
    if (count.distinct() <= static_cast<std::size_t>(limit)) {
        for (const ColourCount::Entry& entry : count.entries()) colours.push_back(entry.colour);
    } else {
        colours = chosenColours(count, limit);
    }
    reduced.used = static_cast<int>(colours.size());
    std::vector<OkLab> labs;
    for (std::size_t k = 0; k < colours.size(); ++k) {
        reduced.palette.colours[k + 1] = colours[k];
        reduced.indices_.emplace(keyOf(colours[k]), static_cast<std::uint8_t>(k + 1));
        labs.push_back(okLabFrom(colours[k]));
    }
    if (reduced.exact()) return reduced;

    // So many colours that each alone would take long share the place of their cube.
    const bool inCubes = count.distinct() > kMaxPoints;
    std::unordered_map<std::uint32_t, std::uint8_t> ofCubes;
    double times = 0.0;
    for (const ColourCount::Entry& entry : count.entries()) {
        const OkLab lab = okLabFrom(entry.colour);
        std::uint8_t index = 0;
        if (inCubes) {
            std::uint8_t& ofCube = ofCubes[cubeOf(entry.colour)];
            if (ofCube == 0) {
                const OkLab centre = okLabFrom(centreOfCube(entry.colour));
                ofCube = static_cast<std::uint8_t>(nearest(labs, centre) + 1);
            }
            index = ofCube;
        } else {
            index = static_cast<std::uint8_t>(nearest(labs, lab) + 1);
        }
        index = reduced.indices_.try_emplace(keyOf(entry.colour), index).first->second;
        const double distance = std::sqrt(squaredDistance(labs[index - 1u], lab));
        reduced.meanDistance += distance * static_cast<double>(entry.times);
        reduced.maxDistance = std::max(reduced.maxDistance, distance);
        times += static_cast<double>(entry.times);
    }
    reduced.meanDistance /= times;
    return reduced;
}

}  // namespace voxprite
