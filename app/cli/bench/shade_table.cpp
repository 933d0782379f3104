#include <array>
#include <cstdio>

#include "app/cli/bench/tables.h"
#include "app/cli/text_table.h"

namespace voxprite::bench {

namespace {

std::string number(double value, const char* format) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

std::string shadeTable(const Json& figures) {
    std::vector<std::vector<std::string>> rows{
        {"model", "sigma", "processor, ns a hit: off / occlusion / shadow / both",
         "OpenGL, ms a frame", "pixels changed: occlusion / shadow / both", "FLIP",
         "voxel view, ms a frame: off / corners / rays / shadow"}};
    const auto append = [&](std::size_t column, const std::string& text) {
        std::string& cell = rows.back()[column];
        cell += (cell.empty() ? "" : " / ") + text;
    };
    for (const Json& figure : figures) {
        const bool off = figure["shade"] == "off";
        const bool sprite = figure["scene"] == "sprite";
        if (sprite && off) {
            rows.push_back(
                {figure["model"].get<std::string>(), cli::textOf(figure["sigma"].get<double>())});
            rows.back().resize(rows.front().size());
        }
        append(sprite ? 3 : 6, number(figure["ms"].get<double>(), "%.3g"));
        if (!sprite) continue;
        append(2, number(figure["ns_a_hit"].get<double>(), "%.0f"));
        if (off) continue;
        append(4, number(100.0 * figure["changed"].get<double>(), "%.0f %%"));
        append(5, number(figure["flip"].get<double>(), "%.3f"));
    }
    return cli::textOf(rows, cli::TableStyle::markdown);
}

}  // namespace voxprite::bench
