// voxprite convert: from any format that is read to any that is written, by their endings; one file
// (-o OUT), or many at once (--out-dir).
#include <filesystem>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/convert_batch.h"
#include "app/cli/mesh_options.h"
#include "app/cli/outputs.h"
#include "app/cli/source.h"
#include "core/io/png.h"

namespace voxprite::cli {
namespace {

struct ConvertOptions {
    std::vector<std::string> inputs;
    std::optional<std::string> output, folder, to, log, profile, variant;
    std::optional<int> jobs;
    ReadOptions reading;
    WriteOptions writing;
    bool strict = false;
    bool* json = nullptr;  // owned by the Command
};

Result<Report> convertMany(const ConvertOptions& options) {
    BatchCommand batch;
    batch.inputs = options.inputs;
    batch.folder = *options.folder;
    if (options.to) batch.to = *options.to;
    batch.jobs = options.jobs.value_or(0);
    batch.log = options.log;
    batch.profile = options.profile;
    batch.variant = options.variant;
    batch.strict = options.strict;
    batch.quiet = *options.json;
    batch.reading = options.reading;
    batch.writing = options.writing;
    return convertBatch(batch);
}

Result<Report> convertOne(const ConvertOptions& options) {
    const std::string& input = options.inputs[0];
    const std::string& output = *options.output;
    // A model may take its own place, if all of it is written.
    const bool inPlace = isReadWhole(input, options.reading) && !options.variant;
    checkReplacesNone({"--output", output}, inPlace ? std::vector<std::string>{} : options.inputs);
    // Before any work: is the output of a kind that can be written?
    const Result<Format> format = formatOf(output);
    if (!format) throw CLI::ValidationError("--output", format.error().describe());
    if (!infoOf(*format).writes()) {
        throw CLI::ValidationError(
            "--output", std::string(infoOf(*format).ending) +
                            " is read but not written (written: " + listed(writtenEndings()) + ")");
    }
    const Result<LoadedDocument> loaded =
        loadSource(input, std::nullopt, options.variant, options.reading);
    if (!loaded) return Failure(loaded.error());
    if (!loaded->whole) checkReplacesNone({"--output", output}, options.inputs);
    const Result<GameProfile> profile = profileForSaving(options.profile, loaded->document);
    if (!profile) return Failure(profile.error());
    const std::vector<std::string> losses = lossesOf(loaded->document, *format);
    if (options.strict && !losses.empty()) {
        return failInFile(input, "would lose something: " + losses.front() +
                                     (losses.size() > 1 ? " ..." : "") + " (nothing was written)");
    }
    if (!*options.json) tellLosses(input, losses);
    if (Status saved = saveDocument(output, loaded->document, *profile, {}, options.writing);
        !saved) {
        return Failure(saved.error());
    }
    Json warnings = warningsJson(*loaded);
    const std::string ofReading = warningLines(warnings);
    for (const std::string& loss : losses) warnings.push_back(textJson(loss));
    std::error_code unknown;  // of a pipe
    const std::uintmax_t size = std::filesystem::file_size(output, unknown);
    const std::uintmax_t bytes = unknown ? 0 : size;
    Report report;
    report.json = {{"input", textJson(input)},
                   {"from", nameOf(loaded->format)},
                   {"output", textJson(output)},
                   {"to", nameOf(*format)},
                   {"bytes", bytes},
                   {"warnings", std::move(warnings)}};
    report.text = output + ": " + std::to_string(bytes) + " bytes\n" + ofReading;
    return report;
}

Result<Report> convert(const ConvertOptions& options) {
    if (options.folder) {
        if (options.output) throw CLI::ValidationError("-o and --out-dir exclude one another");
        return convertMany(options);
    }
    if (!options.output)
        throw CLI::ValidationError("either --output OUT or --out-dir DIR is required");
    if (options.inputs.size() != 1) {
        throw CLI::ValidationError("-o takes one file; for several there is --out-dir DIR");
    }
    if (options.to || options.log || options.jobs) {
        throw CLI::ValidationError("--to, --log and --jobs go with --out-dir");
    }
    return convertOne(options);
}

}  // namespace

void addConvert(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("convert", "Convert between formats by file ending: from " +
                                                       listed(modelEndings()) + " to " +
                                                       listed(writtenEndings()));
    auto options = std::make_shared<ConvertOptions>();
    options->json = &command.json;
    sub.add_option("IN", options->inputs, "The files to read")->required();
    sub.add_option("-o,--output", options->output, "The file to write")->type_name("OUT");
    sub.add_option("--out-dir", options->folder,
                   "Write every file under its own name into this folder")
        ->type_name("DIR");
    sub.add_option("--to", options->to,
                   "With --out-dir: the format to write, by its name: voxprite (the default), "
                   "vox, svo ...")
        ->type_name("FORMAT");
    addParsed(sub, "--jobs", "N", "With --out-dir: files at a time (as many as there are cores)",
              indexFrom, [options](int jobs) { options->jobs = jobs; })
        ->check(CLI::Range(0, 1024));
    sub.add_option("--log", options->log,
                   "With --out-dir: a JSON object for each file, a line each, in their order")
        ->type_name("FILE");
    sub.add_flag("--strict", options->strict,
                 "Fail instead of leaving out what the format cannot hold");
    sub.add_flag(
        "--force", options->writing.replaceNeighbours,
        "Replace files that lie beside OUT under the names of those written beside it, even "
        "if no OUT refers to them");
    sub.add_option("--profile", options->profile,
                   "The game profile (JSON) whose values are recorded as authored")
        ->type_name("FILE");
    sub.add_option("--variant", options->variant,
                   "The palette variant, by its name; its colours become the file's palette")
        ->type_name("NAME");
    addParsed(sub, "--slice-rows", "N",
              "Of a .png with all layers below one another: rows of one layer", indexFrom,
              [options](int rows) { options->reading.slices.layerRows = rows; })
        ->check(CLI::Range(1, kMaxPngEdge));
    sub.add_option("--grid", options->reading.vdb.grid, "Of a .vdb: the grid that becomes voxels")
        ->type_name("NAME");
    addParsed(sub, "--threshold", "X", "Of a .vdb: density above this is solid (0.5)", numberFrom,
              [options](double threshold) { options->reading.vdb.threshold = threshold; });
    addEntityOption(sub, options->reading);
    addMeshReadOptions(sub, options->reading);
    addMeshWriteOptions(sub, options->writing);
    addJsonFlag(sub, command);
    runs(sub, command, options, convert);
}

}  // namespace voxprite::cli
