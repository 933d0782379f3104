#include "app/cli/bench/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>

#include "app/cli/text_table.h"

namespace voxprite::bench {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
}

// Three digits.
std::string ms(const Json& figure, const char* key = "ms") {
    if (figure["ms"].is_null()) return "not run";
    std::array<char, 32> text{};
    const double value = figure[key].get<double>();
    std::snprintf(text.data(), text.size(),
                  value < 10.0    ? "%.2f"
                  : value < 100.0 ? "%.1f"
                                  : "%.0f",
                  value);
    return text.data();
}

std::string raysOf(const Json& figure) {
    return figure["ms"].is_null()
               ? ""
               : grouped(static_cast<std::uint64_t>(std::llround(figure["rays"].get<double>())));
}

std::string oneSpriteTable(const Json& figures) {
    Rows rows{{"model", "sigma", "`single_pass`, ms", "rays", "`sprite_buffer`, ms", "rays",
               "times faster"}};
    for (const Json& figure : figures) {
        if (figure["scene"] != "one_sprite") continue;
        if (figure["mode"] == "single_pass") {
            rows.push_back({figure["model"].get<std::string>(),
                            cli::textOf(figure["sigma"].get<double>()), ms(figure),
                            raysOf(figure)});
            continue;
        }
        rows.back().insert(rows.back().end(),
                           {ms(figure), raysOf(figure),
                            std::to_string(std::lround(figure["timesFaster"].get<double>()))});
    }
    return cli::textOf(rows, cli::TableStyle::markdown);
}

// View, camera and number of entities make a row.
using Row = std::tuple<std::string, std::string, int>;

std::string crowdTable(const Json& figures) {
    std::vector<std::string> columns;
    std::vector<Row> order;
    std::map<std::pair<Row, std::string>, const Json*> cells;
    for (const Json& figure : figures) {
        if (figure["scene"] != "crowd") continue;
        const double step = figure["viewStep"].get<double>();
        const std::string column =
            "`" + figure["mode"].get<std::string>() + "`" +
            (step > 0.0 ? " with view step " + cli::textOf(step) : std::string());
        const Row row{figure["view"].get<std::string>(), figure["camera"].get<std::string>(),
                      figure["entities"].get<int>()};
        if (std::ranges::find(columns, column) == columns.end()) columns.push_back(column);
        if (std::ranges::find(order, row) == order.end()) order.push_back(row);
        cells[{row, column}] = &figure;
    }
    std::ranges::sort(order);
    std::ranges::sort(columns);
    std::reverse(columns.begin(), columns.end());
    Rows rows{{"view", "camera", "entities"}};
    // Beside the median the mean, as rays are means: with a view step most frames cast nothing.
    const auto times = [](const Json& figure) {
        return figure["ms"].is_null() ? ms(figure) : ms(figure) + " (" + ms(figure, "meanMs") + ")";
    };
    for (const std::string& column : columns) {
        rows[0].push_back(column + ", ms (mean)");
        rows[0].emplace_back("rays");
    }
    for (const Row& row : order) {
        rows.push_back({std::get<0>(row), std::get<1>(row),
                        grouped(static_cast<std::uint64_t>(std::get<2>(row)))});
        for (const std::string& column : columns) {
            const auto cell = cells.find({row, column});
            rows.back().push_back(cell == cells.end() ? "" : times(*cell->second));
            rows.back().push_back(cell == cells.end() ? "" : raysOf(*cell->second));
        }
    }
    return cli::textOf(rows, cli::TableStyle::markdown);
}

std::string countOf(const Json& figure, const char* key) {
    return figure[key].is_null() ? "" : grouped(figure[key].get<std::uint64_t>());
}

std::string clusterBuildTable(const Json& figures) {
    Rows rows{{"model", "build, ms of one core", "clusters", "KiB", "triangles, finest", "level 1",
               "level 2", "level 3"}};
    for (const Json& figure : figures) {
        const bool level = figure.contains("level");
        if (figure.contains("build_ms") && figure["threads"] == 1) {
            const auto bytes = figure["bytes"].get<std::uint64_t>();
            rows.push_back({figure["model"].get<std::string>(),
                            cli::textOf(std::round(figure["processor_ms"].get<double>())),
                            countOf(figure, "clusters"), grouped(bytes / 1024)});
        } else if (figure.contains("refused")) {
            rows.push_back({figure["model"].get<std::string>(), "refused: too large"});
        } else if (level && figure["level"].get<int>() < 4) {
            rows.back().push_back(countOf(figure, "triangles"));
        }
    }
    for (std::vector<std::string>& row : rows) row.resize(rows[0].size());
    return cli::textOf(rows, cli::TableStyle::markdown);
}

std::string clusterBudgetTable(const Json& figures) {
    Rows rows{{"model", "budget, px", "clusters", "triangles", "outside the exact silhouette, px",
               "of it missing, px"}};
    for (const Json& figure : figures) {
        if (!figure.contains("overhang_px")) continue;
        rows.push_back({figure["model"].get<std::string>(),
                        cli::textOf(figure["budget_px"].get<double>()), countOf(figure, "clusters"),
                        countOf(figure, "triangles"), countOf(figure, "overhang_px"),
                        countOf(figure, "missing_px")});
    }
    return cli::textOf(rows, cli::TableStyle::markdown);
}

}  // namespace

std::string frameTables(const Json& figures) {
    return oneSpriteTable(figures) + "\n" + crowdTable(figures);
}

std::string clusterTables(const Json& figures) {
    return clusterBuildTable(figures) + "\n" + clusterBudgetTable(figures);
}

}  // namespace voxprite::bench
