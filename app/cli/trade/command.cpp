#include "app/cli/trade/command.h"

#include <CLI/Error.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/arguments.h"
#include "app/cli/outputs.h"
#include "app/cli/text_table.h"
#include "app/cli/trade/camera_way.h"
#include "app/cli/trade/run.h"
#include "core/io/profile_json.h"

namespace voxprite::trade {
namespace {

std::vector<Axis> axesOf(const std::vector<std::string>& names) {
    if (names.empty()) return allAxes();
    std::vector<Axis> axes{Axis::game};
    for (const Axis axis : allAxes())
        if (axis != Axis::game &&
            std::find(names.begin(), names.end(), nameOf(axis)) != names.end())
            axes.push_back(axis);
    return axes;
}

// What a budget asks for, and what was found.
struct Choice {
    Yardstick yardstick = Yardstick::sprite;
    std::string asked;
    std::optional<std::size_t> best;         // of all settings
    std::optional<std::size_t> bestProfile;  // of those that a profile can say
};

Choice choose(const ReportOptions& options, const Curve& curve) {
    Wish wish;
    wish.yardstick =
        options.yardstick == "perspective" ? Yardstick::perspective : Yardstick::sprite;
    Choice choice;
    choice.yardstick = wish.yardstick;
    const auto found = [&](bool profileOnly) {
        wish.profileOnly = profileOnly;
        return options.budgetError ? cheapestWithin(curve, *options.budgetError, wish)
                                   : bestWithin(curve, *options.budgetMs, wish);
    };
    choice.asked = options.budgetError ? "an error of " + cli::percentText(*options.budgetError)
                                       : cli::textOf(*options.budgetMs) + " ms a frame";
    choice.best = found(false);
    choice.bestProfile = found(true);
    return choice;
}

cli::Json jsonOf(const Curve& curve, const std::optional<std::size_t>& at) {
    if (!at) return nullptr;
    const Point& point = curve.points[*at];
    return {{"name", point.name},
            {"setting", jsonOf(point.setting)},
            {"ms", point.milliseconds()},
            {"rays", point.rays()},
            {"flip",
             {{"sprite", point.error(Yardstick::sprite)},
              {"perspective", point.error(Yardstick::perspective)}}}};
}

std::string sentence(const Curve& curve, const std::optional<std::size_t>& at,
                     Yardstick yardstick) {
    if (!at) return "nothing that was measured";
    const Point& point = curve.points[*at];
    return point.name + " (" + cli::textOf(point.milliseconds()) + " ms, " +
           std::to_string(std::llround(point.rays())) + " rays, FLIP " +
           cli::percentText(point.error(yardstick)) +
           (yardstick == Yardstick::sprite ? " off the exact sprite)" : " off the perspective)");
}

// Adds what the budget chooses to the report, and writes the profile that was asked for.
Status addChoice(const ReportOptions& options, const TradeReport& measured, cli::Report& report) {
    const Curve curve = combined(measured.models);
    const Choice choice = choose(options, curve);
    report.json["choice"] = {{"within", choice.asked},
                             {"yardstick", nameOf(choice.yardstick)},
                             {"best", jsonOf(curve, choice.best)},
                             {"best_of_profile", jsonOf(curve, choice.bestProfile)},
                             {"profile", nullptr}};
    report.text +=
        "Within " + choice.asked + ": " + sentence(curve, choice.best, choice.yardstick) + "\n";
    if (choice.best != choice.bestProfile)
        report.text += "  of what a game profile can say: " +
                       sentence(curve, choice.bestProfile, choice.yardstick) + "\n";
    if (!options.writeProfile) return {};
    if (!choice.bestProfile)
        return failInFile(*options.writeProfile,
                          "not written: no setting that was measured is within " + choice.asked);
    const GameProfile profile =
        profileWith(curve.profile, curve.points[*choice.bestProfile].setting);
    if (Status written = writeProfileFile(*options.writeProfile, profile); !written) return written;
    report.json["choice"]["profile"] = cli::textJson(*options.writeProfile);
    report.text += "  written: " + *options.writeProfile + "\n";
    return {};
}

// What could not be drawn: settings, as warnings; and whole models, which is a failure.
void addLeftOut(const TradeReport& measured, cli::Report& report) {
    cli::Json& warnings = report.json["warnings"] = cli::Json::array();
    for (const ModelReport& model : measured.models)
        for (const Skipped& one : model.skipped)
            warnings.push_back(
                cli::textJson(model.curve.model + ", " + one.name + ": " + one.reason));
    for (std::size_t k = 1; k < measured.failures.size(); ++k)
        warnings.push_back(cli::textJson(measured.failures[k].describe()));
    report.text += cli::warningLines(warnings);
    if (!measured.failures.empty()) report.failure = measured.failures.front();
}

std::optional<std::uint64_t> seedFrom(std::string_view text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return seed;
}

void checkUsage(const ReportOptions& options) {
    const bool budget = options.budgetMs || options.budgetError;
    if (options.files.empty() && !options.costs)
        throw CLI::ValidationError("FILES", "are needed: which models to measure");
    if (options.budgetMs && options.budgetError)
        throw CLI::ValidationError("--budget-ms", "excludes --budget-error");
    if (budget && options.files.empty())
        throw CLI::ValidationError("FILES", "are needed for a budget");
    if (options.budgetMs && *options.budgetMs < 0.0)
        throw CLI::ValidationError("--budget-ms", "must be 0 or more");
    if (options.budgetError && (*options.budgetError < 0.0 || *options.budgetError > 1.0))
        throw CLI::ValidationError("--budget-error", "must be 0 to 1");
    if (!options.writeProfile) return;
    if (!budget)
        throw CLI::ValidationError("--write-profile", "needs --budget-ms or --budget-error");
    const cli::Output profile{"--write-profile", *options.writeProfile};
    // The game's own profile may be written again.
    std::vector<std::string> inputs = options.files;
    if (options.way) inputs.push_back(*options.way);
    cli::checkEnding(profile, {".json"});
    cli::checkReplacesNone(profile, inputs);
}

}  // namespace

void addReportOptions(CLI::App& sub, ReportOptions& options) {
    std::vector<std::string> names;
    for (const Axis axis : allAxes())
        if (axis != Axis::game) names.emplace_back(nameOf(axis));
    CLI::Option_group& group = *sub.add_option_group("Report");
    CLI::Option* const output =
        group
            .add_option(
                "-o,--output", options.folder,
                "Measure every setting of FILES and write trade.json, trade.csv, report.html "
                "and plots there")
            ->type_name("DIR");
    group.add_flag("--quick", options.quick, "Fewer settings and views: under 30 s a small model");
    cli::addParsed(group, "--seed", "N", "Of the views: the same seed gives the same errors",
                   seedFrom, [&options](std::uint64_t seed) { options.seed = seed; });
    group
        .add_option("--axes", options.axes, "Only these: sigma, view_step, snapshots, levels, ...")
        ->delimiter(',')
        ->check(CLI::IsMember(names))
        ->type_name("AXIS,...");
    group.add_option("--profile", options.profile, "The game's own (else the file's values)")
        ->type_name("FILE");
    group
        .add_option("--way", options.way,
                    "A camera's recorded way, for times and restlessness (else one made up)")
        ->type_name("FILE");
    group
        .add_option("--backend", options.backend, "What is timed: gl where there is OpenGL, or cpu")
        ->check(CLI::IsMember({"auto", "cpu", "gl"}));
    group.add_flag("--costs", options.costs,
                   "Costs that grow, too: with model, sigma, screen and crowd");
    cli::addParsed(group, "--budget-ms", "MS",
                   "Say the most accurate setting that takes at most so long a frame",
                   cli::numberFrom, [&options](double most) { options.budgetMs = most; });
    cli::addParsed(group, "--budget-error", "FLIP",
                   "Say the cheapest setting whose error (FLIP, 0 ... 1) is at most that",
                   cli::numberFrom, [&options](double most) { options.budgetError = most; });
    group.add_option("--yardstick", options.yardstick, "Of budgets: sprite or perspective")
        ->check(CLI::IsMember({"sprite", "perspective"}));
    group
        .add_option("--write-profile", options.writeProfile,
                    "Write the game profile with what the budget chose")
        ->type_name("FILE");
    // Beside figures they would be ignored.
    for (CLI::Option* const option : group.get_options())
        if (option != output) option->needs(output);
}

Result<cli::Report> reportTrade(const ReportOptions& options) {
    checkUsage(options);
    RunOptions run;
    run.files = options.files;
    run.reading = options.reading;
    run.folder = options.folder;
    run.writeProfile = options.writeProfile;
    run.profile = options.profile;
    if (options.way) {
        Result<std::vector<OrbitAngles>> way = readCameraWay(*options.way);
        if (!way) return Failure(way.error());
        run.recordedWay = std::move(*way);
    }
    run.axes = axesOf(options.axes);
    run.quick = options.quick;
    run.growth = options.costs;
    run.seed = options.seed;
    run.gl = options.backend != "cpu";
    run.needGl = options.backend == "gl";
    const Result<TradeReport> measured = runTrade(run);
    if (!measured) return Failure(measured.error());
    if (!measured->failures.empty() && measured->models.empty() && measured->growth.empty())
        return Failure(measured->failures.front());

    cli::Report report;
    const Result<std::vector<std::string>> files = writeReport(*measured, options.folder);
    if (!files) return Failure(files.error());
    int done = 0, wanted = 0;
    for (const ModelReport& model : measured->models) {
        done += model.measured();
        wanted += model.settings;
    }
    report.json = {{"finished", measured->finished},
                   {"settings", done},
                   {"backend", measured->backend},
                   {"commit", measured->commit},
                   {"files", Json::array()}};
    for (const std::string& file : *files) report.json["files"].push_back(cli::textJson(file));
    if (options.markdown) report.text = frontTable(*measured) + "\n" + growthTable(*measured);
    for (const std::string& file : *files)
        if (!options.markdown) report.text += file + "\n";
    addLeftOut(*measured, report);
    if (!measured->finished) {
        report.failure =
            failInFile(options.folder, "stopped: the report holds the " + std::to_string(done) +
                                           " settings that were measured until then")
                .value();
        return report;
    }
    if ((options.budgetMs || options.budgetError) && !measured->models.empty()) {
        if (Status chosen = addChoice(options, *measured, report); !chosen)
            report.failure = chosen.error();
    }
    return report;
}

}  // namespace voxprite::trade
