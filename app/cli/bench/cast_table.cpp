#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/cli/bench/tables.h"
#include "app/cli/text_table.h"

namespace voxprite::bench {
namespace {

constexpr std::array kCasters{"nanovdb",   "openvdb", "octree_restart",
                              "dense_dda", "scalar",  "packet"};

std::string rounded(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), value < 100.0 ? "%.1f" : "%.0f", value);
    return text.data();
}

// One model under one kind of rays, by caster; `more` by all threads.
struct Row {
    std::string model, kind;
    std::map<std::string, double> rate, more;
};

std::vector<Row> rowsOf(const Json& figures) {
    std::vector<Row> rows;
    for (const Json& figure : figures) {
        if (!figure.contains("mrays_per_s")) continue;
        const std::string model = figure["model"], kind = figure["kind"];
        auto row = std::ranges::find_if(
            rows, [&](const Row& r) { return r.model == model && r.kind == kind; });
        if (row == rows.end()) row = rows.insert(rows.end(), Row{model, kind, {}, {}});
        auto& rates = figure["threads"] == 1 ? row->rate : row->more;
        rates[figure["caster"]] = figure["mrays_per_s"];
    }
    return rows;
}

}  // namespace

std::string castTable(const Json& figures) {
    std::vector<std::vector<std::string>> rows{{"model", "rays"}};
    for (const char* caster : kCasters) rows[0].push_back("`" + std::string(caster) + "`");
    rows[0].insert(rows[0].end(),
                   {"times `nanovdb`", "times `dense_dda`", "all threads, times one"});
    double logarithms = 0.0;
    int files = 0;
    for (const Row& row : rowsOf(figures)) {
        std::vector<std::string>& cells = rows.emplace_back();
        cells = {row.model, row.kind};
        const auto rateOf = [&](const char* caster) {
            const auto found = row.rate.find(caster);
            return found == row.rate.end() ? 0.0 : found->second;
        };
        for (const char* caster : kCasters)
            cells.push_back(rateOf(caster) > 0.0 ? rounded(rateOf(caster)) : "");
        const double ours = rateOf("packet");
        const auto times = [&](double other) {
            return ours > 0.0 && other > 0.0 ? rounded(ours / other) : std::string();
        };
        cells.push_back(times(rateOf("nanovdb")));
        cells.push_back(times(rateOf("dense_dda")));
        const auto more = row.more.find("packet");
        cells.push_back(more == row.more.end() || ours == 0.0 ? "" : rounded(more->second / ours));
        if (row.kind == "parallel" && row.model.find('/') != std::string::npos &&
            !row.model.starts_with("samples/")) {
            logarithms += std::log(ours / rateOf("nanovdb"));
            ++files;
        }
    }
    std::string text = cli::textOf(rows, cli::TableStyle::markdown);
    if (files > 0)
        text += "\nParallel rays over the corpus, geometric mean: " +
                rounded(std::exp(logarithms / files)) + " times `nanovdb`.\n";
    return text;
}

}  // namespace voxprite::bench
