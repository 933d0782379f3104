// voxprite convert IN -o OUT: from any format that is read to any that is written, by their
// endings.
#include <filesystem>

#include "app/cli/command.h"
#include "app/cli/mesh_options.h"
#include "app/cli/source.h"

namespace voxprite::cli {
namespace {

struct Options {
    std::string input, output;
    std::optional<std::string> profile;
    std::optional<std::string> variant;
    ReadOptions read;
    WriteOptions write;
};

Result<Report> convert(const Options& options) {
    // Before any work: is the output of a kind that can be written?
    const Result<Format> format = formatOf(options.output);
    if (!format) throw CLI::ValidationError("--output", format.error().describe());
    const Result<LoadedDocument> loaded =
        loadSource(options.input, std::nullopt, options.variant, options.read);
    if (!loaded) return Failure(loaded.error());
    const Result<GameProfile> profile = profileForSaving(options.profile, loaded->document);
    if (!profile) return Failure(profile.error());
    if (Status saved = saveDocument(options.output, loaded->document, *profile, {}, options.write);
        !saved) {
        return Failure(saved.error());
    }
    Json warnings = Json::array();
    for (const std::string& warning : loaded->warnings) warnings.push_back(textJson(warning));
    for (const std::string& loss : lossesOf(loaded->document, *format)) {
        warnings.push_back(textJson(loss));
    }
    const auto bytes = std::filesystem::file_size(options.output);
    Report report;
    report.json = {{"input", textJson(options.input)},
                   {"from", nameOf(loaded->format)},
                   {"output", textJson(options.output)},
                   {"to", nameOf(*format)},
                   {"bytes", bytes},
                   {"warnings", std::move(warnings)}};
    report.text = options.output + ": " + std::to_string(bytes) + " bytes\n";
    report.text += warningLines(report.json["warnings"]);
    return report;
}

}  // namespace

void addConvert(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("convert", "Convert between formats by file ending: from " +
                                                       listed(modelEndings()) + " to " +
                                                       listed(writtenEndings()));
    auto options = std::make_shared<Options>();
    sub.add_option("IN", options->input, "The file to read")->required();
    sub.add_option("-o,--output", options->output, "The file to write")
        ->required()
        ->type_name("OUT");
    sub.add_option("--profile", options->profile,
                   "The game profile (JSON) whose values are recorded as authored")
        ->type_name("FILE");
    sub.add_option("--variant", options->variant,
                   "The palette variant, by its name; its colours become the file's palette")
        ->type_name("NAME");
    addMeshReadOptions(sub, options->read);
    addMeshWriteOptions(sub, options->write);
    addJsonFlag(sub, command);
    runs(sub, command, options, convert);
}

}  // namespace voxprite::cli
