// voxprite trade: what the choices of the sprite cost and gain, measured.
#include <CLI/Error.hpp>
#include <algorithm>
#include <cmath>

#include "app/cli/command.h"
#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/representations.h"
#include "app/cli/conformance/snapshots.h"
#include "app/cli/conformance/stability.h"
#include "app/cli/conformance/temporal.h"
#include "app/cli/source.h"
#include "app/cli/text_table.h"
#include "app/cli/trade/command.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"

namespace voxprite::cli {
namespace {

struct TradeOptions {
    trade::ReportOptions report;
    std::vector<std::string> files;
    ReadOptions reading;
    bool conformance = false;
    bool stability = false;
    bool temporal = false;
    bool representations = false;
    bool snapshots = false;
    bool markdown = false;
    [[nodiscard]] TableStyle style() const {
        return markdown ? TableStyle::markdown : TableStyle::plain;
    }
};

void addConformance(const TradeOptions& options, Report& report, std::vector<std::string>& broken) {
    const std::vector<conformance::Comparison> all = conformance::compareReadings();
    std::vector<std::vector<std::string>> rows{
        {"row", "what goes wrong", "literal", "voxprite", "promised", "unit", "how measured"}};
    Json& figures = report.json["conformance"] = Json::array();
    for (const conformance::Comparison& one : all) {
        rows.push_back({std::to_string(one.row), one.what, textOf(one.literal), textOf(one.ours),
                        textOf(one.promised), one.unit, one.how});
        figures.push_back({{"row", one.row},
                           {"key", one.key},
                           {"what", one.what},
                           {"literal", one.literal},
                           {"ours", one.ours},
                           {"promised", one.promised},
                           {"unit", one.unit},
                           {"how", one.how},
                           {"held", one.held()}});
        if (!one.held()) broken.push_back("row " + std::to_string(one.row) + ", " + one.key);
    }
    report.text += textOf(rows, options.style());
}

// The figures of one sweep: a row each, its name and counts before the first.
void addSweep(const conformance::Sweep& sweep, std::vector<std::vector<std::string>>& rows,
              Json& sweeps, std::vector<std::string>& broken) {
    Json figures = Json::array();
    rows.push_back({sweep.key, sweep.what, std::to_string(sweep.cases),
                    std::to_string(sweep.refused), std::to_string(sweep.failures)});
    rows.back().resize(rows.front().size());
    for (std::size_t k = 0; k < sweep.figures.size(); ++k) {
        const conformance::Figure& figure = sweep.figures[k];
        const bool bounded = std::isfinite(figure.promised);
        if (k > 0) rows.emplace_back(rows.front().size());
        rows.back()[5] = figure.what;
        rows.back()[6] = textOf(figure.value);
        rows.back()[7] = bounded ? textOf(figure.promised) : "";
        rows.back()[8] = figure.unit;
        figures.push_back({{"key", figure.key},
                           {"what", figure.what},
                           {"value", figure.value},
                           {"promised", bounded ? Json(figure.promised) : Json(nullptr)},
                           {"unit", figure.unit},
                           {"held", figure.held()}});
        if (!figure.held()) broken.push_back(sweep.key + ", " + figure.key);
    }
    if (sweep.failures > 0) broken.push_back(sweep.key + ", " + sweep.failed);
    sweeps.push_back({{"key", sweep.key},
                      {"what", sweep.what},
                      {"cases", sweep.cases},
                      {"refused", sweep.refused},
                      {"failures", sweep.failures},
                      {"first_failure", sweep.failed},
                      {"not_run", sweep.notRun},
                      {"held", sweep.held()},
                      {"figures", std::move(figures)}});
}

void addStability(const TradeOptions& options, Report& report, std::vector<std::string>& broken) {
    std::vector<std::vector<std::string>> rows{{"sweep", "over", "cases", "refused", "failures",
                                                "figure", "measured", "promised", "unit"}};
    Json& sweeps = report.json["stability"] = Json::array();
    std::string notRun;
    for (const conformance::Sweep& sweep : conformance::sweepExtremes()) {
        addSweep(sweep, rows, sweeps, broken);
        if (!sweep.notRun.empty()) notRun += sweep.key + " was not run: " + sweep.notRun + '\n';
    }
    report.text += textOf(rows, options.style()) + notRun;
}

Result<std::vector<conformance::TurningModel>> turningModels(const TradeOptions& options) {
    if (options.files.empty()) return conformance::turningSubjects();
    std::vector<conformance::TurningModel> models;
    for (const std::string& file : options.files) {
        Result<LoadedDocument> loaded =
            loadSource(file, std::nullopt, std::nullopt, options.reading);
        if (!loaded) return Failure(loaded.error());
        const VoxelGrid voxels = flatten(loaded->document, 0);
        if (voxels.empty()) return failInFile(file, "its first frame has no voxels to turn");
        Result<Octree> octree = bake(voxels);
        if (!octree) return Failure(inFile(std::move(octree), file).error());
        models.push_back({std::filesystem::path(file).stem().string(), std::move(*octree),
                          std::move(loaded->document.palette)});
    }
    return models;
}

Status addTemporal(const TradeOptions& options, Report& report) {
    const auto models = turningModels(options);
    if (!models) return Failure(models.error());
    std::vector<std::vector<std::string>> rows{{"view step", "frames that change",
                                                "of a sprite, in such a frame", "a degree",
                                                "off the exact view", "while trembling"}};
    Json& figures = report.json["temporal"] = Json::array();
    const auto percent = [](double value) { return textOf(value) + " %"; };
    for (const conformance::TurnFigures& one : conformance::measureTurns(
             *models, {0.0, 0.5, 1.0, 1.5, 2.5, 3.0, 5.0, 7.5, 9.0, 11.25, 15.0})) {
        rows.push_back({textOf(one.stepDegrees), percent(one.framesChanged),
                        percent(one.changedAFrame), percent(one.changedADegree),
                        percent(one.offTheExact), percent(one.changedByTremble)});
        figures.push_back({{"viewStep", one.stepDegrees},
                           {"frames_changed", one.framesChanged},
                           {"changed_a_frame", one.changedAFrame},
                           {"changed_a_degree", one.changedADegree},
                           {"off_the_exact", one.offTheExact},
                           {"frames_changed_trembling", one.changedByTremble}});
    }
    report.text += textOf(rows, options.style());
    return {};
}

// Error and cost, a column a size.
Status addRepresentations(const TradeOptions& options, Report& report) {
    const auto models = turningModels(options);
    if (!models) return Failure(models.error());
    const std::vector<double> sizesPx{4, 8, 16, 32, 64, 128};
    const auto all = conformance::measureRepresentationRows(*models, sizesPx, 8);
    if (!all) return Failure(all.error());
    std::vector<std::vector<std::string>> rows{{"model", "drawn by"}};
    for (const double sizePx : sizesPx) rows.front().push_back(textOf(2.0 * sizePx) + " px high");
    Json& figures = report.json["representations"] = Json::array();
    for (const conformance::RepresentationRow& one : *all) {
        std::vector<std::string>& row = rows.emplace_back();
        row = {one.model, one.name};
        Json bySize = Json::array();
        for (const RepresentationFigures::AtSize& at : one.figures.bySize) {
            const bool exact = one.figures.choice.kind == Representation::sprite;
            row.push_back((exact ? "" : textOf(std::round(1000.0 * at.error) / 10.0) + " %, ") +
                          textOf(std::round(at.microseconds)) + " µs");
            bySize.push_back(
                {{"radius_px", at.sizePx}, {"error", at.error}, {"us", at.microseconds}});
        }
        figures.push_back({{"model", one.model}, {"drawn_by", one.name}, {"sizes", bySize}});
    }
    report.text += textOf(rows, options.style());
    return {};
}

Status addSnapshots(const TradeOptions& options, Report& report) {
    const auto models = turningModels(options);
    if (!models) return Failure(models.error());
    const auto rounded = [](double value) { return textOf(std::round(10.0 * value) / 10.0); };
    std::vector<std::vector<std::string>> rows{{"kind", "views", "degrees off"}};
    for (const double screenPx : conformance::kSnapshotDistances)
        rows.front().push_back(textOf(screenPx) + " px a virtual pixel");
    rows.front().insert(rows.front().end(), {"MiB", "ms"});
    Json& figures = report.json["snapshots"] = Json::array();
    for (const conformance::SnapshotFigures& one : conformance::measureSnapshots(*models)) {
        std::vector<std::string>& row = rows.emplace_back();
        row = {one.kind, one.set, rounded(one.meanDegreesOff)};
        Json byDistance = Json::array();
        for (const conformance::SnapshotFigures::Unlike& unlike : one.unlike) {
            const bool voxels = std::isfinite(unlike.voxels);
            row.push_back(textOf(std::round(1000.0 * unlike.flip) / 1000.0) + ", " +
                          rounded(unlike.silhouette) + " %" +
                          (voxels ? ", " + rounded(unlike.voxels) + " %" : ""));
            byDistance.push_back({{"flip", unlike.flip},
                                  {"silhouette", unlike.silhouette},
                                  {"voxels", voxels ? Json(unlike.voxels) : Json(nullptr)}});
        }
        row.push_back(rounded(one.bytes / (1 << 20)));
        row.push_back(textOf(std::round(one.milliseconds)));
        figures.push_back({{"kind", one.kind},
                           {"view_set", one.set},
                           {"views", one.views},
                           {"degrees_off", one.meanDegreesOff},
                           {"distances", std::move(byDistance)},
                           {"bytes", one.bytes},
                           {"ms", one.milliseconds}});
    }
    report.text += textOf(rows, options.style());
    return {};
}

Result<Report> runTrade(const TradeOptions& options) {
    const bool figures = options.conformance || options.stability || options.temporal ||
                         options.representations || options.snapshots;
    if (options.report.folder.empty() && !figures)
        throw CLI::ValidationError("--output", "is needed, or one of the figures");
    if (options.reading.entity && options.files.empty())
        throw CLI::ValidationError("--entity", "needs FILES");
    if (!options.report.folder.empty()) {
        if (figures) throw CLI::ValidationError("--output", "excludes the figures");
        trade::ReportOptions report = options.report;
        report.files = options.files;
        report.reading = options.reading;
        report.markdown = options.markdown;
        return trade::reportTrade(report);
    }
    if (!options.files.empty() && !options.temporal && !options.representations &&
        !options.snapshots) {
        throw CLI::ValidationError("FILES",
                                   "are for --temporal, --representations and --snapshots");
    }
    Report report;
    std::vector<std::string> broken;
    if (options.conformance) addConformance(options, report, broken);
    if (options.stability) addStability(options, report, broken);
    if (options.temporal) {
        if (Status status = addTemporal(options, report); !status) return Failure(status.error());
    }
    if (options.snapshots) {
        if (Status status = addSnapshots(options, report); !status) return Failure(status.error());
    }
    if (options.representations) {
        if (Status status = addRepresentations(options, report); !status) {
            return Failure(status.error());
        }
    }
    if (!broken.empty()) {
        std::string message = "not held: ";
        for (std::size_t k = 0; k < broken.size(); ++k) message += (k > 0 ? "; " : "") + broken[k];
        report.failure = fail(message).value();
    }
    return report;
}

}  // namespace

void addTrade(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("trade", "Measure what the sprite's choices cost and gain");
    auto options = std::make_shared<TradeOptions>();
    CLI::Option_group& figures = *sub.add_option_group("Figures");
    figures.add_flag("--conformance", options->conformance,
                     "The specification's literal reading against ours, decision by decision");
    figures.add_flag("--stability", options->stability,
                     "Views, sizes, places and inputs at their extremes, against what is promised");
    figures.add_flag("--temporal", options->temporal,
                     "Pixels that change while the camera turns slowly, for several view steps");
    figures.add_flag("--representations", options->representations,
                     "Error and cost of what stands for a sprite, by size on the screen");
    figures.add_flag("--snapshots", options->snapshots,
                     "Snapshots against the exact sprite, by their views and by distance");
    trade::addReportOptions(sub, options->report);
    sub.add_option("FILES", options->files,
                   "Models: those of the report; for --temporal, --representations and --snapshots "
                   "(else some made for the purpose)");
    addEntityOption(sub, options->reading);
    sub.add_flag("--markdown", options->markdown, "Tables as Markdown");
    addJsonFlag(sub, command);
    runs(sub, command, options, runTrade);
}

}  // namespace voxprite::cli
