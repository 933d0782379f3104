#include "app/cli/bench/ratios.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace voxprite::bench {
namespace {

// Counts that say what a figure is of. (Others are results, such as rays or triangles.)
constexpr std::array kCounts{"threads",  "entities", "viewStep", "sigma",    "depth",
                             "maxDepth", "edge",     "level",    "distance", "budget_px"};
// By whom: what has rivals.
constexpr std::array kWho{"caster", "baker", "mode", "by", "program"};
constexpr std::array kRivals{"nanovdb", "openvdb",     "dense_dda", "octree_restart",
                             "naive",   "single_pass", "seed"};

template <class List>
bool has(const List& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool isRival(const std::string& whoKey, const std::string& name) {
    return whoKey == "program" ? name != "voxprite" : has(kRivals, name);
}

bool isRate(const std::string& measure) {
    return measure.find("_per_s") != std::string::npos;
}

bool isMeasure(const std::string& key, const Json& value) {
    if (!value.is_number()) return false;
    return isRate(key) || key == "ms" || key == "us" || key == "ns_a_hit" || key.ends_with("_ms");
}

// One figure taken apart.
struct Figure {
    std::string what;   // with whom
    std::string group;  // without
    std::string who;
    bool rival = false;
    std::map<std::string, double> measures;
};

Figure figureOf(const Json& json) {
    Figure figure;
    const auto add = [](std::string& text, const std::string& more) {
        text += (text.empty() ? "" : ", ") + more;
    };
    for (const auto& [key, value] : json.items()) {
        if (isMeasure(key, value)) {
            if (value.get<double>() > 0.0) figure.measures[key] = value.get<double>();
        } else if (value.is_string()) {
            const std::string text = value.get<std::string>();
            add(figure.what, text);
            if (has(kWho, key)) {
                figure.who = text;
                figure.rival = isRival(key, text);
            } else {
                add(figure.group, text);
            }
        } else if (value.is_number() && has(kCounts, key)) {
            const std::string text = key + " " + cli::textOf(value.get<double>());
            add(figure.what, text);
            add(figure.group, text);
        }
    }
    return figure;
}

// How many times as fast `now` is.
double timesAsFast(const std::string& measure, double now, double other) {
    return isRate(measure) ? now / other : other / now;
}

template <class Each>
void forFigures(const Json& parts, Each each) {
    for (const auto& [part, figures] : parts.items()) {
        if (!figures.is_array()) continue;
        for (const Json& json : figures)
            if (json.is_object()) each(part, figureOf(json));
    }
}

}  // namespace

std::vector<Ratio> ratiosOf(const Json& run, const Json& kept) {
    using Key = std::array<std::string, 3>;  // part, of what, measure
    std::map<Key, double> then;
    if (kept.is_object() && kept.contains("figures"))
        forFigures(kept["figures"], [&](const std::string& part, const Figure& figure) {
            for (const auto& [measure, value] : figure.measures)
                then[{part, figure.what, measure}] = value;
        });
    std::map<Key, std::pair<double, std::string>> rivals;
    forFigures(run, [&](const std::string& part, const Figure& figure) {
        if (!figure.rival) return;
        for (const auto& [measure, value] : figure.measures) {
            auto& best = rivals[{part, figure.group, measure}];
            if (best.second.empty() || timesAsFast(measure, value, best.first) > 1.0)
                best = {value, figure.who};
        }
    });
    std::vector<Ratio> ratios;
    forFigures(run, [&](const std::string& part, const Figure& figure) {
        if (figure.rival) return;
        for (const auto& [measure, value] : figure.measures) {
            Ratio ratio{part, figure.what, measure, value, {}, {}, {}};
            if (const auto it = then.find({part, figure.what, measure}); it != then.end())
                ratio.toKept = timesAsFast(measure, value, it->second);
            if (const auto it = rivals.find({part, figure.group, measure}); it != rivals.end()) {
                ratio.toRival = timesAsFast(measure, value, it->second.first);
                ratio.rival = it->second.second;
            }
            ratios.push_back(std::move(ratio));
        }
    });
    return ratios;
}

Json keptFigures(const Json& run, const std::string& commit) {
    Json parts = Json::object();
    for (const auto& [part, figures] : run.items()) {
        if (!figures.is_array()) continue;
        for (const Json& json : figures) {
            if (!json.is_object()) continue;
            const Figure figure = figureOf(json);
            if (figure.rival || figure.measures.empty()) continue;
            Json small = Json::object();
            for (const auto& [key, value] : json.items()) {
                // Four digits are more than a time is worth.
                if (isMeasure(key, value))
                    small[key] = std::stod(cli::textOf(value.get<double>()));
                else if (value.is_string() || has(kCounts, key))
                    small[key] = value;
            }
            parts[part].push_back(std::move(small));
        }
    }
    return {{"voxprite_figures", 1},
            {"commit", commit},
            {"machine", run.value("machine", Json::object())},
            {"figures", std::move(parts)}};
}

std::string ratioTable(const std::vector<Ratio>& ratios, const Json& kept, cli::TableStyle style) {
    std::vector<std::vector<std::string>> rows{{"part", "of", "measure", "now",
                                                "times as fast as kept", "times as fast as a rival",
                                                "rival"}};
    const auto text = [](const std::optional<double>& ratio) {
        return ratio ? cli::textOf(std::round(100.0 * *ratio) / 100.0) : std::string();
    };
    for (const Ratio& one : ratios)
        rows.push_back({one.part, one.what, one.measure, cli::textOf(one.now), text(one.toKept),
                        text(one.toRival), one.rival});
    std::string head;
    if (kept.is_object() && kept.contains("machine"))
        head = "Kept: commit " + kept.value("commit", std::string("unknown")) + ", " +
               kept["machine"].value("cpu", std::string("unknown")) + "\n";
    return head + cli::textOf(rows, style);
}

Json jsonOf(const std::vector<Ratio>& ratios) {
    Json json = Json::array();
    for (const Ratio& one : ratios)
        json.push_back({{"part", one.part},
                        {"of", one.what},
                        {"measure", one.measure},
                        {"now", one.now},
                        {"to_kept", one.toKept ? Json(*one.toKept) : Json(nullptr)},
                        {"to_rival", one.toRival ? Json(*one.toRival) : Json(nullptr)},
                        {"rival", one.rival}});
    return json;
}

}  // namespace voxprite::bench
