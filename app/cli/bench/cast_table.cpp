#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>

#include "app/cli/bench/tables.h"
#include "app/cli/text_table.h"

namespace voxprite::bench {
namespace {

// Ours is "packet"; by one thread.
constexpr std::array kOthers{"scalar", "nanovdb", "openvdb", "octree_restart", "dense_dda"};
constexpr std::array kKinds{"parallel", "perspective"};

std::string rounded(double value, double wholeFrom) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), value < wholeFrom ? "%.1f" : "%.0f", value);
    return text.data();
}

// Million rays a second of a model, by kind of rays, caster and threads.
struct Row {
    std::string model;
    std::map<std::tuple<std::string, std::string, int>, double> rates;
    std::string sprite;  // "340 / 200": microseconds of one, by one thread and by all

    // 0: not measured.
    [[nodiscard]] double rate(const std::string& kind, const std::string& caster,
                              int threads) const {
        const auto found = rates.find({kind, caster, threads});
        return found == rates.end() ? 0.0 : found->second;
    }
    // "346 / 120": parallel and eye rays; empty where neither was measured.
    template <class Of>
    [[nodiscard]] static std::string both(double wholeFrom, Of of) {
        std::string text;
        bool any = false;
        for (const char* kind : kKinds) {
            const double value = of(std::string(kind));
            any = any || value > 0.0;
            text += (text.empty() ? "" : " / ") + (value > 0.0 ? rounded(value, wholeFrom) : "-");
        }
        return any ? text : "";
    }
};

}  // namespace

std::string castTable(const Json& figures) {
    std::vector<Row> table;
    std::set<int> threads;
    for (const Json& figure : figures) {
        const std::string model = figure["model"];
        auto row = std::ranges::find(table, model, &Row::model);
        if (row == table.end()) row = table.insert(table.end(), Row{model, {}, {}});
        if (figure["kind"] == "sprite") {
            const double microseconds = 1000.0 * figure["ms"].get<double>();
            const double times = figure["times_one_thread"];
            row->sprite =
                rounded(microseconds, 100.0) + " / " + rounded(microseconds / times, 100.0);
            continue;
        }
        const int count = figure["threads"];
        threads.insert(count);
        row->rates[{figure["kind"], figure["caster"], count}] = figure["mrays_per_s"];
    }
    std::vector<std::vector<std::string>> rows{{"model"}};
    for (const int count : threads)
        rows[0].push_back(count == 1 ? "packets"
                                     : "packets, " + std::to_string(count) + " threads");
    rows[0].insert(rows[0].end(), kOthers.begin(), kOthers.end());
    rows[0].emplace_back("times nanovdb");
    rows[0].emplace_back("sprite, µs");
    double logarithms = 0.0;
    int files = 0;
    for (const Row& row : table) {
        std::vector<std::string>& cells = rows.emplace_back();
        cells = {row.model};
        for (const int count : threads)
            cells.push_back(Row::both(
                100.0, [&](const std::string& kind) { return row.rate(kind, "packet", count); }));
        for (const char* caster : kOthers)
            cells.push_back(Row::both(
                100.0, [&](const std::string& kind) { return row.rate(kind, caster, 1); }));
        const auto times = [&](const std::string& kind) {
            const double theirs = row.rate(kind, "nanovdb", 1);
            return theirs > 0.0 ? row.rate(kind, "packet", 1) / theirs : 0.0;
        };
        cells.push_back(Row::both(1e9, times));
        cells.push_back(row.sprite);
        const bool corpus =
            row.model.find('/') != std::string::npos && !row.model.starts_with("samples/");
        if (!corpus || !(times("parallel") > 0.0)) continue;
        logarithms += std::log(times("parallel"));
        ++files;
    }
    std::string text = cli::textOf(rows, cli::TableStyle::markdown);
    if (files > 0)
        text += "\nParallel rays over the corpus, geometric mean: " +
                rounded(std::exp(logarithms / files), 1e9) + " times `nanovdb`.\n";
    return text;
}

}  // namespace voxprite::bench
