#include "app/cli/trade/report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/cli/text_table.h"
#include "app/cli/trade/plots.h"
#include "core/base/file.h"
#include "core/io/png.h"

namespace voxprite::trade {
namespace {

namespace fs = std::filesystem;

std::string rounded(double value) {
    return cli::textOf(std::round(100.0 * value) / 100.0);
}

std::string exponentText(const Growth& growth, double (*cost)(const Growth::Sample&)) {
    const std::optional<double> exponent = exponentOf(growth, cost);
    return exponent ? rounded(*exponent) : "";
}

}  // namespace

double millisecondsOf(const Growth::Sample& sample) {
    return sample.milliseconds.least;
}
double raysOf(const Growth::Sample& sample) {
    return sample.rays;
}
double bytesOf(const Growth::Sample& sample) {
    return sample.bytes;
}

std::optional<double> exponentOf(const Growth& growth, double (*cost)(const Growth::Sample&)) {
    double n = 0.0, sumX = 0.0, sumY = 0.0, sumXx = 0.0, sumXy = 0.0;
    for (const Growth::Sample& sample : growth.samples) {
        if (!(sample.size > 0.0) || !(cost(sample) > 0.0)) continue;
        const double x = std::log(sample.size), y = std::log(cost(sample));
        n += 1.0;
        sumX += x;
        sumY += y;
        sumXx += x * x;
        sumXy += x * y;
    }
    const double spread = n * sumXx - sumX * sumX;
    if (n < 3.0 || !(spread > 0.0)) return std::nullopt;
    const double exponent = (n * sumXy - sumX * sumY) / spread;
    // What does not grow has 0, and neither -0 nor what rounding leaves.
    return std::abs(exponent) < 1e-9 ? 0.0 : exponent;
}

std::string minifiedText(const Point& point) {
    std::vector<std::string> drawn;
    for (const AtSize& at : point.bySize) {
        if (!at.sigmaInForce || *at.sigmaInForce >= point.setting.sigma) continue;
        std::string sigma = cli::textOf(*at.sigmaInForce);
        if (std::find(drawn.begin(), drawn.end(), sigma) == drawn.end())
            drawn.push_back(std::move(sigma));
    }
    std::string text;
    for (const std::string& sigma : drawn) text += (text.empty() ? "" : " and ") + sigma;
    return text.empty() ? "" : ", drawn at sigma " + text;
}

std::string growthTable(const TradeReport& report) {
    std::vector<std::vector<std::string>> rows{
        {"by", "from", "to", "ms", "exponent", "rays", "exponent", "MiB", "exponent"}};
    for (const Growth& growth : report.growth) {
        if (growth.samples.empty()) continue;
        const Growth::Sample &first = growth.samples.front(), &last = growth.samples.back();
        rows.push_back(
            {growth.title + ", " + growth.unit, plot::tickText(first.size),
             plot::tickText(last.size),
             rounded(millisecondsOf(first)) + " ... " + rounded(millisecondsOf(last)),
             exponentText(growth, millisecondsOf),
             std::to_string(std::llround(first.rays)) + " ... " +
                 std::to_string(std::llround(last.rays)),
             exponentText(growth, raysOf),
             rounded(first.bytes / 1048576.0) + " ... " + rounded(last.bytes / 1048576.0),
             exponentText(growth, bytesOf)});
    }
    return rows.size() == 1 ? "" : cli::textOf(rows, cli::TableStyle::markdown);
}

std::string frontTable(const TradeReport& report) {
    std::vector<std::vector<std::string>> rows{
        {"model", "setting on the front", "ms", "rays", "FLIP", "voxels", "silhouette", "MiB"}};
    for (const ModelReport& model : report.models)
        for (const std::size_t k : paretoFront(model.curve, Yardstick::sprite)) {
            const Point& point = model.curve.points[k];
            double silhouette = 0.0, voxels = 0.0, bytes = 0.0;
            bool known = true;
            const auto sizes = static_cast<double>(point.bySize.size());
            for (const AtSize& at : point.bySize) {
                silhouette += at.sprite.silhouette / sizes;
                voxels += at.sprite.voxels.value_or(0.0) / sizes;
                known = known && at.sprite.voxels;
                bytes += at.costs->bytes / sizes;
            }
            rows.push_back({model.curve.model, point.name + minifiedText(point),
                            rounded(point.milliseconds()),
                            std::to_string(std::llround(point.rays())),
                            rounded(100.0 * point.error(Yardstick::sprite)) + " %",
                            known ? rounded(100.0 * voxels) + " %" : "",
                            rounded(100.0 * silhouette) + " %", rounded(bytes / 1048576.0)});
        }
    return rows.size() == 1 ? "" : cli::textOf(rows, cli::TableStyle::markdown);
}

Result<std::vector<std::string>> writeReport(const TradeReport& report, const std::string& folder) {
    std::vector<std::string> files;
    const auto keep = [&](const std::string& name, auto write) -> Status {
        const fs::path path = fs::path(folder) / name;
        if (Status written = write(path); !written) return inFile(written, path.string());
        files.push_back(path.string());
        return {};
    };
    const auto text = [&](const std::string& name, const std::string& content) {
        return keep(name, [&](const fs::path& path) { return writeFileAtomically(path, content); });
    };
    Status status = text("trade.json", jsonOf(report).dump(1) + "\n");
    if (status) status = text("trade.csv", csvOf(report));
    if (status) status = text("report.html", htmlOf(report));
    const std::vector<std::string> names = fileNames(report.models);
    std::vector<NamedPlot> plots;
    for (std::size_t k = 0; k < report.models.size(); ++k)
        for (NamedPlot& each : plotsOf(report.models[k], names[k]))
            plots.push_back(std::move(each));
    for (NamedPlot& each : plotsOf(report.growth)) plots.push_back(std::move(each));
    for (const NamedPlot& each : plots) {
        if (!status) break;
        status = keep(each.name + ".png", [&](const fs::path& path) {
            return writePngFile(path, plot::pictureOf(plot::layOut(each.plot)));
        });
    }
    if (!status) return Failure(status.error());
    return files;
}

}  // namespace voxprite::trade
