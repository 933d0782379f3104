// voxprite trade: what the choices of the sprite cost and gain, measured.
#include <algorithm>
#include <iomanip>
#include <sstream>

#include "app/cli/command.h"
#include "app/cli/conformance/conformance.h"

namespace voxprite::cli {
namespace {

struct Options {
    bool conformance = false;
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

Result<Report> runTrade(const Options& options) {
    Report report;
    std::vector<std::string> broken;
    if (options.conformance) addConformance(report, broken);
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
    figures.require_option(1, 0);
    addJsonFlag(sub, command);
    runs(sub, command, options, runTrade);
}

}  // namespace voxprite::cli
