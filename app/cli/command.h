// A subcommand: it adds its options to the parser and, when it was chosen, says what to run.
//
// Wrong usage is a CLI::ParseError thrown while parsing or by run() (exit status 2); any other
// failure is an Error (exit status 1). What a command returns is printed by main: the JSON with
// --json, else the text.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace voxprite::cli {

using Json = nlohmann::ordered_json;

struct Report {
    Json json;
    std::string text;  // ends in a newline, or is empty
    // Set when the command failed although it has this to report (a promise that is not held): the
    // report is printed, then this, and the exit status is 1.
    std::optional<Error> failure = std::nullopt;
};

struct Command {
    std::function<Result<Report>()> run;
    bool json = false;
};

void addEdit(CLI::App& app, Command& command);
void addInspect(CLI::App& app, Command& command);
void addConvert(CLI::App& app, Command& command);
void addExport(CLI::App& app, Command& command);
void addPalette(CLI::App& app, Command& command);
void addRender(CLI::App& app, Command& command);
void addSheet(CLI::App& app, Command& command);
void addCompare(CLI::App& app, Command& command);
void addBench(CLI::App& app, Command& command);
void addTrade(CLI::App& app, Command& command);

// --json, which every command but `edit` has.
void addJsonFlag(CLI::App& app, Command& command);

// A text for JSON: file names may hold any bytes.
[[nodiscard]] Json textJson(const std::string& bytes);
[[nodiscard]] Json textJson(const std::filesystem::path& path);
// "  warning: ..." for each text of a list, a line each.
[[nodiscard]] std::string warningLines(const Json& warnings);

// Runs an Options-taking function when `sub` was chosen:
//     auto options = std::make_shared<Options>(); ...; runs(sub, command, options, inspect);
template <class Options>
void runs(CLI::App& sub, Command& command, std::shared_ptr<Options> options,
          Result<Report> (*function)(const Options&)) {
    sub.callback([&command, options, function] {
        command.run = [options, function] { return function(*options); };
    });
}

}  // namespace voxprite::cli
