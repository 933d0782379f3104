// voxprite export IN... -o OUT.svo: octrees for the game's runtime, verified.
#include <deque>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/convert_batch.h"
#include "app/cli/outputs.h"
#include "app/cli/source.h"
#include "core/base/file.h"
#include "core/io/svo_file.h"
#include "core/io/svo_set.h"

namespace voxprite::cli {
namespace {

struct ExportOptions {
    std::vector<std::string> inputs;
    std::string output;
    std::optional<std::string> profile;
    std::optional<int> model;
    std::optional<std::string> variant;
    ReadOptions reading;
    bool each = false;
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

Json modelsJson(const SvoFile& file) {
    Json models = Json::array();
    for (const SvoModel& model : file.models) models.push_back(modelJson(model));
    return models;
}

// Of several inputs each warning names its own.
Result<LoadedDocument> load(const ExportOptions& options, const std::string& input, Json& warnings,
                            std::string& ofReading) {
    Result<LoadedDocument> loaded =
        loadSource(input, options.model, options.variant, options.reading);
    if (!loaded) return loaded;
    const std::vector<std::string> losses = lossesOf(loaded->document, Format::svo);
    if (!*options.json) tellLosses(input, losses);
    const std::string whose = options.inputs.size() > 1 ? input + ": " : "";
    Json read = Json::array();
    for (const std::string& warning : loaded->warnings) read.push_back(textJson(whose + warning));
    ofReading += warningLines(read);
    for (Json& warning : read) warnings.push_back(std::move(warning));
    for (const std::string& loss : losses) warnings.push_back(textJson(whose + loss));
    return loaded;
}

Result<Report> exportOne(const ExportOptions& options) {
    const std::string& input = options.inputs[0];
    Json warnings = Json::array();
    std::string ofReading;
    const Result<LoadedDocument> loaded = load(options, input, warnings, ofReading);
    if (!loaded) return Failure(loaded.error());
    const Result<GameProfile> profile = profileForSaving(options.profile, loaded->document);
    if (!profile) return Failure(profile.error());
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

    Report report;
    report.json = {{"input", textJson(input)},
                   {"output", textJson(options.output)},
                   {"bytes", bytes->size()},
                   {"models", modelsJson(*file)},
                   {"clips", file->clips.size()},
                   {"sockets", file->sockets.size()},
                   {"verified", true},
                   {"warnings", std::move(warnings)}};
    report.text = options.output + ": " + std::to_string(bytes->size()) + " bytes, " +
                  std::to_string(file->models.size()) +
                  " model(s), read back and compared voxel by voxel\n" + ofReading;
    return report;
}

Json entityJson(const SvoFile& entity, const std::string& input) {
    return {{"name", textJson(entity.name)},
            {"input", textJson(input)},
            {"anchor", {entity.anchor.x, entity.anchor.y, entity.anchor.z}},
            {"models", modelsJson(entity)},
            {"clips", entity.clips.size()},
            {"sockets", entity.sockets.size()}};
}

// Several entities into one file: one for each input, or for each of their models.
Result<Report> exportSet(const ExportOptions& options) {
    std::deque<std::pair<LoadedDocument, GameProfile>> sources;  // members refer to them
    std::vector<SetMember> members;
    std::vector<std::string> inputs;  // of each member
    Json warnings = Json::array();
    std::string ofReading;
    for (const std::string& input : options.inputs) {
        Result<LoadedDocument> loaded = load(options, input, warnings, ofReading);
        if (!loaded) return Failure(loaded.error());
        const Result<GameProfile> profile = profileForSaving(options.profile, loaded->document);
        if (!profile) return Failure(profile.error());
        const auto& [source, values] = sources.emplace_back(std::move(*loaded), *profile);
        const std::string stem = std::filesystem::path(input).stem().string();
        if (options.each) {
            for (SetMember& member : modelsOneByOne(source.document, values, stem)) {
                members.push_back(std::move(member));
            }
        } else {
            members.push_back({source.document, values, std::nullopt, stem});
        }
        inputs.resize(members.size(), input);
    }
    if (members.empty()) {
        return failInFile(options.inputs[0], "has no model with voxels; nothing was written");
    }
    const Result<Bytes> bytes = exportSvoSet(members);
    if (!bytes) return inFile(Result<Report>(Failure(bytes.error())), options.output);
    if (Status s = inFile(writeFileAtomically(options.output, *bytes), options.output); !s) {
        return Failure(s.error());
    }
    // What lies on the disk now are the bytes that were compared.
    const Result<Bytes> written = readFile(options.output);
    if (!written) return Failure(written.error());
    if (*written != *bytes) return failInFile(options.output, "is not what was written");
    const Result<std::vector<SvoFile>> set = readSvoSet(*written);
    if (!set) return inFile(Result<Report>(Failure(set.error())), options.output);

    Json entities = Json::array();
    for (std::size_t i = 0; i < set->size(); ++i) {
        entities.push_back(entityJson((*set)[i], inputs[i]));
    }
    Report report;
    report.json = {{"output", textJson(options.output)},
                   {"bytes", bytes->size()},
                   {"entities", std::move(entities)},
                   {"verified", true},
                   {"warnings", std::move(warnings)}};
    report.text = options.output + ": " + std::to_string(bytes->size()) + " bytes, " +
                  std::to_string(set->size()) +
                  " entities, read back and compared voxel by voxel\n" + ofReading;
    return report;
}

Result<Report> exportSvo(const ExportOptions& options) {
    const Result<Format> format = formatOf(options.output);
    if (!format || *format != Format::svo) {
        throw CLI::ValidationError("--output", "the octree's file must end in .svo");
    }
    // Not even an octree in its own place: the file would lose its other entities.
    checkReplacesNone({"--output", options.output}, options.inputs);
    if (options.each || options.inputs.size() > 1) return exportSet(options);
    return exportOne(options);
}

}  // namespace

void addExport(CLI::App& app, Command& command) {
    CLI::App& sub =
        *app.add_subcommand("export", "Write the octrees that the game's runtime loads");
    auto options = std::make_shared<ExportOptions>();
    options->json = &command.json;
    sub.add_option("IN", options->inputs,
                   "The model to export; several become entities of one file, each with its own "
                   "palette and anchor")
        ->required();
    sub.add_option("-o,--output", options->output, "The octrees' file")
        ->required()
        ->type_name("OUT.svo");
    sub.add_option("--profile", options->profile,
                   "The game profile (JSON) whose values are recorded as authored")
        ->type_name("FILE");
    sub.add_option("--variant", options->variant, "The palette variant, by its name")
        ->type_name("NAME");
    CLI::Option* const model =
        addParsed(sub, "--model", "INDEX",
                  "Only this source model, as `inspect` lists them (from 0), not the entity",
                  indexFrom, [options](int index) { options->model = index; });
    sub.add_flag("--each", options->each,
                 "Each source model becomes an entity of its own, without its placement")
        ->excludes(model);
    addEntityOption(sub, options->reading);
    addJsonFlag(sub, command);
    runs(sub, command, options, exportSvo);
}

}  // namespace voxprite::cli
