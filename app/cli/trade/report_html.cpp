#include <algorithm>
#include <cmath>

#include "app/cli/text_table.h"
#include "app/cli/trade/plots.h"
#include "app/cli/trade/report.h"

namespace voxprite::trade {
namespace {

// Neutral, on a light page and on a dark one.
constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>voxprite: speed against accuracy</title>
<style>
:root { --page:#f3f3f2; --card:#fcfcfb; --ink:#202226; --dim:#5e636b; --hair:#dfe0e2; --best:#e6efe6; }
@media (prefers-color-scheme: dark) {
  :root { --page:#1b1d20; --card:#24272b; --ink:#e8e9eb; --dim:#a3a8b0; --hair:#3a3e44; --best:#2b3a30; }
}
* { box-sizing: border-box; }
body { margin:0; background:var(--page); color:var(--ink); font:15px/1.5 Inter,system-ui,sans-serif; }
main { max-width:1240px; margin:0 auto; padding:32px 24px 64px; }
h1 { font-size:26px; margin:0 0 4px; } h2 { font-size:21px; margin:40px 0 8px; }
p { margin:6px 0; } .dim { color:var(--dim); }
.plots { display:grid; grid-template-columns:repeat(auto-fit,minmax(540px,1fr)); gap:16px; margin:16px 0; }
figure { margin:0; background:var(--card); border:1px solid var(--hair); border-radius:8px; padding:8px; }
figcaption { color:var(--dim); font-size:13px; padding:0 8px 6px; }
svg { width:100%; height:auto; display:block; font-family:Inter,system-ui,sans-serif; }
.scroll { overflow-x:auto; background:var(--card); border:1px solid var(--hair); border-radius:8px; }
table { border-collapse:collapse; font-size:13px; width:100%; }
th,td { padding:4px 9px; text-align:right; white-space:nowrap; border-bottom:1px solid var(--hair); }
th { color:var(--dim); font-weight:600; } th:first-child,td:first-child { text-align:left; }
tr.best td { background:var(--best); } ul { margin:6px 0; padding-left:20px; }
.warn { border-left:3px solid #d55e00; padding-left:10px; }
</style>
</head>
<body><main>
)";

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    }
    return out;
}

// Names of files may hold any bytes, a page only UTF-8: what is none becomes U+FFFD.
std::string validUtf8(const std::string& bytes) {
    return Json::parse(Json(bytes).dump(-1, ' ', false, Json::error_handler_t::replace))
        .get<std::string>();
}

std::string percent(const std::optional<double>& share) {
    return share ? cli::percentText(*share) : "–";
}
std::string number(double value) {
    return std::isfinite(value) ? cli::textOf(value) : "–";
}
// 36 440
std::string whole(double value) {
    if (!std::isfinite(value)) return "–";
    std::string digits = std::to_string(std::llround(value));
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, "\u202f");
    return digits;
}
std::string mebibytes(double bytes) {
    return cli::textOf(std::round(bytes / 1048576.0 * 100.0) / 100.0);
}

// The mean over the sizes of what each has.
template <class Of>
std::optional<double> meanOf(const Point& point, Of of) {
    double sum = 0.0;
    int count = 0;
    for (const AtSize& at : point.bySize)
        if (const std::optional<double> value = of(at)) {
            sum += *value;
            ++count;
        }
    if (count == 0) return std::nullopt;
    return sum / count;
}

std::string row(const std::vector<std::string>& cells, const char* tag, bool best = false) {
    std::string out = best ? "<tr class=\"best\">" : "<tr>";
    for (const std::string& cell : cells)
        out += std::string("<") + tag + ">" + cell + "</" + tag + ">";
    return out + "</tr>\n";
}

std::string millisecondsText(const Point& point) {
    if (!std::isfinite(point.milliseconds())) return "–";
    const auto median = meanOf(point, [](const AtSize& at) {
        return std::optional<double>(at.costs->milliseconds.median);
    });
    const auto most = meanOf(
        point, [](const AtSize& at) { return std::optional<double>(at.costs->milliseconds.most); });
    return number(point.milliseconds()) + " <span class=\"dim\">(" + number(*median) + ", " +
           number(*most) + ")</span>";
}

std::string pointRow(const Point& point, bool best, const std::string& backend) {
    const auto of = [&](auto field) { return meanOf(point, field); };
    using Maybe = std::optional<double>;
    const std::string& by =
        point.bySize.front().costs ? point.bySize.front().costs->backend : backend;
    return row(
        {(best ? "● " : "") + escaped(point.name + minifiedText(point)) +
             (by == backend ? "" : " <span class=\"dim\">(" + by + ")</span>"),
         millisecondsText(point), whole(point.rays()), percent(point.error(Yardstick::sprite)),
         percent(of([](const AtSize& at) { return Maybe(at.sprite.flipWorst); })),
         percent(of([](const AtSize& at) { return Maybe(at.sprite.mismatch); })),
         percent(of([](const AtSize& at) { return at.sprite.voxels; })),
         percent(of([](const AtSize& at) { return Maybe(at.sprite.silhouette); })),
         percent(of([](const AtSize& at) { return Maybe(at.sprite.boundaryIou); })),
         percent(of([](const AtSize& at) { return at.sprite.outlineKept; })),
         percent(of([](const AtSize& at) { return at.sprite.outlineTrue; })),
         percent(point.error(Yardstick::perspective)), percent(of([](const AtSize& at) {
             return at.numbers ? Maybe(at.numbers->voxels) : Maybe();
         })),
         percent(of([](const AtSize& at) { return Maybe(at.time.changedADegree); })),
         percent(of([](const AtSize& at) { return Maybe(at.time.flipsADegree); })),
         percent(of([](const AtSize& at) { return Maybe(at.time.crawlADegree); })),
         mebibytes(of([](const AtSize& at) {
                       return at.costs ? Maybe(at.costs->bytes) : Maybe();
                   }).value_or(0.0)),
         number(of([](const AtSize& at) {
                    return at.costs ? Maybe(at.costs->prepareMilliseconds) : Maybe();
                }).value_or(0.0))},
        "td", best);
}

std::string pointTable(const Curve& curve) {
    const std::vector<std::size_t> front = paretoFront(curve, Yardstick::sprite);
    std::string out = "<div class=\"scroll\"><table>\n";
    out += row(
        {"setting", "ms a frame (median, most)", "rays", "FLIP", "worst view", "pixels", "voxels",
         "silhouette", "boundary IoU", "outline kept", "outline true", "FLIP, perspective",
         "rounding", "changed a degree", "flips", "crawl", "MiB", "prepare, ms"},
        "th");
    for (std::size_t k = 0; k < curve.points.size(); ++k)
        out += pointRow(curve.points[k], std::find(front.begin(), front.end(), k) != front.end(),
                        curve.backend);
    return out + "</table></div>\n";
}

// What the front says, in sentences.
std::string inShort(const Curve& curve) {
    std::string out = "<ul>\n";
    const auto say = [&](const std::string& sentence) { out += "<li>" + sentence + "</li>\n"; };
    const Point* game = nullptr;
    for (const Point& point : curve.points)
        if (point.axis == Axis::game) game = &point;
    if (game != nullptr)
        say("The game's own setting takes " + number(game->milliseconds()) + " ms a frame, " +
            whole(game->rays()) + " rays, and is " + percent(game->error(Yardstick::sprite)) +
            " (FLIP) off the exact sprite.");
    for (const double budget : {0.02, 0.05, 0.1, 0.2}) {
        const std::optional<std::size_t> best = cheapestWithin(curve, budget);
        if (!best) continue;
        const Point& point = curve.points[*best];
        std::string sentence = "Within " + percent(budget) + ": <b>" + escaped(point.name) +
                               "</b>, " + number(point.milliseconds()) + " ms";
        if (game != nullptr && game->milliseconds() > 0.0)
            sentence +=
                " (" + percent(point.milliseconds() / game->milliseconds()) + " of the game's own)";
        say(sentence + ", FLIP " + percent(point.error(Yardstick::sprite)) + ".");
    }
    return out + "</ul>\n";
}

std::string figuresOf(const std::vector<NamedPlot>& plots) {
    std::string out = "<div class=\"plots\">\n";
    for (const NamedPlot& named : plots)
        out += "<figure>" + plot::svgOf(plot::layOut(named.plot)) + "<figcaption>" +
               escaped(named.caption) + "</figcaption></figure>\n";
    return out + "</div>\n";
}

std::string growthSection(const TradeReport& report) {
    if (report.growth.empty()) return "";
    std::string out =
        "<h2>Costs that grow</h2>\n<p class=\"dim\">The exponent k of cost = c · "
        "size<sup>k</sup>, by least squares of the logarithms: 1 grows as the size, 2 "
        "as its square.</p>\n<div class=\"scroll\"><table>\n";
    out += row({"by", "from – to", "what", "ms", "exponent", "rays", "exponent", "MiB", "exponent"},
               "th");
    const auto exponent = [](const Growth& growth, double (*cost)(const Growth::Sample&)) {
        const std::optional<double> k = exponentOf(growth, cost);
        return k ? cli::textOf(std::round(100.0 * *k) / 100.0) : std::string("–");
    };
    for (const Growth& growth : report.growth) {
        if (growth.samples.empty()) {
            out += row({escaped(growth.title), "–", escaped(growth.notRun), "", "", "", "", "", ""},
                       "td");
            continue;
        }
        const Growth::Sample &first = growth.samples.front(), &last = growth.samples.back();
        const auto range = [](double a, double b) { return number(a) + " – " + number(b); };
        out +=
            row({escaped(growth.title),
                 plot::tickText(first.size) + " – " + plot::tickText(last.size) + " " +
                     escaped(growth.unit),
                 escaped(growth.what), range(millisecondsOf(first), millisecondsOf(last)),
                 exponent(growth, millisecondsOf), whole(first.rays) + " – " + whole(last.rays),
                 exponent(growth, raysOf), mebibytes(first.bytes) + " – " + mebibytes(last.bytes),
                 exponent(growth, bytesOf)},
                "td");
    }
    return out + "</table></div>\n" + figuresOf(plotsOf(report.growth));
}

std::string sizesText(const Plan& plan) {
    std::string sizes;
    for (const double size : plan.sizesPx)
        sizes += (sizes.empty() ? "" : " and ") + cli::textOf(2.0 * size);
    return sizes;
}

std::string skippedList(const ModelReport& model) {
    if (model.skipped.empty()) return "";
    std::string out = "<div class=\"warn\">Left out, for they cannot be drawn:<ul>\n";
    for (const Skipped& one : model.skipped)
        out += "<li>" + escaped(one.name + ": " + one.reason) + "</li>\n";
    return out + "</ul></div>\n";
}

std::string headOf(const TradeReport& report) {
    const auto text = [&](const char* key) {
        return report.machine.contains(key) && report.machine[key].is_string()
                   ? report.machine[key].get<std::string>()
                   : std::string("none");
    };
    std::string out = "<h1>Speed against accuracy</h1>\n<p class=\"dim\">voxprite " +
                      std::string(VOXPRITE_VERSION) + ", commit " + escaped(report.commit) + " · " +
                      escaped(text("cpu")) + ", " +
                      std::to_string(report.machine.value("cores", 0)) + " cores, " +
                      escaped(text("simd")) + " · OpenGL: " + escaped(text("gl")) + "</p>\n";
    if (!report.models.empty()) {
        const Plan& plan = report.models.front().plan;
        const bool recorded = !plan.recordedWay.empty();
        out += "<p class=\"dim\">Each setting is looked at from " + std::to_string(plan.views) +
               " seeded views (seed " + std::to_string(plan.seed) + ") and timed over a camera's " +
               (recorded ? "recorded way of " : "way of ") +
               std::to_string(recorded ? plan.recordedWay.size()
                                       : static_cast<std::size_t>(plan.frames)) +
               " frames" + (recorded ? "" : ", " + cli::textOf(plan.degreesAFrame) + "° each") +
               ", again and again; what was cast stays. Errors are FLIP at " +
               cli::textOf(plan.flipPixelsPerDegree) +
               " pixels a degree over what the model covers. Errors, rays and MiB are the same on "
               "every run and by both backends; milliseconds are this machine's.</p>\n";
    }
    if (!report.finished)
        out += "<p class=\"warn\">Stopped before all was measured: what was done is shown.</p>\n";
    return out;
}

}  // namespace

std::string htmlOf(const TradeReport& report) {
    std::string page = kHead + headOf(report);
    const std::vector<std::string> names = fileNames(report.models);
    for (std::size_t k = 0; k < report.models.size(); ++k) {
        const ModelReport& model = report.models[k];
        if (model.curve.points.empty()) continue;
        page += "<h2>" + escaped(model.curve.model) + "</h2>\n<p class=\"dim\">" +
                std::to_string(model.size.x) + " × " + std::to_string(model.size.y) + " × " +
                std::to_string(model.size.z) + ", " + whole(static_cast<double>(model.voxels)) +
                " voxels, octree " + mebibytes(static_cast<double>(model.octreeBytes)) +
                " MiB; sigma " + cli::textOf(model.curve.profile.sigma) + "; shown " +
                sizesText(model.plan) + " pixels wide; " + std::to_string(model.measured()) +
                " of " + std::to_string(model.settings) + " settings</p>\n";
        page += skippedList(model);
        page +=
            inShort(model.curve) + figuresOf(plotsOf(model, names[k])) + pointTable(model.curve);
        if (model.light && !model.light->points.empty())
            page += "<p>Light, against occlusion and shadow of strength " +
                    cli::textOf(kFullLight) + ":</p>\n" + pointTable(*model.light);
    }
    return validUtf8(page + growthSection(report) + "</main></body>\n</html>\n");
}

}  // namespace voxprite::trade
