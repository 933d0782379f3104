
#include "app/cli/bench/tables.h"
#include "app/cli/text_table.h"

namespace voxprite::bench {

std::string raycastTable(const Json& figures) {
    std::vector<std::vector<std::string>> rows{{"model", "depth", "cast down to",
                                                "nodes passed a ray", "Mrays/s, 1 thread",
                                                "all threads", "OpenGL", "full screen, ms"}};
    std::size_t threads = 0;  // figures of the processor in this row
    for (const Json& figure : figures) {
        const std::string by = figure["by"].get<std::string>();
        if (by == "cpu" && figure["threads"] == 1) {
            threads = 0;
            rows.push_back({figure["model"].get<std::string>(), figure["depth"].dump(),
                            figure["maxDepth"].dump(),
                            cli::textOf(figure["iterations_a_ray"].get<double>())});
        }
        std::vector<std::string>& row = rows.back();
        if (by == "gl" && threads == 1) row.push_back(row.back());  // one core is all
        if (by == "cpu") ++threads;
        row.push_back(cli::textOf(figure[by == "frame" ? "ms" : "mrays_per_s"].get<double>()));
    }
    return cli::textOf(rows, cli::TableStyle::markdown);
}

}  // namespace voxprite::bench
