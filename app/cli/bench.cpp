// voxprite bench: the performance figures of this machine.
#include "app/cli/bench/bench.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include "app/cli/bench/cluster_frames.h"
#include "app/cli/bench/convert_files.h"
#include "app/cli/bench/counters.h"
#include "app/cli/bench/ratios.h"
#include "app/cli/bench/tables.h"
#include "app/cli/command.h"
#include "commit.h"
#include "core/base/file.h"
#include "render/gl/context.h"

namespace voxprite::cli {
namespace {

constexpr std::array<const char*, 12> kParts{"cast",    "raycast", "bake",  "update",
                                             "memory",  "frame",   "shade", "clusters",
                                             "latency", "start",   "loops", "files"};

struct BenchOptions {
    std::vector<std::string> only;
    bool quick = false;
    bool markdown = false;
    std::optional<std::string> corpus;
    std::optional<std::string> against, keep;  // files of kept figures
};

Result<Json> readKept(const std::string& file) {
    const Result<std::string> text = readTextFile(file);
    if (!text) return Failure(text.error());
    Json kept = Json::parse(*text, nullptr, false);
    if (kept.is_discarded() || !kept.is_object() || kept.value("voxprite_figures", Json()) != 1)
        return failInFile(file, "no figures of voxprite bench (--keep writes them)");
    return kept;
}

// Ratios to what was kept and to the rivals; what is to be kept of this run, if it is whole.
void addRatios(const BenchOptions& options, const std::optional<Json>& kept, Report& report) {
    const Json run = report.json;
    if (kept) {
        const std::vector<bench::Ratio> ratios = bench::ratiosOf(run, *kept);
        const TableStyle style = options.markdown ? TableStyle::markdown : TableStyle::plain;
        report.text += "\n" + bench::ratioTable(ratios, *kept, style);
        report.json["ratios"] = bench::jsonOf(ratios);
    }
    if (!options.keep || report.failure) return;
    const Status written =
        writeFileAtomically(*options.keep, bench::keptFigures(run, VOXPRITE_COMMIT).dump(1) + "\n");
    if (!written) report.failure = inFile(written, *options.keep).error();
}

std::filesystem::path corpusOf(const BenchOptions& options) {
    if (options.corpus) return *options.corpus;
    const char* const variable = std::getenv("VOXPRITE_CORPUS");
    return variable != nullptr ? variable : "";
}

// One line a figure: "cast: model shell128, kind parallel, ...".
std::string describe(const Json& json) {
    std::ostringstream text;
    text << "machine: " << json["machine"].dump() << '\n';
    for (const char* part : kParts) {
        if (!json.contains(part)) continue;
        for (const Json& figure : json[part]) {
            text << part << ':';
            for (const auto& [key, value] : figure.items()) {
                text << ' ' << key << ' ';
                if (value.is_string())
                    text << value.get<std::string>();
                else if (value.is_number_float())
                    text << value.get<double>();
                else
                    text << value;
            }
            text << '\n';
        }
    }
    return text.str();
}

Result<Report> runBench(const BenchOptions& options) {
    const auto wanted = [&](const char* part) {
        return options.only.empty() || std::count(options.only.begin(), options.only.end(), part);
    };
    std::optional<Json> kept;
    if (options.against) {
        Result<Json> read = readKept(*options.against);
        if (!read) return Failure(read.error());
        kept = std::move(*read);
    }
    const bench::Effort effort{options.quick};
    const Result<std::vector<bench::BenchModel>> models =
        bench::benchModels(options.quick, corpusOf(options));
    if (!models) return Failure(models.error());

    Report report;
    report.json["machine"] = bench::machine();
    report.json["machine"]["counters"] = bench::describe(bench::HardwareCounters());
    report.json["machine"]["gl"] = nullptr;
    // OpenGL is not needed for the other parts, and may be missing on the machine.
    Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
    if (context) {
        report.json["machine"]["gl"] = gl::driverInfo().renderer + ", " + gl::driverInfo().version;
    } else if (wanted("raycast") || wanted("frame") || wanted("shade") || wanted("clusters") ||
               wanted("latency")) {
        return Failure(context.error());
    }
    using Part = Result<Json> (*)(const std::vector<bench::BenchModel>&, const bench::Effort&);
    constexpr std::array<Part, kParts.size()> run{
        bench::benchCast,    bench::benchRaycast, bench::benchBake,  bench::benchUpdate,
        bench::benchMemory,  bench::benchFrame,   bench::benchShade, bench::benchClusters,
        bench::benchLatency, bench::benchStart,   bench::benchLoops, bench::benchFiles};
    for (std::size_t k = 0; k < kParts.size(); ++k) {
        if (!wanted(kParts[k])) continue;
        Result<Json> figures = run[k](*models, effort);
        if (figures) {
            report.json[kParts[k]] = std::move(*figures);
            continue;
        }
        // The other parts took their time, too: they are printed all the same.
        Error error = std::move(figures.error());
        error.message = std::string(kParts[k]) + " could not be measured: " + error.message;
        if (!report.failure) report.failure = std::move(error);
    }
    if (options.markdown && report.json.contains("cast"))
        report.text += bench::castTable(report.json["cast"]);
    if (options.markdown && report.json.contains("raycast"))
        report.text += bench::raycastTable(report.json["raycast"]);
    if (options.markdown && report.json.contains("frame"))
        report.text += bench::frameTables(report.json["frame"]);
    if (options.markdown && report.json.contains("shade"))
        report.text += bench::shadeTable(report.json["shade"]);
    if (options.markdown && report.json.contains("clusters"))
        report.text += bench::clusterTables(report.json["clusters"]) + "\n" +
                       bench::clusterFrameTable(report.json["clusters"]);
    if (options.markdown && report.json.contains("files"))
        report.text += bench::fileTable(report.json["files"]);
    if (report.text.empty()) report.text = describe(report.json);
    addRatios(options, kept, report);
    return report;
}

}  // namespace

void addBench(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("bench", "Measure this machine");
    auto options = std::make_shared<BenchOptions>();
    sub.add_option("--only", options->only,
                   "Only these parts: cast, raycast, bake, update, memory, frame, shade, clusters, "
                   "latency, start, loops, files")
        ->delimiter(',')
        ->check(CLI::IsMember(std::vector<std::string>(kParts.begin(), kParts.end())))
        ->type_name("PART,...");
    sub.add_flag("--quick", options->quick, "Smaller models and fewer runs: under 30 seconds");
    sub.add_option("--corpus", options->corpus,
                   "A folder of real models beside the samples (else VOXPRITE_CORPUS)")
        ->type_name("DIR");
    sub.add_flag("--markdown", options->markdown,
                 "Rays, frames, shade, clusters and files as tables in Markdown");
    sub.add_option("--against", options->against,
                   "Print ratios to the figures kept there, and to the rivals of this run")
        ->type_name("FILE");
    sub.add_option("--keep", options->keep,
                   "Keep this run's figures there, for --against (if all of it could be measured)")
        ->type_name("FILE");
    addJsonFlag(sub, command);
    runs(sub, command, options, runBench);
}

}  // namespace voxprite::cli
