// voxprite export IN -o OUT.svo: the octree for the game's runtime, verified.
#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/convert_batch.h"
#include "app/cli/source.h"
#include "core/base/file.h"
#include "core/io/svo_file.h"

namespace voxprite::cli {
namespace {

struct Options {
    std::string input, output;
    std::optional<std::string> profile;
    std::optional<int> model;
    std::optional<std::string> variant;
    bool* json = nullptr;  // owned by the Command
};

Json modelJson(const SvoModel& model) {
    const Octree& octree = model.octree;
    return {{"name", textJson(model.name)},
            {"size", {octree.size.x, octree.size.y, octree.size.z}},
            {"max_depth", octree.maxDepth},
            {"nodes", octree.nodes.size()},
            {"payloads", octree.payloads.size()}};
}

Result<Report> exportSvo(const Options& options) {
    const Result<Format> format = formatOf(options.output);
    if (!format || *format != Format::svo) {
        throw CLI::ValidationError("--output", "the octree's file must end in .svo");
    }
    const Result<LoadedDocument> loaded = loadSource(options.input, options.model, options.variant);
    if (!loaded) return Failure(loaded.error());
    const Result<GameProfile> profile = profileForSaving(options.profile, loaded->document);
    if (!profile) return Failure(profile.error());
    const std::vector<std::string> losses = lossesOf(loaded->document, Format::svo);
    if (!*options.json) tellLosses(options.input, losses);
    if (Status saved = saveDocument(options.output, loaded->document, *profile); !saved) {
        return Failure(saved.error());
    }
    // What lies on the disk now, voxel by voxel.
    const Result<Bytes> bytes = readFile(options.output);
    if (!bytes) return Failure(bytes.error());
    if (Status same = inFile(verifyExport(*bytes, loaded->document), options.output); !same) {
        return Failure(same.error());
    }
    const Result<SvoFile> file = inFile(readSvo(*bytes), options.output);
    if (!file) return Failure(file.error());

    Json warnings = Json::array();
    for (const std::string& loss : losses) warnings.push_back(textJson(loss));
    Json models = Json::array();
    for (const SvoModel& model : file->models) models.push_back(modelJson(model));
    Report report;
    report.json = {{"input", textJson(options.input)},
                   {"output", textJson(options.output)},
                   {"bytes", bytes->size()},
                   {"models", std::move(models)},
                   {"clips", file->clips.size()},
                   {"sockets", file->sockets.size()},
                   {"verified", true},
                   {"warnings", std::move(warnings)}};
    report.text = options.output + ": " + std::to_string(bytes->size()) + " bytes, " +
                  std::to_string(file->models.size()) +
                  " model(s), read back and compared voxel by voxel\n";
    return report;
}

}  // namespace

void addExport(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("export", "Write the octree that the game's runtime loads");
    auto options = std::make_shared<Options>();
    options->json = &command.json;
    sub.add_option("IN", options->input, "The model to export")->required();
    sub.add_option("-o,--output", options->output, "The octree's file")
        ->required()
        ->type_name("OUT.svo");
    sub.add_option("--profile", options->profile,
                   "The game profile (JSON) whose values are recorded as authored")
        ->type_name("FILE");
    sub.add_option("--variant", options->variant, "The palette variant, by its name")
        ->type_name("NAME");
    addParsed(sub, "--model", "INDEX",
              "Only this source model, as `inspect` lists them (from 0), not the entity", indexFrom,
              [options](int model) { options->model = model; });
    addJsonFlag(sub, command);
    runs(sub, command, options, exportSvo);
}

}  // namespace voxprite::cli
