// voxprite trade: what the choices of the sprite cost and gain, measured.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "app/cli/command.h"
#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/stability.h"

namespace voxprite::cli {
namespace {

struct Options {
    bool conformance = false;
    bool stability = false;
};

std::string textOf(double number) {
    std::ostringstream text;
    text << std::setprecision(4) << number;
    return text.str();
}

// Columns as wide as their widest cell, two blanks between.
std::string table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            text += row[k];
            if (k + 1 < row.size()) text += std::string(widths[k] - row[k].size() + 2, ' ');
        }
        text += '\n';
    }
    return text;
}

void addConformance(Report& report, std::vector<std::string>& broken) {
    const std::vector<conformance::Comparison> all = conformance::compareReadings();
    std::vector<std::vector<std::string>> rows{
        {"row", "what", "literal", "ours", "promised", "unit", "how measured"}};
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
    report.text += table(rows);
    Json& leftOut = report.json["left_out"] = Json::array();
    for (const conformance::LeftOut& row : conformance::rowsLeftOut()) {
        leftOut.push_back({{"row", row.row}, {"why", row.why}});
        report.text += "row " + std::to_string(row.row) + " is left out: " + row.why + '\n';
    }
}

void addStability(Report& report, std::vector<std::string>& broken) {
    std::vector<std::vector<std::string>> rows{
        {"sweep", "cases", "refused", "failures", "figure", "measured", "promised", "unit"}};
    Json& sweeps = report.json["stability"] = Json::array();
    std::string swept;
    for (const conformance::Sweep& sweep : conformance::sweepExtremes()) {
        Json figures = Json::array();
        const std::vector<std::string> head{sweep.key, std::to_string(sweep.cases),
                                            std::to_string(sweep.refused),
                                            std::to_string(sweep.failures)};
        rows.push_back(head);
        rows.back().resize(rows.front().size());
        for (std::size_t k = 0; k < sweep.figures.size(); ++k) {
            const conformance::Figure& figure = sweep.figures[k];
            const bool bounded = std::isfinite(figure.promised);
            if (k > 0) rows.push_back({"", "", "", "", "", "", "", ""});
            rows.back()[4] = figure.what;
            rows.back()[5] = textOf(figure.value);
            rows.back()[6] = bounded ? textOf(figure.promised) : "";
            rows.back()[7] = figure.unit;
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
        swept += sweep.key + ": " + sweep.what + '\n';
        if (!sweep.notRun.empty()) swept += sweep.key + " was not run: " + sweep.notRun + '\n';
    }
    report.text += table(rows) + swept;
}

Result<Report> runTrade(const Options& options) {
    Report report;
    std::vector<std::string> broken;
    if (options.conformance) addConformance(report, broken);
    if (options.stability) addStability(report, broken);
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
    auto options = std::make_shared<Options>();
    CLI::Option_group& figures = *sub.add_option_group("Figures");
    figures.add_flag("--conformance", options->conformance,
                     "The specification's literal reading against ours, decision by decision");
    figures.add_flag("--stability", options->stability,
                     "Views, sizes, places and inputs at their extremes, against what is promised");
    figures.require_option(1, 0);
    addJsonFlag(sub, command);
    runs(sub, command, options, runTrade);
}

}  // namespace voxprite::cli
