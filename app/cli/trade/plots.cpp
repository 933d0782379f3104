#include "app/cli/trade/plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/cli/text_table.h"

namespace voxprite::trade {
namespace {

using plot::Datum;
using plot::Mark;
using plot::Plot;
using plot::Series;

struct Look {
    Rgba8 colour;
    Mark mark;
};
// Told apart by hue (Okabe & Ito, legible on light and dark) and by shape.
constexpr std::array<Look, kAxes> kLooks{{
    {{120, 124, 132, 255}, Mark::square},   // game
    {{0, 114, 178, 255}, Mark::disc},       // sigma
    {{204, 121, 167, 255}, Mark::diamond},  // mode
    {{213, 94, 0, 255}, Mark::triangle},    // view step
    {{0, 158, 115, 255}, Mark::square},     // proxy
    {{150, 110, 60, 255}, Mark::diamond},   // registration
    {{200, 160, 0, 255}, Mark::disc},       // light
    {{86, 180, 233, 255}, Mark::ring},      // snapshots
    {{0, 158, 115, 255}, Mark::triangle},   // levels
    {{204, 121, 167, 255}, Mark::cross},    // clusters
    {{190, 60, 60, 255}, Mark::cross},      // walk
    {{0, 114, 178, 255}, Mark::ring},       // mixed
}};
constexpr Rgba8 kFrontColour{128, 132, 140, 255};

std::string tipOf(const Point& point, Yardstick yardstick) {
    return point.name + ": FLIP " + cli::percentText(point.error(yardstick)) + ", " +
           cli::textOf(point.milliseconds()) + " ms, " +
           std::to_string(std::llround(point.rays())) + " rays a frame";
}

Series seriesOf(Axis axis, const std::string& name) {
    const Look& look = kLooks[static_cast<std::size_t>(axis)];
    Series series;
    series.name = name;
    series.colour = look.colour;
    series.mark = look.mark;
    return series;
}

glm::dvec2 spreadOver(const Point& point) {
    glm::dvec2 sum(0.0);
    for (const AtSize& at : point.bySize)
        sum += glm::dvec2(at.costs->milliseconds.least, at.costs->milliseconds.median);
    return sum / static_cast<double>(point.bySize.size());
}

// Error against cost: every setting, and the front of those that nothing beats.
NamedPlot frontPlot(const Curve& curve, Yardstick yardstick, const std::string& name,
                    const std::string& title, const std::string& caption) {
    NamedPlot named{name, caption, {}};
    Plot& plot = named.plot;
    plot.title = title;
    plot.x = {"milliseconds a frame (" + curve.backend +
                  "), least of the repeats; the line: to their median",
              true, false};
    plot.y = {
        std::string("FLIP against ") +
            (yardstick == Yardstick::sprite ? "the exact sprite" : "the full perspective view"),
        false, yardstick == Yardstick::sprite};
    const std::vector<std::size_t> front = paretoFront(curve, yardstick);
    Series stairs;
    stairs.name = "Pareto front";
    stairs.colour = kFrontColour;
    stairs.line = stairs.staircase = true;
    stairs.marks = false;
    for (const std::size_t k : front) {
        const Point& point = curve.points[k];
        stairs.data.push_back({point.milliseconds(), point.error(yardstick), {}, "", ""});
    }
    plot.series.push_back(std::move(stairs));
    for (const Axis axis : allAxes()) {
        Series series = seriesOf(axis, titleOf(axis));
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const Point& point = curve.points[k];
            if (point.axis != axis || !std::isfinite(point.milliseconds())) continue;
            if (point.bySize.front().costs->backend != curve.backend) continue;
            const bool best = std::find(front.begin(), front.end(), k) != front.end();
            series.data.push_back({point.milliseconds(), point.error(yardstick), spreadOver(point),
                                   tipOf(point, yardstick), best ? point.name : ""});
        }
        if (!series.data.empty()) plot.series.push_back(std::move(series));
    }
    return named;
}

// A figure along one axis, the game's own setting among the others.
Series along(const Curve& curve, Axis axis, double (*at)(const Setting&),
             double (*figure)(const Point&), Series series) {
    series.line = true;
    for (const Point& point : curve.points) {
        if (point.axis != axis && point.axis != Axis::game) continue;
        series.data.push_back({at(point.setting), figure(point), {}, point.name, ""});
    }
    std::sort(series.data.begin(), series.data.end(),
              [](const Datum& a, const Datum& b) { return a.x < b.x; });
    if (series.data.size() < 2) series.data.clear();
    return series;
}

double bySprite(const Point& point) {
    return point.error(Yardstick::sprite);
}
double byPerspective(const Point& point) {
    return point.error(Yardstick::perspective);
}
double changedOf(const Point& point) {
    double sum = 0.0;
    for (const AtSize& at : point.bySize) sum += at.time.changedADegree;
    return sum / static_cast<double>(point.bySize.size());
}

NamedPlot sigmaPlot(const Curve& curve, const std::string& prefix) {
    NamedPlot named{prefix + "-sigma",
                    "What sigma leaves out: against the perspective view the error falls as sigma "
                    "grows, until virtual pixels are as small as the screen's; against the game's "
                    "own sprite it is 0 at the game's own sigma.",
                    {}};
    named.plot.title = "Sigma";
    named.plot.x = {"sigma, virtual pixels a voxel", true, false};
    named.plot.y = {"FLIP", false, true};
    const auto sigma = [](const Setting& setting) { return setting.sigma; };
    named.plot.series = {
        along(curve, Axis::sigma, sigma, byPerspective,
              seriesOf(Axis::viewStep, "full perspective")),
        along(curve, Axis::sigma, sigma, bySprite, seriesOf(Axis::sigma, "game's own sprite"))};
    return named;
}

NamedPlot stepPlot(const Curve& curve, const std::string& prefix) {
    NamedPlot named{prefix + "-step",
                    "Snapped views: the wider the step, the farther off the true view. While the "
                    "camera turns pixels change less often, but more of them at once; over a few "
                    "steps that is about as many a degree.",
                    {}};
    named.plot.title = "View step";
    named.plot.x = {"degrees between the views shown", false, true};
    named.plot.y = {"share", false, true};
    const auto step = [](const Setting& setting) { return setting.viewStepDegrees; };
    named.plot.series = {
        along(curve, Axis::viewStep, step, bySprite, seriesOf(Axis::viewStep, "FLIP")),
        along(curve, Axis::viewStep, step, changedOf, seriesOf(Axis::sigma, "changed a degree"))};
    return named;
}

NamedPlot snapshotPlot(const Curve& curve, const std::string& prefix) {
    NamedPlot named{prefix + "-snapshots",
                    "Snapshots: more views are nearer to the true one. Those of the seed are "
                    "pictures of fixed resolution without outline.",
                    {}};
    named.plot.title = "Snapshots";
    named.plot.x = {"views in the set", true, false};
    named.plot.y = {"FLIP against the exact sprite", false, true};
    Series sprites = seriesOf(Axis::snapshots, "sprites");
    Series seeds = seriesOf(Axis::sigma, "seed, by resolution");
    sprites.line = true;
    for (const Point& point : curve.points) {
        if (point.axis != Axis::snapshots) continue;
        const bool sprite = point.setting.snapshotKind == SnapshotKind::sprite;
        const Result<ViewSet> views = ViewSet::named(point.setting.viewSet);
        if (!views) continue;
        (sprite ? sprites : seeds)
            .data.push_back({static_cast<double>(views->count()),
                             bySprite(point),
                             {},
                             point.name,
                             sprite ? "" : std::to_string(point.setting.snapshotPx) + " px"});
    }
    named.plot.series = {std::move(sprites), std::move(seeds)};
    return named;
}

bool empty(const NamedPlot& named) {
    return std::all_of(named.plot.series.begin(), named.plot.series.end(),
                       [](const Series& series) { return series.data.empty(); });
}

}  // namespace

std::vector<NamedPlot> plotsOf(const ModelReport& model, const std::string& prefix) {
    const Curve& curve = model.curve;
    std::vector<NamedPlot> plots;
    plots.push_back(frontPlot(curve, Yardstick::sprite, prefix + "-front",
                              "Speed against accuracy: " + curve.model,
                              "Left and low is better. On the grey line lie the settings that no "
                              "other beats; those right of it and above cost more for less."));
    plots.push_back(frontPlot(curve, Yardstick::perspective, prefix + "-style",
                              "What the style leaves out: " + curve.model,
                              "The same settings against the voxels themselves, a ray through each "
                              "screen pixel. Outline, grid and parallel rays are the style: no "
                              "sprite comes to 0. Clusters do nearly: they are no sprites, but the "
                              "voxels in perspective."));
    plots.push_back(sigmaPlot(curve, prefix));
    plots.push_back(stepPlot(curve, prefix));
    plots.push_back(snapshotPlot(curve, prefix));
    if (model.light)
        plots.push_back(frontPlot(*model.light, Yardstick::sprite, prefix + "-light",
                                  "Light left out: " + curve.model,
                                  "Occlusion and shadow of strength 0.6 are what is asked for; the "
                                  "settings leave them out."));
    plots.erase(std::remove_if(plots.begin(), plots.end(), empty), plots.end());
    return plots;
}

std::vector<NamedPlot> plotsOf(const std::vector<Growth>& growth) {
    std::vector<NamedPlot> plots;
    for (const Growth& one : growth) {
        if (one.samples.size() < 2) continue;
        NamedPlot named{"costs-" + one.key, one.what, {}};
        std::replace(named.name.begin(), named.name.end(), '_', '-');
        named.plot.title = "Cost by " + one.title;
        named.plot.x = {one.unit, true, false};
        named.plot.y = {"milliseconds, thousands of rays, MiB", true, false};
        struct Column {
            const char* name;
            double (*cost)(const Growth::Sample&);
            double unit;
            Axis look;
        };
        for (const Column& column : {Column{"ms", millisecondsOf, 1.0, Axis::viewStep},
                                     Column{"1000 rays", raysOf, 1000.0, Axis::sigma},
                                     Column{"MiB", bytesOf, 1048576.0, Axis::proxy}}) {
            const std::optional<double> exponent = exponentOf(one, column.cost);
            Series series = seriesOf(
                column.look,
                std::string(column.name) +
                    (exponent ? " ~ n^" + cli::textOf(std::round(100.0 * *exponent) / 100.0) : ""));
            series.line = true;
            for (const Growth::Sample& sample : one.samples)
                series.data.push_back({sample.size, column.cost(sample) / column.unit, {}, "", ""});
            named.plot.series.push_back(std::move(series));
        }
        plots.push_back(std::move(named));
    }
    return plots;
}

std::vector<std::string> fileNames(const std::vector<ModelReport>& models) {
    std::vector<std::string> names;
    std::set<std::string> taken{"costs"};  // plotsOf() the costs that grow
    for (const ModelReport& model : models) {
        std::string name;
        for (const char c : model.curve.model) {
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                               (c >= '0' && c <= '9') || c == '_';
            name += plain ? c : '-';
        }
        if (name.empty()) name = "model";
        std::string unique = name;
        for (int k = 2; !taken.insert(unique).second; ++k) unique = name + "-" + std::to_string(k);
        names.push_back(unique);
    }
    return names;
}

}  // namespace voxprite::trade
